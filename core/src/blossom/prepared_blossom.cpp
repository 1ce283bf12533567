
#include <blossom/core/blossom/blossom.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/made_once.hpp>

#include <atomic>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>

#include "maps/binomial_weights.hpp"
#include "maps/on_threads.hpp"
#include "maps/result_room.hpp"
#include "run_construction.hpp"
#include "values_in_words.hpp"
#include "word_factors.hpp"

namespace blossom {

namespace {

/// Sums over the normalised coefficients or the control points.
BlossomSums prepared(const PolynomialMap& map, BlossomSums::Use use) {
    if (const auto* bezier = std::get_if<BezierCurve>(&map))
        return {bezier->control_points().numbers(), bezier->dimension(), use};
    const PointArray& coefficients = std::get<PolynomialCurve>(map).coefficients();
    const auto weights = binomial_weights(coefficients.size() - 1);
    RationalVector numbers = coefficients.numbers().weighted(weights->numerators, weights->denominator);
    if (use == BlossomSums::Use::many) numbers.make_canonical();
    return {std::move(numbers), coefficients.dimension(), use};
}

/// The most factors that fit in the arrays on the stack.
constexpr std::size_t most_factors_in_place = 64;

/// The bits of an argument whose numerator and denominator are words.
constexpr std::size_t word_argument_bits = 65;

}  // namespace

// An argument is two consecutive numbers.
static_assert(std::is_standard_layout_v<Argument> && offsetof(Argument, u) == 0 &&
              offsetof(Argument, mass) == sizeof(Rational) && sizeof(Argument) == 2 * sizeof(Rational));

struct Blossom::Kernel {
    Kernel(const PolynomialMap& map, const Limits& given, BlossomSums::Use use)
        : limits(given),
          sums(prepared(map, use)),
          bits(numerator_bits(map) + degree_of(map) * frame_bits(map)) {
        if (const auto* bezier = std::get_if<BezierCurve>(&map)) {
            interval = cleared(bezier->interval());
            frame = WordFrame(*interval);
        }
        // A decimal digit has more than three bits.
        words_are_within_limits = (bits + sums.degree() * word_argument_bits) / 3 < limits.digits;
        reads_eight = words_are_within_limits && !frame.is_beyond_words() && sums.degree() > 0;
        reads_pairs = reads_eight && frame.is_monomial();
    }

    void evaluate(std::span<const Argument> arguments, std::size_t first_row,
                  std::span<Rational> coordinates) const {
        if (!reads_pairs || !sums.evaluate_pairs(&arguments.front().u, first_row, coordinates))
            evaluate_any(arguments, first_row, coordinates);
    }

    /// Takes arguments of any size and number. It is not inlined, because the fast path above needs no
    /// memory.
    [[gnu::noinline]] void evaluate_any(std::span<const Argument> arguments, std::size_t first_row,
                                        std::span<Rational> coordinates) const {
        WordFactor in_place[most_factors_in_place];
        std::vector<WordFactor> on_heap;
        if (arguments.size() > most_factors_in_place) on_heap.resize(arguments.size());
        WordFactor* factors = on_heap.empty() ? in_place : on_heap.data();
        if (words_are_within_limits && frame.read(arguments, factors)) {
            sums.evaluate(std::span<const WordFactor>(factors, arguments.size()), first_row, coordinates);
        } else {
            sums.evaluate(integer_factors(arguments), first_row, coordinates);
        }
    }

    /// The values at eight tuples, one after the other; returns false if words do not suffice.
    bool evaluate_eight(std::span<const std::vector<Argument>, 8> tuples, std::span<Rational> values) const {
        if (!reads_eight) return false;
        const Rational* pairs[8];
        for (std::size_t l = 0; l < 8; ++l) pairs[l] = &tuples[l].front().u;
        return sums.evaluate_eight(pairs, values, frame.line());
    }

    std::vector<IntegerFactor> integer_factors(std::span<const Argument> arguments) const {
        const ClearedArguments cleared_arguments = cleared_one_by_one(arguments);
        require_result_bits(bits + cleared_arguments.bits, limits);
        std::vector<IntegerFactor> factors;
        factors.reserve(arguments.size());
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            const auto& [u, mass] = cleared_arguments.pairs[i];
            const Integer& scale = cleared_arguments.scales[i];
            if (interval) {
                const auto& [a, b, q] = *interval;
                factors.push_back({b * mass - q * u, q * u - a * mass, scale * (b - a)});
            } else {
                factors.push_back({mass, u, scale});
            }
        }
        return factors;
    }

    Limits limits;
    BlossomSums sums;
    std::size_t bits;  ///< a bound on the bits of a value without those of the arguments
    std::optional<ClearedInterval> interval;
    WordFrame frame;
    bool words_are_within_limits;
    bool reads_eight;  ///< arguments are factors, perhaps over another line; see evaluate_eight
    bool reads_pairs;  ///< arguments are factors; see evaluate_pairs
};

/// The map, and its prepared form once that pays.
struct Blossom::Shared {
    Shared(PolynomialMap of, const Limits& given) : map(std::move(of)), limits(given) {}

    /// The prepared form, or nullptr if `count` more values are as cheap without it.
    const Kernel* kernel_for(std::size_t count) const {
        constexpr std::size_t values_without = 2;  // preparation costs as much as one to four of them
        const Kernel* known = kernel.if_made();
        if (known || asked.fetch_add(count, std::memory_order_relaxed) + count <= values_without)
            return known;
        return &kernel.value([&] { return Kernel(map, limits, BlossomSums::Use::many); });
    }

    /// One value without the prepared form; its coordinates start at row `first`.
    void evaluate_once(std::span<const Argument> arguments, std::size_t first,
                       std::span<Rational> coordinates) const {
        const auto in_words = [&](const auto& curve) { return value_in_words(curve, arguments, limits); };
        if (auto value = std::visit(in_words, map)) {
            std::move(value->begin() + static_cast<std::ptrdiff_t>(first),
                      value->begin() + static_cast<std::ptrdiff_t>(first + coordinates.size()),
                      coordinates.begin());
        } else {
            Kernel(map, limits, BlossomSums::Use::once).evaluate(arguments, first, coordinates);
        }
    }

    PolynomialMap map;
    Limits limits;
    mutable std::atomic<std::size_t> asked = 0;
    MadeOnce<Kernel> kernel;
};

Blossom::Blossom(PolynomialMap map, Limits limits) : degree_(degree_of(map)), dimension_(dimension_of(map)) {
    require_within(degree_, limits.degree, "degree", "the formal degree", Part::degree);
    shared_ = std::make_shared<const Shared>(std::move(map), limits);
}

void Blossom::evaluate(std::span<const Argument> arguments, std::size_t first,
                       std::span<Rational> coordinates) const {
    require_arity(degree_, arguments.size());
    if (const Kernel* kernel = shared_->kernel_for(1)) {
        kernel->evaluate(arguments, first, coordinates);
    } else {
        shared_->evaluate_once(arguments, first, coordinates);
    }
}

Coordinates Blossom::operator()(std::span<const Argument> arguments) const {
    Coordinates value(dimension_);
    evaluate(arguments, 0, value);
    return value;
}

Rational Blossom::coordinate(std::size_t j, std::span<const Argument> arguments) const {
    Rational value;
    evaluate(arguments, j, {&value, 1});
    return value;
}

std::vector<Rational> Blossom::values(std::span<const std::vector<Argument>> tuples, std::size_t jobs) const {
    return written(tuples.size() * dimension_,
                   [&](std::span<Rational> results) { values(tuples, results, jobs); });
}

void Blossom::values(std::span<const std::vector<Argument>> tuples, std::span<Rational> results,
                     std::size_t jobs) const {
    require_room(tuples.size(), "tuples of arguments", dimension_, results.size());
    for (const auto& arguments : tuples) require_arity(degree_, arguments.size());
    const Kernel* kernel = shared_->kernel_for(tuples.size());
    if (!kernel) {
        for (std::size_t i = 0; i < tuples.size(); ++i)
            shared_->evaluate_once(tuples[i], 0, results.subspan(i * dimension_, dimension_));
        return;
    }
    on_threads(tuples.size(), jobs, [&](std::size_t begin, std::size_t end) {
        const auto results_of = [&](std::size_t i, std::size_t count) {
            return results.subspan(i * dimension_, count * dimension_);
        };
        for (std::size_t i = begin; i < end;) {
            const std::size_t count = std::min<std::size_t>(end - i, 8);
            if (count < 8 || !kernel->evaluate_eight(tuples.subspan(i).first<8>(), results_of(i, 8))) {
                for (std::size_t k = i; k < i + count; ++k) kernel->evaluate(tuples[k], 0, results_of(k, 1));
            }
            i += count;
        }
    });
}

}  // namespace blossom
