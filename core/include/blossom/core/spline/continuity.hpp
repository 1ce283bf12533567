#pragma once

#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/blossom/contact.hpp>
#include <blossom/core/maps/bspline_curve.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace blossom {

/// The contact of two curves; its first difference, for order k, is at (s^(n-k-1), (s + 1)^(k+1)).
using Contact = ContactAt<std::vector<Argument>>;
using BlossomDifference = DifferenceAt<std::vector<Argument>>;

/// The contact of two maps at s, decided by their blossoms of the greater of the two formal degrees: it has
/// order k or more if and only if f(x_1, ..., x_k, s, ..., s) = g(x_1, ..., x_k, s, ..., s) for all x_i.
/// Since blossoms are affine in each argument, the values with every x_i = s or s + 1 decide, and each order
/// adds only the value with all x_i = s + 1.
///
/// Cost: O(n^2) multiply-adds. Errors: `mismatched_dimensions`, `limit_exceeded`.
/// Source: DeRose, theorem 2 and equations (5) to (7). Statements: derose-thm2, derose-eq6, derose-ck-def.
Contact contact(const PolynomialMap& left, const PolynomialMap& right, const Rational& s,
                const Limits& limits = {});

/// The spans on the two sides of s; they are equal if s is not a knot.
/// Errors: `outside_domain` unless s is strictly inside the domain.
std::pair<std::size_t, std::size_t> sides(const KnotVector& knots, const Rational& s);

/// The contact of the segments on the two sides of s: at a knot of multiplicity m its order is at least n -
/// m; it is infinite if s is not a knot. Errors: `outside_domain` unless s is strictly inside the domain;
/// `limit_exceeded`. Source: DeRose, section 4.6. Statements: derose-46-c2cond, derose-46-general-cd1.
Contact contact(const BSplineCurve& curve, const Rational& s, const Limits& limits = {});

/// The geometric meaning of contact of order k: the curves share "the point", "the tangent", "the osculating
/// parabola", "the osculating curve of degree k". Its blossom is f(x_1, ..., x_k, s^(n-k)).
std::string osculating_name(std::size_t order);

/// For instance "The curves meet with order 1 at 3, sharing the tangent but not the osculating parabola".
std::string contact_text(std::ptrdiff_t order, const Rational& s);

/// A contact and its reason as a sentence: `contact_text`, followed by, for instance, ": the blossom values
/// at (3, 4, 4) are (1, 2) and (1, 3)".
std::string to_string(const Contact& contact, const Rational& s);

}  // namespace blossom
