#pragma once

#include <blossom/core/algebra/sparse_polynomial.hpp>
#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace blossom {

/// A polynomial map in several variables by its monomial coefficients. The variables are grouped: the first
/// s_0 of them belong to factor 0, in which the map has the formal total degree n_0, and so on. One group
/// gives a map with a simplex blossom, whose arguments are points; groups of one variable each give a tensor
/// product.
///
/// The coefficient of x_1^(i_1) ... x_s^(i_s) has the index (i_0, i_1, ..., i_s), where i_0 = n - i_1 - ... -
/// i_s is the exponent of the mass that makes the polynomial homogeneous: coefficients have the shape of a
/// control net. An argument is (mass, x_1, ..., x_s), see `point_argument` and `vector_argument`. Source:
/// DeRose, theorem 3. Statement: derose-thm3.
class PolynomialPatch {
public:
    /// Takes coefficients in the order of `NetShape`. Errors: as for `BezierPatch`, below
    /// `Part::coefficients`.
    PolynomialPatch(NetShape shape, PointArray coefficients);
    /// Takes one polynomial per coordinate, in the variables 0, 1, ... Errors: `degree_too_low` if a term has
    /// a degree above that of its factor; `wrong_arity` if there is no polynomial, or a variable beyond those
    /// of the shape; `limit_exceeded`.
    PolynomialPatch(NetShape shape, std::span<const SparsePolynomial> coordinates, const Limits& limits = {});

    const NetShape& shape() const { return shape_; }
    std::size_t dimension() const { return coefficients_.dimension(); }
    const PointArray& coefficients() const { return coefficients_; }
    /// Coordinate j as a polynomial in the variables 0, 1, ...
    SparsePolynomial coordinate(std::size_t j) const;

    friend bool operator==(const PolynomialPatch&, const PolynomialPatch&) = default;
    /// "degree 1 on a simplex of dimension 2, coefficients (0), (1), (2)".
    friend std::string to_string(const PolynomialPatch& patch);
    friend std::size_t hash_value(const PolynomialPatch& patch) {
        return hash_of(patch.shape_, patch.coefficients_);
    }

private:
    NetShape shape_;
    PointArray coefficients_;
};

/// (1, x_1, ..., x_s): a point as an argument.
Coordinates point_argument(std::span<const Rational> point);
/// (0, x_1, ..., x_s): a vector as an argument.
Coordinates vector_argument(std::span<const Rational> vector);

/// The same polynomial with another grouping of its variables: from a total degree to one degree per variable
/// or the reverse. Errors: `degree_too_low` if a term has a degree above that of its factor; `wrong_arity`
/// unless the dimensions have the same sum; `limit_exceeded`.
PolynomialPatch regrouped(const PolynomialPatch& patch, const NetShape& shape, const Limits& limits = {});

}  // namespace blossom
