#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/blossom/patch_subdivision.hpp>
#include <blossom/core/blossom/patch_values.hpp>
#include <blossom/rational/error.hpp>

#include "patch_constructions.hpp"
#include "polarization.hpp"

namespace blossom {

namespace {

constexpr auto mass_check(const BezierPatch&) { return require_mass; }
constexpr auto mass_check(const PolynomialPatch&) { return require_first; }

template <class Map>
void require_affine_point(const Map& patch, const PatchPoint& point) {
    require_point(patch.shape().list(), point);
    for (std::size_t f = 0; f < point.size(); ++f) {
        within(f, [&] { mass_check(patch)(point[f], 1, "a point"); });
    }
}

template <class Map>
void require_vectors(const Map& patch, const PatchArguments& directions) {
    require_directions(patch.shape(), directions);
    within(Part::directions, [&] { require_masses(directions, 0, "a direction", mass_check(patch)); });
}

}  // namespace

template <PatchRepresentation Map>
Coordinates blossom_value(const Map& patch, const PatchArguments& arguments, const Limits& limits) {
    return polar_value(patch.shape(), polar_of(patch), arguments, limits);
}

template <PatchRepresentation Map>
std::vector<Coordinates> evaluate(const Map& patch, std::span<const PatchPoint> points,
                                  const Limits& limits) {
    require_product_within({points.size(), patch.dimension()}, limits.numbers, "numbers",
                           "the number of coordinates of the values", Part::at);
    const std::vector<Rational> numbers = PatchValues(patch, limits).at(points);
    std::vector<Coordinates> values;
    values.reserve(points.size());
    for (auto value = numbers.begin(); value != numbers.end();) {
        const auto end = value + static_cast<std::ptrdiff_t>(patch.dimension());
        values.emplace_back(value, end);
        value = end;
    }
    return values;
}

template <PatchRepresentation Map>
Coordinates derivative(const Map& patch, const PatchArguments& directions, const PatchPoint& at,
                       const Limits& limits) {
    require_vectors(patch, directions);
    within(Part::at, [&] { require_affine_point(patch, at); });
    return polar_derivative_at(patch.shape(), polar_of(patch), directions, at, limits);
}

template <PatchRepresentation Map>
Map derivative_patch(const Map& patch, const PatchArguments& directions, const Limits& limits) {
    require_vectors(patch, directions);
    auto [shape, polar] = polar_derivative(patch.shape(), polar_of(patch), directions, limits);
    if constexpr (std::same_as<Map, PolynomialPatch>) polar = form_of(shape, polar);
    return {std::move(shape), std::move(polar)};
}

PointArray sheared(const NetShape& shape, const PointArray& polar, int sign, const Limits& limits) {
    BezierPatch net(shape, polar);
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        const std::size_t vertices = shape[f].dimension + 1;
        std::vector<Coordinates> elements(vertices, Coordinates(vertices));
        for (std::size_t k = 0; k < vertices; ++k) {
            if (k > 0) elements[k][0] = sign;
            elements[k][k] = 1;
        }
        net = with_frame(net, f, elements, limits);
    }
    return net.control_net();
}

Coordinates blossom_value(const PatchMap& map, const PatchArguments& arguments, Construction construction,
                          const Limits& limits) {
    require_arguments(shape_of(map), arguments);
    const std::size_t bits = bits_of(points_of(map));
    if (construction == Construction::regrouped_polarization) {
        throw Error(ErrorCode::wrong_kind,
                    "regrouped-polarization is a construction of curves; a patch has symmetric, polarization "
                    "and casteljau",
                    Part::construction);
    }
    const bool sums = construction == Construction::polarization;
    if (sums) require_terms_of_polarization(multiplicities(arguments), limits);
    const IntegerArguments integers =
        sums ? cleared_together(arguments, bits, limits) : cleared_one_by_one(arguments, bits, limits);
    return reduced(run_construction(map, construction, integers.tuples, limits), integers.denominator);
}

template Coordinates blossom_value(const BezierPatch&, const PatchArguments&, const Limits&);
template Coordinates blossom_value(const PolynomialPatch&, const PatchArguments&, const Limits&);
template std::vector<Coordinates> evaluate(const BezierPatch&, std::span<const PatchPoint>, const Limits&);
template std::vector<Coordinates> evaluate(const PolynomialPatch&, std::span<const PatchPoint>,
                                           const Limits&);
template Coordinates derivative(const BezierPatch&, const PatchArguments&, const PatchPoint&, const Limits&);
template Coordinates derivative(const PolynomialPatch&, const PatchArguments&, const PatchPoint&,
                                const Limits&);
template BezierPatch derivative_patch(const BezierPatch&, const PatchArguments&, const Limits&);
template PolynomialPatch derivative_patch(const PolynomialPatch&, const PatchArguments&, const Limits&);

}  // namespace blossom
