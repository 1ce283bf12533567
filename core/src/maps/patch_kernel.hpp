#pragma once

// The algorithms that control nets and monomial coefficients share: both are weighted by products of powers
// of the coordinates of an argument, with respect to the vertices or to the origin and the unit vectors.

#include <blossom/core/maps/patch_map.hpp>
#include <blossom/rational/error.hpp>

#include <string>
#include <utility>

#include "integer_tuple.hpp"

namespace blossom {

/// The numbers of a net. `greatest` is the largest magnitude among the values of the blossom at the elements
/// of its frame.
NetSums net_sums(const NetShape& shape, const PointArray& net, const Integer& greatest);
/// Whether all sums at tuples of words are within the limits.
bool words_are_within(const NetSums& sums, const Limits& limits);

/// The blossom with the values `polar` at the elements of the frame in which the arguments are given: prod_j
/// sum_k argument_jk X_k, factor by factor, with the values substituted for the monomials in X.
Coordinates polar_value(const NetShape& shape, const PointArray& polar, const PatchArguments& arguments,
                        const Limits& limits);

/// The values times the multinomial coefficients: the coefficients of a homogeneous polynomial.
PointArray form_of(const NetShape& shape, const PointArray& polar);
/// The inverse of `form_of`.
PointArray polar_of(const NetShape& shape, const PointArray& form);

/// The values of a patch in either representation.
inline const PointArray& polar_of(const BezierPatch& patch) { return patch.control_net(); }
inline PointArray polar_of(const PolynomialPatch& patch) {
    return polar_of(patch.shape(), patch.coefficients());
}
inline PointArray form_of(const BezierPatch& patch) { return form_of(patch.shape(), patch.control_net()); }
inline const PointArray& form_of(const PolynomialPatch& patch) { return patch.coefficients(); }

/// The derivative in these directions, k_f of them in factor f of degree n_f: prod n_f! / (n_f - k_f)! times
/// the value at n_f - k_f copies of the point and the directions; zero if some k_f > n_f.
Coordinates polar_derivative_at(const NetShape& shape, const PointArray& polar,
                                const PatchArguments& directions, const PatchPoint& at, const Limits& limits);

/// The same derivative as values at the elements of the frame, of degrees n_f - k_f; zero of degree 0 if some
/// k_f > n_f.
std::pair<NetShape, PointArray> polar_derivative(NetShape shape, const PointArray& polar,
                                                 const PatchArguments& directions, const Limits& limits);

/// `factor` times the values at the elements of the frame with these arguments besides, k_f of them in factor
/// f, of degrees n_f - k_f. One level of de Casteljau's algorithm per argument.
std::pair<NetShape, PointArray> partial_polar(NetShape shape, const PointArray& polar,
                                              const PatchArguments& arguments, const Integer& factor,
                                              const Limits& limits);

/// Errors: `wrong_arity` for more arguments than the degree of a factor; `mismatched_dimensions`.
void require_some_arguments(const NetShape& shape, const PatchArguments& arguments);

/// Errors: `wrong_arity`; `mismatched_dimensions`, at the factor.
void require_point(std::span<const SimplexFactor> shape, const PatchPoint& point);
/// The errors of `require_point` for each direction, below `Part::directions`.
void require_directions(const NetShape& shape, const PatchArguments& directions);

/// Errors: `not_affine` unless the sum of the coordinates is `mass`; `what` names the tuple, a point or a
/// vector.
void require_mass(const Coordinates& tuple, int mass, const std::string& what);
/// The same for the first entry of (mass, x_1, ..., x_s).
void require_first(const Coordinates& tuple, int mass, const std::string& what);
/// Calls require(tuple, mass, what) for each tuple; the places of errors are the factor and the index in its
/// list.
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
