#pragma once

#include <blossom/rational/rational.hpp>

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace blossom {

/// Rational numbers stored as integers over one common denominator: element i is numerators()[i] /
/// denominator().
///
/// Kernels combine the numerators and never invert a denominator. The denominator is positive. The numerators
/// may share a factor with it until `make_canonical` is called, so that a chain of operations reduces only
/// once. Equality is equality of the numbers.
class RationalVector {
public:
    RationalVector() = default;
    /// Clears the denominators. Cost: one lcm and one product per element.
    explicit RationalVector(std::span<const Rational> values);
    RationalVector(std::initializer_list<Rational> values)
        : RationalVector(std::span(values.begin(), values.size())) {}
    /// Errors: `zero_denominator`.
    RationalVector(std::vector<Integer> numerators, Integer denominator);

    RationalVector(const RationalVector&) = default;
    /// Leaves an empty list behind.
    RationalVector(RationalVector&& other) noexcept
        : numerators_(std::move(other.numerators_)),
          denominator_(std::exchange(other.denominator_, 1)),
          factors_(std::move(other.factors_)) {}
    RationalVector& operator=(const RationalVector&) = default;
    RationalVector& operator=(RationalVector&&) noexcept = default;
    ~RationalVector() = default;

    std::size_t size() const { return numerators_.size(); }
    bool empty() const { return numerators_.empty(); }
    const std::vector<Integer>& numerators() const { return numerators_; }
    const Integer& denominator() const { return denominator_; }
    /// Positive numbers whose product is the denominator, in the order in which they arose: the factors that
    /// the denominators of the given numbers contributed, and later divisors. Reductions are cheaper by short
    /// factors. The list is the denominator alone if nothing else is known.
    std::span<const Integer> denominator_factors() const {
        return factors_.empty() ? std::span(&denominator_, 1) : std::span(factors_);
    }
    /// Element i in lowest terms. Cost: one gcd. Errors: `outside_domain` unless i < size().
    Rational operator[](std::size_t i) const {
        require_index(i, size());
        return {numerators_[i], denominator_};
    }
    std::vector<Rational> to_rationals() const;

    /// Other numerators over the same denominator.
    RationalVector over_same_denominator(std::vector<Integer> numerators) const;
    /// Element i times weights[i mod weights.size()] / divisor, with divisor > 0; the result is not reduced.
    RationalVector weighted(std::span<const Integer> weights, const Integer& divisor) const;

    /// Divides by the greatest common divisor of the denominator and all numerators, which leaves the least
    /// common denominator.
    void make_canonical();

    friend bool operator==(const RationalVector& a, const RationalVector& b);
    /// "(1/2, 3)".
    friend std::string to_string(const RationalVector& values);
    friend std::size_t hash_value(const RationalVector& values) { return hash_of(values.to_rationals()); }

private:
    std::vector<Integer> numerators_;
    Integer denominator_ = 1;
    std::vector<Integer> factors_;  ///< none of them 1; empty if only the denominator itself is known
};

/// The largest bit length among `values`; 0 if there are none.
std::size_t greatest_bit_length(std::span<const Integer> values);

}  // namespace blossom
