#pragma once

// A step of Boehm's algorithm on points with their own denominators.

#include <blossom/rational/limits.hpp>
#include <blossom/rational/rational.hpp>

#include <span>

namespace blossom {

/// The coordinates (end - x) / (end - begin) and (x - begin) / (end - begin) of a parameter x with respect to
/// two knots, as integers over one length.
class KnotWeights {
public:
    KnotWeights(const Rational& begin, const Rational& end, const Rational& x);

    /// to[j] = (left * a[j] + right * b[j]) / length; `to` may be a or b. Errors: `limit_exceeded`.
    void combine(std::span<const Rational> a, std::span<const Rational> b, std::span<Rational> to,
                 const Limits& limits) const;

private:
    Integer left_;
    Integer right_;
    Integer length_;
};

}  // namespace blossom
