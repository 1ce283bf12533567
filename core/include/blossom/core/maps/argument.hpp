#pragma once

#include <blossom/rational/rational.hpp>

#include <compare>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace blossom {

/// A vector of the affine line: a difference of parameters, with mass 0 as an argument of a blossom.
struct Direction {
    Rational value;

    friend Direction operator+(const Direction& a, const Direction& b) { return {a.value + b.value}; }
    friend Direction operator-(const Direction& a, const Direction& b) { return {a.value - b.value}; }
    friend Direction operator-(const Direction& a) { return {-a.value}; }
    friend Direction operator*(const Rational& scale, const Direction& a) { return {scale * a.value}; }
    friend Direction operator*(const Direction& a, const Rational& scale) { return {scale * a.value}; }
    /// Errors: `division_by_zero`.
    friend Direction operator/(const Direction& a, const Rational& scale) { return {a.value / scale}; }
    Direction& operator+=(const Direction& other) { return *this = *this + other; }
    Direction& operator-=(const Direction& other) { return *this = *this - other; }
    friend bool operator==(const Direction&, const Direction&) = default;
    /// "1/2 delta".
    friend std::string to_string(const Direction& direction) { return to_string(direction.value) + " delta"; }
    friend std::size_t hash_value(const Direction& direction) { return hash_of(direction.value, 0); }
};

/// A point of the affine line: a parameter value, with mass 1 as an argument of a blossom.
///
/// The sum of two parameters does not compile; their difference is a `Direction`.
struct Parameter {
    Parameter(Rational parameter) : value(std::move(parameter)) {}  // NOLINT(google-explicit-constructor)
    template <WholeNumber Word>
    Parameter(Word parameter) : value(parameter) {}  // NOLINT(google-explicit-constructor)

    Rational value;

    friend Direction operator-(const Parameter& a, const Parameter& b) { return {a.value - b.value}; }
    friend Parameter operator+(const Parameter& a, const Direction& b) { return a.value + b.value; }
    friend Parameter operator+(const Direction& a, const Parameter& b) { return a.value + b.value; }
    friend Parameter operator-(const Parameter& a, const Direction& b) { return a.value - b.value; }
    Parameter& operator+=(const Direction& other) { return *this = *this + other; }
    Parameter& operator-=(const Direction& other) { return *this = *this - other; }
    friend bool operator==(const Parameter&, const Parameter&) = default;
    friend std::strong_ordering operator<=>(const Parameter&, const Parameter&) = default;
    friend std::string to_string(const Parameter& parameter) { return to_string(parameter.value); }
    friend std::size_t hash_value(const Parameter& parameter) { return hash_of(parameter.value, 1); }
};

/// delta = (1, 0), the unit vector; each occurrence in a blossom differentiates once (Goldman, section 4.2).
inline const Direction delta{1};

/// An argument of a homogeneous blossom: Goldman's pair (u, v), where the mass v is 1 for a point and 0 for a
/// vector. Source: Goldman, section 4.1. Statements: goldman-haxioms, goldman-hblossom-dehom.
struct Argument {
    // NOLINTBEGIN(google-explicit-constructor): points and vectors are arguments
    Argument(Parameter point) : u(std::move(point.value)), mass(1) {}
    Argument(Direction direction) : u(std::move(direction.value)), mass(0) {}
    Argument(Rational point) : u(std::move(point)), mass(1) {}
    template <WholeNumber Word>
    Argument(Word point) : u(point), mass(1) {}
    // NOLINTEND(google-explicit-constructor)
    Argument(Rational first, Rational second) : u(std::move(first)), mass(std::move(second)) {}

    Rational u;
    Rational mass;

    friend bool operator==(const Argument&, const Argument&) = default;
    /// "(u, mass)".
    friend std::string to_string(const Argument& argument) {
        return "(" + to_string(argument.u) + ", " + to_string(argument.mass) + ")";
    }
    friend std::size_t hash_value(const Argument& argument) { return hash_of(argument.u, argument.mass); }
};

/// `arguments` followed by k copies of `repeated`.
std::vector<Argument> with_copies(std::vector<Argument> arguments, std::size_t k, const Argument& repeated);

}  // namespace blossom
