#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/constructions/net_shape.hpp>
#include <blossom/core/nurbs/rational_curve.hpp>

#include "triangle_net.hpp"

namespace blossom::worked {

namespace {

/// The greatest degree at which the Bernstein polynomials of the check are written out.
constexpr std::size_t bernstein_degree = 3;

Picture construction(const GivenTriangle& given, const TriangleNet& net) {
    const std::size_t n = net.degree();
    TrianglePicture picture(given, net, "The construction.");
    for (std::size_t level = 0; level < n; ++level) {
        picture.add_net(level, level == 0 ? Role::control : Role::construction);
    }
    for (std::size_t k = 0; k < 3; ++k) picture.add_side(k, (k + 1) % 3, Role::control);
    for (std::size_t level = 0; level <= n; ++level) {
        if (level > 0 && level < n && n > TrianglePicture::named_degree) continue;
        picture.add_points(level, level == n   ? Role::result
                                  : level == 0 ? Role::control
                                               : Role::construction);
    }
    return picture.done();
}

/// The control points times Bernstein polynomials.
Formula bernstein_sum(const TriangleNet& net) {
    std::vector<std::pair<Rational, Formula>> terms;
    for (const MultiIndex& index : net.indices(0)) {
        Rational weight(multinomial(index));
        for (std::size_t k = 0; k < 3; ++k) weight *= pow(net.u()[k], index[k]);
        if (!weight.is_zero()) terms.emplace_back(weight, net.name(index));
    }
    return combination(terms);
}

}  // namespace

Document triangle_evaluation(const GivenTriangle& given, const Coordinates& u, const Limits& limits) {
    const TriangleNet net(given, u, limits);
    Document document = begun(given, net, "De Casteljau's algorithm on a triangle", "DeRose, section 5.2");
    const Formula wanted = call("P", {symbol("u")});
    document.statement.say({"Find ", wanted, " for the point"});
    document.statement.add(point_display(given, net));

    append_levels(document, given, net);
    if (net.degree() > 0) document.steps.back().blocks.add(construction(given, net));
    const MultiIndex none(3);
    const Coordinates value = net.value(none);
    document.result.show({equation({wanted, net.name(none), point_formula(value)})});
    if (given.weighted) {
        document.result.say("Divided by the weight this is the point");
        document.result.show({equation({division(value), point_formula(projected(value))})});
    }
    const Coordinates direct = evaluate(net.patch(), {u}, limits);
    std::vector<Formula> sides{wanted};
    if (net.degree() <= bernstein_degree) sides.push_back(bernstein_sum(net));
    sides.push_back(point_formula(direct));
    document.check = {{Paragraph{"The control points, weighted with Bernstein polynomials, give the same:"},
                       Display{{equation(std::move(sides))}}},
                      value == direct};
    return document;
}

}  // namespace blossom::worked
