#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/blossom/patch_subdivision.hpp>
#include <blossom/core/curve/roots.hpp>
#include <blossom/core/patch/edge_contact.hpp>
#include <blossom/core/patch/patch_conversion.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>
#include <utility>

#include "edge_rows.hpp"

namespace blossom {

namespace {

Coordinates plane_sum(const Coordinates& point, const Coordinates& vector, const Rational& factor = 1) {
    return {point[0] + factor * vector[0], point[1] + factor * vector[1]};
}

Coordinates plane_difference(const Coordinates& to, const Coordinates& from) {
    return {to[0] - from[0], to[1] - from[1]};
}

/// Twice the area between two vectors, positive where the second is to the left of the first.
Rational cross(const Coordinates& u, const Coordinates& v) { return u[0] * v[1] - u[1] * v[0]; }

bool is_parallel(const PlaneSegment& segment, const Coordinates& point) {
    return cross(plane_difference(segment.end, segment.begin), plane_difference(point, segment.begin))
        .is_zero();
}

/// The parameter of a point of the line through a segment.
Rational parameter_on(const PlaneSegment& segment, const Coordinates& point) {
    const Coordinates along = plane_difference(segment.end, segment.begin);
    const std::size_t axis = along[0].is_zero() ? 1 : 0;
    return (point[axis] - segment.begin[axis]) / along[axis];
}

/// The parameters of `segment` at which the line of `edge` covers it, in rising order.
std::optional<std::pair<Rational, Rational>> covered_part(const PlaneSegment& segment,
                                                          const PlaneSegment& edge) {
    if (!is_parallel(segment, edge.begin) || !is_parallel(segment, edge.end)) return std::nullopt;
    Rational from = parameter_on(segment, edge.begin);
    Rational to = parameter_on(segment, edge.end);
    if (to < from) std::swap(from, to);
    from = std::max(from, Rational(0));
    to = std::min(to, Rational(1));
    if (to <= from) return std::nullopt;
    return std::pair(std::move(from), std::move(to));
}

/// The corners of the domain, around it.
std::vector<Coordinates> corners_of(const PlacedPatch& patch) {
    if (patch.frames.size() == 1 && patch.frames[0].dimension() == 2 &&
        patch.frames[0].space_dimension() == 2) {
        return patch.frames[0].vertices();
    }
    const bool box =
        patch.frames.size() == 2 && patch.frames[0].dimension() == 1 && patch.frames[1].dimension() == 1;
    if (!box) {
        throw Error(ErrorCode::mismatched_dimensions,
                    "edges are those of maps over a triangle of the plane or over a rectangle");
    }
    const auto& u = patch.frames[0].vertices();
    const auto& v = patch.frames[1].vertices();
    return {{u[0][0], v[0][0]}, {u[1][0], v[0][0]}, {u[1][0], v[1][0]}, {u[0][0], v[1][0]}};
}

/// A corner of the domain off the line of one of its edges.
Coordinates corner_off(const PlacedPatch& patch, const PlaneSegment& segment) {
    const std::vector<Coordinates> corners = corners_of(patch);
    return *std::ranges::find_if(corners,
                                 [&](const Coordinates& corner) { return !is_parallel(segment, corner); });
}

/// Where one piece covers a segment.
struct CoveredPart {
    std::size_t piece;
    Rational from;
    Rational to;
};

std::vector<CoveredPart> parts_on(std::span<const PlacedPatch> pieces, const PlaneSegment& segment) {
    std::vector<CoveredPart> parts;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (const PlaneSegment& edge : edges_of(pieces[i])) {
            if (auto covered = covered_part(segment, edge))
                parts.push_back({i, std::move(covered->first), std::move(covered->second)});
        }
    }
    return parts;
}

/// Errors: `degenerate_simplex`; `not_adjacent` unless the parts make up the whole segment.
std::vector<CoveredPart> required_parts(std::span<const PlacedPatch> pieces, const NamedEdge& edge) {
    if (edge.segment.begin == edge.segment.end)
        throw Error(ErrorCode::degenerate_simplex, "the ends of the edge are the same point");
    if (edge.off && is_parallel(edge.segment, *edge.off))
        throw Error(ErrorCode::degenerate_simplex, "the third point lies on the line of the edge");
    std::vector<CoveredPart> parts = parts_on(pieces, edge.segment);
    std::ranges::sort(parts, {}, &CoveredPart::from);
    Rational reached;
    for (const CoveredPart& part : parts) {
        if (part.from > reached) break;
        reached = std::max(reached, part.to);
    }
    if (reached < Rational(1)) {
        throw Error(ErrorCode::not_adjacent,
                    "the segment does not lie on edges of the domain: it leaves them at the parameter " +
                        to_string(reached) + " from its beginning");
    }
    return parts;
}

/// From the edge into the domain: across a box a unit vector, in a triangle to its opposite vertex.
Coordinates inwards(const PlacedPatch& patch, const PlaneSegment& segment) {
    Coordinates vector = plane_difference(corner_off(patch, segment), segment.begin);
    if (patch.frames.size() == 1) return vector;
    const std::size_t axis = segment.begin[0] == segment.end[0] ? 0 : 1;
    Coordinates unit(2);
    unit[axis] = vector[axis].sign();
    return unit;
}

std::vector<Joint> joints_along(std::span<const PlacedPatch> left, std::span<const PlacedPatch> right,
                                const NamedEdge& left_edge, const NamedEdge& right_edge,
                                const std::vector<CoveredPart>& of_left,
                                const std::vector<CoveredPart>& of_right) {
    std::vector<Joint> found;
    for (const CoveredPart& one : of_left) {
        for (const CoveredPart& other : of_right) {
            const Rational from = std::max(one.from, other.from);
            const Rational to = std::min(one.to, other.to);
            if (to <= from) continue;
            const Coordinates before = left_edge.off
                                           ? plane_difference(*left_edge.off, left_edge.segment.begin)
                                           : inwards(left[one.piece], left_edge.segment);
            Coordinates behind = right_edge.off ? plane_difference(*right_edge.off, right_edge.segment.begin)
                                                : inwards(right[other.piece], right_edge.segment);
            if (!right_edge.off)
                for (Rational& coordinate : behind) coordinate = -coordinate;
            const auto triangle = [&](const PlaneSegment& segment, const Coordinates& off) {
                const Coordinates begin = segment.at(from);
                return std::vector<Coordinates>{begin, segment.at(to), plane_sum(begin, off)};
            };
            found.push_back({one.piece, other.piece, triangle(left_edge.segment, before),
                             triangle(right_edge.segment, behind)});
        }
    }
    return found;
}

std::vector<Polynomial> boundary_curve(const PlacedPatch& patch, const PlaneSegment& segment,
                                       const Limits& limits) {
    const std::vector<Coordinates> triangle{segment.begin, segment.end, corner_off(patch, segment)};
    return EdgeRows(over_triangle(patch, triangle, limits)).points();
}

std::size_t curve_degree(const std::vector<Polynomial>& curve) {
    return std::ranges::max(curve, {}, &Polynomial::degree).degree();
}

/// The numbers a with a^n = r.
std::vector<Rational> rational_powers(const Rational& r, std::size_t n, const Limits& limits) {
    std::vector<Rational> found;
    for (const Root& root : roots(Polynomial::monomial(n) - Polynomial(r), ParameterRange(), 0, limits)) {
        if (root.is_rational()) found.push_back(root.lower);
    }
    return found;
}

/// The affine changes c, increasing or not, with p(t) = q(c(t)); none for a point.
std::vector<Polynomial> changes_between(const std::vector<Polynomial>& p, const std::vector<Polynomial>& q,
                                        const Limits& limits) {
    const std::size_t n = curve_degree(p);
    if (n == 0 || curve_degree(q) != n) return {};
    const auto leading = static_cast<std::size_t>(
        std::ranges::find_if(q, [&](const Polynomial& one) { return !one[n].is_zero(); }) - q.begin());
    std::vector<Polynomial> found;
    for (const Rational& a : rational_powers(p[leading][n] / q[leading][n], n, limits)) {
        if (a.is_zero()) continue;
        // The coefficient of t^(n-1) of q(a t + b).
        Rational power = 1;
        for (std::size_t k = 1; k < n; ++k) power *= a;
        const Rational b = (p[leading][n - 1] / power - q[leading][n - 1]) / (Rational(n) * q[leading][n]);
        const Polynomial change = Polynomial(b) + Polynomial(a) * Polynomial::monomial(1);
        bool same = true;
        for (std::size_t j = 0; same && j < p.size(); ++j) same = compose(q[j], change) == p[j];
        if (same) found.push_back(change);
    }
    return found;
}

}  // namespace

Coordinates PlaneSegment::at(const Rational& t) const {
    return plane_sum(begin, plane_difference(end, begin), t);
}

std::vector<PlaneSegment> edges_of(const PlacedPatch& patch) {
    const std::vector<Coordinates> corners = corners_of(patch);
    std::vector<PlaneSegment> edges;
    edges.reserve(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
        edges.push_back({corners[i], corners[(i + 1) % corners.size()]});
    return edges;
}

std::vector<Joint> joints(std::span<const PlacedPatch> left, std::span<const PlacedPatch> right) {
    std::vector<Joint> found;
    for (std::size_t i = 0; i < left.size(); ++i) {
        for (const PlaneSegment& edge : edges_of(left[i])) {
            for (const auto& [piece, from, to] : parts_on(right, edge)) {
                const Coordinates begin = edge.at(from);
                const std::vector<Coordinates> triangle{begin, edge.at(to),
                                                        plane_sum(begin, inwards(left[i], edge))};
                found.push_back({i, piece, triangle, triangle});
            }
        }
    }
    return found;
}

std::vector<Joint> joints(std::span<const PlacedPatch> left, std::span<const PlacedPatch> right,
                          const NamedEdge& left_edge, const NamedEdge& right_edge) {
    const auto of_left = within(Part::left, [&] { return required_parts(left, left_edge); });
    const auto of_right = within(Part::right, [&] { return required_parts(right, right_edge); });
    return joints_along(left, right, left_edge, right_edge, of_left, of_right);
}

std::vector<Joint> matching_joints(std::span<const PlacedPatch> left, std::span<const PlacedPatch> right,
                                   const Limits& limits) {
    std::vector<Joint> found;
    for (std::size_t i = 0; i < left.size(); ++i) {
        for (const PlaneSegment& edge : edges_of(left[i])) {
            const auto curve = boundary_curve(left[i], edge, limits);
            for (std::size_t k = 0; k < right.size(); ++k) {
                for (const PlaneSegment& other : edges_of(right[k])) {
                    for (const Polynomial& change :
                         changes_between(curve, boundary_curve(right[k], other, limits), limits)) {
                        // The parameters of the left edge that belong to [0, 1] on the right one.
                        Rational from = -change[0] / change[1];
                        Rational to = (Rational(1) - change[0]) / change[1];
                        if (to < from) std::swap(from, to);
                        from = std::max(from, Rational(0));
                        to = std::min(to, Rational(1));
                        if (to <= from) continue;
                        const NamedEdge one{{edge.at(from), edge.at(to)}, {}};
                        const NamedEdge two{{other.at(change(from)), other.at(change(to))}, {}};
                        auto more = joints_along(left, right, one, two, {{i, 0, 1}}, {{k, 0, 1}});
                        found.insert(found.end(), more.begin(), more.end());
                    }
                }
            }
        }
    }
    return found;
}

BezierPatch over_triangle(const PlacedPatch& patch, const std::vector<Coordinates>& vertices,
                          const Limits& limits) {
    const NetShape& shape = patch.patch.shape();
    if (shape.factors() == 1) {
        std::vector<Coordinates> elements;
        elements.reserve(vertices.size());
        for (const Coordinates& vertex : vertices) elements.push_back(patch.frames[0].of_point(vertex));
        return with_frame(patch.patch, 0, elements, limits);
    }
    const NetShape total = NetShape::simplex(2, shape[0].degree + shape[1].degree, limits);
    const BarycentricFrame frame(vertices);
    return control_net(regrouped(monomial_form(patch.patch, patch.frames, limits), total, limits),
                       std::span(&frame, 1), limits);
}

PatchContact joint_contact(std::span<const PlacedPatch> left, std::span<const PlacedPatch> right,
                           const Joint& joint, bool projected, const Limits& limits) {
    const std::vector<BarycentricFrame> frames{BarycentricFrame(joint.left)};
    const PlacedPatch one{over_triangle(left[joint.left_piece], joint.left, limits), frames};
    const PlacedPatch two{over_triangle(right[joint.right_piece], joint.right, limits), frames};
    const Face edge{{0, 1}};
    return projected ? projected_contact(one, two, edge, limits) : contact(one, two, edge, limits);
}

}  // namespace blossom
