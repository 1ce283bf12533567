#pragma once

// The data that PreparedPolynomial keeps about its rows.

#include <blossom/rational/made_once.hpp>
#include <blossom/rational/prepared_polynomial.hpp>

#include <atomic>
#include <deque>
#include <vector>

#include "evaluation_by_halves.hpp"
#include "form_limbs.hpp"
#include "number/uint128.hpp"
#include "quotients/small_primes.hpp"

namespace blossom {

/// The odd primes of the table that divide a number, and its cofactor with the other primes; 0 for 0.
struct PrimeParts {
    explicit PrimeParts(const Integer& value);

    small_primes::Set primes = 0;
    Integer rest = 1;
    std::uint64_t rest_word = 1;  ///< `rest` as a word; 0 if it is not one

    /// Whether the rest and a word v > 0 have a prime in common.
    bool shares_prime_with(std::uint64_t v) const {
        if (rest_word == 1 || v < 2 + small_primes::table.primes[small_primes::count - 1].prime) return false;
        if (rest_word != 0) return gcd_of_words(rest_word % v, v) != 1;
        return !gcd(rest, Integer(v)).is_one();
    }
};

/// One row of coefficients over the common denominator.
class FormRow {
public:
    FormRow(std::span<const Integer> coefficients, std::span<const std::int64_t> words,
            const Integer& denominator);

    const std::span<const std::int64_t> words;  ///< empty unless all numbers are words
    const PrimeParts greatest;                  ///< of the largest coefficient
    const FormLimbs limbs;

    Rational value_by_halves(const Integer& u, const Integer& v) const;

private:
    const std::span<const Integer> coefficients_;
    const Integer& denominator_;
    // The number of evaluations so far: preparation begins when it would have paid for itself.
    mutable std::atomic<std::size_t> evaluations_ = 0;
    MadeOnce<EvaluationByHalves> plain_;
    MadeOnce<EvaluationByHalves> prepared_;
};

struct PreparedPolynomial::Forms {
    Forms(RationalVector numbers, std::size_t row_count);

    RationalVector numbers;
    std::size_t degree;
    std::size_t sum_bits;  ///< of (n + 1) max |C_k|
    std::vector<std::int64_t> words;
    std::uint64_t word_denominator = 0;       ///< the denominator if it is a word, otherwise 0
    std::vector<std::uint64_t> denominators;  ///< its factors if all of them are words, otherwise empty
    small_primes::Set denominator_primes = 0;
    std::deque<FormRow> rows;
};

}  // namespace blossom
