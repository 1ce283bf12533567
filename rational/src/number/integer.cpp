#include <blossom/rational/error.hpp>
#include <blossom/rational/integer.hpp>
#include <blossom/rational/resource_budget.hpp>

#include <algorithm>
#include <bit>
#include <vector>

#include "backend.hpp"
#include "uint128.hpp"

namespace blossom {

using backend::Number;

namespace {

/// The numbers that this thread released last, with their memory, for the next results, which are usually of
/// similar size. Nothing here has a destructor, so that integers of any lifetime can be released.
struct FreeList {
    Integer::Large* first;
    std::size_t words;  ///< the words that all of them hold
};
/// The most words of one number in the list, and of all numbers of a thread.
constexpr std::size_t most_words_of_number = 32;
constexpr std::size_t most_words_of_free_list = std::size_t{1} << 17;
thread_local FreeList free_list{};
thread_local bool free_list_is_closed = false;  ///< true once the thread ends

/// Deletes the list when the thread ends.
struct FreeListOfThread {
    FreeListOfThread() = default;
    FreeListOfThread(const FreeListOfThread&) = delete;
    FreeListOfThread(FreeListOfThread&&) = delete;
    FreeListOfThread& operator=(const FreeListOfThread&) = delete;
    FreeListOfThread& operator=(FreeListOfThread&&) = delete;
    ~FreeListOfThread() {
        free_list_is_closed = true;
        while (free_list.first) delete std::exchange(free_list.first, free_list.first->next);
    }
    void start() const {}
};
thread_local const FreeListOfThread free_list_of_thread;

/// A number whose value is arbitrary.
Integer::Large* take_large() {
    constexpr std::uint64_t words_of_taking = 8;
    spend_work(words_of_taking);
    if (!free_list.first) return new Integer::Large;
    Integer::Large* const number = std::exchange(free_list.first, free_list.first->next);
    free_list.words -= backend::words_held(number->value);
    return number;
}

void give_back(Integer::Large* number) noexcept {
    const std::size_t words = backend::words_held(number->value);
    if (free_list_is_closed || words > most_words_of_number ||
        free_list.words + words > most_words_of_free_list) {
        delete number;
        return;
    }
    if (!free_list.first) free_list_of_thread.start();
    number->next = std::exchange(free_list.first, number);
    free_list.words += words;
}

std::uint64_t words(const Number& value) { return backend::words_used(value); }
std::uint64_t words(std::int64_t) { return 1; }

constexpr std::size_t bits_per_word = 64;
using backend::most_bits;

[[noreturn]] void refuse_bits() {
    throw Error(ErrorCode::limit_exceeded,
                "the number has more than " + std::to_string(most_bits) + " binary digits");
}

/// Counts the work of a product, and refuses one that the backend cannot hold.
void prepare_product(std::uint64_t a, std::uint64_t b) {
    if (a + b > most_bits / bits_per_word) refuse_bits();
    spend_work(words_of_product(a, b));
}

void require_divisor(const Integer& divisor) {
    if (divisor.is_zero()) throw Error(ErrorCode::division_by_zero, "an integer cannot be divided by 0");
}

}  // namespace

Integer::Large& Integer::promote() {
    if (!large_) {
        large_ = take_large();
        large_->value = std::exchange(small_, 0);
    } else {
        spend_work(words(large_->value));
    }
    return *large_;
}

Integer& Integer::settle() {
    if (const auto word = backend::to_word(large_->value)) {
        small_ = *word;
        release();
    }
    return *this;
}

Integer Integer::from_unsigned(std::uint64_t value) {
    Integer result;
    result.promote().value = value;
    return std::move(result.settle());
}

void Integer::copy_large(const Integer& other) {
    large_ = take_large();
    large_->value = other.large_->value;
}

void Integer::assign_large(const Integer& other) {
    if (!other.large_) {
        release();
        small_ = other.small_;
    } else if (large_) {
        large_->value = other.large_->value;
    } else {
        copy_large(other);
        small_ = 0;
    }
}

void Integer::release() noexcept { give_back(std::exchange(large_, nullptr)); }

Integer IntegerAccess::from_number(Number&& value) {
    return computed([&](Number& number) { number.swap(value); });
}

template <class Compute>
Integer IntegerAccess::computed(const Compute& compute) {
    Integer result;
    result.large_ = take_large();
    compute(result.large_->value);
    return std::move(result.settle());
}

int Integer::large_sign() const { return large_->value.sign(); }

std::size_t Integer::bit_length() const {
    if (!large_) return static_cast<std::size_t>(std::bit_width(magnitude(small_)));
    return backend::bit_length(large_->value);
}

bool Integer::is_odd() const {
    return large_ ? boost::multiprecision::bit_test(large_->value, 0) : (small_ & 1) != 0;
}

Integer& Integer::add_large(const Integer& other) {
    Number& value = promote().value;
    IntegerAccess::visit(other, [&](const auto& term) { value += term; });
    return settle();
}

Integer& Integer::subtract_large(const Integer& other) {
    Number& value = promote().value;
    IntegerAccess::visit(other, [&](const auto& term) { value -= term; });
    return settle();
}

Integer& Integer::multiply_large(const Integer& other) {
    Number& value = promote().value;
    IntegerAccess::visit(other, [&](const auto& factor) {
        prepare_product(words(value), words(factor));
        backend::multiply(value, value, factor);
    });
    return settle();
}

Integer Integer::product_large(const Integer& a, const Integer& b) {
    if (!a.large_) return b.large_ ? product_large(b, a) : Integer(a).multiply_large(b);
    return IntegerAccess::visit(b, [&](const auto& factor) {
        prepare_product(words(a.large_->value), words(factor));
        return IntegerAccess::computed(
            [&](Number& product) { backend::multiply(product, a.large_->value, factor); });
    });
}

Integer& Integer::add_product_large(const Integer& a, const Integer& b) {
    if (!a.large_) return b.large_ ? add_product_large(b, a) : *this += a * b;
    Number& sum = promote().value;
    IntegerAccess::visit(b, [&](const auto& factor) {
        prepare_product(words(a.large_->value), words(factor));
        backend::add_product(sum, a.large_->value, factor);
    });
    return settle();
}

void Integer::negate_large() {
    Number& value = promote().value;
    value = -value;
    settle();
}

bool Integer::equal_large(const Integer& a, const Integer& b) {
    return a.large_ && b.large_ && a.large_->value == b.large_->value;
}

std::strong_ordering Integer::compare_large(const Integer& a, const Integer& b) {
    const auto order = [](int sign) { return sign <=> 0; };
    if (!a.large_) return order(-b.large_sign());
    if (!b.large_) return order(a.large_sign());
    return order(a.large_->value.compare(b.large_->value));
}

Integer& Integer::operator/=(const Integer& other) {
    require_divisor(other);
    const bool overflows = small_ == std::numeric_limits<std::int64_t>::min() && other.small_ == -1;
    if (!large_ && !other.large_ && !overflows) {
        small_ /= other.small_;
        return *this;
    }
    Number& value = promote().value;
    IntegerAccess::visit(other, [&](const auto& divisor) {
        spend_work(words_of_product(words(value), words(divisor)));
        value /= divisor;
    });
    return settle();
}

Integer& Integer::operator%=(const Integer& other) {
    require_divisor(other);
    if (!large_ && !other.large_) {
        small_ = other.small_ == -1 ? 0 : small_ % other.small_;
        return *this;
    }
    const Number divisor = IntegerAccess::to_number(other);
    Number& value = promote().value;
    spend_work(words_of_product(words(value), words(divisor)));
    value %= divisor;
    return settle();
}

Integer& Integer::operator<<=(Count bits) {
    if (is_zero()) return *this;
    if (bits > most_bits - std::min(bit_length(), most_bits)) refuse_bits();
    spend_work(bits / bits_per_word);
    promote().value <<= std::size_t{bits};
    return settle();
}

Integer& Integer::operator>>=(Count bits) {
    if (!large_) {
        small_ >>= std::min<std::size_t>(bits, 63);
        return *this;
    }
    // Backends differ on negative values: -(((-x) - 1) >> k) - 1 is the floor on all of them.
    Number& value = large_->value;
    const bool negative = value.sign() < 0;
    if (negative) value = -value - 1;
    value >>= std::size_t{bits};
    if (negative) value = -value - 1;
    return settle();
}

Integer abs(Integer value) {
    if (value.sign() < 0) value.negate();
    return value;
}

Integer gcd(const Integer& a, const Integer& b) {
    const auto x = a.to_int64();
    const auto y = b.to_int64();
    if (x && y) return *y == 0 ? magnitude(*x) : gcd_of_words(magnitude(*x), magnitude(*y));
    if (!x && !y) {
        // The gcd of numbers of n words takes about n products by words, as long as products are quadratic.
        spend_work(2 * words_of_product(words(IntegerAccess::large(a)), words(IntegerAccess::large(b))));
        return IntegerAccess::computed([&](Number& common) {
            backend::set_gcd(common, IntegerAccess::large(a), IntegerAccess::large(b));
        });
    }
    const Integer& large = x ? b : a;
    const std::uint64_t word = magnitude(x ? *x : *y);
    if (word == 0) return abs(large);
    return gcd_of_words(backend::remainder(IntegerAccess::large(large), word), word);
}

Integer lcm(const Integer& a, const Integer& b) {
    if (a.is_zero() || b.is_zero()) return 0;
    return abs(divide_exactly(a, gcd(a, b)) * b);
}

Integer pow(const Integer& base, Count exponent) {
    const std::size_t bits = base.bit_length();
    if (bits > 1 && exponent > most_bits / (bits - 1)) refuse_bits();
    Integer result = 1;
    Integer square = base;
    for (std::size_t rest = exponent; rest != 0; rest >>= 1) {
        if (rest & 1) result *= square;
        if (rest > 1) square *= square;
    }
    return result;
}

Integer divide_exactly(const Integer& a, const Integer& b) {
    if (b.is_one()) return a;
    const bool divides_words = a.is_word() && b.is_word() && b.word() > 0;
    if (divides_words) return a.word() / b.word();
    if (a.is_word()) return a / b;
    require_divisor(b);
    return IntegerAccess::visit(b, [&](const auto& divisor) {
        spend_work(words_of_product(words(IntegerAccess::large(a)), words(divisor)));
        return IntegerAccess::computed([&](Number& quotient) {
            backend::set_exact_quotient(quotient, IntegerAccess::large(a), divisor);
        });
    });
}

Integer dot(std::span<const Integer> a, std::span<const Integer> b) {
    Integer sum;
    for (std::size_t i = 0; i < a.size(); ++i) sum.add_product(a[i], b[i]);
    return sum;
}

void IntegerAccess::set_magnitude(Integer& value, std::span<const std::uint64_t> words, bool negative) {
    std::size_t used = words.size();
    while (used > 1 && words[used - 1] == 0) --used;
    if (used == 1 && words[0] <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
        const auto word = static_cast<std::int64_t>(words[0]);
        return set_word(value, negative ? -word : word);
    }
    if (!value.large_) value.large_ = take_large();
    value.small_ = 0;
    backend::set_words(value.large_->value, words.first(used), negative);
    // The least 64-bit value is a word.
    if (used == 1) value.settle();
}

Integer IntegerAccess::from_twos_complement(std::span<const std::uint64_t> words) {
    // Words at the top that only repeat the sign are dropped.
    std::size_t used = words.size();
    const auto sign = static_cast<std::uint64_t>(static_cast<std::int64_t>(words.back()) >> 63);
    while (used > 1 && words[used - 1] == sign && (words[used - 2] ^ sign) >> 63 == 0) --used;
    if (used == 1) return static_cast<std::int64_t>(words[0]);
    Integer result;
    result.large_ = take_large();
    backend::set_twos_complement(result.large_->value, words.first(used));
    return result;
}

void IntegerAccess::to_twos_complement(const Integer& value, std::span<std::uint64_t> words) {
    if (!value.large_) {
        const auto low = static_cast<std::uint64_t>(value.small_);
        std::ranges::fill(words, value.small_ < 0 ? ~std::uint64_t{0} : 0);
        words[0] = low;
        return;
    }
    std::ranges::fill(words, 0);
    const Number& number = value.large_->value;
    backend::to_words(number, words);
    bool carry = number.sign() < 0;
    if (!carry) return;
    for (std::uint64_t& word : words) {
        word = ~word + static_cast<std::uint64_t>(carry);
        carry = carry && word == 0;
    }
}

Integer from_twos_complement(std::span<const std::uint64_t> words) {
    return IntegerAccess::from_twos_complement(words);
}

void to_twos_complement(const Integer& value, std::span<std::uint64_t> words) {
    IntegerAccess::to_twos_complement(value, words);
}

void allocate_numbers_with_new() { backend::allocate_with_new(); }

void prepare_thread_for_numbers() { free_list_of_thread.start(); }

std::size_t hash_value(const Integer& value) {
    return IntegerAccess::visit(
        value, [](const auto& number) { return std::hash<std::remove_cvref_t<decltype(number)>>{}(number); });
}

}  // namespace blossom
