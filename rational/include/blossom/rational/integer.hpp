#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

#include <blossom/rational/count.hpp>
#include <blossom/rational/value.hpp>

namespace blossom {

/// An integer of any size.
///
/// Values of 64 bits are stored in the object; larger ones in the number backend (GMP or Boost's `cpp_int`),
/// which no public header names. The representation is canonical: a value that fits in 64 bits is never
/// stored as a large one.
///
/// Cost: a few instructions and no allocation while operands and result fit in 64 bits, otherwise that of the
/// backend. `parse_integer` and `exact_rational` construct integers from text and from doubles.
class Integer {
public:
    Integer() noexcept = default;

    template <WholeNumber Word>
    Integer(Word value) {  // NOLINT(google-explicit-constructor): an integral value is an Integer
        if constexpr (sizeof(Word) > sizeof(std::int64_t)) {
            constexpr int bits = 64;
            using High = std::conditional_t<(Word(-1) < Word(0)), std::int64_t, std::uint64_t>;
            *this = (Integer(static_cast<High>(value >> bits)) << bits) + static_cast<std::uint64_t>(value);
        } else if (std::in_range<std::int64_t>(value)) {
            small_ = static_cast<std::int64_t>(value);
        } else {
            *this = from_unsigned(static_cast<std::uint64_t>(value));
        }
    }

    Integer(const Integer& other) : small_(other.small_) {
        if (other.large_) copy_large(other);
    }
    Integer(Integer&& other) noexcept
        : small_(std::exchange(other.small_, 0)), large_(std::exchange(other.large_, nullptr)) {}
    Integer& operator=(const Integer& other) {
        if (!large_ && !other.large_) {
            small_ = other.small_;
        } else if (this != &other) {
            assign_large(other);
        }
        return *this;
    }
    Integer& operator=(Integer&& other) noexcept {
        std::swap(small_, other.small_);
        std::swap(large_, other.large_);
        return *this;
    }
    ~Integer() {
        if (large_) release();
    }

    bool is_zero() const { return !large_ && small_ == 0; }
    bool is_one() const { return small_ == 1; }
    /// -1, 0 or 1.
    int sign() const { return large_ ? large_sign() : (small_ > 0) - (small_ < 0); }
    /// The number of binary digits of |x|; 0 for 0.
    std::size_t bit_length() const;
    bool is_odd() const;
    /// Whether the value fits in 64 bits.
    bool is_word() const { return !large_; }
    /// The value if it fits in 64 bits, otherwise 0.
    std::int64_t word() const { return small_; }
    /// The value if it fits in 64 bits.
    std::optional<std::int64_t> to_int64() const {
        return large_ ? std::nullopt : std::optional<std::int64_t>(small_);
    }

    Integer& operator+=(const Integer& other) {
        std::int64_t sum = 0;
        if (!large_ && !other.large_ && !__builtin_add_overflow(small_, other.small_, &sum)) {
            small_ = sum;
            return *this;
        }
        return add_large(other);
    }
    Integer& operator-=(const Integer& other) {
        std::int64_t difference = 0;
        if (!large_ && !other.large_ && !__builtin_sub_overflow(small_, other.small_, &difference)) {
            small_ = difference;
            return *this;
        }
        return subtract_large(other);
    }
    Integer& operator*=(const Integer& other) {
        std::int64_t product = 0;
        if (!large_ && !other.large_ && !__builtin_mul_overflow(small_, other.small_, &product)) {
            small_ = product;
            return *this;
        }
        return multiply_large(other);
    }
    /// The quotient truncated towards zero, as for built-in integers. Errors: `division_by_zero`.
    Integer& operator/=(const Integer& other);
    /// The remainder of truncated division, which has the sign of the dividend. Errors: `division_by_zero`.
    Integer& operator%=(const Integer& other);
    /// Errors: `limit_exceeded` for a result of more than 2^33 bits (2^31 with `cpp_int`), as for products.
    Integer& operator<<=(Count bits);
    /// Rounds towards minus infinity.
    Integer& operator>>=(Count bits);

    /// *this += a * b, without a temporary if the backend supports it.
    Integer& add_product(const Integer& a, const Integer& b) {
        std::int64_t product = 0;
        std::int64_t sum = 0;
        if (!large_ && !a.large_ && !b.large_ && !__builtin_mul_overflow(a.small_, b.small_, &product) &&
            !__builtin_add_overflow(small_, product, &sum)) {
            small_ = sum;
            return *this;
        }
        return add_product_large(a, b);
    }

    friend Integer operator+(Integer a, const Integer& b) { return std::move(a += b); }
    friend Integer operator-(Integer a, const Integer& b) { return std::move(a -= b); }
    friend Integer operator*(const Integer& a, const Integer& b) {
        std::int64_t product = 0;
        if (!a.large_ && !b.large_ && !__builtin_mul_overflow(a.small_, b.small_, &product)) return product;
        return product_large(a, b);
    }
    friend Integer operator/(Integer a, const Integer& b) { return std::move(a /= b); }
    friend Integer operator%(Integer a, const Integer& b) { return std::move(a %= b); }
    friend Integer operator<<(Integer a, Count bits) { return std::move(a <<= bits); }
    friend Integer operator>>(Integer a, Count bits) { return std::move(a >>= bits); }
    friend Integer operator-(Integer a) {
        a.negate();
        return a;
    }
    void negate() {
        if (!large_ && small_ != std::numeric_limits<std::int64_t>::min()) {
            small_ = -small_;
        } else {
            negate_large();
        }
    }

    friend bool operator==(const Integer& a, const Integer& b) {
        return a.large_ || b.large_ ? equal_large(a, b) : a.small_ == b.small_;
    }
    friend std::strong_ordering operator<=>(const Integer& a, const Integer& b) {
        return a.large_ || b.large_ ? compare_large(a, b) : a.small_ <=> b.small_;
    }

    struct Large;  ///< the backend's number, defined in the private sources

private:
    friend struct IntegerAccess;

    static Integer from_unsigned(std::uint64_t value);
    Large& promote();
    Integer& settle();
    void copy_large(const Integer& other);
    void assign_large(const Integer& other);
    void release() noexcept;
    int large_sign() const;
    Integer& add_large(const Integer& other);
    Integer& subtract_large(const Integer& other);
    Integer& multiply_large(const Integer& other);
    Integer& add_product_large(const Integer& a, const Integer& b);
    void negate_large();
    static Integer product_large(const Integer& a, const Integer& b);
    static bool equal_large(const Integer& a, const Integer& b);
    static std::strong_ordering compare_large(const Integer& a, const Integer& b);

    std::int64_t small_ = 0;  ///< the value if `large_` is null; otherwise 0
    Large* large_ = nullptr;  ///< owned
};

Integer abs(Integer value);
/// The non-negative greatest common divisor; gcd(0, 0) = 0.
Integer gcd(const Integer& a, const Integer& b);
/// The non-negative least common multiple; 0 if either is 0.
Integer lcm(const Integer& a, const Integer& b);
/// base^exponent, with 0^0 = 1.
/// Errors: `limit_exceeded`, as for shifts.
Integer pow(const Integer& base, Count exponent);
/// a / b where b divides a, which the caller guarantees. Cheaper than a division with remainder. Errors:
/// `division_by_zero`.
Integer divide_exactly(const Integer& a, const Integer& b);
/// The sum of a_i b_i; both spans have the same length.
Integer dot(std::span<const Integer> a, std::span<const Integer> b);

/// The integer with this two's complement of at least one word, least significant first.
Integer from_twos_complement(std::span<const std::uint64_t> words);
/// Writes the two's complement of `value` to `words`, which has room for `value.bit_length()` bits and the
/// sign.
void to_twos_complement(const Integer& value, std::span<std::uint64_t> words);

/// Decimal digits, with a leading '-' for negative values.
std::string to_string(const Integer& value);

std::size_t hash_value(const Integer& value);

}  // namespace blossom
