// Forms at sums of terms, written term by term in order.

#include <blossom/core/algebra/sparse_polynomial.hpp>
#include <blossom/core/constructions/constructions.hpp>

#include "each_case.hpp"
#include "support/map_generators.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

Rational coefficient(Random& random) {
    return random.one_in(3) ? Rational(1) : number(random, random.one_in(8) ? Size::any : Size::small);
}

/// Up to 7 terms, each with a variable that no later term has, and sometimes a constant; in a quarter of the
/// cases the terms may share variables.
SparsePolynomial sum_of_terms(Random& random) {
    const bool independent = !random.one_in(4);
    SparsePolynomial sum;
    std::size_t variable = 0;
    for (std::size_t i = random.below(7); i > 0; --i) {
        variable = independent ? variable + random.below(3) : random.below(6);
        std::vector<std::size_t> exponents(variable);
        exponents.push_back(1 + (random.one_in(4) ? random.below(20) : 0));
        if (random.one_in(3)) exponents.resize(exponents.size() + 2, random.below(2));
        sum += SparsePolynomial::term(coefficient(random), exponents);
        ++variable;
    }
    return random.one_in(3) ? sum + SparsePolynomial(coefficient(random)) : sum;
}

}  // namespace

TEST_CASE("forms at sums of terms: in order and by Horner's rule", "[differential]") {
    each_case("forms at sums of terms", [&](Random& random) {
        const SparsePolynomial x = sum_of_terms(random);
        const SparsePolynomial y =
            random.one_in(8) ? sum_of_terms(random) : SparsePolynomial(coefficient(random));
        std::vector<SparsePolynomial> coefficients;
        for (std::size_t k = random.below(7) + 1; k > 0; --k) {
            const bool zero = random.one_in(3);
            coefficients.push_back(zero ? SparsePolynomial() : SparsePolynomial(coefficient(random)));
        }
        if (random.one_in(8)) coefficients.back() = sum_of_terms(random);
        const std::span<const SparsePolynomial> all(coefficients);
        count_as(has_independent_terms(x) && !x.is_zero() ? "of independent terms" : "of other terms");
        CHECK(form_value(all, x, y) == constructions::form_value<SparsePolynomial>(all, x, y));
        CHECK(polynomial_value(all, x) == constructions::polynomial_value<SparsePolynomial>(all, x));
    });
}
