#include "word_quotients.hpp"

#include <algorithm>
#include <array>

#include "limbs/limb_arithmetic.hpp"
#include "quotient_reduction.hpp"
#include "word_gcds.hpp"

namespace blossom {

namespace {

constexpr std::size_t most_words = DenominatorWords::most_words + 1;

/// A number >= 0 in the first `size` words of memory that the caller owns.
struct Words {
    std::uint64_t* words;
    std::size_t size;

    std::span<const std::uint64_t> span() const { return {words, size}; }

    void multiply(std::uint64_t factor) { limbs::multiply_by_word(words, size, factor); }
    void divide(std::uint64_t divisor) const {
        UInt128 rest = 0;
        for (std::size_t i = size; i-- > 0;) {
            rest = rest << 64 | words[i];
            words[i] = static_cast<std::uint64_t>(rest / divisor);
            rest %= divisor;
        }
    }
    /// Divides by an odd divisor from the least significant word upwards, with 1/divisor modulo 2^64, and
    /// passes the words of the quotient to `keep`. The returned remainder is congruent to the number times a
    /// power of 2^-64 modulo the divisor; it is 0 if the divisor divides the number.
    template <class Keep>
    std::uint64_t divide_from_below(std::uint64_t divisor, std::uint64_t inverse, const Keep& keep) const {
        std::uint64_t carry = 0;
        for (std::size_t i = 0; i < size; ++i) {
            const bool borrow = words[i] < carry;
            const std::uint64_t quotient = (words[i] - carry) * inverse;
            keep(i, quotient);
            carry = static_cast<std::uint64_t>(UInt128{quotient} * divisor >> 64) +
                    static_cast<std::uint64_t>(borrow);
        }
        return carry;
    }
    /// Divides the number by the prime if possible, and returns whether it was.
    bool divide_by(const small_primes::Prime& prime) const {
        if (divide_from_below(prime.prime, prime.inverse, [](auto, auto) {}) != 0) return false;
        divide_from_below(prime.prime, prime.inverse,
                          [&](std::size_t i, std::uint64_t quotient) { words[i] = quotient; });
        return true;
    }
};

/// Consecutive primes whose product is a word.
struct PrimeGroup {
    small_primes::Set primes = 0;
    std::uint64_t product = 1;
    std::uint64_t inverse = 1;
};

constexpr auto prime_groups = [] {
    std::array<PrimeGroup, 3> groups{};
    std::size_t last = 0;
    for (std::size_t i = 0; i < small_primes::count; ++i) {
        const std::uint64_t prime = small_primes::table.primes[i].prime;
        if (groups[last].product > ~std::uint64_t{0} / prime) ++last;
        groups[last].product *= prime;
        groups[last].primes |= small_primes::Set{1} << i;
    }
    for (PrimeGroup& group : groups) group.inverse = inverse_of_odd(group.product);
    return groups;
}();

/// The primes of a set that divide the number.
small_primes::Set divisors(const Words& number, small_primes::Set set) {
    small_primes::Set result = 0;
    for (const PrimeGroup& group : prime_groups) {
        if ((set & group.primes) == 0) continue;
        const std::uint64_t rest = number.divide_from_below(group.product, group.inverse, [](auto, auto) {});
        for (small_primes::Set left = set & group.primes; left != 0; left &= left - 1) {
            const bool divides = small_primes::table.primes[std::countr_zero(left)].divides(rest);
            result |= divides ? left & (0 - left) : 0;
        }
    }
    return result;
}

/// The product of the factors, written to `words`, which has room for it.
Words product(std::span<const std::uint64_t> factors, std::uint64_t* words) {
    words[0] = 1;
    Words result{words, 1};
    for (const std::uint64_t factor : factors) result.multiply(factor);
    return result;
}

/// The quotient of a numerator > 0: divides numerator and denominator by their common primes, one factor of
/// the denominator after the other.
void assign_quotient_by_primes(Rational& value, const Words& top, bool negative,
                               const DenominatorWords& denominator) {
    std::uint64_t left[most_words];
    const std::span<std::uint64_t> factors = std::span(left).first(denominator.words().size());
    const std::size_t twos = limbs::trailing_zeros(top.words);
    std::size_t shared_twos = 0;
    for (std::size_t i = 0; i < factors.size(); ++i) {
        const std::uint64_t factor = denominator.words()[i];
        const std::size_t shift =
            std::min(twos - shared_twos, static_cast<std::size_t>(std::countr_zero(factor)));
        factors[i] = factor >> shift;
        shared_twos += shift;
    }
    if (shared_twos != 0) limbs::shift_right(top.words, top.size, shared_twos);
    small_primes::for_each(divisors(top, denominator.primes()), [&](const small_primes::Prime& prime) {
        for (std::uint64_t& factor : factors) {
            while (prime.divides(factor)) {
                if (!top.divide_by(prime)) return;
                factor *= prime.inverse;
            }
        }
    });
    std::uint64_t words[most_words];
    RationalAccess::set_lowest_terms(value, top.span(), negative, product(factors, words).span());
}

/// The same for any factors; returns false and does nothing if the common factor is longer than a word.
bool assign_quotient_in_place(Rational& value, const Words& top, bool negative,
                              std::span<const std::uint64_t> factors) {
    std::uint64_t common[most_words];
    gcds_with_words(top.span(), factors, common);
    std::uint64_t shared = 1;
    for (const std::uint64_t factor : std::span(common).first(factors.size()))
        if (__builtin_mul_overflow(shared, factor, &shared)) return false;
    std::uint64_t words[most_words];
    const Words bottom = product(factors, words);
    if (shared != 1 && factors.size() > 1)
        shared = gcd_of_words(limbs::remainder(top.words, top.size, shared), shared);
    if (shared != 1) {
        top.divide(shared);
        bottom.divide(shared);
    }
    RationalAccess::set_lowest_terms(value, top.span(), negative, bottom.span());
    return true;
}

}  // namespace

void assign_quotient_by_gcd(Rational& value, std::int64_t numerator, std::uint64_t denominator) {
    const std::uint64_t size = magnitude(numerator);
    const std::uint64_t common = gcd_of_words(size % denominator, denominator);
    const auto top = static_cast<std::int64_t>(common == 1 ? size : size / common);
    RationalAccess::set_words(value, numerator < 0 ? -top : top,
                              static_cast<std::int64_t>(common == 1 ? denominator : denominator / common));
}

void assign_quotient(Rational& value, std::span<std::uint64_t> numerator, bool negative,
                     const DenominatorWords& denominator, std::span<const Integer> further) {
    const std::span<const std::uint64_t> factors = denominator.words();
    const Words top{numerator.data(), limbs::used(numerator.data(), numerator.size())};
    const bool is_short = further.empty();
    if (top.size == 0) {
        value = 0;
    } else if (is_short && factors.empty()) {
        value = IntegerAccess::from_magnitude(top.span(), negative);
    } else if (is_short && denominator.primes() != small_primes::any_primes) {
        assign_quotient_by_primes(value, top, negative, denominator);
    } else if (!is_short || !assign_quotient_in_place(value, top, negative, factors)) {
        value = reduced_quotient(top.span(), negative, factors, further);
    }
}

}  // namespace blossom
