#include <blossom/rational/integer_polynomials.hpp>
#include <blossom/rational/rational_vector.hpp>

#include <algorithm>
#include <bit>

namespace blossom {

namespace {

/// The value at 2^bits, by halves.
Integer value_at_power(std::span<const Integer> polynomial, std::size_t bits) {
    if (polynomial.size() == 1) return polynomial.front();
    const std::size_t half = polynomial.size() / 2;
    return value_at_power(polynomial.first(half), bits) +
           (value_at_power(polynomial.subspan(half), bits) << (half * bits));
}

/// The coefficients, of fewer than `bits` bits, from the value at 2^bits.
void read_coefficients(Integer value, std::size_t bits, std::span<Integer> polynomial) {
    if (polynomial.size() == 1) {
        polynomial.front() = std::move(value);
        return;
    }
    const std::size_t half = polynomial.size() / 2;
    const std::size_t place = half * bits;
    Integer upper = (value + (Integer(1) << (place - 1))) >> place;
    value -= upper << place;
    read_coefficients(std::move(value), bits, polynomial.first(half));
    read_coefficients(std::move(upper), bits, polynomial.subspan(half));
}

}  // namespace

IntegerPolynomial product(std::span<const Integer> a, std::span<const Integer> b) {
    constexpr std::size_t least_size = 64;
    constexpr std::size_t least_bits = 64;
    if (a.empty() || b.empty()) return {};
    IntegerPolynomial result(a.size() + b.size() - 1);
    const std::size_t size = std::min(a.size(), b.size());
    const std::size_t bits =
        greatest_bit_length(a) + greatest_bit_length(b) + static_cast<std::size_t>(std::bit_width(size)) + 2;
    if (size >= least_size && bits >= least_bits) {
        read_coefficients(value_at_power(a, bits) * value_at_power(b, bits), bits, result);
        return result;
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) result[i + j].add_product(a[i], b[j]);
    }
    return result;
}

}  // namespace blossom
