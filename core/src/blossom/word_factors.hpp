#pragma once

// Reads arguments of a blossom as linear factors in machine words, without a common multiple or a reduction.

#include <blossom/core/maps/argument.hpp>
#include <blossom/rational/blossom_sums.hpp>

#include <limits>
#include <span>

#include "maps/integer_frame.hpp"

namespace blossom {

/// The frame of the factors: monomial coefficients, where (u, v) gives v + u X, or control points over [a/q,
/// b/q], where it gives (b v - q u) + (q u - a v) X over b - a.
class WordFrame {
public:
    /// The frame of monomial coefficients.
    WordFrame() = default;
    explicit WordFrame(const ClearedInterval& interval);

    bool is_monomial() const { return kind_ == Kind::monomial; }
    bool is_beyond_words() const { return kind_ == Kind::beyond_words; }
    /// The line to which factors over monomial coefficients are moved; null if they are not moved.
    const WordLine* line() const { return kind_ == Kind::interval ? &line_ : nullptr; }

    /// Reads the factors of arguments of mass 0 or 1, one per argument. Returns whether words hold all of
    /// them; otherwise the factors are unspecified.
    bool read(std::span<const Argument> arguments, WordFactor* factors) const {
        if (kind_ == Kind::beyond_words) return false;
        for (std::size_t i = 0; i < arguments.size(); ++i)
            if (!read_factor(arguments[i].u, arguments[i].mass, factors[i])) return false;
        return kind_ == Kind::monomial || move_to_interval({factors, arguments.size()});
    }

private:
    enum class Kind { monomial, interval, beyond_words };

    /// Moves factors over monomial coefficients to the interval.
    bool move_to_interval(std::span<WordFactor> factors) const;

    static constexpr std::int64_t least_word = std::numeric_limits<std::int64_t>::min();

    Kind kind_ = Kind::monomial;
    WordLine line_{};  ///< with signs for which b - a is positive
};

}  // namespace blossom
