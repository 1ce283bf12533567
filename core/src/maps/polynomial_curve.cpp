#include <blossom/core/maps/polynomial_curve.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace blossom {

namespace {

void require_formal_degree(std::size_t actual, std::size_t formal) {
    if (actual <= formal) return;
    throw Error(ErrorCode::degree_too_low,
                "the formal degree " + std::to_string(formal) + " is below the actual degree " +
                    std::to_string(actual),
                Part::degree);
}

PointArray padded(std::span<const Coordinates> coefficients, std::optional<Count> degree) {
    PointArray given(coefficients);
    std::size_t actual = given.size() - 1;
    const std::size_t formal = degree.value_or(actual);
    if (formal == actual) return given;
    while (actual > 0 && std::ranges::all_of(coefficients[actual], &Rational::is_zero)) --actual;
    require_formal_degree(actual, formal);

    std::vector<Integer> numerators;
    numerators.reserve(given.dimension() * (formal + 1));
    for (std::size_t j = 0; j < given.dimension(); ++j) {
        const auto row = given.coordinate(j).first(std::min(given.size(), formal + 1));
        numerators.insert(numerators.end(), row.begin(), row.end());
        numerators.resize((j + 1) * (formal + 1));
    }
    return {given.dimension(), given.numbers().over_same_denominator(std::move(numerators))};
}

PointArray stacked(std::span<const Polynomial> coordinates, std::optional<Count> degree) {
    if (coordinates.empty()) throw Error(ErrorCode::wrong_arity, "a map needs at least one coordinate");
    std::size_t actual = 0;
    Integer denominator = 1;
    for (const Polynomial& coordinate : coordinates) {
        actual = std::max(actual, coordinate.degree());
        denominator = lcm(denominator, coordinate.coefficients().denominator());
    }
    const std::size_t formal = degree.value_or(actual);
    require_formal_degree(actual, formal);

    std::vector<Integer> numerators;
    numerators.reserve(coordinates.size() * (formal + 1));
    for (std::size_t j = 0; j < coordinates.size(); ++j) {
        const RationalVector& row = coordinates[j].coefficients();
        const Integer scale = divide_exactly(denominator, row.denominator());
        for (const Integer& numerator : row.numerators()) numerators.push_back(numerator * scale);
        numerators.resize((j + 1) * (formal + 1));
    }
    return {coordinates.size(), RationalVector(std::move(numerators), denominator)};
}

}  // namespace

PolynomialCurve::PolynomialCurve(std::span<const Coordinates> coefficients, std::optional<Count> degree)
    : coefficients_(padded(coefficients, degree)) {}

PolynomialCurve::PolynomialCurve(std::span<const Polynomial> coordinates, std::optional<Count> degree)
    : coefficients_(stacked(coordinates, degree)) {}

PolynomialCurve::PolynomialCurve(const Polynomial& polynomial, std::optional<Count> degree)
    : coefficients_(stacked({&polynomial, 1}, degree)) {}

std::size_t PolynomialCurve::actual_degree() const {
    std::size_t actual = 0;
    for (std::size_t j = 0; j < dimension(); ++j) {
        std::size_t k = degree();
        while (k > actual && coefficients_.coordinate(j)[k].is_zero()) --k;
        actual = k;
    }
    return actual;
}

Polynomial PolynomialCurve::coordinate(std::size_t j) const {
    const auto row = coefficients_.coordinate(j);
    return Polynomial(coefficients_.numbers().over_same_denominator({row.begin(), row.end()}));
}

std::vector<Polynomial> coordinates_of(const PolynomialCurve& curve) {
    std::vector<Polynomial> coordinates;
    coordinates.reserve(curve.dimension());
    for (std::size_t j = 0; j < curve.dimension(); ++j) coordinates.push_back(curve.coordinate(j));
    return coordinates;
}

}  // namespace blossom
