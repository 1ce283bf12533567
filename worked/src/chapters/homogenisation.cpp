#include <blossom/core/blossom/agreement.hpp>
#include <blossom/core/constructions/constructions.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/lists.hpp>
#include <blossom/worked/chapters.hpp>

#include "curve_pictures.hpp"
#include "symbols.hpp"

namespace blossom::worked {

namespace {

using Symbolic = std::vector<SparsePolynomial>;

/// The greatest degree at which the 2^n terms are written.
constexpr std::size_t written_degree = 5;

/// Variables 0..n-1 are the parameters u, n..2n-1 the masses v.
std::vector<Formula> pair_symbols(std::size_t n) {
    std::vector<Formula> symbols = numbered_symbols("u", n);
    std::ranges::move(numbered_symbols("v", n), std::back_inserter(symbols));
    return symbols;
}

std::vector<Formula> pairs(std::size_t n) {
    std::vector<Formula> list;
    for (std::size_t i = 1; i <= n; ++i) {
        list.push_back(tuple({symbol("u" + std::to_string(i)), symbol("v" + std::to_string(i))}));
    }
    return list;
}

/// Every term of the multiaffine blossom, with v_i for each u_i that it lacks.
SparsePolynomial homogenised(const SparsePolynomial& blossom, std::size_t n) {
    SparsePolynomial result;
    for (std::size_t term = 0; term < blossom.size(); ++term) {
        std::vector<std::size_t> exponents(2 * n);
        for (std::size_t i = 0; i < n; ++i) {
            exponents[i] = blossom.exponent(term, i);
            exponents[n + i] = 1 - exponents[i];
        }
        result += SparsePolynomial::term(blossom.coefficient(term), exponents);
    }
    return result;
}

/// The polarization of the form sum c_k t^k w^(n-k), computed without the affine blossom.
SparsePolynomial polarized_form(const Polynomial& polynomial, std::size_t n) {
    std::vector<HomogeneousPair<SparsePolynomial>> arguments;
    arguments.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
        arguments.push_back({SparsePolynomial::variable(i), SparsePolynomial::variable(n + i)});
    }
    const auto form = [&](const HomogeneousPair<SparsePolynomial>& pair) {
        SparsePolynomial value;
        for (std::size_t k = 0; k <= polynomial.degree(); ++k) {
            value += SparsePolynomial(polynomial[k]) * pow(pair.u, k) * pow(pair.mass, n - k);
        }
        return std::vector<SparsePolynomial>{value};
    };
    const auto result = constructions::by_polarization<SparsePolynomial>(
        form, std::span<const HomogeneousPair<SparsePolynomial>>(arguments));
    return result.numerators.front() * SparsePolynomial(Rational(1, result.denominator));
}

/// The first half of the symbols are parameters, the others masses.
Formula parameters_first(const SparsePolynomial& polynomial, std::span<const Formula> symbols) {
    return sparse_formula(polynomial, symbols, (symbols.size() + 1) / 2);
}

Formula coordinates_formula(const Symbolic& coordinates, std::span<const Formula> symbols) {
    std::vector<Formula> formulas = mapped(coordinates, [&](const SparsePolynomial& coordinate) {
        return parameters_first(coordinate, symbols);
    });
    return formulas.size() == 1 ? formulas.front() : tuple(std::move(formulas));
}

/// P(t, w) = sum c_k t^k w^(n-k).
Formula form_equation(const PolynomialCurve& curve, const std::string& variable) {
    const std::size_t n = curve.degree();
    const std::vector<Formula> symbols{symbol(variable), symbol("w")};
    Symbolic coordinates;
    for (std::size_t j = 0; j < curve.dimension(); ++j) {
        SparsePolynomial form;
        for (std::size_t k = 0; k <= n; ++k) {
            form += SparsePolynomial::term(curve.coordinate(j)[k], std::vector<std::size_t>{k, n - k});
        }
        coordinates.push_back(std::move(form));
    }
    return equation({call("P", symbols), coordinates_formula(coordinates, symbols)});
}

/// The square: the map, its blossom, its form, the blossom of its form.
Table square(std::size_t n, const std::string& variable) {
    return {"The square: to the right blossom, downwards homogenise.",
            {"", "map", "blossom"},
            {{"affine", call("P", {symbol(variable)}), blossom_of("p", numbered_symbols("u", n))},
             {"homogeneous", call("P", {symbol(variable), symbol("w")}), blossom_of("p", pairs(n))}}};
}

/// t^k as a map of degree n in the four corners, as in Goldman, figure 4.
Table monomials(std::size_t n, const std::string& variable) {
    Table table{"The monomials in the four corners of the square.",
                {"map", "blossom", "form", "blossom of the form"},
                {}};
    const std::vector<Formula> symbols = pair_symbols(n);
    for (std::size_t k = 0; k <= n; ++k) {
        SparsePolynomial blossom;
        const Rational weight = Rational(1) / Rational(binomial(n, k));
        for (const auto& subset : subsets_of_size(n, k)) {
            std::vector<std::size_t> exponents(n);
            for (const std::size_t i : subset) exponents[i] = 1;
            blossom += SparsePolynomial::term(weight, exponents);
        }
        const std::vector<Formula> tw{symbol(variable), symbol("w")};
        const SparsePolynomial form = SparsePolynomial::term(1, std::vector<std::size_t>{k, n - k});
        const auto mean_of = [&](const std::vector<Formula>& arguments) {
            return fraction(elementary(k, arguments), binomial_of(number(n), number(k)));
        };
        const Formula power_of_variable = power(tw[0], number(k));
        table.rows.push_back(
            {Cell(k == 0 ? number(1) : power_of_variable, power_of_variable),
             Cell(parameters_first(blossom, symbols), mean_of(numbered_symbols("u", n))),
             Cell(parameters_first(form, tw), product({power_of_variable, power(tw[1], number(n - k))})),
             Cell(parameters_first(homogenised(blossom, n), symbols), mean_of(pairs(n)))});
    }
    return table;
}

}  // namespace

Document homogenisation(const GivenMap& given, const Limits& limits) {
    const PolynomialCurve curve = monomial_form(given.map, limits);
    const std::size_t n = curve.degree();
    Document document = begun({curve, given.variable}, "Blossoming and homogenising commute",
                              "Goldman, figures 4 and 5, theorem 6");
    require_within(n, written_degree, "degree of a page with all arguments", "formal degree");
    document.statement.say("Find its blossom for all arguments, points and vectors alike.");
    document.statement.add(square(n, given.variable));

    const auto affine = agreement_for_all_arguments(curve, limits);
    const Symbolic& blossom = *affine.results.front().value;
    Symbolic first;
    Symbolic second;
    for (std::size_t j = 0; j < blossom.size(); ++j) {
        first.push_back(homogenised(blossom[j], n));
        second.push_back(polarized_form(curve.coordinate(j), n));
    }
    const std::vector<Formula> symbols = pair_symbols(n);
    document.step("Blossom, then homogenise")
        .say("The blossom of the map, one argument in place of each parameter:")
        .show({equation({blossom_of("p", numbered_symbols("u", n)), coordinates_formula(blossom, symbols)})})
        .say({"Each argument becomes a pair ", tuple({symbol("u"), symbol("v")}), "; a mass ", symbol("v"),
              " of 1 makes it the point ", symbol("u"), ", a mass of 0 a vector. A term gets the ",
              symbol("v"), " of every argument whose ", symbol("u"), " it lacks:"})
        .show({equation({blossom_of("p", pairs(n)), coordinates_formula(first, symbols)})});
    document.step("Homogenise, then blossom")
        .say("The map as a form, every term of the same degree:")
        .show({form_equation(curve, given.variable)})
        .say("Its polarization, the alternating sum of the form at all sums of pairs:")
        .show({equation({blossom_of("p", pairs(n)), coordinates_formula(second, symbols)})});
    if (n <= 3) {
        document.step("The same for the monomials")
            .say("Every map of this degree is a combination of these:")
            .add(monomials(n, given.variable));
    }
    document.result.show({equation({blossom_of("p", pairs(n)), coordinates_formula(first, symbols)})});
    document.check = {
        {Paragraph{"Both ways round the square give the same polynomial in all arguments, and the "
                   "three constructions of the blossom agree for all of them."}},
        first == second && affine.agree()};
    return document;
}

}  // namespace blossom::worked
