#include <blossom/core/blossom/evaluation.hpp>
#include <blossom/core/curve/derivative.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/worked/chapters.hpp>

#include "curve_pictures.hpp"

namespace blossom::worked {

namespace {

/// n (n - 1) ... (n - k + 1).
Formula falling(std::size_t n, std::size_t k) {
    std::vector<Formula> factors;
    factors.reserve(k);
    for (std::size_t i = 0; i < k; ++i) factors.push_back(number(n - i));
    return product(std::move(factors));
}

Check derivative_check(const GivenMap& given, std::size_t order, const Parameter& t, const Coordinates& value,
                       const Limits& limits) {
    const PolynomialMap derived = derivative_map(monomial_form(given.map, limits), order);
    const auto& curve = std::get<PolynomialCurve>(derived);
    const Coordinates direct = evaluate(curve, t, limits);
    const Formula symbolic = definition_of({curve, given.variable}).formulas.front().parts.back();
    return {{Paragraph{"Differentiating the coefficients gives the same:"},
             Display{{equation({derivative_of("P", order, symbol(given.variable)), symbolic}),
                      equation({derivative_of("P", order, number(t.value)), point_formula(direct)})}}},
            direct == value};
}

}  // namespace

Document derivative_by_delta(const GivenMap& given, std::size_t order, const Parameter& t,
                             const Limits& limits) {
    Document document =
        begun(given, "A derivative is a blossom value at delta", "Goldman, theorem 9 and figures 9 and 10");
    const std::size_t n = degree_of(given.map);
    const Formula wanted = derivative_of("P", order, number(t.value));
    document.statement.say({"Find ", wanted, ", the derivative of order ", number(order), "."});
    const Coordinates value = derivative(given.map, order, t, limits);
    if (order > n) {
        document.step("The order is above the degree")
            .say({"The blossom has only ", number(n),
                  " arguments, too few for so many vectors: the derivative is zero."});
        document.result.show({equation({wanted, point_formula(value)})});
        document.check = derivative_check(given, order, t, value, limits);
        return document;
    }
    const BezierCurve bezier = bezier_form(given.map, limits);
    const Rational length = bezier.interval().b() - bezier.interval().a();
    const std::vector<Argument> arguments = with_copies(with_copies({}, order, delta), n - order, t);
    const Formula at = value_of_blossom(arguments);
    const Formula general = product({falling(n, order), at});
    document.step("The formula")
        .say({"A difference of parameters is a vector, and ", symbol("delta"),
              " is the unit vector (1, 0). Each derivative takes one argument from "
              "the diagonal, and there "
              "are as many to choose from as are left:"})
        .show({equation({wanted, general})});
    document.step("The triangle")
        .say({"Over the interval ", interval_of(number(bezier.interval().a()), number(bezier.interval().b())),
              " the vector ", symbol("delta"), " has the coordinates ", number(Rational(-1) / length),
              " and ", number(Rational(1) / length), ": on its level", order == 1 ? "" : "s",
              " the triangle takes differences; on the others it is de Casteljau's."})
        .add(casteljau_triangle(bezier, arguments, "The triangle with delta on its first levels.", limits));
    document.step("The factor")
        .say("The apex has to be multiplied by the factor of the formula.")
        .show({equation({wanted, general,
                         product({number(Rational(falling_factorial(n, order))),
                                  point_formula(Blossom(given.map, limits)(arguments))}),
                         point_formula(value)})});
    document.result.show({equation({wanted, point_formula(value)})});
    document.check = derivative_check(given, order, t, value, limits);
    return document;
}

}  // namespace blossom::worked
