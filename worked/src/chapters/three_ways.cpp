#include <blossom/core/blossom/agreement.hpp>
#include <blossom/core/blossom/evaluation.hpp>
#include <blossom/core/constructions/constructions.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/lists.hpp>
#include <blossom/worked/chapters.hpp>

#include <algorithm>
#include <utility>

#include "curve_pictures.hpp"
#include "formulas_of_values.hpp"
#include "symbols.hpp"

namespace blossom::worked {

namespace {

/// The greatest number of terms of an elementary symmetric function, and of rows of a table, that is written
/// out.
constexpr std::size_t terms_written = 35;
constexpr std::size_t rows_written = 130;

/// The product of the u of a subset and the masses of the rest; masses 1 are left out.
Formula elementary_term(std::span<const Argument> arguments, const std::vector<std::size_t>& subset) {
    std::vector<Formula> factors;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (std::ranges::find(subset, i) != subset.end()) {
            factors.push_back(number(arguments[i].u));
        } else if (arguments[i].mass != Rational(1)) {
            factors.push_back(number(arguments[i].mass));
        }
    }
    return product(std::move(factors));
}

/// e_k(arguments) as the sum of its terms and as a number.
Formula elementary_equation(std::span<const Argument> arguments, std::size_t k, const Rational& value) {
    std::vector<Formula> sides{elementary(k, argument_formulas(arguments))};
    const auto subsets = subsets_of_size(arguments.size(), k);
    if (subsets.size() <= terms_written && arguments.size() > 1 && k > 0) {
        sides.push_back(
            sum(mapped(subsets, [&](const auto& subset) { return elementary_term(arguments, subset); })));
    }
    sides.push_back(number(value));
    return equation(std::move(sides));
}

void append_symmetric(Blocks& step, const GivenMap& given, std::span<const Argument> arguments,
                      const Coordinates& value, const Limits& limits) {
    const PolynomialCurve curve = monomial_form(given.map, limits);
    const std::size_t n = curve.degree();
    const std::vector<Rational> values = elementary_values(arguments);
    step.say({"Each power ", power(symbol(given.variable), symbol("k")), " of the polynomial is replaced by ",
              fraction(index(symbol("e"), symbol("k")), binomial_of(number(n), symbol("k"))), ", where ",
              index(symbol("e"), symbol("k")), " is the sum of all products of ", symbol("k"),
              all_points(arguments)
                  ? " arguments:"
                  : " arguments, each times the masses of the arguments that are left out (1 for "
                    "a point, 0 for a vector):"});
    Display sums;
    std::vector<Formula> general;
    std::vector<Formula> written;
    for (std::size_t k = 0; k <= n; ++k) {
        const Coordinates coefficient = curve.coefficients()[k];
        if (std::ranges::all_of(coefficient, [](const Rational& c) { return c.is_zero(); })) continue;
        sums.formulas.push_back(elementary_equation(arguments, k, values[k]));
        Coordinates normalised = coefficient;
        for (Rational& c : normalised) c /= Rational(binomial(n, k));
        const bool alone = normalised == Coordinates{Rational(1)};
        const Formula e = elementary(k, argument_formulas(arguments));
        general.push_back(alone ? e : product({point_formula(normalised), e}));
        written.push_back(alone ? number(values[k])
                                : product({number(values[k]), point_formula(normalised)}));
        if (normalised.size() == 1 && !alone) std::swap(written.back().parts[0], written.back().parts[1]);
    }
    step.add(std::move(sums));
    step.say("With the coefficients of the polynomial this gives");
    step.show({equation({value_of_blossom(arguments), sum(std::move(general)), sum(std::move(written)),
                         point_formula(value)})});
}

/// v^n P(u / v) at the pair that a subset adds up to, or for v = 0 the leading form.
Coordinates form_value(const PolynomialCurve& curve, const Rational& u, const Rational& mass) {
    const std::size_t n = curve.degree();
    Coordinates value(curve.dimension());
    for (std::size_t k = 0; k <= n; ++k) {
        const Rational factor = pow(u, k) * pow(mass, n - k);
        const Coordinates coefficient = curve.coefficients()[k];
        for (std::size_t j = 0; j < value.size(); ++j) value[j] += coefficient[j] * factor;
    }
    return value;
}

/// The sub-multisets of the arguments, each as one row of the table.
struct SubsetRow {
    std::vector<Argument> members;
    Rational u;
    Rational mass;
    Rational weight;             ///< the sign times the number of subsets that look like this one
    std::vector<Formula> alike;  ///< this number, as binomial coefficients
};

std::vector<SubsetRow> subset_rows(std::span<const Argument> arguments) {
    std::vector<HomogeneousPair<Rational>> pairs;
    for (const Argument& argument : arguments) pairs.push_back({argument.u, argument.mass});
    std::vector<SubsetRow> rows{{{}, 0, 0, 1, {}}};
    for (const auto& [pair, times] : constructions::grouped<HomogeneousPair<Rational>>(pairs)) {
        const Argument argument(pair.u, pair.mass);
        std::vector<SubsetRow> longer;
        for (const SubsetRow& row : rows) {
            for (std::size_t j = times + 1; j-- > 0;) {
                const Rational count(j);
                const Rational sign = (times - j) % 2 == 0 ? 1 : -1;
                SubsetRow& next = longer.emplace_back(
                    SubsetRow{with_copies(row.members, j, argument), row.u + count * pair.u,
                              row.mass + count * pair.mass, row.weight * sign * Rational(binomial(times, j)),
                              row.alike});
                next.alike.push_back(binomial_of(number(times), number(j)));
            }
        }
        rows = std::move(longer);
    }
    std::erase_if(rows, [](const SubsetRow& row) { return row.members.empty(); });
    std::ranges::stable_sort(rows, {}, [](const SubsetRow& row) { return row.members.size(); });
    return rows;
}

/// The sum of the arguments as pairs.
Formula sum_of_pairs(std::span<const Argument> arguments) {
    return sum(mapped(arguments, [&](const Argument& argument) {
        return tuple({number(argument.u), number(argument.mass)});
    }));
}

/// (-1)^(n-N), times N^n where values at means are added, times the number of subsets that look alike.
Formula factor_formula(const SubsetRow& row, std::size_t n, bool points) {
    const std::size_t size = row.members.size();
    std::vector<Formula> factors{power(tuple({number(-1)}), number(n - size))};
    if (points) factors.push_back(power(number(size), number(n)));
    factors.insert(factors.end(), row.alike.begin(), row.alike.end());
    return product(std::move(factors));
}

Table polarization_table(const PolynomialCurve& curve, std::span<const SubsetRow> rows, bool points) {
    const std::size_t n = curve.degree();
    Table table{points ? "All subsets of the arguments, each with its mean."
                       : "All subsets of the arguments, each with its sum as a pair (u, v).",
                {"subset", points ? "mean" : "sum", points ? "value at the mean" : "form at the sum",
                 "factor", "term"},
                {}};
    for (const SubsetRow& row : rows) {
        const Rational size(row.members.size());
        const Rational at = points ? row.u / row.mass : row.u;
        const Rational mass = points ? Rational(1) : row.mass;
        const Coordinates value = form_value(curve, at, mass);
        const Rational factor = points ? row.weight * pow(size, n) : row.weight;
        Coordinates term = value;
        for (Rational& coordinate : term) coordinate *= factor;
        const Formula place = points ? number(at) : tuple({number(row.u), number(row.mass)});
        const Formula meaning = points ? call("P", {place}) : blossom_of("p", std::vector<Formula>(n, place));
        const Formula mean = fraction(sum(argument_formulas(row.members)), number(size));
        table.rows.push_back(
            {set_of(argument_formulas(row.members)), Cell(place, points ? mean : sum_of_pairs(row.members)),
             Cell(point_formula(value), meaning), Cell(number(factor), factor_formula(row, n, points)),
             Cell(point_formula(term), product({number(factor), meaning}))});
    }
    return table;
}

void append_polarization(Blocks& step, const GivenMap& given, std::span<const Argument> arguments,
                         const Coordinates& value, const Limits& limits) {
    const PolynomialCurve curve = monomial_form(given.map, limits);
    const std::size_t n = curve.degree();
    if (n == 0) {
        step.say("A constant has no arguments, and nothing to average.");
        return;
    }
    const bool points = all_points(arguments);
    const std::vector<SubsetRow> rows = subset_rows(arguments);
    step.say(
        points
            ? Text{"Only values of the map are used. Every subset of some ", symbol("N"),
                   " arguments contributes the value at its mean with the factor ",
                   product({power(tuple({number(-1)}), sum({number(n), product({number(-1), symbol("N")})})),
                            power(symbol("N"), number(n))}),
                   "; subsets that look alike are counted together."}
            : Text{"The map becomes the form F(u, v) of degree ", number(n), ", and every subset of some ",
                   symbol("N"), " arguments contributes the form at its sum with the sign ",
                   power(tuple({number(-1)}), sum({number(n), product({number(-1), symbol("N")})})),
                   "; subsets that look alike are counted together."});
    if (rows.size() > rows_written) {
        step.say({"The table would have ", number(rows.size()), " rows and is not written out."});
    } else {
        step.add(polarization_table(curve, rows, points));
    }
    Coordinates total = value;
    for (Rational& coordinate : total) coordinate *= Rational(factorial(n));
    const Formula times{product({factorial_of(number(n)), value_of_blossom(arguments)})};
    step.say({"The terms add up to ", equation({times, point_formula(total)}), ", and so"});
    step.show({equation({value_of_blossom(arguments),
                         product({fraction(number(1), factorial_of(number(n))), point_formula(total)}),
                         point_formula(value)})});
}

void append_casteljau(Blocks& step, const GivenMap& given, std::span<const Argument> arguments,
                      const Limits& limits) {
    const BezierCurve bezier = bezier_form(given.map, limits);
    step.say(
        {"Each level replaces one end of the interval ",
         interval_of(number(bezier.interval().a()), number(bezier.interval().b())),
         " by the next argument. On its arrows stand the coordinates of this argument in the interval: the "
         "weights with which the two neighbours are combined."});
    step.add(casteljau_triangle(bezier, arguments, "De Casteljau's pyramid.", limits));
    step.add_if(construction_picture(given.map, arguments, "The construction in the plane.", limits));
}

Check agreement_check(const Agreement<Coordinates>& values, const Formula& left) {
    Table table{"The value by each construction", {"construction", left}, {}};
    std::string skipped;
    for (const auto& result : values.results) {
        const std::string name(construction_name(result.construction));
        if (result.value) {
            table.rows.push_back({name.c_str(), Cell(point_formula(*result.value), left)});
        } else {
            skipped += " The construction " + name + " was not run: " + result.skipped + ".";
        }
    }
    return {
        {Paragraph{"The constructions share no computation, and give the same." + skipped}, std::move(table)},
        values.agree()};
}

}  // namespace

Document three_ways(const GivenMap& given, std::span<const Argument> arguments, const Limits& limits) {
    Document document =
        begun(given, "A blossom value in three ways",
              "Goldman, proposition 1 and figure 3; Fernández-Jambrina, corollary 1; DeRose, figure 6");
    const Agreement<Coordinates> values = agreement(given.map, arguments, limits);
    const Coordinates value = *values.results.front().value;
    const Formula left = value_of_blossom(arguments);
    document.statement.say({"Find the value ", left, " of its blossom."});
    append_symmetric(document.step("By elementary symmetric functions"), given, arguments, value, limits);
    append_polarization(document.step("By polarization"), given, arguments, value, limits);
    append_casteljau(document.step("By de Casteljau's algorithm, one argument per level"), given, arguments,
                     limits);
    document.result.show({equation({left, point_formula(value)})});
    document.check = agreement_check(values, left);
    return document;
}

}  // namespace blossom::worked
