#pragma once

#include <blossom/core/algebra/polynomial.hpp>
#include <blossom/core/maps/point_array.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace blossom {

/// A polynomial map t -> Q^d of formal degree n by its n + 1 monomial coefficients, lowest first.
///
/// The formal degree is the number of arguments of the blossom. It is at least the actual degree, and part of
/// the value: t of degree 1 and t of degree 2 are different maps with different blossoms (Goldman, section
/// 2).
class PolynomialCurve {
public:
    /// The formal degree is `degree`, or by default the number of coefficients minus one.
    /// Errors: `degree_too_low` if a coefficient beyond `degree` is not zero; those of `PointArray`.
    explicit PolynomialCurve(std::span<const Coordinates> coefficients, std::optional<Count> degree = {});
    PolynomialCurve(std::initializer_list<Coordinates> coefficients, std::optional<Count> degree = {})
        : PolynomialCurve(std::span(coefficients.begin(), coefficients.size()), degree) {}
    /// Takes one polynomial per coordinate; the formal degree is by default the greatest actual degree.
    explicit PolynomialCurve(std::span<const Polynomial> coordinates, std::optional<Count> degree = {});
    /// The scalar map of one polynomial.
    explicit PolynomialCurve(const Polynomial& polynomial, std::optional<Count> degree = {});
    explicit PolynomialCurve(PointArray coefficients) : coefficients_(std::move(coefficients)) {}

    std::size_t degree() const { return coefficients_.size() - 1; }
    std::size_t dimension() const { return coefficients_.dimension(); }
    /// The greatest k whose coefficient is not zero; 0 for constants.
    std::size_t actual_degree() const;
    const PointArray& coefficients() const { return coefficients_; }
    /// Coordinate j as a polynomial.
    Polynomial coordinate(std::size_t j) const;

    /// Equality includes the formal degree.
    friend bool operator==(const PolynomialCurve&, const PolynomialCurve&) = default;
    /// "(1 + t^2, t) of degree 2".
    friend std::string to_string(const PolynomialCurve& curve);
    friend std::size_t hash_value(const PolynomialCurve& curve) { return hash_of(curve.coefficients_); }

private:
    PointArray coefficients_;
};

/// One polynomial per coordinate.
std::vector<Polynomial> coordinates_of(const PolynomialCurve& curve);

}  // namespace blossom
