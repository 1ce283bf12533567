#include "triangle_net.hpp"

#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/patch/patch_conversion.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/lists.hpp>

#include <algorithm>
#include <numeric>
#include <span>

#include "symbols.hpp"

namespace blossom::worked {

namespace {

constexpr std::array<const char*, 3> vertex_names{"r", "s", "t"};

/// The control net over the triangle; for a polynomial, over the origin and the ends of the unit vectors.
BezierPatch net_of(const PatchMap& map, const Limits& limits) {
    const NetShape& shape =
        std::visit([](const auto& patch) -> const NetShape& { return patch.shape(); }, map);
    if (shape.factors() != 1 || shape[0].dimension != 2) {
        throw Error(
            ErrorCode::wrong_kind,
            "a worked example of a patch is made for a map on one triangle, or of total degree in two "
            "variables",
            Part::map);
    }
    require_within(shape[0].degree, triangle_page_degree, "degree of a page on a triangle", "formal degree");
    if (const auto* net = std::get_if<BezierPatch>(&map)) return *net;
    const std::array frames{BarycentricFrame::standard(2)};
    return control_net(std::get<PolynomialPatch>(map), frames, limits);
}

std::optional<BarycentricFrame> frame_of(const GivenTriangle& given) {
    if (std::holds_alternative<PolynomialPatch>(given.map)) return BarycentricFrame::standard(2);
    return given.frame;
}

Coordinates unit(std::size_t k) {
    Coordinates vertex(3);
    vertex[k] = 1;
    return vertex;
}

void require_point(const Coordinates& u) {
    if (u.size() != 3) {
        throw Error(ErrorCode::mismatched_dimensions,
                    "a point of a triangle has 3 barycentric coordinates, not " + std::to_string(u.size()),
                    Part::at);
    }
    const Rational sum = std::accumulate(u.begin(), u.end(), Rational(0));
    if (sum != Rational(1)) {
        throw Error(ErrorCode::not_affine,
                    "the barycentric coordinates of a point have the sum 1, not " + to_string(sum), Part::at);
    }
}

/// x = ... for each coordinate of the polynomial.
Formula polynomial_formula(const PolynomialPatch& patch, std::span<const Formula> variables) {
    std::vector<Formula> coordinates;
    coordinates.reserve(patch.dimension());
    for (std::size_t j = 0; j < patch.dimension(); ++j) {
        coordinates.push_back(sparse_formula(patch.coordinate(j), variables, variables.size()));
    }
    return coordinates.size() == 1 ? coordinates.front() : tuple(std::move(coordinates));
}

std::vector<Formula> equations(const TriangleNet& net, std::size_t level) {
    return mapped(net.indices(level),
                  [&](const MultiIndex& index) { return level == 0 ? net.known(index) : net.made(index); });
}

}  // namespace

TriangleNet::TriangleNet(const GivenTriangle& given, Coordinates u, const Limits& limits)
    : patch_(net_of(given.map, limits)),
      u_(std::move(u)),
      vertices_{unit(0), unit(1), unit(2)},
      limits_(limits) {
    require_point(u_);
}

Coordinates TriangleNet::value(const MultiIndex& index) const {
    std::vector<Coordinates> arguments;
    for (std::size_t k = 0; k < 3; ++k) arguments.insert(arguments.end(), index[k], vertices_[k]);
    arguments.resize(degree(), u_);
    return blossom_value(patch_, {arguments}, limits_);
}

Formula TriangleNet::name(const MultiIndex& index) const {
    std::vector<Formula> arguments;
    for (std::size_t k = 0; k < 3; ++k) arguments.insert(arguments.end(), index[k], symbol(vertex_names[k]));
    arguments.resize(degree(), symbol("u"));
    return blossom_of("p", std::move(arguments));
}

Formula TriangleNet::known(const MultiIndex& index) const {
    return equation({name(index), point_formula(value(index))});
}

Formula TriangleNet::made(const MultiIndex& index) const {
    std::vector<std::pair<Rational, Formula>> terms;
    for (std::size_t k = 0; k < 3; ++k) {
        MultiIndex before = index;
        ++before[k];
        if (!u_[k].is_zero()) terms.emplace_back(u_[k], name(before));
    }
    return equation({name(index), combination(terms), point_formula(value(index))});
}

std::vector<MultiIndex> TriangleNet::indices(std::size_t level) const {
    return multi_indices(2, degree() - level);
}

Display point_display(const GivenTriangle& given, const TriangleNet& net) {
    const Coordinates& u = net.u();
    std::vector<std::pair<Rational, Formula>> terms;
    for (std::size_t k = 0; k < 3; ++k) {
        if (!u[k].is_zero()) terms.emplace_back(u[k], symbol(vertex_names[k]));
    }
    std::vector<Formula> sides{symbol("u"), combination(terms)};
    if (const auto frame = frame_of(given)) sides.push_back(point_formula(frame->combination(u)));
    return {{equation(std::move(sides))}};
}

Document begun(const GivenTriangle& given, const TriangleNet& net, std::string title, std::string source) {
    const std::optional<BarycentricFrame> frame = frame_of(given);
    Document document;
    document.title = std::move(title);
    document.source = std::move(source);
    document.maps.push_back({"P", "p", "", TriangleMap{net.patch(), frame}});
    for (std::size_t k = 0; k < 3; ++k) document.points.push_back({vertex_names[k], net.vertices()[k]});
    document.points.push_back({"u", net.u()});

    const Formula degree = number(net.degree());
    if (const auto* polynomial = std::get_if<PolynomialPatch>(&given.map)) {
        std::vector<Formula> variables;
        variables.reserve(given.variables.size());
        for (const std::string& variable : given.variables) variables.push_back(symbol(variable));
        document.statement.say(
            {"Given the polynomial map of formal total degree ", degree, " in the plane:"});
        document.statement.show(
            {equation({call("P", variables), polynomial_formula(*polynomial, variables)})});
    } else {
        document.statement.say({"Given the triangular Bézier patch of degree ", degree, " over the triangle ",
                                symbol("r"), ", ", symbol("s"), ", ", symbol("t"),
                                " by its control points, the values of its blossom at the vertices:"});
        document.statement.show(equations(net, 0));
    }
    if (frame) {
        Text text{std::holds_alternative<PolynomialPatch>(given.map) ? "It is worked out over the triangle "
                                                                     : "The vertices are "};
        for (std::size_t k = 0; k < 3; ++k) {
            if (k > 0) text.append(std::string(k == 1 ? ", " : " and "));
            text.append(equation({symbol(vertex_names[k]), point_formula(frame->vertices()[k])}));
        }
        text.append(".");
        document.statement.say(std::move(text));
    }
    if (given.weighted) {
        document.statement.say(
            "The patch is rational, and its values are homogeneous: the last coordinate is a weight, "
            "and a point of the patch has the others divided by it.");
    }
    return document;
}

void append_levels(Document& document, const GivenTriangle& given, const TriangleNet& net) {
    if (std::holds_alternative<PolynomialPatch>(given.map)) {
        document.step("The control points")
            .say("The control points over the triangle are the values of the blossom at its vertices:")
            .show(equations(net, 0));
    }
    if (net.degree() == 0) return;
    Blocks& levels = document.step("One argument per level becomes the point");
    levels.say({"The blossom is affine in each argument, and so a value with the argument ", symbol("u"),
                " is the combination, with the coordinates of ", symbol("u"),
                " as weights, of three values of the level before, those with ", symbol("r"), ", ",
                symbol("s"), " and ", symbol("t"), " in its place."});
    for (std::size_t level = 1; level <= net.degree(); ++level) {
        levels.say("Level " + std::to_string(level) + ":").show(equations(net, level));
    }
}

}  // namespace blossom::worked
