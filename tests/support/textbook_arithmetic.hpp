#pragma once

// The oracle for the numbers: the same operations on numbers of another library, which share no code with the
// engine. Operands are passed and results returned as decimal digits.

#include <blossom/rational/rational.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace blossom::textbook {

std::string sum(const Integer& a, const Integer& b);
std::string difference(const Integer& a, const Integer& b);
std::string product(const Integer& a, const Integer& b);
/// The quotient truncated towards zero.
std::string quotient(const Integer& a, const Integer& b);
std::string remainder(const Integer& a, const Integer& b);
std::string greatest_common_divisor(const Integer& a, const Integer& b);
std::string least_common_multiple(const Integer& a, const Integer& b);
std::string power(const Integer& base, unsigned exponent);
std::string left_shifted(const Integer& a, unsigned bits);
/// The floor of a / 2^bits.
std::string right_shifted(const Integer& a, unsigned bits);
std::size_t bit_length(const Integer& a);
/// -1, 0 or 1.
int comparison(const Integer& a, const Integer& b);

std::string sum(const Rational& a, const Rational& b);
std::string difference(const Rational& a, const Rational& b);
std::string product(const Rational& a, const Rational& b);
std::string quotient(const Rational& a, const Rational& b);
std::string power(const Rational& base, unsigned exponent);
int comparison(const Rational& a, const Rational& b);
/// p / q in lowest terms with a positive denominator, from any p and any q != 0.
std::string lowest_terms(const Integer& p, const Integer& q);

/// significand * 2^exponent as an exact decimal such as "123e-45".
std::string decimal_of(std::int64_t significand, int exponent);
/// Whether `candidate` is the double nearest to `value`; of two equally near doubles, the one with the even
/// significand.
bool is_nearest(double candidate, const Rational& value);

}  // namespace blossom::textbook
