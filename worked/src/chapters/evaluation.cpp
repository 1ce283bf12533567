#include <blossom/core/blossom/evaluation.hpp>
#include <blossom/worked/chapters.hpp>

#include "curve_pictures.hpp"

namespace blossom::worked {

namespace {

/// c_0 + c_1 t + ... with the number for t.
Formula written_out(const PolynomialCurve& curve, const Rational& t) {
    std::vector<Formula> terms;
    for (std::size_t k = 0; k <= curve.degree(); ++k) {
        const Coordinates coefficient = curve.coefficients()[k];
        if (coefficient == Coordinates(coefficient.size())) continue;
        std::vector<Formula> factors;
        if (k > 0) factors.push_back(power(number(t), number(k)));
        // A number stands in front of a point.
        const Formula value = point_formula(coefficient);
        if (k == 0 || coefficient != Coordinates{1})
            factors.insert(coefficient.size() == 1 ? factors.begin() : factors.end(), value);
        terms.push_back(product(std::move(factors)));
    }
    return sum(std::move(terms));
}

}  // namespace

Document evaluation_at(const GivenMap& given, const Parameter& t, const Limits& limits) {
    Document document = begun(given, "Evaluation by de Casteljau's algorithm",
                              "Goldman, figures 1 and 2; Hart, de Casteljau");
    const std::size_t n = degree_of(given.map);
    const BezierCurve bezier = bezier_form(given.map, limits);
    const std::vector<Argument> arguments = with_copies({}, n, t);
    const Formula wanted = call("P", {number(t.value)});
    const Formula diagonal = value_of_blossom(arguments);
    document.statement.say({"Find ", wanted, "."});

    const Rational& a = bezier.interval().a();
    const Rational& b = bezier.interval().b();
    Blocks& diagonal_value = document.step("The value is a diagonal value of the blossom");
    diagonal_value.say("When all arguments agree, the blossom is the map:")
        .show({equation({wanted, diagonal})});
    if (std::holds_alternative<BezierCurve>(given.map)) {
        diagonal_value.say({"The computation starts from the control points, the values at the ends ",
                            number(a), " and ", number(b), " of the interval."});
    } else {
        diagonal_value
            .say("The computation starts from the control points, the values at the ends of the interval:")
            .show(control_point_equations(bezier));
    }
    document.step("One argument per level becomes the parameter")
        .say({"The parameter is a combination of the ends, ",
              equation({number(t.value), combination({{(b - t.value) / (b - a), number(a)},
                                                      {(t.value - a) / (b - a), number(b)}})}),
              ", and the blossom, affine in each argument, combines its values with the same weights."})
        .add(casteljau_triangle(bezier, arguments, "De Casteljau's pyramid.", limits))
        .add_if(construction_picture(given.map, arguments, "The construction in the plane.", limits));
    const Coordinates value = Blossom(given.map, limits)(arguments);
    document.result.show({equation({wanted, diagonal, point_formula(value)})});

    const PolynomialCurve coefficients = monomial_form(given.map, limits);
    const Coordinates direct = evaluate(coefficients, t, limits);
    document.check = {
        {Paragraph{"The polynomial, evaluated directly, gives the same:"},
         Display{{equation({wanted, written_out(coefficients, t.value), point_formula(direct)})}}},
        value == direct};
    return document;
}

}  // namespace blossom::worked
