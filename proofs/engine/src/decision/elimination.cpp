#include "elimination.hpp"

#include <blossom/rational/error.hpp>

#include <algorithm>
#include <map>

namespace blossom::proofs {

namespace {

std::vector<std::size_t> exponents_of(const SparsePolynomial& polynomial, std::size_t term) {
    std::vector<std::size_t> exponents(polynomial.variables());
    for (std::size_t i = 0; i < exponents.size(); ++i) exponents[i] = polynomial.exponent(term, i);
    return exponents;
}

/// The coefficients of a polynomial by monomials in the `variables`, which are universal.
std::vector<SparsePolynomial> coefficients_by_monomials(const SparsePolynomial& polynomial,
                                                        const std::vector<std::size_t>& variables) {
    std::map<std::vector<std::size_t>, std::vector<SparsePolynomial>> terms;
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        std::vector<std::size_t> exponents = exponents_of(polynomial, i);
        std::vector<std::size_t> key;
        for (const std::size_t variable : variables) {
            key.push_back(polynomial.exponent(i, variable));
            if (variable < exponents.size()) exponents[variable] = 0;
        }
        terms[key].push_back(SparsePolynomial::term(polynomial.coefficient(i), exponents));
    }
    std::vector<SparsePolynomial> result;
    result.reserve(terms.size());
    for (const auto& [key, summands] : terms) result.push_back(sum(summands));
    return result;
}

}  // namespace

std::vector<SparsePolynomial> coefficients_in(const SparsePolynomial& polynomial, std::size_t variable) {
    std::vector<std::vector<SparsePolynomial>> terms(polynomial.degree_in(variable) + 1);
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        std::vector<std::size_t> exponents = exponents_of(polynomial, i);
        const std::size_t power = polynomial.exponent(i, variable);
        if (variable < exponents.size()) exponents[variable] = 0;
        terms[power].push_back(SparsePolynomial::term(polynomial.coefficient(i), exponents));
    }
    std::vector<SparsePolynomial> result;
    result.reserve(terms.size());
    for (const auto& summands : terms) result.push_back(sum(summands));
    return result;
}

void Elimination::solve() {
    for (const Relation& assumption : block_.assumptions) assume(assumption);
    struct Equation {
        SparsePolynomial polynomial;
        std::size_t offset;
        bool has_coefficients;
    };
    std::vector<Equation> equations;
    for (const Relation& hypothesis : block_.hypotheses) {
        const Fraction difference =
            expander_.field().difference(expander_(hypothesis.left), expander_(hypothesis.right));
        for (SparsePolynomial& equation : coefficients_by_monomials(difference.numerator, hypothesis.quantified)) {
            bool has_coefficients = false;
            for (std::size_t i = 0; i < equation.variables(); ++i) {
                has_coefficients =
                    has_coefficients || (equation.degree_in(i) > 0 && block_.symbols[i].is_coefficient);
            }
            equations.push_back({std::move(equation), hypothesis.offset, has_coefficients});
        }
    }
    // Relations between numbers first: they may occur in the coefficients of the others.
    std::ranges::stable_partition(equations, [](const Equation& e) { return !e.has_coefficients; });
    for (const Equation& equation : equations) use(equation.polynomial, equation.offset);
}

void Elimination::assume(const Relation& relation) {
    const Fraction difference =
        expander_.field().difference(expander_(relation.left), expander_(relation.right));
    if (difference.is_zero()) {
        throw Error(ErrorCode::syntax, "this condition can never hold: the two sides are equal", "",
                    relation.offset);
    }
    for (const auto& [factor, exponent] : expander_.field().factorise(difference.numerator).factors)
        assumed_.insert(factor);
}

void Elimination::use(const SparsePolynomial& equation, std::size_t offset) {
    const SparsePolynomial rest = reduced(equation);
    if (rest.is_zero()) return;
    // The best symbol to solve for is a coefficient of a map whose own coefficient is a number; then one
    // whose coefficient is known not to vanish; then the one with the smallest coefficient.
    struct Candidate {
        bool scalar;
        std::size_t size;
        std::size_t symbol;
        SparsePolynomial cofactor;
    };
    std::optional<Candidate> best;
    for (std::size_t i = rest.variables(); i-- > 0;) {
        if (rest.degree_in(i) != 1) continue;
        SparsePolynomial cofactor = coefficients_in(rest, i)[1];
        std::size_t size = 0;
        for (const auto& [factor, exponent] : expander_.field().factorise(cofactor).factors) {
            if (!assumed_.contains(factor)) size += expander_.field().factors()[factor].size();
        }
        const bool scalar = !block_.symbols[i].is_coefficient;
        if (!best || std::pair(scalar, size) < std::pair(best->scalar, best->size)) {
            best = Candidate{scalar, size, i, std::move(cofactor)};
        }
    }
    if (!best) {
        const bool constant = rest.total_degree() == 0;
        throw Error(ErrorCode::syntax,
                    constant ? "the hypotheses contradict each other"
                             : "this hypothesis is not linear in the values of the maps or in a variable",
                    "", offset);
    }
    for (const auto& [factor, exponent] : expander_.field().factorise(best->cofactor).factors)
        conditions_.insert(factor);
    const SparsePolynomial without = coefficients_in(rest, best->symbol)[0];
    solutions_.push_back({best->symbol, -without, best->cofactor});
}

SparsePolynomial Elimination::reduced(SparsePolynomial polynomial) {
    FractionField& field = expander_.field();
    for (const Solution& solution : solutions_) {
        if (polynomial.degree_in(solution.symbol) == 0) continue;
        // sum p_k s^k with s = N/D, times D^d: Horner's rule from above with the powers of D.
        const auto powers = coefficients_in(polynomial, solution.symbol);
        SparsePolynomial value = powers.back();
        SparsePolynomial scale = 1;
        for (std::size_t k = powers.size() - 1; k-- > 0;) {
            scale = field.product(scale, solution.denominator);
            value = field.product(value, solution.numerator) + field.product(powers[k], scale);
        }
        polynomial = std::move(value);
    }
    return polynomial;
}

}  // namespace blossom::proofs
