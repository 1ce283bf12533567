#include "evaluator.hpp"

#include <blossom/core/blossom/evaluation.hpp>
#include <blossom/core/curve/derivative.hpp>
#include <blossom/core/nurbs/rational_curve.hpp>
#include <blossom/core/nurbs/rational_spline.hpp>
#include <blossom/core/spline/curve_values.hpp>
#include <blossom/core/spline/de_boor.hpp>

#include "maps/dispatch_on_kind.hpp"

namespace blossom::protocol {

Evaluator value_evaluator(const Map& map, std::size_t parameters, const Limits& limits) {
    constexpr std::size_t least_prepared = 8;
    const bool prepares = parameters >= least_prepared;
    const auto prepared = [](auto values) -> Evaluator {
        return [values = std::move(values)](const Rational& t) { return values(t); };
    };
    const auto of_polynomial = [&](const OnePolynomial auto& curve) -> Evaluator {
        auto converted = polynomial_map(curve, limits);
        if (prepares)
            return std::visit([&](const auto& one) { return prepared(CurveValues(one, limits)); }, converted);
        return [&limits, converted = std::move(converted)](const Rational& t) {
            return std::visit([&](const auto& one) { return evaluate(one, t, limits); }, converted);
        };
    };
    const auto of_spline = [&](const BSplineCurve& curve) -> Evaluator {
        if (prepares) return prepared(SplineValues(curve, limits));
        return [&](const Rational& t) { return evaluate(curve, t, limits); };
    };
    return dispatch_on_kind<Evaluator>(map, Overloads{of_polynomial, of_spline});
}

Evaluator derivative_evaluator(const Map& map, std::size_t order, const Limits& limits) {
    const bool divided = map.form.separate_weights();
    const auto of_polynomial = [&](const OnePolynomial auto& curve) -> Evaluator {
        return [&limits, order, divided, converted = polynomial_map(curve, limits)](const Rational& t) {
            return divided ? rational_derivative(converted, order, t, limits)
                           : derivative(converted, order, t, limits);
        };
    };
    const auto of_spline = [&](const BSplineCurve& curve) -> Evaluator {
        return [&, order, divided](const Rational& t) {
            return divided ? rational_derivative(curve, order, t, limits)
                           : derivative(curve, order, t, limits);
        };
    };
    return dispatch_on_kind<Evaluator>(map, Overloads{of_polynomial, of_spline});
}

Json values_at(const Evaluator& evaluator, const std::vector<Rational>& parameters, const PointForm& form,
               std::size_t dimension, const Limits& limits) {
    require_numbers(parameters.size(), dimension, limits);
    return written_at(parameters.size(), form, [&](std::size_t i) { return evaluator(parameters[i]); });
}

}  // namespace blossom::protocol
