#include "polynomial_merging.hpp"

#include <blossom/rational/combinatorics.hpp>

#include <algorithm>
#include <numeric>

namespace blossom::proofs::second {

namespace {

/// The terms `begin` to `end` of the first factor times the second factor, by merging halves.
PlainPolynomial merged_product(const PlainPolynomial& a, std::size_t begin, std::size_t end,
                               const PlainPolynomial& b, Budget& budget) {
    using Parts = PolynomialParts;
    const auto shifted = [&](std::size_t term) {
        return ShiftedTerms{b, a.monomial(term), Parts::coefficients(a)[term]};
    };
    if (end - begin == 1) {
        const PlainPolynomial nothing = Parts::empty(Parts::bits(b), b.width(), 0);
        return merged_terms(shifted(begin), {nothing, a.monomial(begin), Parts::coefficients(a)[begin]},
                            budget);
    }
    if (end - begin == 2) return merged_terms(shifted(begin), shifted(begin + 1), budget);
    const std::size_t middle = begin + (end - begin) / 2;
    const PlainPolynomial left = merged_product(a, begin, middle, b, budget);
    const PlainPolynomial right = merged_product(a, middle, end, b, budget);
    const std::vector<std::uint64_t> unshifted(b.width());
    const Integer one = 1;
    return merged_terms({left, unshifted.data(), one}, {right, unshifted.data(), one}, budget);
}

/// Sums of terms in a hash table with open addressing, by their monomials.
class TermTable {
public:
    TermTable(unsigned bits, std::size_t width, Budget& budget)
        : terms_(PolynomialParts::empty(bits, width, 0)), budget_(budget), slots_(1024, no_term) {}

    void add_product(const std::uint64_t* monomial, const Integer& a, const Integer& b) {
        std::vector<Integer>& coefficients = PolynomialParts::coefficients(terms_);
        std::size_t slot = slot_of(monomial);
        while (slots_[slot] != no_term) {
            if (compared_monomials(terms_.monomial(slots_[slot]), monomial, terms_.width()) == 0) {
                coefficients[slots_[slot]].add_product(a, b);
                return;
            }
            budget_.spend(1);
            slot = (slot + 1) & (slots_.size() - 1);
        }
        slots_[slot] = static_cast<std::uint32_t>(coefficients.size());
        PolynomialParts::append(terms_, monomial, a * b);
        if (coefficients.size() * 2 > slots_.size()) grow();
    }

    /// The nonzero terms, in order.
    PlainPolynomial sorted() {
        const std::size_t width = terms_.width();
        std::vector<Integer>& coefficients = PolynomialParts::coefficients(terms_);
        std::vector<std::uint32_t> order;
        for (std::uint32_t k = 0; k < coefficients.size(); ++k) {
            if (!coefficients[k].is_zero()) order.push_back(k);
        }
        std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
            return compared_monomials(terms_.monomial(a), terms_.monomial(b), width) > 0;
        });
        PlainPolynomial result = PolynomialParts::empty(PolynomialParts::bits(terms_), width, 0);
        PolynomialParts::monomials(result).reserve(order.size() * width);
        PolynomialParts::coefficients(result).reserve(order.size());
        for (const std::uint32_t k : order) {
            PolynomialParts::append(result, terms_.monomial(k), std::move(coefficients[k]));
        }
        return result;
    }

private:
    static constexpr std::uint32_t no_term = ~std::uint32_t{0};

    std::size_t slot_of(const std::uint64_t* monomial) const {
        std::uint64_t mixed = 0;
        for (std::size_t k = 0; k < terms_.width(); ++k) {
            mixed = (mixed ^ monomial[k]) * 0x9E3779B97F4A7C15;
            mixed ^= mixed >> 29;
        }
        return static_cast<std::size_t>(mixed) & (slots_.size() - 1);
    }

    void grow() {
        budget_.require_terms(terms_.size(), terms_.width());
        slots_.assign(slots_.size() * 4, no_term);
        for (std::uint32_t k = 0; k < terms_.size(); ++k) {
            std::size_t slot = slot_of(terms_.monomial(k));
            while (slots_[slot] != no_term) slot = (slot + 1) & (slots_.size() - 1);
            slots_[slot] = k;
        }
    }

    PlainPolynomial terms_;
    Budget& budget_;
    std::vector<std::uint32_t> slots_;
};

PlainPolynomial collected_product(const PlainPolynomial& a, const PlainPolynomial& b, Budget& budget) {
    using Parts = PolynomialParts;
    TermTable table(Parts::bits(a), a.width(), budget);
    std::vector<std::uint64_t> monomial(a.width());
    for (std::size_t i = 0; i < a.size(); ++i) {
        budget.spend(b.size());
        for (std::size_t j = 0; j < b.size(); ++j) {
            for (std::size_t k = 0; k < a.width(); ++k) monomial[k] = a.monomial(i)[k] + b.monomial(j)[k];
            table.add_product(monomial.data(), Parts::coefficients(a)[i], Parts::coefficients(b)[j]);
        }
    }
    return table.sorted();
}

}  // namespace

PlainPolynomial product(const PlainPolynomial& a, const PlainPolynomial& b, Budget& budget) {
    if (a.is_zero() || b.is_zero()) return {};
    if (a.is_number()) return scaled(b, a.number(), budget);
    if (b.is_number()) return scaled(a, b.number(), budget);
    if (a.size() > b.size()) return product(b, a, budget);
    constexpr std::size_t merged_up_to = 12;  // terms of the shorter factor (by measurement)
    const AlignedPolynomials both(a, b, true, budget);
    PlainPolynomial result = a.size() <= merged_up_to
                                 ? merged_product(both.first(), 0, a.size(), both.second(), budget)
                                 : collected_product(both.first(), both.second(), budget);
    budget.require_terms(result.size(), result.width());
    PolynomialParts::denominator(result) = PolynomialParts::denominator(a) * PolynomialParts::denominator(b);
    PolynomialParts::set_largest(result, both.largest());
    PolynomialParts::spend_on_bits(result, budget);
    PolynomialParts::reduce(result);
    return result;
}

namespace {

/// (c_1 x_1 + ... + c_m x_m + c_0)^n by the multinomial theorem, which gives its terms in order.
class MultinomialPower {
public:
    MultinomialPower(const PlainPolynomial& base, std::size_t exponent, Budget& budget)
        : base_(base), budget_(budget), monomial_(base.width()) {
        for (std::size_t k = 0; k <= exponent; ++k) binomials_.push_back(binomial_row(k));
        for (const Integer& coefficient : PolynomialParts::coefficients(base)) {
            std::vector<Integer>& powers = powers_.emplace_back(1, 1);
            while (powers.size() <= exponent) powers.push_back(powers.back() * coefficient);
        }
    }

    PlainPolynomial result(std::size_t exponent) {
        result_ = PolynomialParts::empty(PolynomialParts::bits(base_), base_.width(), exponent);
        expand(0, exponent, 1);
        PolynomialParts::denominator(result_) = pow(PolynomialParts::denominator(base_), exponent);
        PolynomialParts::reduce(result_);
        return std::move(result_);
    }

private:
    void expand(std::size_t term, std::size_t rest, const Integer& factor) {
        const bool last = term + 1 == base_.size();
        for (std::size_t exponent = rest + 1; exponent-- > (last ? rest : 0);) {
            add(term, exponent);
            const Integer next = factor * binomials_[rest][exponent] * powers_[term][exponent];
            if (last) {
                budget_.spend(1);
                budget_.require_terms(result_.size() + 1, base_.width());
                PolynomialParts::append(result_, monomial_.data(), next);
            } else {
                expand(term + 1, rest - exponent, next);
            }
            add(term, -std::uint64_t{exponent});
        }
    }

    void add(std::size_t term, std::uint64_t times) {
        for (std::size_t k = 0; k < monomial_.size(); ++k) monomial_[k] += times * base_.monomial(term)[k];
    }

    const PlainPolynomial& base_;
    Budget& budget_;
    std::vector<std::uint64_t> monomial_;
    std::vector<std::vector<Integer>> binomials_;
    std::vector<std::vector<Integer>> powers_;  ///< the powers of the coefficients
    PlainPolynomial result_;
};

/// Whether the terms are multiples of different symbols; the last may be a number.
bool is_sum_of_symbols(const PlainPolynomial& a) {
    const std::vector<std::size_t> symbols = a.symbols();
    const std::size_t with_symbols = a.size() > 0 && symbols.size() + 1 == a.size() ? a.size() - 1 : a.size();
    if (symbols.size() != with_symbols) return false;
    for (std::size_t k = 0; k < with_symbols; ++k) {
        if (a.exponent(k, symbols[k]) != 1 || a.degree(symbols[k]) != 1) return false;
    }
    // Each term begins with a symbol of its own, and no term has two symbols.
    std::size_t occurrences = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        for (const std::size_t symbol : symbols) occurrences += a.exponent(k, symbol);
    }
    return occurrences == with_symbols;
}

}  // namespace

PlainPolynomial power(const PlainPolynomial& a, std::size_t exponent, Budget& budget) {
    if (exponent == 0) return PlainPolynomial(1);
    if (exponent == 1 || a.is_zero()) return a;
    const std::size_t bits = std::max(PolynomialParts::coefficients(a).front().bit_length(),
                                      PolynomialParts::denominator(a).bit_length());
    if (bits > 1 || !a.is_number()) budget.spend_on_bits(bits * exponent, 1);
    if (a.is_number()) return PlainPolynomial(pow(a.number(), exponent));
    constexpr std::size_t fields_end = 128;
    constexpr std::size_t greatest_depth = 64;  // of the recursion
    if (exponent > 2 && a.size() > 1 && a.size() <= greatest_depth && exponent < fields_end &&
        is_sum_of_symbols(a)) {
        return MultinomialPower(a, exponent, budget).result(exponent);
    }
    if (a.size() == 1) {
        const PlainPolynomial half = power(a, exponent / 2, budget);
        const PlainPolynomial square = product(half, half, budget);
        return exponent % 2 == 0 ? square : product(square, a, budget);
    }
    PlainPolynomial result = a;
    for (std::size_t k = 1; k < exponent; ++k) result = product(result, a, budget);
    return result;
}

}  // namespace blossom::proofs::second
