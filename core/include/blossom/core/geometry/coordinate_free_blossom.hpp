#pragma once

#include <blossom/core/algebra/sparse_polynomial.hpp>
#include <blossom/core/geometry/affine_map.hpp>
#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/core/maps/knot_vector.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace blossom::geometry {

/// One list per factor of the domain.
using PointLists = std::vector<std::vector<Point>>;
using VectorLists = std::vector<std::vector<Vector>>;

/// The blossom of a polynomial map between affine spaces. It takes points of the domain to a point of the
/// range, and is symmetric and affine in the arguments of each factor. If a vector is among the arguments,
/// the value is a vector.
///
/// The domain is one simplex, or a product of simplices that may lie in different spaces (tensor products);
/// arguments are any points of the spaces, inside or outside the simplices. Source: DeRose, section 6.
/// Statements: derose-adt-blossom, derose-adt-list.
class Blossom {
public:
    /// The blossom with these values at the vertices of a simplex, in the order of `NetShape`.
    /// Errors: `incomplete_net`, `different_spaces`, `limit_exceeded`. Source: DeRose, section 6,
    /// BlossomCreateFromBezierNet.
    static Blossom from_bezier_net(const Simplex& domain, std::size_t degree, std::span<const Point> net,
                                   const Limits& limits = {});
    /// The same over a product of simplices, with one degree per factor.
    static Blossom from_bezier_net(std::vector<Simplex> domain, std::span<const std::size_t> degrees,
                                   std::span<const Point> net, const Limits& limits = {});
    /// The blossom of one segment of a B-spline curve: of the polynomial on span i of the knots, given by its
    /// control points. `line` is a space of dimension 1. Errors: `wrong_arity`, `outside_domain`,
    /// `mismatched_dimensions`, `different_spaces`.
    static Blossom from_bspline(const Space& line, const KnotVector& knots,
                                std::span<const Point> control_points, std::size_t span,
                                const Limits& limits = {});
    /// The blossom of a polynomial of formal degree n in the coordinates of `domain`, with one polynomial for
    /// each coordinate of `range`. Errors: `degree_too_low`, `wrong_arity`, `mismatched_dimensions`.
    static Blossom from_polynomial(const Space& domain, const Space& range, std::size_t degree,
                                   std::span<const SparsePolynomial> coordinates, const Limits& limits = {});
    /// The blossom of a map that can be evaluated, by the inverse formula from its values on the simplex:
    /// exact if the map is a polynomial of this degree. Source: Fernandez-Jambrina, equation (23).
    static Blossom from_values(const Simplex& domain, std::size_t degree,
                               const std::function<Point(const Point&)>& map, const Limits& limits = {});
    /// An affine map as a blossom of one argument.
    static Blossom from_affine_map(const AffineMap& map);

    const std::vector<Simplex>& domain() const { return domain_; }
    const Space& range() const { return range_; }
    std::size_t degree(std::size_t factor = 0) const { return patch_.shape()[factor].degree; }
    /// The control net over the simplices of the domain.
    const BezierPatch& patch() const { return patch_; }

    /// The value at n points, n the degree. Errors: `wrong_arity`, `different_spaces`, `outside_domain` for a
    /// point outside the affine hull of its simplex. Source: DeRose, section 6, BlossomEvaluate.
    Point operator()(std::span<const Point> arguments) const;
    Point operator()(const PointLists& arguments) const;
    /// The value with at least one vector among the arguments. Additional error: `wrong_arity` if there is no
    /// vector.
    Vector operator()(std::span<const Point> points, std::span<const Vector> vectors) const;
    Vector operator()(const PointLists& points, const VectorLists& vectors) const;

    /// The value of the map: all arguments are equal, with one point per factor.
    Point evaluate(const Point& point) const;
    Point evaluate(std::span<const Point> point) const;
    /// The derivative of order k at a point in k directions, n! / (n - k)! times a value; zero for k > n.
    Vector derivative(const Point& at, std::span<const Vector> directions) const;

    /// The control net over another simplex, with i_k copies of vertex k; every restriction, subdivision and
    /// conversion is such a net. Errors: `different_spaces`, `wrong_arity` for a domain of several factors.
    std::vector<Point> bezier_net(const Simplex& simplex) const;

private:
    Blossom(std::vector<Simplex> domain, Space range, BezierPatch patch, Limits limits)
        : domain_(std::move(domain)), range_(std::move(range)), patch_(std::move(patch)), limits_(limits) {}

    PatchArguments arguments(const PointLists& points, const VectorLists& vectors) const;

    std::vector<Simplex> domain_;
    Space range_;
    BezierPatch patch_;
    Limits limits_;
};

}  // namespace blossom::geometry
