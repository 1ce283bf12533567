// MISUSE_POINT_PLUS_POINT: no match for 'operator\+'|invalid operands
// MISUSE_DIRECTION_AS_PARAMETER: no matching function|cannot convert|could not convert|no viable conversion
// MISUSE_PARAMETER_AS_DIRECTION: cannot convert|could not convert|no viable conversion|conversion from
// MISUSE_SCALED_POINT: no match for 'operator\*'|invalid operands
// MISUSE_PARAMETER_FROM_DOUBLE: no matching function|conversion from|no viable conversion|could not convert

#include <blossom/core/blossom/evaluation.hpp>

using namespace blossom;

Coordinates correct(const PolynomialCurve& curve, const Parameter& a, const Parameter& b) {
    const Direction difference = b - a;
    return evaluate(curve, a + Rational(1, 2) * difference);
}

#ifdef MISUSE_POINT_PLUS_POINT
auto sum(const Parameter& a, const Parameter& b) { return a + b; }
#endif

#ifdef MISUSE_DIRECTION_AS_PARAMETER
Coordinates at_vector(const PolynomialCurve& curve) { return evaluate(curve, delta); }
#endif

#ifdef MISUSE_PARAMETER_AS_DIRECTION
Direction vector_from(const Parameter& a) { return a; }
#endif

#ifdef MISUSE_SCALED_POINT
auto twice(const Parameter& a) { return Rational(2) * a; }
#endif

#ifdef MISUSE_PARAMETER_FROM_DOUBLE
const Parameter half = 0.5;
#endif
