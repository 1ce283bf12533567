#include <blossom/rational/integer_polynomials.hpp>
#include <blossom/rational/resource_budget.hpp>

#include <algorithm>

#include "prime_images.hpp"

namespace blossom {

namespace {

std::uint64_t difference(const PrimeField& field, std::uint64_t a, std::uint64_t b) {
    return field.sum(a, b == 0 ? 0 : field.prime() - b);
}

/// The resultant of polynomials of formal degrees a.size() - 1 and b.size() - 1, whose leading coefficients
/// may be 0.
std::uint64_t resultant_in(const PrimeField& field, WordList a, WordList b) {
    std::uint64_t result = 1;
    const auto multiply = [&](std::uint64_t factor, bool negative) {
        result = field.product(result, negative ? difference(field, 0, factor) : factor);
    };
    while (a.size() > 1 && b.size() > 1) {
        const bool odd = (b.size() - 1) % 2 == 1;
        if (a.back() == 0) {
            // The first column of Sylvester's matrix holds the leading coefficient of b only.
            multiply(b.back(), odd);
            a.pop_back();
        } else if (b.back() == 0) {
            multiply(a.back(), false);
            b.pop_back();
        } else if (a.size() < b.size()) {
            multiply(1, odd && a.size() % 2 == 0);
            std::swap(a, b);
        } else {
            const std::uint64_t inverse = field.inverse(b.back());
            while (a.size() >= b.size()) {
                const std::uint64_t factor = field.product(a.back(), inverse);
                const std::size_t shift = a.size() - b.size();
                for (std::size_t k = 0; k + 1 < b.size(); ++k)
                    a[shift + k] = difference(field, a[shift + k], field.product(factor, b[k]));
                multiply(b.back(), odd);
                a.pop_back();
            }
        }
        if (result == 0) return 0;
    }
    const auto& constant = a.size() == 1 ? a : b;
    const auto& other = a.size() == 1 ? b : a;
    return field.product(result, field.power(constant.front(), other.size() - 1));
}

/// The coefficients of the polynomial that has these values at 0, 1, 2, ...
WordList interpolated(const PrimeField& field, WordList values) {
    const std::size_t n = values.size();
    WordList inverses(n, 1);
    for (std::size_t k = 2; k < n; ++k) inverses[k] = field.inverse(k);
    for (std::size_t k = 1; k < n; ++k) {
        for (std::size_t i = n - 1; i >= k; --i)
            values[i] = field.product(difference(field, values[i], values[i - 1]), inverses[k]);
    }
    // Horner's rule in Newton's form: p = p (s - k) + values[k].
    for (std::size_t k = n - 1; k-- > 0;) {
        for (std::size_t i = k; i + 1 < n; ++i)
            values[i] = difference(field, values[i], field.product(k, values[i + 1]));
    }
    return values;
}

using Rows = std::span<const IntegerPolynomial>;

/// The degree in s.
std::size_t inner_degree(Rows rows) {
    std::size_t most = 1;
    for (const IntegerPolynomial& row : rows) most = std::max(most, row.size());
    return most - 1;
}

std::size_t bits_of_norm(Rows rows) {
    Integer sum;
    for (const IntegerPolynomial& row : rows) {
        for (const Integer& coefficient : row) sum += abs(coefficient);
    }
    return sum.bit_length();
}

class Image {
public:
    Image(Rows rows, const PrimeField& field) : field_(field) {
        for (const IntegerPolynomial& row : rows) rows_.push_back(words_of(row, field));
    }
    /// The polynomial in t at s.
    WordList at(std::uint64_t s) const {
        WordList values;
        values.reserve(rows_.size());
        for (const WordList& row : rows_) {
            std::uint64_t value = 0;
            for (std::size_t k = row.size(); k-- > 0;) value = field_.sum(field_.product(value, s), row[k]);
            values.push_back(value);
        }
        return values;
    }

private:
    const PrimeField& field_;
    std::vector<WordList> rows_;
};

}  // namespace

IntegerPolynomial resultant(Rows f, Rows g) {
    if (f.empty() || g.empty()) return {};
    const std::size_t m = f.size() - 1;
    const std::size_t n = g.size() - 1;
    const std::size_t degree = n * inner_degree(f) + m * inner_degree(g);
    const std::size_t bits = n * bits_of_norm(f) + m * bits_of_norm(g) + 1;
    Combination combination;
    for (std::uint64_t prime = prime_below(primes_end); combination.modulus().bit_length() <= bits + 1;
         prime = prime_below(prime)) {
        const PrimeField field(prime);
        const Image first(f, field);
        const Image second(g, field);
        constexpr std::size_t words_of_step = 4;
        spend_work(
            words_of_step * (degree + 1) *
            ((m + 1) * (n + 1) + (m + 1) * (inner_degree(f) + 1) + (n + 1) * (inner_degree(g) + 1) + degree));
        WordList values;
        for (std::uint64_t s = 0; s <= degree; ++s)
            values.push_back(resultant_in(field, first.at(s), second.at(s)));
        combination.add(interpolated(field, std::move(values)), field);
    }
    IntegerPolynomial result = combination.values();
    while (!result.empty() && result.back().is_zero()) result.pop_back();
    return result;
}

}  // namespace blossom
