#include "small_fractions.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "limbs/limb_arithmetic.hpp"

namespace blossom {

namespace {

using limbs::Limb;

/// The most words of a numerator or denominator that is searched for.
constexpr std::size_t most_fraction_words = 80;

/// Finds a / b = N / D for large N and D from their most significant words alone.
///
/// With h words for each of a and b, 2 h + 1 words x and y at the top of N and D, and |N| <= D without loss
/// of generality, |x/y - a/b| <= 2/y < 1/(2 b^2), so that a/b is a convergent of x/y. With b = b_j its
/// remainder |x b_j - y a_j| is below 2 b, and therefore below the bound 2^(64 h + 32). For any earlier
/// remainder r_i below the bound, b_(i+1) > y / (2 r_i) would be greater than b. Therefore Euclid's algorithm
/// runs up to the first remainder below the bound.
class FractionSearch {
public:
    explicit FractionSearch(const Integer& denominator)
        : denominator_(denominator), bits_(denominator.bit_length()), bottom_(limbs_of(denominator)) {}

    using Fraction = std::pair<Integer, Integer>;

    /// A fraction of at most `words` words, if there is one.
    std::optional<Fraction> find(const Integer& number, std::size_t words) {
        const std::size_t bits = std::max(bits_, number.bit_length());
        const std::size_t width = 2 * words + 1;
        if (bits <= 64 * width) return std::nullopt;
        first_ = top_words(limbs_of(number), bits - 64 * width, width);
        second_ = top_words(bottom_, bits - 64 * width, width);
        const Integer x = IntegerAccess::from_magnitude(first_, false);
        const Integer y = IntegerAccess::from_magnitude(second_, false);
        first_weight_.assign(words + 3, 0);
        second_weight_.assign(words + 3, 0);
        first_weight_[0] = 1;
        if (x < y) {
            std::swap(first_, second_);
            std::swap(first_weight_, second_weight_);
        }
        if (!run_to(words)) return std::nullopt;
        const Integer bottom = IntegerAccess::from_magnitude(second_weight_, false);
        if (bottom.is_zero()) return std::nullopt;
        Integer top = (2 * x * bottom + y) / (2 * y);
        if (number.sign() < 0) top.negate();
        if (number * bottom != top * denominator_) return std::nullopt;
        return Fraction(std::move(top), bottom);
    }

private:
    static std::vector<Limb> limbs_of(const Integer& value) {
        std::vector<Limb> result(limbs::size_of(value));
        limbs::write_magnitude(value, result.data(), result.size());
        return result;
    }
    /// `width` words of number / 2^shift.
    static std::vector<Limb> top_words(const std::vector<Limb>& number, std::size_t shift,
                                       std::size_t width) {
        std::vector<Limb> result(width);
        for (std::size_t i = 0; i < width; ++i) result[i] = limbs::bits_from(number, shift + 64 * i);
        return result;
    }

    /// Whether a remainder is at least 2^(64 words + 32).
    static bool reaches(const std::vector<Limb>& number, std::size_t words) {
        return number[words] >> 32 != 0 || limbs::used(number.data(), number.size()) > words + 1;
    }

    /// Runs Euclid's algorithm to the first remainder below the bound; returns false if the sizes of the
    /// numbers differ too much.
    bool run_to(std::size_t words) {
        while (reaches(first_, words)) {
            if (!reaches(second_, words)) return true;
            if (!several_steps()) one_step();
        }
        return false;
    }

    /// Takes as many quotients as the top 64 bits determine, by Lehmer's method with Jebelean's condition. It
    /// stops before large quotients, such as the one after the desired fraction.
    bool several_steps() {
        constexpr Limb least_large_quotient = Limb{1} << 16;
        const std::size_t top = limbs::used(first_.data(), first_.size()) - 1;
        const int shift = std::countl_zero(first_[top]);
        const auto leading = [&](const std::vector<Limb>& number) {
            return static_cast<Limb>((UInt128{number[top]} << 64 | number[top - 1]) << shift >> 64);
        };
        Limb a = leading(first_);
        Limb b = leading(second_);
        Limb own = 1;  // The next pair is own * first - other * second and the like, or the negatives.
        Limb other = 0;
        Limb next_own = 0;
        Limb next_other = 1;
        bool odd = false;
        while (b != 0) {
            const Limb quotient = a / b;
            if (quotient >= least_large_quotient) break;
            const Limb rest = a - quotient * b;
            const Limb new_other = other + quotient * next_other;
            if (rest < new_other || b - rest < new_other + next_other) break;
            a = std::exchange(b, rest);
            own = std::exchange(next_own, own + quotient * next_own);
            other = std::exchange(next_other, new_other);
            odd = !odd;
        }
        if (other == 0) return false;
        Int128 carry = 0;
        Int128 next_carry = 0;
        for (std::size_t i = 0; i <= top; ++i) {
            const Limb x = first_[i];
            const Limb y = second_[i];
            carry += difference(x, own, y, other, odd);
            next_carry += difference(x, next_own, y, next_other, !odd);
            first_[i] = static_cast<Limb>(carry);
            second_[i] = static_cast<Limb>(next_carry);
            carry >>= 64;
            next_carry >>= 64;
        }
        UInt128 sum = 0;
        UInt128 next_sum = 0;
        for (std::size_t i = 0; i < first_weight_.size(); ++i) {
            const Limb x = first_weight_[i];
            const Limb y = second_weight_[i];
            sum += UInt128{x} * own + UInt128{y} * other;
            next_sum += UInt128{x} * next_own + UInt128{y} * next_other;
            first_weight_[i] = static_cast<Limb>(sum);
            second_weight_[i] = static_cast<Limb>(next_sum);
            sum >>= 64;
            next_sum >>= 64;
        }
        return true;
    }
    /// x a - y b or its negative, for a and b below 2^33.
    static Int128 difference(Limb x, Limb a, Limb y, Limb b, bool negative) {
        const Int128 result = static_cast<Int128>(UInt128{x} * a) - static_cast<Int128>(UInt128{y} * b);
        return negative ? -result : result;
    }

    /// Takes one quotient of any size.
    void one_step() {
        const std::size_t m = limbs::used(first_.data(), first_.size());
        const std::size_t n = limbs::used(second_.data(), second_.size());
        std::vector<Limb> quotient(m - n + 1);
        limbs::divide(quotient.data(), first_.data(), first_.data(), m, second_.data(), n);
        std::fill(first_.begin() + static_cast<std::ptrdiff_t>(n), first_.end(), Limb{0});
        std::swap(first_, second_);
        const std::size_t size = limbs::used(second_weight_.data(), second_weight_.size());
        if (size > 0) {
            std::vector<Limb> product(std::max(size + quotient.size(), first_weight_.size()));
            limbs::multiply_any(product.data(), std::span(second_weight_).first(size), quotient);
            limbs::add(first_weight_.data(), first_weight_.data(), product.data(), first_weight_.size());
        }
        std::swap(first_weight_, second_weight_);
    }

    const Integer& denominator_;
    std::size_t bits_;
    std::vector<Limb> bottom_;
    std::vector<Limb> first_;          ///< the current remainder
    std::vector<Limb> second_;         ///< the next remainder
    std::vector<Limb> first_weight_;   ///< the coefficient of x in the current remainder, without sign
    std::vector<Limb> second_weight_;  ///< the same for the next remainder
};

}  // namespace

std::optional<SmallFractions> small_fractions(std::span<const Integer> numerators,
                                              const Integer& denominator) {
    const std::size_t most = std::min(limbs::size_of(denominator) / 4, most_fraction_words);
    FractionSearch search(denominator);
    SmallFractions result;
    result.tops.reserve(numerators.size());
    result.bottoms.reserve(numerators.size());
    std::size_t words = 1;
    std::size_t failures = 0;
    for (const Integer& numerator : numerators) {
        if (numerator.is_zero()) {
            result.tops.emplace_back(0);
            result.bottoms.emplace_back(1);
            continue;
        }
        // Adjacent fractions have similar numbers of words.
        std::optional<FractionSearch::Fraction> found;
        for (; !found && words <= most; words *= 2) found = search.find(numerator, words);
        if (found) {
            words = std::max(limbs::size_of(found->first), limbs::size_of(found->second));
            result.tops.push_back(std::move(found->first));
            result.bottoms.push_back(std::move(found->second));
        } else {
            words = 1;
            if (++failures * 8 > result.tops.size() + 8) return std::nullopt;
            result.tops.push_back(numerator);
            result.bottoms.push_back(denominator);
        }
    }
    return result;
}

}  // namespace blossom
