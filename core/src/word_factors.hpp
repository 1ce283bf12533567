#pragma once

// Arguments of a blossom as linear factors in machine words, read without a common multiple or a reduction.

#include <blossom/core/argument.hpp>
#include <blossom/rational/linear_factor_sums.hpp>

#include <algorithm>
#include <limits>

#include "integer_frame.hpp"

namespace blossom {

/// What the factors of arguments are taken over: monomial coefficients, for which (u, v) gives v + u X, or
/// control points over [a/q, b/q], for which it gives (b v - q u) + (q u - a v) X over b - a.
class WordFrame {
public:
    /// Monomial coefficients.
    WordFrame() = default;
    explicit WordFrame(const ClearedInterval& interval);

    /// The factor of an argument of mass 0 or 1, if words hold it; otherwise `factor` is left in between.
    bool read(const Argument& argument, WordFactor& factor) const {
        if (!is_word_fraction(argument.u)) return false;
        const std::int64_t u = *argument.u.numerator().to_int64();
        const std::int64_t scale = *argument.u.denominator().to_int64();
        const bool point = argument.mass.numerator().is_one() && argument.mass.is_integer();
        if (!point && !argument.mass.is_zero()) return false;
        const std::int64_t mass = point ? scale : 0;
        if (kind_ == Kind::monomial) {
            factor = {mass, u, scale};
            return true;
        }
        return kind_ == Kind::interval && read_over_interval(u, mass, scale, factor);
    }

private:
    enum class Kind { monomial, interval, beyond_words };

    static bool is_word(const Integer& value) { return value.to_int64().value_or(least_word) != least_word; }
    static bool is_word_fraction(const Rational& value) {
        return is_word(value.numerator()) && is_word(value.denominator());
    }
    bool read_over_interval(std::int64_t u, std::int64_t mass, std::int64_t scale, WordFactor& factor) const;

    static constexpr std::int64_t least_word = std::numeric_limits<std::int64_t>::min();

    Kind kind_ = Kind::monomial;
    std::int64_t a_ = 0;  ///< with the signs that make b - a positive
    std::int64_t b_ = 0;
    std::int64_t q_ = 0;
    std::int64_t length_ = 0;
};

}  // namespace blossom
