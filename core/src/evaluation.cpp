#include <blossom/core/evaluation.hpp>

#include "run_construction.hpp"

namespace blossom {

namespace {

Coordinates evaluate_map(const PolynomialMap& map, const PointArray& numbers, const Parameter& t,
                         const Limits& limits) {
    const std::size_t degree = numbers.size() - 1;
    const Argument argument(t);
    const ClearedArguments cleared = cleared_one_by_one({&argument, 1});
    require_result_bits(greatest_bit_length(numbers.numbers().numerators()) + degree * cleared.bits, limits);
    const HomogeneousForm<Integer> form(map);
    return reduced({form(cleared.pairs.front()), form.denominator()}, pow(cleared.denominator, degree));
}

}  // namespace

Coordinates evaluate(const PolynomialCurve& curve, const Parameter& t, const Limits& limits) {
    return evaluate_map(curve, curve.coefficients(), t, limits);
}

Coordinates evaluate(const BezierCurve& curve, const Parameter& t, const Limits& limits) {
    return evaluate_map(curve, curve.control_points(), t, limits);
}

}  // namespace blossom
