#pragma once

#include <blossom/rational/rational.hpp>

#include <span>
#include <utility>
#include <vector>

namespace blossom {

/// A vector of the affine line: a difference of parameters, with mass 0 as an argument of a blossom.
struct Direction {
    Rational value;

    friend Direction operator+(const Direction& a, const Direction& b) { return {a.value + b.value}; }
    friend Direction operator*(const Rational& scale, const Direction& a) { return {scale * a.value}; }
    friend bool operator==(const Direction&, const Direction&) = default;
};

/// A point of the affine line: a parameter value, with mass 1 as an argument of a blossom.
///
/// The sum of two parameters does not compile; their difference is a `Direction`.
struct Parameter {
    Parameter(Rational parameter) : value(std::move(parameter)) {}  // NOLINT(google-explicit-constructor)
    template <std::integral Word>
    Parameter(Word parameter) : value(parameter) {}  // NOLINT(google-explicit-constructor)

    Rational value;

    friend Direction operator-(const Parameter& a, const Parameter& b) { return {a.value - b.value}; }
    friend Parameter operator+(const Parameter& a, const Direction& b) { return a.value + b.value; }
    friend bool operator==(const Parameter&, const Parameter&) = default;
};

/// delta = (1, 0), the unit vector; each occurrence in a blossom differentiates once (Goldman, section 4.2).
inline const Direction delta{1};

/// An argument of a homogeneous blossom: Goldman's pair (u, v), where the mass v is 1 for a point and 0 for a
/// vector. Source: Goldman, section 4.1. Statements: goldman-haxioms, goldman-hblossom-dehom.
struct Argument {
    // NOLINTBEGIN(google-explicit-constructor): points and vectors are arguments
    Argument(Parameter point) : u(std::move(point.value)), mass(1) {}
    Argument(Direction direction) : u(std::move(direction.value)), mass(0) {}
    // NOLINTEND(google-explicit-constructor)
    Argument(Rational first, Rational second) : u(std::move(first)), mass(std::move(second)) {}

    Rational u;
    Rational mass;

    friend bool operator==(const Argument&, const Argument&) = default;
};

/// `arguments` followed by k copies of `repeated`.
std::vector<Argument> with_copies(std::vector<Argument> arguments, std::size_t k, const Argument& repeated);

}  // namespace blossom
