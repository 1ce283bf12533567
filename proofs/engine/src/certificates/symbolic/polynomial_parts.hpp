#pragma once

#include "plain_polynomial.hpp"

namespace blossom::proofs::second {

/// Access to the representation for the operations on polynomials.
struct PolynomialParts {
    static constexpr std::uint64_t guards_of_8 = 0x8080808080808080;
    static constexpr std::uint64_t guards_of_16 = 0x8000800080008000;

    static std::uint64_t guards(const PlainPolynomial& a) {
        return a.bits_ == 8 ? guards_of_8 : guards_of_16;
    }
    static std::vector<std::uint64_t>& monomials(PlainPolynomial& a) { return a.monomials_; }
    static const std::vector<std::uint64_t>& monomials(const PlainPolynomial& a) { return a.monomials_; }
    static std::vector<Integer>& coefficients(PlainPolynomial& a) { return a.coefficients_; }
    static const std::vector<Integer>& coefficients(const PlainPolynomial& a) { return a.coefficients_; }
    static Integer& denominator(PlainPolynomial& a) { return a.denominator_; }
    static const Integer& denominator(const PlainPolynomial& a) { return a.denominator_; }
    static unsigned bits(const PlainPolynomial& a) { return a.bits_; }
    static std::uint64_t largest(const PlainPolynomial& a) { return a.largest_; }
    static void set_largest(PlainPolynomial& a, std::uint64_t exponent) { a.largest_ = exponent; }

    /// A polynomial without terms in the given layout.
    static PlainPolynomial empty(unsigned bits, std::size_t width, std::uint64_t largest) {
        PlainPolynomial result;
        result.bits_ = bits;
        result.width_ = width;
        result.largest_ = largest;
        return result;
    }

    static std::size_t fields_per_word(unsigned bits) { return 64 / bits; }
    static unsigned shift_of(std::size_t symbol, unsigned bits) {
        return 64 - bits * static_cast<unsigned>(symbol % fields_per_word(bits) + 1);
    }
    static std::uint64_t field_of(const std::uint64_t* monomial, std::size_t symbol, unsigned bits) {
        const std::uint64_t mask = bits == 8 ? 0xFF : 0xFFFF;
        return monomial[symbol / fields_per_word(bits)] >> shift_of(symbol, bits) & mask;
    }
    static void add_to_field(std::uint64_t* monomial, std::size_t symbol, unsigned bits,
                             std::uint64_t exponent) {
        monomial[symbol / fields_per_word(bits)] += exponent << shift_of(symbol, bits);
    }

    /// The number of words for the symbols below `symbols`.
    static std::size_t width_for(std::size_t symbols, unsigned bits) {
        return (symbols + fields_per_word(bits) - 1) / fields_per_word(bits);
    }

    /// The same polynomial in another layout, which must have room for it.
    static PlainPolynomial converted(const PlainPolynomial& a, unsigned bits, std::size_t width);

    static void append(PlainPolynomial& a, const std::uint64_t* monomial, Integer coefficient) {
        a.monomials_.insert(a.monomials_.end(), monomial, monomial + a.width_);
        a.coefficients_.push_back(std::move(coefficient));
    }

    /// Divides denominator and coefficients by their common divisor.
    static void reduce(PlainPolynomial& a);

    /// Counts the work on long coefficients, estimated from the first and the last one and the denominator.
    static void spend_on_bits(const PlainPolynomial& a, Budget& budget);
};

/// Two polynomials in one layout with room for exponents up to a given one; copied only if necessary.
class AlignedPolynomials {
public:
    AlignedPolynomials(const PlainPolynomial& a, const PlainPolynomial& b, bool for_product, Budget& budget);

    const PlainPolynomial& first() const { return first_copy_ ? *first_copy_ : first_; }
    const PlainPolynomial& second() const { return second_copy_ ? *second_copy_ : second_; }
    unsigned bits() const { return bits_; }
    std::size_t width() const { return width_; }
    std::uint64_t largest() const { return largest_; }

private:
    const PlainPolynomial& first_;
    const PlainPolynomial& second_;
    std::optional<PlainPolynomial> first_copy_;
    std::optional<PlainPolynomial> second_copy_;
    unsigned bits_ = 8;
    std::size_t width_ = 0;
    std::uint64_t largest_ = 0;
};

/// -1, 0 or 1 if the first monomial comes after, equals or precedes the other in the order of terms.
inline int compared_monomials(const std::uint64_t* a, const std::uint64_t* b, std::size_t width) {
    for (std::size_t k = 0; k < width; ++k) {
        if (a[k] != b[k]) return a[k] < b[k] ? -1 : 1;
    }
    return 0;
}

}  // namespace blossom::proofs::second
