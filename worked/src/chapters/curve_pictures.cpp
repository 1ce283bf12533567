#include "curve_pictures.hpp"

#include <blossom/core/blossom/conversion.hpp>
#include <blossom/rational/lists.hpp>

#include <algorithm>
#include <utility>

namespace blossom::worked {

namespace {

BezierCurve graph_of(const BezierCurve& curve) {
    const Rational& a = curve.interval().a();
    const Rational step = (curve.interval().b() - a) / Rational(curve.degree());
    std::vector<Coordinates> points;
    for (std::size_t k = 0; k <= curve.degree(); ++k) {
        points.push_back({a + Rational(k) * step, curve.control_points()[k][0]});
    }
    return BezierCurve(points, curve.interval());
}

PolynomialCurve graph_of(const PolynomialCurve& curve) {
    return PolynomialCurve(std::vector<Polynomial>{Polynomial::monomial(1), curve.coordinate(0)},
                           curve.degree());
}

/// The interval of the parameters that occur.
Interval hull(const Interval& interval, std::span<const Argument> arguments) {
    Rational least = std::min(interval.a(), interval.b());
    Rational greatest = std::max(interval.a(), interval.b());
    for (const Argument& argument : arguments) {
        least = std::min(least, argument.u);
        greatest = std::max(greatest, argument.u);
    }
    return {least, greatest};
}

/// (a^(n-r-i), u_1, ..., u_r, b^i), the label of node i on level r; points in increasing order.
std::vector<Argument> node_arguments(const BezierCurve& curve, std::span<const Argument> arguments,
                                     std::size_t r, std::size_t i) {
    std::vector<Argument> label = with_copies({}, curve.degree() - r - i, Parameter(curve.interval().a()));
    label.insert(label.end(), arguments.begin(), arguments.begin() + static_cast<std::ptrdiff_t>(r));
    label = with_copies(std::move(label), i, Parameter(curve.interval().b()));
    return r > 0 ? ordered(std::move(label)) : label;
}

Role role_of(std::size_t level, std::size_t degree) {
    if (level == degree) return Role::result;
    return level == 0 ? Role::control : Role::construction;
}

}  // namespace

std::optional<PlaneMap> plane_map(const PolynomialMap& map, const Limits&) {
    const std::size_t dimension = dimension_of(map);
    if (degree_of(map) == 0 || dimension > 2) return std::nullopt;
    if (dimension == 2) return PlaneMap{map, false};
    return std::visit([](const auto& curve) { return PlaneMap{graph_of(curve), true}; }, map);
}

PlanePoint place_of(const Coordinates& point) { return {point[0], point[1]}; }

std::vector<PlanePoint> places_of(const PointArray& points) { return mapped(points.to_points(), place_of); }

void add_polygon(Picture& picture, const BezierCurve& curve, const PointArray& points, Role role,
                 const Naming& name, bool named) {
    picture.lines.push_back({places_of(points), role});
    for (std::size_t k = 0; named && k <= curve.degree(); ++k)
        picture.points.push_back({place_of(points[k]), name(end_arguments(curve, k)), role});
}

bool all_points(std::span<const Argument> arguments) {
    return std::ranges::all_of(arguments,
                               [](const Argument& argument) { return argument.mass == Rational(1); });
}

TrianglePyramid triangle_by(const TriangleRule& rule, std::string caption) {
    TrianglePyramid triangle{std::move(caption), {}};
    for (std::size_t r = 0; r <= rule.degree; ++r) {
        std::vector<PyramidNode>& level = triangle.levels.emplace_back();
        for (std::size_t i = 0; i + r <= rule.degree; ++i) {
            const std::vector<Argument> label = rule.label(r, i);
            PyramidNode node{rule.name(label), point_formula(rule.value(label)), {}, {}};
            if (r > 0) {
                const auto [left, right] = rule.weights(r, i);
                node.left_weight = number(left);
                node.right_weight = number(right);
            }
            level.push_back(std::move(node));
        }
    }
    return triangle;
}

std::vector<Argument> ordered(std::vector<Argument> arguments) {
    if (all_points(arguments)) std::ranges::sort(arguments, {}, &Argument::u);
    return arguments;
}

TrianglePyramid casteljau_triangle(const BezierCurve& curve, std::span<const Argument> arguments,
                                   std::string caption, const Limits& limits) {
    const Rational& a = curve.interval().a();
    const Rational& b = curve.interval().b();
    const Blossom p(curve, limits);
    const auto weights = [&](std::size_t r, std::size_t) {
        const Argument& u = arguments[r - 1];
        return std::pair((b * u.mass - u.u) / (b - a), (u.u - a * u.mass) / (b - a));
    };
    const auto label = [&](std::size_t r, std::size_t i) { return node_arguments(curve, arguments, r, i); };
    return triangle_by({curve.degree(), label, weights, std::cref(p), named_by("p")}, std::move(caption));
}

std::optional<Picture> construction_picture(const PolynomialMap& map, std::span<const Argument> arguments,
                                            std::string caption, const Limits& limits) {
    const auto plane = plane_map(map, limits);
    if (!plane || !all_points(arguments)) return std::nullopt;
    const BezierCurve bezier = bezier_form(plane->map, limits);
    const Pyramid pyramid = casteljau_pyramid(bezier, arguments, limits);
    Picture picture;
    picture.caption = std::move(caption);
    picture.graph = plane->graph;
    picture.description =
        "The control polygon, the points of each level of de Casteljau's algorithm, each "
        "named by its blossom value, and the curve.";
    const std::size_t n = bezier.degree();
    for (std::size_t r = 0; r <= n; ++r) {
        const std::vector<PlanePoint> places = places_of(pyramid.levels[r]);
        if (r < n) picture.lines.push_back({places, role_of(r, n)});
        // More than about 15 names would cover the picture.
        const bool named = n <= 4 || r == 0 || r == n;
        for (std::size_t i = 0; named && i < places.size(); ++i) {
            picture.points.push_back(
                {places[i], value_of_blossom(node_arguments(bezier, arguments, r, i)), role_of(r, n)});
        }
    }
    picture.curves = curves_over(plane->map, hull(bezier.interval(), arguments), Role::control, limits);
    return picture;
}

}  // namespace blossom::worked
