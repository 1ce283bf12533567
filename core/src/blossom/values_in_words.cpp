#include "values_in_words.hpp"

#include <blossom/rational/combinatorics.hpp>

#include <array>

#include "run_construction.hpp"
#include "word_factors.hpp"

namespace blossom {

namespace {

/// The greatest degree for which this pays; the binomials and their least common multiple are words.
constexpr std::size_t most_factors = 40;

/// A bound on the bits of every numerator and denominator computed here, far above the actual sizes.
constexpr std::size_t most_bits = 64 * (most_factors + 4);

/// lcm_k C(n, k) / C(n, k) for all k, followed by the least common multiple.
using Weights = std::array<std::int64_t, most_factors + 2>;

std::span<const std::int64_t> binomial_weights(std::size_t n) {
    static const auto table = [] {
        std::array<Weights, most_factors + 1> weights{};
        for (std::size_t degree = 0; degree <= most_factors; ++degree) {
            const Integer multiple = binomial_row_lcm(degree);
            const std::vector<Integer> binomials = binomial_row(degree);
            for (std::size_t k = 0; k <= degree; ++k)
                weights[degree][k] = *divide_exactly(multiple, binomials[k]).to_int64();
            weights[degree][degree + 1] = *multiple.to_int64();
        }
        return weights;
    }();
    return std::span(table[n]).first(n + 2);
}

// Elements that are not read stay uninitialized.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
struct Factors {
    WordFactor words[most_factors];
    std::size_t size = 0;
    std::span<const WordFactor> span() const { return {words, size}; }
};

bool read(const WordFrame& frame, std::span<const Argument> arguments, const Limits& limits,
          Factors& factors) {
    if (arguments.size() > most_factors || most_bits / 3 >= limits.digits) return false;
    factors.size = arguments.size();
    return frame.read(arguments, factors.words);
}

/// Reads the numerators of one coordinate into `row`, multiplied by the weights if there are any.
bool read(std::span<const Integer> numbers, std::span<const std::int64_t> weights, std::int64_t* row) {
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        const auto word = numbers[k].to_int64();
        if (!word || __builtin_mul_overflow(*word, weights.empty() ? 1 : weights[k], &row[k])) return false;
        if (row[k] == std::numeric_limits<std::int64_t>::min()) return false;
    }
    return true;
}

/// `value` is BlossomSums::sum_in_words or BlossomSums::apex_in_words.
template <class Value>
std::optional<Coordinates> values(const PointArray& numbers, std::span<const std::int64_t> weights,
                                  const Factors& factors, const Value& value) {
    const auto denominator = numbers.denominator().to_int64();
    if (!denominator) return std::nullopt;
    const std::uint64_t denominators[] = {static_cast<std::uint64_t>(*denominator),
                                          weights.empty() ? 1 : static_cast<std::uint64_t>(weights.back())};
    Coordinates coordinates;
    coordinates.reserve(numbers.dimension());
    for (std::size_t j = 0; j < numbers.dimension(); ++j) {
        std::int64_t row[most_factors + 1];
        if (!read(numbers.coordinate(j), weights, row)) return std::nullopt;
        auto coordinate = value(std::span<const std::int64_t>(row, numbers.size()), std::span(denominators),
                                factors.span());
        if (!coordinate) return std::nullopt;
        coordinates.push_back(*std::move(coordinate));
    }
    return coordinates;
}

}  // namespace

std::optional<Coordinates> value_in_words(const PolynomialCurve& curve, std::span<const Argument> arguments,
                                          const Limits& limits) {
    Factors factors;
    if (!read(WordFrame(), arguments, limits, factors)) return std::nullopt;
    return values(curve.coefficients(), binomial_weights(arguments.size()), factors,
                  BlossomSums::sum_in_words);
}

std::optional<Coordinates> value_in_words(const BezierCurve& curve, std::span<const Argument> arguments,
                                          const Limits& limits) {
    Factors factors;
    if (!read(WordFrame(cleared(curve.interval())), arguments, limits, factors)) return std::nullopt;
    return values(curve.control_points(), {}, factors, BlossomSums::apex_in_words);
}

}  // namespace blossom
