// Values of patches: evaluation, blossoms, derivatives.

#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/nurbs/rational_patch.hpp>
#include <blossom/core/patch/patch_elevation.hpp>

#include <algorithm>
#include <map>

#include "blossom_arguments.hpp"
#include "directions.hpp"
#include "evaluator.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "patch_answers.hpp"

namespace blossom::protocol {

namespace {

/// x_1, ..., x_s of (mass, x_1, ..., x_s).
Coordinates without_mass(const Coordinates& argument) { return {argument.begin() + 1, argument.end()}; }

PatchPoint without_mass(const PatchPoint& point) {
    PatchPoint result;
    for (const Coordinates& argument : point) result.push_back(without_mass(argument));
    return result;
}

PatchArguments without_mass(const PatchArguments& arguments) {
    PatchArguments result;
    for (const auto& list : arguments) result.push_back(without_mass(list));
    return result;
}

struct Values {
    std::span<const PatchPoint> points;
    const Limits& limits;

    std::vector<Coordinates> operator()(const BezierPatch& net) const {
        return evaluate(net, points, limits);
    }
    std::vector<Coordinates> operator()(const PolynomialPatch& polynomial) const {
        std::vector<PatchPoint> plain;
        for (const PatchPoint& point : points) plain.push_back(without_mass(point));
        return evaluate(polynomial, plain, limits);
    }
};

struct DerivativeValue {
    const PatchArguments& directions;
    const PatchPoint& at;
    const Limits& limits;

    Coordinates operator()(const BezierPatch& net) const { return derivative(net, directions, at, limits); }
    Coordinates operator()(const PolynomialPatch& polynomial) const {
        return derivative(polynomial, without_mass(directions), without_mass(at), limits);
    }
};

struct DerivativeMap {
    const PatchArguments& directions;
    const Limits& limits;

    PatchMap operator()(const BezierPatch& net) const { return derivative_patch(net, directions, limits); }
    PatchMap operator()(const PolynomialPatch& polynomial) const {
        return derivative_patch(polynomial, without_mass(directions), limits);
    }
};

std::vector<PatchPoint> read_parameters(Fields& request, const Patch& patch, const Limits& limits) {
    return request.required("at", [&](const Json& value) {
        return read_list(value, [&](const Json& element) {
            return engine_arguments(patch, read_tuple(element, patch.parameters(), limits), 1);
        });
    });
}

bool is_zero(const Coordinates& tuple) { return std::ranges::all_of(tuple, &Rational::is_zero); }

/// A derivative in directions of the whole domain as a sum of derivatives in directions of single factors,
/// with how often each occurs.
using FactorTerms = std::map<PatchArguments, Integer>;

FactorTerms factor_terms(const NetShape& shape, std::span<const PatchPoint> directions,
                         const Limits& limits) {
    FactorTerms terms{{PatchArguments(shape.factors()), 1}};
    for (const PatchPoint& direction : directions) {
        FactorTerms longer;
        // A direction that is 0 in all factors counts in the first.
        const bool zero = std::ranges::all_of(direction, is_zero);
        for (const auto& [lists, times] : terms) {
            for (std::size_t f = 0; f < shape.factors(); ++f) {
                if (is_zero(direction[f]) && (!zero || f > 0)) continue;
                PatchArguments extended = lists;
                extended[f].push_back(direction[f]);
                longer[std::move(extended)] += times;
            }
        }
        terms = std::move(longer);
        require_within(terms.size(), limits.polarization_terms, "polarization_terms",
                       "the number of mixed derivatives");
    }
    return terms;
}

Coordinates derivative_at(const Patch& patch, std::span<const PatchPoint> directions, const PatchPoint& at,
                          const Limits& limits) {
    Coordinates sum(patch.dimension());
    for (const auto& [lists, times] : factor_terms(patch.shape(), directions, limits)) {
        const Coordinates value = std::visit(DerivativeValue{lists, at, limits}, patch.map);
        for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += Rational(times) * value[j];
    }
    return sum;
}

/// The sum of maps of one representation, each multiplied by an integer, in the least common degrees.
PatchMap sum_of(const std::vector<std::pair<PatchMap, Integer>>& maps, const Limits& limits) {
    const auto add = [&](const auto& first) -> PatchMap {
        using Kind = std::decay_t<decltype(first)>;
        std::vector<Kind> raised;
        raised.reserve(maps.size());
        for (const auto& [map, times] : maps) raised.push_back(std::get<Kind>(map));
        for (std::size_t f = 0; f < first.shape().factors(); ++f) {
            std::size_t degree = 0;
            for (const Kind& map : raised) degree = std::max(degree, map.shape()[f].degree);
            for (Kind& map : raised) map = elevate(map, f, degree - map.shape()[f].degree, limits);
        }
        std::vector<Coordinates> total(raised.front().shape().size(), Coordinates(first.dimension()));
        for (std::size_t i = 0; i < raised.size(); ++i) {
            const auto points = numbers_of(raised[i]).to_points();
            for (std::size_t k = 0; k < points.size(); ++k) {
                for (std::size_t j = 0; j < points[k].size(); ++j)
                    total[k][j] += Rational(maps[i].second) * points[k][j];
            }
        }
        return Kind(raised.front().shape(), PointArray(total));
    };
    return std::visit(add, maps.front().first);
}

PatchMap derivative_map(const Patch& patch, std::span<const PatchPoint> directions, const Limits& limits) {
    std::vector<std::pair<PatchMap, Integer>> terms;
    for (const auto& [lists, times] : factor_terms(patch.shape(), directions, limits)) {
        terms.emplace_back(std::visit(DerivativeMap{lists, limits}, patch.map), times);
    }
    return sum_of(terms, limits);
}

PatchMap divided_derivative_map(const Patch& patch, std::vector<PatchPoint> directions,
                                const Limits& limits) {
    if (const auto* net = std::get_if<BezierPatch>(&patch.map))
        return rational_derivative_patch(*net, directions, limits);
    for (PatchPoint& direction : directions) direction = without_mass(direction);
    return rational_derivative_patch(std::get<PolynomialPatch>(patch.map), directions, limits);
}

}  // namespace

Coordinates derivative_value(const Patch& patch, std::span<const PatchPoint> directions, const PatchPoint& at,
                             bool divided, const Limits& limits) {
    if (!divided) return derivative_at(patch, directions, at, limits);
    const auto in_subset = [&](std::size_t subset) {
        std::vector<PatchPoint> chosen;
        for (std::size_t k = 0; k < directions.size(); ++k) {
            if ((subset >> k & 1) != 0) chosen.push_back(directions[k]);
        }
        return derivative_at(patch, chosen, at, limits);
    };
    return projected_derivative(directions.size(), in_subset, limits);
}

Json evaluate_patch(Fields& request, const Map& map, const Limits& limits) {
    const Patch& patch = *patch_of(map);
    const std::vector<PatchPoint> points = read_parameters(request, patch, limits);
    request.finish();
    const std::vector<Coordinates> values = std::visit(Values{points, limits}, patch.map);
    return Json::Object{
        {"values", written_at(values.size(), map.form, [&](std::size_t i) { return values[i]; })}};
}

Json blossom_of_patch(Fields& request, const Map& map, const Limits& limits) {
    const Patch& patch = *patch_of(map);
    const PatchArguments arguments = request.required(
        "arguments", [&](const Json& value) { return read_patch_arguments(value, patch, map.form, limits); });
    const auto construction = request.optional("construction", read_construction);
    request.finish();
    const Coordinates value = at_arguments(patch, [&] {
        if (construction) return blossom_value(patch.map, arguments, *construction, limits);
        return std::visit([&](const auto& one) { return blossom_value(one, arguments, limits); }, patch.map);
    });
    return Json::Object{{"value", within("arguments", [&] { return to_json(value, map.form); })}};
}

Answer derivative_of_patch(Fields& request, const Map& map, const Limits& limits) {
    const Patch& patch = *patch_of(map);
    const auto read = [&](const Json& value) {
        return engine_arguments(patch, read_tuple(value, patch.parameters(), limits), 0);
    };
    const std::vector<PatchPoint> directions = read_directions(request, patch.parameters(), limits, read);
    std::optional<std::vector<PatchPoint>> points;
    if (request.has("at")) points = read_parameters(request, patch, limits);
    request.finish();
    const bool divided = map.form.separate_weights();
    if (!points) {
        Patch derived = patch;
        derived.map = divided ? divided_derivative_map(patch, directions, limits)
                              : derivative_map(patch, directions, limits);
        return answer_of(like(map, std::move(derived)));
    }
    const PointForm form = divided ? PointForm{.scalar = map.form.scalar} : map.form;
    return Json::Object{{"values", written_at(points->size(), form, [&](std::size_t i) {
                             return derivative_value(patch, directions, (*points)[i], divided, limits);
                         })}};
}

}  // namespace blossom::protocol
