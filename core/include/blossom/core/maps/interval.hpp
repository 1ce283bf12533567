#pragma once

#include <blossom/rational/rational.hpp>

namespace blossom {

/// A parameter interval [a, b] with a != b; a > b means the reversed parametrisation.
class Interval {
public:
    /// The interval [0, 1].
    Interval() : b_(1) {}
    /// Errors: `empty_interval` if a == b.
    Interval(Rational a, Rational b);

    const Rational& a() const { return a_; }
    const Rational& b() const { return b_; }

    friend bool operator==(const Interval&, const Interval&) = default;

private:
    Rational a_;
    Rational b_;
};

}  // namespace blossom
