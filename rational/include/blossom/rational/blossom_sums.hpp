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

/// In machine words, none of which is the least value of 64 bits.
using WordFactor = LinearFactor<std::int64_t>;
using IntegerFactor = LinearFactor<Integer>;

/// m + u X, if u is a quotient of such words and m is 0 or 1; otherwise `factor` is left in between.
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

/// The ways to compute the sums below; the first that provably suffices is taken.
enum class SumKernel { word, wide, limbs, residues, integers };

/// A kernel and when it is taken.
struct SumKernelRule {
    SumKernel kernel;
    std::string_view name;
    std::string_view condition;
};
/// One entry a kernel, in the order in which they are considered.
std::span<const SumKernelRule> sum_kernel_rules();

/// Rows of numbers c_j0, ..., c_jn over one denominator, prepared for the sums
///
///     s_j = sum_k c_jk e_k,   sum_k e_k X^k = prod_{i = 1..n} (constant_i + slope_i X) / denominator_i,
///
/// which is what a blossom is in the monomial and in the Bernstein basis. No denominator is inverted:
/// numerators are combined, and each sum is reduced once.
///
/// Which kernel runs follows from the bound max |c_jk| * prod (|constant_i| + |slope_i|) on the numerators of
/// the sums, taken in integers. Copies share what was prepared.
class BlossomSums {
public:
    /// How much may be spent on what pays only when many sums follow.
    enum class Use { many, once };

    /// `numbers` are `rows` rows of equal length, one after the other.
    BlossomSums(RationalVector numbers, std::size_t rows, Use use = Use::many);

    std::size_t rows() const;
    /// n
    std::size_t degree() const;
    const RationalVector& numbers() const;

    /// s_j for the rows j from `first_row` on, as many as there are places in `sums`; n factors.
    /// Cost: n^2 / 2 multiply-adds, n per row, and one reduction per row.
    void evaluate(std::span<const WordFactor> factors, std::size_t first_row, std::span<Rational> sums) const;
    void evaluate(std::span<const IntegerFactor> factors, std::size_t first_row,
                  std::span<Rational> sums) const;

    /// The same for factors m + u X: `pairs` points to the u of the first one, its m follows, then the
    /// others. False, and nothing is done, unless every u is a quotient of words, every m is 0 or 1, there
    /// are few factors and the kernel `word` suffices.
    bool evaluate_pairs(const Rational* pairs, std::size_t first_row, std::span<Rational> sums) const;

    /// The sums of all rows for eight tuples of factors, those of a tuple one after the other: factors m + u
    /// X, pairs of numbers, over another line if there is one. tuples[l] points to the u of the first pair of
    /// tuple l, its m follows, then the other pairs.
    ///
    /// False, and nothing is done, unless there are few factors, every u is a quotient of words, every m is 0
    /// or 1, the kernel `word` suffices for all of them by one bound, and this processor computes eight at a
    /// time.
    bool evaluate_eight(std::span<const Rational* const, 8> tuples, std::span<Rational> sums,
                        const WordLine* line = nullptr) const;

    /// What `evaluate` chooses.
    SumKernel kernel(std::span<const WordFactor> factors) const;
    SumKernel kernel(std::span<const IntegerFactor> factors) const;

    /// The sum of one row of numbers row[k] / prod denominators, if the kernels `word` and `wide` suffice for
    /// it; there is nothing to prepare then. `row` does not contain the least value of 64 bits.
    static std::optional<Rational> sum_in_words(std::span<const std::int64_t> row,
                                                std::span<const std::uint64_t> denominators,
                                                std::span<const WordFactor> factors);
    /// The same number as the apex of the triangle over `row`, see `fold_triangle`.
    static std::optional<Rational> apex_in_words(std::span<const std::int64_t> row,
                                                 std::span<const std::uint64_t> denominators,
                                                 std::span<const WordFactor> factors);

    struct PreparedRows;  ///< the rows in the forms that the kernels read, defined in the private sources

private:
    std::shared_ptr<const PreparedRows> prepared_;
};

}  // namespace blossom
