#pragma once

// ln 2, ln 3 and ln 5: exactly, as a basis over Q of their combinations, and in rational enclosures.

#include <blossom/core/maps/point_array.hpp>

namespace blossom::testing {

/// A closed interval with rational ends that contains a real number.
struct Enclosure {
    Rational lower;
    Rational upper;

    Enclosure(Rational number)
        : lower(number), upper(std::move(number)) {}  // NOLINT(google-explicit-constructor)
    Enclosure(Rational least, Rational greatest) : lower(std::move(least)), upper(std::move(greatest)) {}

    Rational width() const { return upper - lower; }
};

Enclosure operator+(const Enclosure& a, const Enclosure& b);
Enclosure operator-(const Enclosure& a, const Enclosure& b);
Enclosure operator*(const Enclosure& a, const Enclosure& b);

/// (c_0, c_1, c_2, c_3) for c_0 + c_1 ln 2 + c_2 ln 3 + c_3 ln 5: ln t for a positive t without other prime
/// factors.
Coordinates logarithm(const Rational& t);

/// The real number with these coordinates, within 10^-40 for coefficients below a million.
Enclosure enclosed(const Coordinates& combination);

}  // namespace blossom::testing
