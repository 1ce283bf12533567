#pragma once

// What control nets and monomial coefficients share: both are weighted by products of powers of the
// coordinates of an argument, with respect to the vertices, or to the origin and the unit vectors.

#include <blossom/core/maps/patch_map.hpp>
#include <blossom/rational/error.hpp>

#include <string>
#include <utility>

#include "integer_tuple.hpp"

namespace blossom {

/// The numbers of a net, with the greatest magnitude among the values of the blossom at the elements of its
/// frame.
NetSums net_sums(const NetShape& shape, const PointArray& net, const Integer& greatest);
/// Whether sums at tuples that words hold are within the limits.
bool words_are_within(const NetSums& sums, const Limits& limits);

/// The blossom with the values `polar` at the elements of the frame, which the arguments are given in:
/// prod_j sum_k argument_jk X_k, factor by factor, with the values in place of the monomials in X.
Coordinates polar_value(const NetShape& shape, const PointArray& polar, const PatchArguments& arguments,
                        const Limits& limits);

/// The values times the multinomial coefficients: a homogeneous polynomial.
PointArray form_of(const NetShape& shape, const PointArray& polar);
/// The inverse.
PointArray polar_of(const NetShape& shape, const PointArray& form);

/// Of a patch, whichever of the two it keeps.
inline const PointArray& polar_of(const BezierPatch& patch) { return patch.control_net(); }
inline PointArray polar_of(const PolynomialPatch& patch) {
    return polar_of(patch.shape(), patch.coefficients());
}
inline PointArray form_of(const BezierPatch& patch) { return form_of(patch.shape(), patch.control_net()); }
inline const PointArray& form_of(const PolynomialPatch& patch) { return patch.coefficients(); }

/// The derivative in these directions, k_f of them in factor f of degree n_f: prod n_f! / (n_f - k_f)! times
/// the value at n_f - k_f copies of the point and the directions; zero where k_f > n_f.
Coordinates polar_derivative_at(const NetShape& shape, const PointArray& polar,
                                const PatchArguments& directions, const PatchPoint& at, const Limits& limits);

/// The same as values at the elements of the frame, of degrees n_f - k_f; zero of degree 0 where some k_f >
/// n_f.
std::pair<NetShape, PointArray> polar_derivative(NetShape shape, const PointArray& polar,
                                                 const PatchArguments& directions, const Limits& limits);

/// Errors: `wrong_arity`; `mismatched_dimensions`, at the factor.
void require_point(std::span<const SimplexFactor> shape, const PatchPoint& point);
/// Errors: the same for each direction, below `Part::directions`.
void require_directions(const NetShape& shape, const PatchArguments& directions);

/// Errors: `not_affine` unless the coordinates have the sum `mass`; `what` is a point or a vector.
void require_mass(const Coordinates& tuple, int mass, const std::string& what);
/// The same of (mass, x_1, ..., x_s).
void require_first(const Coordinates& tuple, int mass, const std::string& what);
/// require(tuple, mass, what) for each of the lists, at the factor and the index in its list.
template <class Require>
void require_masses(const PatchArguments& lists, int mass, const std::string& what, const Require& require) {
    for (std::size_t f = 0; f < lists.size(); ++f) {
        within(f, [&] {
            for (std::size_t i = 0; i < lists[f].size(); ++i)
                within(i, [&] { require(lists[f][i], mass, what); });
        });
    }
}

}  // namespace blossom
