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
        const Integer& top = argument.u.numerator();
        const Integer& bottom = argument.u.denominator();
        const std::int64_t u = top.word();
        const std::int64_t scale = bottom.word();
        if (!top.is_word() || !bottom.is_word() || u == least_word) return false;
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

    bool read_over_interval(std::int64_t u, std::int64_t mass, std::int64_t scale, WordFactor& factor) const;

    static constexpr std::int64_t least_word = std::numeric_limits<std::int64_t>::min();

    Kind kind_ = Kind::monomial;
    std::int64_t a_ = 0;  ///< with the signs that make b - a positive
    std::int64_t b_ = 0;
    std::int64_t q_ = 0;
    std::int64_t length_ = 0;
};

}  // namespace blossom
