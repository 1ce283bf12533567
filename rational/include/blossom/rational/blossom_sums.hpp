#pragma once

#include <blossom/rational/rational_vector.hpp>
#include <blossom/rational/word_line.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace blossom {

/// (constant + slope X) / denominator, with denominator > 0.
template <class R>
struct LinearFactor {
    R constant;
    R slope;
    R denominator;
};

/// A factor in machine words, none of which is the least 64-bit value.
using WordFactor = LinearFactor<std::int64_t>;
using IntegerFactor = LinearFactor<Integer>;

/// Sets `factor` to m + u X if u is a quotient of such words and m is 0 or 1; otherwise its value is
/// unspecified.
[[gnu::always_inline]] inline bool read_factor(const Rational& u, const Rational& m, WordFactor& factor) {
    const Integer& top = u.numerator();
    const Integer& bottom = u.denominator();
    if (!top.is_word() || !bottom.is_word() || top.word() == std::numeric_limits<std::int64_t>::min())
        return false;
    const bool is_one = m.numerator().is_one() && m.is_integer();
    if (!is_one && !m.is_zero()) return false;
    factor = {is_one ? bottom.word() : 0, top.word(), bottom.word()};
    return true;
}

/// The ways to compute the sums below; `evaluate` takes the first that provably suffices.
enum class SumKernel { word, wide, limbs, residues, integers };

/// A kernel and the condition under which it is taken.
struct SumKernelRule {
    SumKernel kernel;
    std::string_view name;
    std::string_view condition;
};
/// One entry per kernel, in the order in which they are considered.
std::span<const SumKernelRule> sum_kernel_rules();

/// Rows of numbers c_j0, ..., c_jn over one denominator, prepared for the sums
///
///     s_j = sum_k c_jk e_k,   sum_k e_k X^k = prod_{i = 1..n} (constant_i + slope_i X) / denominator_i,
///
/// which are blossom values in the monomial and in the Bernstein basis. No denominator is inverted:
/// numerators are combined, and each sum is reduced once.
///
/// The kernel follows from the integer bound max |c_jk| * prod (|constant_i| + |slope_i|) on the numerators
/// of the sums. Copies share the prepared data.
class BlossomSums {
public:
    /// Whether many sums follow, so that preparation pays.
    enum class Use { many, once };

    /// `numbers` holds `rows` rows of equal length, one after the other.
    BlossomSums(RationalVector numbers, std::size_t rows, Use use = Use::many);

    std::size_t rows() const;
    /// n
    std::size_t degree() const;
    const RationalVector& numbers() const;

    /// s_j for the rows j from `first_row` on, one per element of `sums`, over n factors.
    /// Cost: n^2 / 2 multiply-adds, n per row, and one reduction per row.
    void evaluate(std::span<const WordFactor> factors, std::size_t first_row, std::span<Rational> sums) const;
    void evaluate(std::span<const IntegerFactor> factors, std::size_t first_row,
                  std::span<Rational> sums) const;

    /// The same for factors m + u X: `pairs` points to u and m of the first factor, followed by those of the
    /// others. Returns false and does nothing unless every u is a quotient of words, every m is 0 or 1, there
    /// are few factors, and the kernel `word` suffices.
    bool evaluate_pairs(const Rational* pairs, std::size_t first_row, std::span<Rational> sums) const;

    /// The sums of all rows for eight tuples of factors m + u X, taken over `line` if there is one. tuples[l]
    /// points to the u of the first factor of tuple l, followed by its m and by the pairs of the other
    /// factors. The sums of one tuple lie one after the other.
    ///
    /// Returns false and does nothing unless there are few factors, every u is a quotient of words, every m
    /// is 0 or 1, one bound shows that the kernel `word` suffices for all tuples, and the processor has the
    /// vector instructions.
    bool evaluate_eight(std::span<const Rational* const, 8> tuples, std::span<Rational> sums,
                        const WordLine* line = nullptr) const;

    /// The kernel that `evaluate` chooses.
    SumKernel kernel(std::span<const WordFactor> factors) const;
    SumKernel kernel(std::span<const IntegerFactor> factors) const;

    /// The sum of one row of numbers row[k] / prod denominators, without preparation, if one of the kernels
    /// `word` and `wide` suffices. `row` does not contain the least 64-bit value.
    static std::optional<Rational> sum_in_words(std::span<const std::int64_t> row,
                                                std::span<const std::uint64_t> denominators,
                                                std::span<const WordFactor> factors);
    /// The same number computed as the apex of the triangle over `row`, see `fold_triangle`.
    static std::optional<Rational> apex_in_words(std::span<const std::int64_t> row,
                                                 std::span<const std::uint64_t> denominators,
                                                 std::span<const WordFactor> factors);

    struct PreparedRows;  ///< the rows in the forms that the kernels read, defined in the private sources

private:
    std::shared_ptr<const PreparedRows> prepared_;
};

}  // namespace blossom
