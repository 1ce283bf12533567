#pragma once

#include <blossom/rational/rational.hpp>

#include <string>

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
    /// "[a, b]".
    friend std::string to_string(const Interval& interval) {
        return "[" + to_string(interval.a_) + ", " + to_string(interval.b_) + "]";
    }
    friend std::size_t hash_value(const Interval& interval) { return hash_of(interval.a_, interval.b_); }

private:
    Rational a_;
    Rational b_;
};

}  // namespace blossom
