#pragma once

#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/maps/argument.hpp>

#include <cstdint>
#include <random>
#include <vector>

/// A polynomial of formal degree n and n arguments, whose numerators and denominators have `bits` bits. They
/// are the same for all sides and all runs.
struct Case {
    std::size_t degree;
    std::size_t bits;
    std::vector<blossom::Rational> coefficients;
    std::vector<blossom::Rational> arguments;
};

/// A number of `bits` bits from the random stream, with an odd denominator so that it does not become
/// shorter.
inline blossom::Rational number(std::mt19937_64& random, std::size_t bits) {
    const auto integer = [&](std::size_t size) {
        blossom::Integer value;
        for (std::size_t rest = size; rest > 0;) {
            const std::size_t step = rest < 62 ? rest : 62;
            value = (value << step) + blossom::Integer(random() >> (64 - step));
            rest -= step;
        }
        return value;
    };
    const std::size_t width = bits == 64 ? 62 : bits;
    blossom::Integer numerator = integer(width);
    if (random() % 2 == 0) numerator.negate();
    blossom::Integer denominator = integer(width);
    if (!denominator.is_odd()) denominator += 1;
    return {std::move(numerator), std::move(denominator)};
}

inline Case make_case(std::size_t degree, std::size_t bits) {
    std::mt19937_64 random(degree * 1000 + bits);
    Case result{degree, bits, {}, {}};
    for (std::size_t k = 0; k <= degree; ++k) result.coefficients.push_back(number(random, bits));
    for (std::size_t k = 0; k < degree; ++k) result.arguments.push_back(number(random, bits));
    return result;
}

inline blossom::PolynomialCurve curve_of(const Case& given) {
    std::vector<blossom::Coordinates> points;
    for (const auto& coefficient : given.coefficients) points.push_back({coefficient});
    return blossom::PolynomialCurve(points);
}

inline std::vector<blossom::Argument> arguments_of(const Case& given) {
    std::vector<blossom::Argument> arguments;
    for (const blossom::Rational& value : given.arguments) arguments.emplace_back(blossom::Parameter(value));
    return arguments;
}

/// For larger cases, textbook loops take seconds.
inline bool textbook_is_bearable(const Case& given) {
    return given.degree <= 20 || (given.degree <= 100 && given.bits <= 64);
}
