#pragma once

// The number backend: the only header that names the library of large integers.

#include <blossom/rational/integer.hpp>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <utility>

#if defined(BLOSSOM_NUMBERS_GMP)
#include <boost/multiprecision/gmp.hpp>
#elif defined(BLOSSOM_NUMBERS_CPP_INT)
#include <boost/multiprecision/cpp_int.hpp>
#else
#error "define BLOSSOM_NUMBERS_GMP or BLOSSOM_NUMBERS_CPP_INT"
#endif

namespace blossom {

namespace backend {

#if defined(BLOSSOM_NUMBERS_GMP)

using Number = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// Before GMP allocates memory for a product, it frees that of `product`; if the allocation failed, the
/// number would be left without memory. Therefore the memory is reserved here. `product` may be a or b.
inline void multiply(Number& product, const Number& a, const Number& b) {
    const std::size_t words = mpz_size(a.backend().data()) + mpz_size(b.backend().data());
    const mpz_ptr data = product.backend().data();
    if (static_cast<std::size_t>(data->_mp_alloc) < words) mpz_realloc2(data, words * GMP_NUMB_BITS);
    mpz_mul(product.backend().data(), a.backend().data(), b.backend().data());
}

inline void multiply(Number& product, const Number& a, std::int64_t b) {
    mpz_mul_si(product.backend().data(), a.backend().data(), b);
}

inline void add_product(Number& sum, const Number& a, const Number& b) {
    mpz_addmul(sum.backend().data(), a.backend().data(), b.backend().data());
}

inline void add_product(Number& sum, const Number& a, std::int64_t b) {
    if (b >= 0) {
        mpz_addmul_ui(sum.backend().data(), a.backend().data(), static_cast<std::uint64_t>(b));
    } else {
        mpz_submul_ui(sum.backend().data(), a.backend().data(), 0 - static_cast<std::uint64_t>(b));
    }
}

/// a / b for b that divides a.
inline void set_exact_quotient(Number& quotient, const Number& a, const Number& b) {
    mpz_divexact(quotient.backend().data(), a.backend().data(), b.backend().data());
}

inline void set_exact_quotient(Number& quotient, const Number& a, std::int64_t b) {
    mpz_divexact_ui(quotient.backend().data(), a.backend().data(),
                    b < 0 ? 0 - static_cast<std::uint64_t>(b) : static_cast<std::uint64_t>(b));
    if (b < 0) mpz_neg(quotient.backend().data(), quotient.backend().data());
}

inline void set_gcd(Number& common, const Number& a, const Number& b) {
    mpz_gcd(common.backend().data(), a.backend().data(), b.backend().data());
}

/// |a| modulo b > 0.
inline std::uint64_t remainder(const Number& a, std::uint64_t b) {
    return mpz_tdiv_ui(a.backend().data(), b);
}

inline void negate(Number& value) { mpz_neg(value.backend().data(), value.backend().data()); }

/// The value if it is from -2^63 to 2^63 - 1.
inline std::optional<std::int64_t> to_word(const Number& value) {
    const mpz_srcptr data = value.backend().data();
    if (mpz_size(data) > 1 || mpz_fits_slong_p(data) == 0) return std::nullopt;
    return mpz_get_si(data);
}

/// The allocated words of a number, whatever its value is.
inline std::size_t words_held(const Number& value) {
    return static_cast<std::size_t>(value.backend().data()->_mp_alloc);
}

/// The length of the magnitude in words.
inline std::size_t words_used(const Number& value) { return mpz_size(value.backend().data()); }

/// The longest number. GMP ends the process beyond 2^37 bits.
constexpr std::size_t most_bits = std::size_t{1} << 33;

/// Makes numbers allocate their memory with operator new and delete.
inline void allocate_with_new() {
    mp_set_memory_functions([](std::size_t size) { return ::operator new(size); },
                            [](void* old, std::size_t old_size, std::size_t size) {
                                void* const block = ::operator new(size);
                                std::memcpy(block, old, std::min(old_size, size));
                                ::operator delete(old, old_size);
                                return block;
                            },
                            [](void* block, std::size_t size) { ::operator delete(block, size); });
}

/// Sets `value` to the number with this sign and the binary digits `words`, least significant first, the last
/// of them not 0.
inline void set_words(Number& value, std::span<const std::uint64_t> words, bool negative) {
    static_assert(GMP_NUMB_BITS == 64 && sizeof(long) == sizeof(std::int64_t));
    const auto size = static_cast<mp_size_t>(words.size());
    const mpz_ptr data = value.backend().data();
    mp_limb_t* const limbs = data->_mp_alloc < size ? mpz_limbs_write(data, size) : data->_mp_d;
    for (mp_size_t i = 0; i < size; ++i) limbs[i] = words[static_cast<std::size_t>(i)];
    data->_mp_size = static_cast<int>(negative ? -size : size);
}

/// Sets `value` to the number whose two's complement is `words`.
inline void set_twos_complement(Number& value, std::span<const std::uint64_t> words) {
    auto size = static_cast<mp_size_t>(words.size());
    const mpz_ptr data = value.backend().data();
    mp_limb_t* const limbs = data->_mp_alloc < size ? mpz_limbs_write(data, size) : data->_mp_d;
    const auto sign = static_cast<std::uint64_t>(static_cast<std::int64_t>(words.back()) >> 63);
    std::uint64_t carry = sign & 1;
    for (mp_size_t i = 0; i < size; ++i) {
        limbs[i] = (words[static_cast<std::size_t>(i)] ^ sign) + carry;
        carry &= static_cast<std::uint64_t>(limbs[i] == 0);
    }
    while (size > 0 && limbs[size - 1] == 0) --size;
    data->_mp_size = static_cast<int>(sign != 0 ? -size : size);
}

/// The bit length of the magnitude.
inline std::size_t bit_length(const Number& value) {
    const mpz_srcptr data = value.backend().data();
    const std::size_t size = mpz_size(data);
    return size == 0 ? 1 : 64 * size - static_cast<std::size_t>(std::countl_zero(data->_mp_d[size - 1]));
}

/// Writes the binary digits of the magnitude to the front of `words` and leaves the other words unchanged.
inline void to_words(const Number& value, std::span<std::uint64_t> words) {
    const mpz_srcptr data = value.backend().data();
    std::copy_n(mpz_limbs_read(data), mpz_size(data), words.begin());
}

#else

using Number =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

inline void multiply(Number& product, const Number& a, const Number& b) { product = a * b; }
inline void multiply(Number& product, const Number& a, std::int64_t b) { product = a * b; }

inline void add_product(Number& sum, const Number& a, const Number& b) { sum += a * b; }
inline void add_product(Number& sum, const Number& a, std::int64_t b) { sum += a * b; }

inline void set_exact_quotient(Number& quotient, const Number& a, const Number& b) { quotient = a / b; }
inline void set_exact_quotient(Number& quotient, const Number& a, std::int64_t b) { quotient = a / b; }

inline void set_gcd(Number& common, const Number& a, const Number& b) {
    common = boost::multiprecision::gcd(a, b);
}

/// |a| modulo b > 0.
inline std::uint64_t remainder(const Number& a, std::uint64_t b) {
    return static_cast<std::uint64_t>(Number(boost::multiprecision::abs(a) % b));
}

inline void negate(Number& value) { value = -value; }

inline std::optional<std::int64_t> to_word(const Number& value) {
    if (value < std::numeric_limits<std::int64_t>::min() || value > std::numeric_limits<std::int64_t>::max())
        return std::nullopt;
    return static_cast<std::int64_t>(value);
}

inline std::size_t words_held(const Number& value) { return value.backend().size(); }
inline std::size_t words_used(const Number& value) { return value.backend().size(); }

/// The longest number. Boost counts bits by 32-bit integers in places.
constexpr std::size_t most_bits = std::size_t{1} << 31;

/// Boost's numbers use operator new anyway.
inline void allocate_with_new() {}

inline void set_words(Number& value, std::span<const std::uint64_t> words, bool negative) {
    value = 0;
    boost::multiprecision::import_bits(value, words.begin(), words.end(), 64, false);
    if (negative) negate(value);
}

inline void set_twos_complement(Number& value, std::span<const std::uint64_t> words) {
    set_words(value, words, false);
    if (words.back() >> 63 != 0) value -= Number(1) << (64 * words.size());
}

inline std::size_t bit_length(const Number& value) {
    return boost::multiprecision::msb(Number(boost::multiprecision::abs(value))) + 1;
}

inline void to_words(const Number& value, std::span<std::uint64_t> words) {
    boost::multiprecision::export_bits(Number(boost::multiprecision::abs(value)), words.begin(), 64, false);
}

#endif

}  // namespace backend

struct Integer::Large {
    backend::Number value;
    Large* next = nullptr;  ///< the next one in the list of unused numbers
};

/// Access to the representation of Integer for the sources of this layer.
struct IntegerAccess {
    static Integer from_number(backend::Number&& value);
    /// The integer to which `compute(number)` sets its argument, whose initial value is arbitrary.
    template <class Compute>
    static Integer computed(const Compute& compute);
    static backend::Number to_number(const Integer& value) {
        return value.large_ ? value.large_->value : backend::Number(value.small_);
    }

    static void set_word(Integer& value, std::int64_t word) {
        if (value.large_) value.release();
        value.small_ = word;
    }

    /// Two words: the value if it fits in one, otherwise 0; and the address of the large number, or null.
    static constexpr bool is_word_and_address =
        offsetof(Integer, small_) == 0 && offsetof(Integer, large_) == 8 && sizeof(Integer) == 16;

    /// The backend number of a value beyond 64 bits.
    static const backend::Number& large(const Integer& value) { return value.large_->value; }

    /// Calls operation(n) with the backend number or the 64-bit value, whichever holds `value`. The least
    /// 64-bit value is passed as a backend number, because Boost negates 64-bit operands.
    template <class Operation>
    static decltype(auto) visit(const Integer& value, Operation&& operation) {
        if (value.large_) return operation(std::as_const(value.large_->value));
        if (value.small_ == std::numeric_limits<std::int64_t>::min())
            return operation(backend::Number(value.small_));
        return operation(value.small_);
    }

    /// Sets `value` to the integer with this sign and these binary digits, least significant first, at least
    /// one word.
    static void set_magnitude(Integer& value, std::span<const std::uint64_t> words, bool negative);
    static Integer from_magnitude(std::span<const std::uint64_t> words, bool negative) {
        Integer value;
        set_magnitude(value, words, negative);
        return value;
    }
    /// The integer with this two's complement of at least one word, least significant first.
    static Integer from_twos_complement(std::span<const std::uint64_t> words);
    /// Writes the two's complement of `value` to `words`, which has room for it and its sign.
    static void to_twos_complement(const Integer& value, std::span<std::uint64_t> words);
};

}  // namespace blossom
