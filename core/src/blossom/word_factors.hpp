#pragma once

// Arguments of a blossom as linear factors in machine words, read without a common multiple or a reduction.

#include <blossom/core/maps/argument.hpp>
#include <blossom/rational/blossom_sums.hpp>

#include <limits>
#include <span>

#include "maps/integer_frame.hpp"

namespace blossom {

/// What the factors of arguments are taken over: monomial coefficients, for which (u, v) gives v + u X, or
/// control points over [a/q, b/q], for which it gives (b v - q u) + (q u - a v) X over b - a.
class WordFrame {
public:
    /// Monomial coefficients.
    WordFrame() = default;
    explicit WordFrame(const ClearedInterval& interval);

    bool is_monomial() const { return kind_ == Kind::monomial; }
    bool is_beyond_words() const { return kind_ == Kind::beyond_words; }
    /// What factors over monomial coefficients are moved to; null if they stay as they are.
    const WordLine* line() const { return kind_ == Kind::interval ? &line_ : nullptr; }

    /// The factors of arguments of mass 0 or 1, as many as there are arguments, if words hold them all;
    /// otherwise the factors are left in between.
    bool read(std::span<const Argument> arguments, WordFactor* factors) const {
        if (kind_ == Kind::beyond_words) return false;
        for (std::size_t i = 0; i < arguments.size(); ++i)
            if (!read_factor(arguments[i].u, arguments[i].mass, factors[i])) return false;
        return kind_ == Kind::monomial || move_to_interval({factors, arguments.size()});
    }

private:
    enum class Kind { monomial, interval, beyond_words };

    /// From factors over monomial coefficients.
    bool move_to_interval(std::span<WordFactor> factors) const;

    static constexpr std::int64_t least_word = std::numeric_limits<std::int64_t>::min();

    Kind kind_ = Kind::monomial;
    WordLine line_{};  ///< with the signs that make b - a positive
};

}  // namespace blossom
