#include <blossom/core/blossom/polar.hpp>
#include <blossom/core/patch/combined_maps.hpp>
#include <blossom/core/patch/curve_along.hpp>
#include <blossom/core/patch/tensor_bspline_change.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/lists.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include "spline/spline_pieces.hpp"
#include "tensor_rows.hpp"

namespace blossom {

namespace {

bool is_inside(const Rational& knot, const Interval& domain) {
    return domain.a() < knot && knot < domain.b();
}

void require_same_boxes(std::span<const TensorBSpline> maps) {
    for (std::size_t i = 0; i < maps.size(); ++i) {
        if (maps[i].directions() != maps[0].directions()) {
            throw Error(ErrorCode::mismatched_dimensions,
                        "map " + std::to_string(i) + " has " + std::to_string(maps[i].directions()) +
                            " directions, map 0 has " + std::to_string(maps[0].directions()),
                        Part::maps / i);
        }
        for (std::size_t d = 0; d < maps[i].directions(); ++d) {
            const Interval own = maps[i].knots(d).domain();
            const Interval first = maps[0].knots(d).domain();
            if (own == first) continue;
            throw Error(ErrorCode::outside_domain,
                        "map " + std::to_string(i) + " is over [" + to_string(own.a()) + ", " +
                            to_string(own.b()) + "], map 0 over [" + to_string(first.a()) + ", " +
                            to_string(first.b()) + "]",
                        Part::maps / i);
        }
    }
}

/// The knots of all maps inside the domain, in order, each with the multiplicity that keeps the order of
/// contact in degree n.
std::vector<KnotMultiplicity> common_inner_knots(std::span<const TensorBSpline> maps, std::size_t direction,
                                                 std::size_t n) {
    const Interval domain = maps[0].knots(direction).domain();
    std::vector<KnotMultiplicity> common;
    for (const TensorBSpline& map : maps) {
        const KnotVector& knots = map.knots(direction);
        for (const auto& [knot, multiplicity] : knots.distinct()) {
            if (!is_inside(knot, domain)) continue;
            const std::size_t needed =
                multiplicity + n >= knots.degree() ? multiplicity + n - knots.degree() : 0;
            const auto place = std::ranges::lower_bound(common, knot, {}, &KnotMultiplicity::knot);
            if (place != common.end() && place->knot == knot) {
                place->multiplicity = std::max(place->multiplicity, needed);
            } else {
                common.insert(place, {knot, needed});
            }
        }
    }
    return common;
}

/// Knots of degree n over the domain: `end` times its ends, and the inner ones, each `every` times or by its
/// multiplicity.
KnotVector knots_with_ends(std::size_t n, const Interval& domain, std::span<const KnotMultiplicity> inner,
                           std::size_t every) {
    std::vector<Rational> knots(n + 1, domain.a());
    for (const auto& [knot, multiplicity] : inner)
        knots.insert(knots.end(), every > 0 ? every : multiplicity, knot);
    knots.insert(knots.end(), n + 1, domain.b());
    const std::size_t points = knots.size() - n - 1;
    return {n, std::move(knots), points};
}

/// The map with every inner knot of all maps.
TensorBSpline refined(const TensorBSpline& map, std::size_t direction,
                      std::span<const KnotMultiplicity> inner, const Limits& limits) {
    std::vector<Rational> missing;
    for (const auto& [knot, multiplicity] : inner) {
        if (map.knots(direction).multiplicity(knot) == 0) missing.push_back(knot);
    }
    return missing.empty() ? map : insert_knots(map, direction, missing, limits);
}

/// Nets on boxes, the last direction fastest, as one grid.
PointGrid grid_of_boxes(std::span<const BezierPatch> nets, std::span<const std::size_t> boxes) {
    const NetShape& shape = nets.front().shape();
    const std::size_t directions = shape.factors();
    PointGrid grid;
    std::size_t size = 1;
    for (std::size_t d = 0; d < directions; ++d) {
        grid.counts.push_back(boxes[d] * shape.count(d));
        size *= grid.counts.back();
    }
    grid.points.resize(size);
    for (std::size_t b = 0; b < nets.size(); ++b) {
        const std::vector<Coordinates> points = nets[b].control_net().to_points();
        for (std::size_t i = 0; i < points.size(); ++i) {
            std::size_t box = b;
            std::size_t index = i;
            std::size_t place = 0;
            std::size_t stride = 1;
            for (std::size_t d = directions; d-- > 0;) {
                place += stride * (box % boxes[d] * shape.count(d) + index % shape.count(d));
                stride *= grid.counts[d];
                box /= boxes[d];
                index /= shape.count(d);
            }
            grid.points[place] = points[i];
        }
    }
    return grid;
}

bool are_affine(std::span<const CoordinateSum> sums) {
    return std::ranges::all_of(sums, [](const CoordinateSum& sum) {
        return std::ranges::all_of(
            sum, [](const CoordinateProduct& product) { return product.coordinates.size() <= 1; });
    });
}

/// Affine combinations of maps over the same knots: those of their control points.
TensorBSpline combined_points(std::span<const TensorBSpline> maps, std::span<const CoordinateSum> sums) {
    std::vector<Coordinates> points;
    for (std::size_t i = 0; i < maps[0].control_points().size(); ++i) {
        Coordinates& point = points.emplace_back(sums.size());
        for (std::size_t j = 0; j < sums.size(); ++j) {
            for (const auto& [coordinates, factor] : sums[j]) {
                Rational term = factor;
                for (const auto& [map, coordinate] : coordinates)
                    term *= maps[map].control_points()[i][coordinate];
                point[j] += term;
            }
        }
    }
    return {maps[0].knots(), std::move(points)};
}

/// The map that piecewise(nets) makes on each box of the nets of all maps, of degrees[d] in direction d and
/// into so many dimensions.
template <class Piecewise>
TensorBSpline on_common_boxes(std::span<const TensorBSpline> maps, std::span<const std::size_t> degrees,
                              std::size_t dimension, const Piecewise& piecewise, const Limits& limits) {
    std::vector<TensorBSpline> operands(maps.begin(), maps.end());
    std::vector<KnotVector> knots;      // of the result
    std::vector<KnotVector> separated;  // of its pieces, which have no points in common
    std::vector<std::size_t> boxes;
    std::size_t count = std::max<std::size_t>(dimension, 1);
    for (std::size_t d = 0; d < degrees.size(); ++d) {
        const std::size_t n = degrees[d];
        const KnotVector& first = maps[0].knots(d);
        const auto inner = common_inner_knots(maps, d, n);
        const auto has_these = [&](const TensorBSpline& map) { return map.knots(d) == first; };
        const bool same = n == first.degree() && std::ranges::all_of(maps, has_these);
        boxes.push_back(inner.size() + 1);
        const std::size_t row = boxes.back() * (n + 1);
        require_product_within({row, count}, limits.numbers, "numbers", "the number of points of the result",
                               Part::maps);
        count *= row;
        knots.push_back(same ? first : knots_with_ends(n, first.domain(), inner, 0));
        separated.push_back(knots_with_ends(n, first.domain(), inner, n + 1));
        for (TensorBSpline& operand : operands) operand = refined(operand, d, inner, limits);
    }
    // Of each box, for each map.
    const auto spans =
        mapped(operands, [&](const TensorBSpline& operand) { return boxes_of(operand, limits); });
    std::vector<BezierPatch> nets;
    for (std::size_t b = 0; b < spans.front().size(); ++b) {
        std::vector<BezierPatch> pieces;
        pieces.reserve(operands.size());
        for (std::size_t i = 0; i < operands.size(); ++i)
            pieces.push_back(bezier_segment(operands[i], spans[i][b], limits));
        nets.push_back(piecewise(pieces));
    }
    TensorBSpline result(std::move(separated), grid_of_boxes(nets, boxes).points);
    for (std::size_t d = 0; d < knots.size(); ++d) {
        result = changed_along(result, d, [&](const BSplineCurve& rows) {
            return spline_of_pieces(knots[d], bezier_segments(rows, limits), limits);
        });
    }
    return result;
}

/// The greatest degree of the products in one direction.
std::size_t degree_of_sums(std::span<const TensorBSpline> maps, std::span<const CoordinateSum> sums,
                           std::size_t direction, const Limits& limits) {
    std::size_t greatest = 0;
    for (const CoordinateSum& sum : sums) {
        for (const CoordinateProduct& product : sum) {
            std::size_t degree = 0;
            for (const CoordinateOf& one : product.coordinates)
                degree += maps[one.map].knots(direction).degree();
            greatest = std::max(greatest, degree);
        }
    }
    require_within(greatest, limits.degree, "degree", "the degree of a product", Part::maps);
    return greatest;
}

}  // namespace

TensorBSpline combined(std::span<const TensorBSpline> maps, std::span<const CoordinateSum> sums,
                       const Limits& limits) {
    if (maps.empty()) throw Error(ErrorCode::wrong_arity, "at least one map is needed", Part::maps);
    require_same_boxes(maps);
    const auto has_first_knots = [&](const TensorBSpline& map) { return map.knots() == maps[0].knots(); };
    if (are_affine(sums) && std::ranges::all_of(maps, has_first_knots)) return combined_points(maps, sums);
    std::vector<std::size_t> degrees;
    degrees.reserve(maps[0].directions());
    for (std::size_t d = 0; d < maps[0].directions(); ++d)
        degrees.push_back(degree_of_sums(maps, sums, d, limits));
    const auto piecewise = [&](const std::vector<BezierPatch>& pieces) {
        return combined(std::span<const BezierPatch>(pieces), sums, limits);
    };
    return on_common_boxes(maps, degrees, sums.size(), piecewise, limits);
}

BSplineCurve combined(std::span<const BSplineCurve> maps, std::span<const CoordinateSum> sums,
                      const Limits& limits) {
    std::vector<TensorBSpline> splines;
    for (const BSplineCurve& curve : maps)
        splines.emplace_back(std::vector{curve.knots()}, curve.control_points());
    const TensorBSpline result = combined(std::span<const TensorBSpline>(splines), sums, limits);
    return {result.knots(0), result.control_points()};
}

template <PatchRepresentation Outer>
TensorBSpline composed(const Outer& outer, const TensorBSpline& arguments, const Limits& limits) {
    std::vector<std::size_t> degrees(arguments.directions());
    for (std::size_t d = 0; d < degrees.size(); ++d) {
        for (const SimplexFactor& factor : outer.shape().list())
            degrees[d] += factor.degree * arguments.knots(d).degree();
        require_within(degrees[d], limits.degree, "degree", "the degree of the composition");
    }
    const auto piecewise = [&](const std::vector<BezierPatch>& pieces) {
        return composed(outer, pieces.front(), limits);
    };
    return on_common_boxes(std::span(&arguments, 1), degrees, outer.dimension(), piecewise, limits);
}

template TensorBSpline composed(const BezierPatch&, const TensorBSpline&, const Limits&);
template TensorBSpline composed(const PolynomialPatch&, const TensorBSpline&, const Limits&);

}  // namespace blossom
