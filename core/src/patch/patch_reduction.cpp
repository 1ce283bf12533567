#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/patch/curve_along.hpp>
#include <blossom/core/patch/patch_reduction.hpp>
#include <blossom/core/patch/tensor_bspline_change.hpp>
#include <blossom/core/spline/spline_reduction.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "blossom/patch_product.hpp"

namespace blossom {

namespace {

void require_each(std::size_t given, std::size_t factors, ReductionMethod method) {
    if (given != factors) {
        throw Error(ErrorCode::wrong_arity,
                    std::to_string(given) + " degrees for " + std::to_string(factors) + " factors", Part::to);
    }
    if (method == ReductionMethod::uniform) {
        throw Error(ErrorCode::wrong_kind, "the best uniform approximation is known for curves only");
    }
}

void require_lower(std::size_t n, std::size_t m) {
    if (m <= n) return;
    throw Error(ErrorCode::degree_too_low,
                "degree " + std::to_string(n) + " cannot be reduced to " + std::to_string(m) +
                    ": the new degree must not be greater; raise it instead",
                Part::to);
}

/// The volume of a simplex, by the determinant of its edges from vertex 0.
Rational simplex_volume(const BarycentricFrame& frame) {
    const std::size_t s = frame.dimension();
    const auto& vertices = frame.vertices();
    std::vector<Coordinates> edges;
    for (std::size_t k = 1; k <= s; ++k) {
        edges.push_back(vertices[k]);
        for (std::size_t j = 0; j < s; ++j) edges.back()[j] -= vertices[0][j];
    }
    Rational product = 1;
    for (std::size_t i = 0; i < s; ++i) {
        const auto pivot = std::find_if(edges.begin() + static_cast<std::ptrdiff_t>(i), edges.end(),
                                        [&](const Coordinates& edge) { return !edge[i].is_zero(); });
        std::iter_swap(edges.begin() + static_cast<std::ptrdiff_t>(i), pivot);
        product *= edges[i][i];
        for (std::size_t k = i + 1; k < s; ++k) {
            const Rational factor = edges[k][i] / edges[i][i];
            for (std::size_t j = i; j < s; ++j) edges[k][j] -= factor * edges[i][j];
        }
    }
    return abs(product) / Rational(factorial(s));
}

BezierPatch net_difference(const BezierPatch& patch, const BezierPatch& other) {
    std::vector<Coordinates> points = patch.control_net().to_points();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Coordinates subtracted = other.control_net()[i];
        for (std::size_t j = 0; j < subtracted.size(); ++j) points[i][j] -= subtracted[j];
    }
    return {patch.shape(), PointArray(points)};
}

/// The unit net with one coordinate per control point, in which `elevate` shows what it does to each.
BezierPatch unit_net(const NetShape& shape) {
    std::vector<Coordinates> points(shape.size(), Coordinates(shape.size()));
    for (std::size_t i = 0; i < points.size(); ++i) points[i][i] = 1;
    return {shape, PointArray(points)};
}

/// Solves the equations of a positive definite matrix, whose right sides are the last entries of the rows.
std::vector<Coordinates> solved_rows(std::vector<Coordinates> rows) {
    const std::size_t size = rows.size();
    for (std::size_t i = 0; i < size; ++i) {
        const Rational pivot = rows[i][i];
        for (std::size_t j = i; j < rows[i].size(); ++j) rows[i][j] /= pivot;
        for (std::size_t k = 0; k < size; ++k) {
            if (k == i || rows[k][i].is_zero()) continue;
            const Rational factor = rows[k][i];
            for (std::size_t j = i; j < rows[k].size(); ++j) rows[k][j] -= factor * rows[i][j];
        }
    }
    for (Coordinates& row : rows) row.erase(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(size));
    return rows;
}

/// The net of degree m that is nearest to the one of a simplex after raising.
BezierPatch nearest_net(const BezierPatch& patch, std::size_t m, const Limits& limits) {
    const std::size_t n = patch.shape()[0].degree;
    require_lower(n, m);
    if (m == n) return patch;
    const NetShape shape = patch.shape().with_degree(0, m, limits);
    const std::size_t size = shape.size();
    require_product_within({size, patch.shape().size(), size}, limits.numbers, "numbers",
                           "the number of products of the equations", Part::to);
    const auto raised = elevate(unit_net(shape), 0, n - m, limits).control_net().to_points();
    const auto given = patch.control_net().to_points();
    std::vector<Coordinates> rows(size, Coordinates(size + patch.dimension()));
    for (std::size_t k = 0; k < raised.size(); ++k) {
        for (std::size_t i = 0; i < size; ++i) {
            if (raised[k][i].is_zero()) continue;
            for (std::size_t j = 0; j < size; ++j) rows[i][j] += raised[k][i] * raised[k][j];
            for (std::size_t j = 0; j < given[k].size(); ++j) rows[i][size + j] += raised[k][i] * given[k][j];
        }
    }
    return {shape, PointArray(solved_rows(std::move(rows)))};
}

BezierPatch reduced_along(const BezierPatch& patch, std::size_t factor, std::size_t m, ReductionMethod method,
                          const Limits& limits) {
    // A reduction does not depend on the interval.
    std::vector<BarycentricFrame> unit(patch.shape().factors(), BarycentricFrame::standard(1));
    return changed_along(PlacedPatch{patch, std::move(unit)}, factor,
                         [&](const BezierCurve& rows) { return reduce(rows, m, method, limits).curve; })
        .patch;
}

}  // namespace

Rational integral_of_square(const BezierPatch& patch, std::span<const BarycentricFrame> frames,
                            const Limits& limits) {
    const Form form = form_rows(patch);
    const ProductTable table(form.shape, form.shape, limits);
    Rational sum;
    for (const auto& row : form.rows) {
        const auto square = patch_of<BezierPatch>(
            {table.shape(), {table.product(row, row)}, form.denominator * form.denominator});
        for (const Coordinates& point : square.control_net().to_points()) sum += point.front();
    }
    sum /= Rational(table.shape().size());
    for (std::size_t f = 0; f < patch.shape().factors(); ++f)
        sum *= f < frames.size() ? simplex_volume(frames[f])
                                 : Rational(1) / Rational(factorial(patch.shape()[f].dimension));
    return sum;
}

PatchReduction reduce(const BezierPatch& patch, std::span<const BarycentricFrame> frames,
                      std::span<const std::size_t> degrees, ReductionMethod method, const Limits& limits) {
    const NetShape& shape = patch.shape();
    require_each(degrees.size(), shape.factors(), method);
    BezierPatch reduced = patch;
    std::vector<std::size_t> own;
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        own.push_back(shape[f].degree);
        if (shape[f].dimension == 1) {
            reduced = reduced_along(reduced, f, degrees[f], method, limits);
            continue;
        }
        if (shape.factors() > 1) {
            throw Error(ErrorCode::wrong_kind,
                        "a product of simplices is reduced where it is a simplex or a box");
        }
        if (method != ReductionMethod::least_squares) {
            throw Error(ErrorCode::wrong_kind, "a simplex is reduced by least-squares, not by " +
                                                   std::string(reduction_method_name(method)));
        }
        reduced = nearest_net(reduced, degrees[f], limits);
    }
    const BezierPatch raised = elevated_to(reduced, own, limits);
    return {std::move(reduced), integral_of_square(net_difference(patch, raised), frames, limits)};
}

TensorReduction reduce(const TensorBSpline& spline, std::span<const std::size_t> degrees,
                       ReductionMethod method, const Limits& limits) {
    require_each(degrees.size(), spline.directions(), method);
    TensorReduction result{spline, 0};
    for (std::size_t d = 0; d < degrees.size(); ++d) {
        require_lower(spline.knots(d).degree(), degrees[d]);
        if (degrees[d] == spline.knots(d).degree()) continue;
        result.spline = changed_along(result.spline, d, [&](const BSplineCurve& rows) {
            return reduce(rows, degrees[d], method, limits).curve;
        });
    }
    std::vector<std::size_t> own;
    for (const KnotVector& knots : spline.knots()) own.push_back(knots.degree());
    for (const auto& spans : boxes_of(spline, limits)) {
        const PlacedPatch piece = placed_segment(spline, spans, limits);
        std::vector<Rational> corner;
        for (const Interval& interval : box_of(spline, spans)) corner.push_back(interval.a());
        const PlacedPatch reduced = placed_segment(result.spline, spans_at(result.spline, corner), limits);
        const BezierPatch raised = elevated_to(over_frames(reduced, piece.frames, limits), own, limits);
        result.l2_squared += integral_of_square(net_difference(piece.patch, raised), piece.frames, limits);
    }
    return result;
}

}  // namespace blossom
