// MISUSE_POINT_PLUS_POINT: no match for 'operator\+'|invalid operands
// MISUSE_SCALED_POINT: no match for 'operator\*'|invalid operands
// MISUSE_VECTOR_AS_ARGUMENT: no match|no matching|no viable
// MISUSE_VERTEX_VECTOR: no matching|could not convert|no viable conversion|cannot convert
// MISUSE_POINT_WITHOUT_SPACE: no matching|could not convert|no viable conversion|conversion from|cannot convert
// MISUSE_BARE_NUMBERS: no match|no matching|no viable
// MISUSE_VALUE_AS_VECTOR: conversion from|could not convert|no viable conversion|no matching

#include <blossom/core/geometry/coordinate_free_blossom.hpp>

using namespace blossom;

geometry::Vector correct(const geometry::Blossom& f, const geometry::Point& p, const geometry::Vector& v) {
    const geometry::Point q = p + Rational(1, 2) * v;
    return f(std::vector{p}, std::vector{q - p}) + (f(std::vector{p, q}) - f(std::vector{p, p}));
}

#ifdef MISUSE_POINT_PLUS_POINT
auto sum(const geometry::Point& p, const geometry::Point& q) { return p + q; }
#endif

#ifdef MISUSE_SCALED_POINT
auto twice(const geometry::Point& p) { return Rational(2) * p; }
#endif

#ifdef MISUSE_VECTOR_AS_ARGUMENT
auto value(const geometry::Blossom& f, const geometry::Vector& v) { return f(std::vector{v, v}); }
#endif

#ifdef MISUSE_VERTEX_VECTOR
geometry::Simplex simplex(const geometry::Point& p, const geometry::Vector& v) {
    return geometry::Simplex({p, v});
}
#endif

#ifdef MISUSE_POINT_WITHOUT_SPACE
const geometry::Point point = Coordinates{1, 2};
#endif

#ifdef MISUSE_BARE_NUMBERS
auto value_at_numbers(const geometry::Blossom& f) { return f(std::vector<Coordinates>{{1, 2}}); }
#endif

#ifdef MISUSE_VALUE_AS_VECTOR
geometry::Vector vector(const geometry::Blossom& f, const geometry::Point& p) { return f(std::vector{p}); }
#endif
