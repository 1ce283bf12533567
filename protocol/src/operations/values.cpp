#include "values.hpp"

#include <blossom/core/blossom/evaluation.hpp>
#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/spline/curve_values.hpp>
#include <blossom/core/spline/de_boor.hpp>

#include "maps/dispatch_on_kind.hpp"

namespace blossom::protocol {

namespace {

constexpr std::size_t least_prepared = 8;

struct Values {
    const Parameters& parameters;
    const Limits& limits;

    std::vector<Coordinates> operator()(const OnePolynomial auto& curve) const {
        const auto values = [&](const auto& one) { return on_line<CurveValues>(one); };
        return std::visit(values, polynomial_map(curve, limits));
    }
    std::vector<Coordinates> operator()(const BSplineCurve& curve) const {
        return on_line<SplineValues>(curve);
    }
    std::vector<Coordinates> operator()(const Patch& patch) const {
        const std::vector<PatchPoint> points = at_each(parameters, [&](std::span<const Rational> numbers) {
            return engine_arguments(patch, numbers, 1);
        });
        return std::visit([&](const auto& one) { return evaluate(one, points, limits); }, patch.map);
    }
    std::vector<Coordinates> operator()(const TensorBSpline& spline) const {
        return at_each(parameters, [&](std::span<const Rational> numbers) {
            return as_parameter(Part::at, [&] { return evaluate(spline, numbers, limits); });
        });
    }

private:
    template <class Prepared>
    std::vector<Coordinates> on_line(const auto& curve) const {
        if (parameters.size() < least_prepared) {
            return at_each(parameters, [&](std::span<const Rational> t) {
                return evaluate(curve, Parameter(t.front()), limits);
            });
        }
        const Prepared prepared(curve, limits);
        return at_each(parameters, [&](std::span<const Rational> t) { return prepared(t.front()); });
    }
};

}  // namespace

std::vector<Coordinates> values_at(const Map& map, const Parameters& parameters, const Limits& limits) {
    within("at", [&] { require_numbers(parameters.size(), dimension_of(map), limits); });
    return dispatch_on_kind<std::vector<Coordinates>>(map, Values{parameters, limits});
}

}  // namespace blossom::protocol
