#include <blossom/rational/error.hpp>
#include <blossom/rational/lists.hpp>
#include <blossom/rational/rational_vector.hpp>

#include <algorithm>
#include <bit>

#include "backend.hpp"
#include "uint128.hpp"

namespace blossom {

RationalVector::RationalVector(std::span<const Rational> values) {
    for (const Rational& value : values) {
        if (value.is_integer() || value.denominator() == denominator_) continue;
        const Integer factor = divide_exactly(value.denominator(), gcd(denominator_, value.denominator()));
        if (factor.is_one()) continue;
        denominator_ *= factor;
        factors_.push_back(factor);
    }
    numerators_.reserve(values.size());
    for (const Rational& value : values) {
        numerators_.push_back(value.numerator() * divide_exactly(denominator_, value.denominator()));
    }
}

RationalVector::RationalVector(std::vector<Integer> numerators, Integer denominator)
    : numerators_(std::move(numerators)), denominator_(std::move(denominator)) {
    if (denominator_.is_zero())
        throw Error(ErrorCode::zero_denominator, "a common denominator must not be 0");
    if (denominator_.sign() > 0) return;
    denominator_.negate();
    for (Integer& numerator : numerators_) numerator.negate();
}

std::vector<Rational> RationalVector::to_rationals() const {
    std::vector<Rational> values;
    values.reserve(size());
    for (std::size_t i = 0; i < size(); ++i) values.push_back((*this)[i]);
    return values;
}

RationalVector RationalVector::over_same_denominator(std::vector<Integer> numerators) const {
    RationalVector result;
    result.numerators_ = std::move(numerators);
    result.denominator_ = denominator_;
    result.factors_ = factors_;
    return result;
}

RationalVector RationalVector::weighted(std::span<const Integer> weights, const Integer& divisor) const {
    std::vector<Integer> numerators;
    numerators.reserve(size());
    for (std::size_t i = 0; i < size(); ++i)
        numerators.push_back(numerators_[i] * weights[i % weights.size()]);
    RationalVector result = over_same_denominator(std::move(numerators));
    if (divisor.is_one()) return result;
    if (factors_.empty() && !denominator_.is_one()) result.factors_.push_back(denominator_);
    result.factors_.push_back(divisor);
    result.denominator_ *= divisor;
    return result;
}

std::string to_string(const RationalVector& values) {
    return "(" + joined(values.to_rationals(), [](const Rational& value) { return to_string(value); }) + ")";
}

void RationalVector::make_canonical() {
    Integer common = denominator_;
    // Neighbours often share much: the control points over an interval have powers of the denominator of one
    // end point only at the ends. Therefore the gcd is taken from both ends, and then outwards from the
    // middle.
    const std::size_t size = numerators_.size();
    for (std::size_t i = 0; i < size; ++i) {
        if (common.is_one()) return;
        const std::size_t k = i < 2 ? i * (size - 1) : 1 + (i - 2 + (size - 2) / 2) % (size - 2);
        common = gcd(common, numerators_[k]);
    }
    if (common.is_one()) return;
    for (Integer& numerator : numerators_) numerator = divide_exactly(numerator, common);
    denominator_ = divide_exactly(denominator_, common);
    for (Integer& factor : factors_) {
        const Integer shared = gcd(factor, common);
        if (shared.is_one()) continue;
        factor = divide_exactly(factor, shared);
        common = divide_exactly(common, shared);
    }
    std::erase_if(factors_, [](const Integer& factor) { return factor.is_one(); });
}

bool operator==(const RationalVector& a, const RationalVector& b) {
    if (a.denominator_ == b.denominator_) return a.numerators_ == b.numerators_;
    return std::ranges::equal(a.numerators_, b.numerators_, [&](const Integer& x, const Integer& y) {
        return x * b.denominator_ == y * a.denominator_;
    });
}

std::size_t greatest_bit_length(std::span<const Integer> values) {
    std::size_t greatest = 0;
    std::uint64_t words = 0;  // bits that are set if one of the magnitudes has them
    for (const Integer& value : values) {
        if (value.is_word()) {
            words |= magnitude(value.word());
        } else {
            greatest = std::max(greatest, value.bit_length());
        }
    }
    return std::max(greatest, static_cast<std::size_t>(std::bit_width(words)));
}

}  // namespace blossom
