#include <blossom/core/blossom/inverse_formula.hpp>
#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/blossom/patch_subdivision.hpp>
#include <blossom/core/geometry/coordinate_free_blossom.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/core/patch/patch_conversion.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>
#include <utility>

namespace blossom::geometry {

namespace {

std::vector<Coordinates> coordinates_of(std::span<const Point> points) {
    std::vector<Coordinates> coordinates;
    for (const Point& point : points) {
        require_same_space(points.front().space(), point.space());
        coordinates.push_back(point.coordinates());
    }
    return coordinates;
}

void require_line(const Space& line) {
    if (line.dimension() == 1) return;
    throw Error(
        ErrorCode::mismatched_dimensions,
        "the parameters of a curve lie in a space of dimension 1, not " + std::to_string(line.dimension()));
}

/// The origin and the ends of the unit vectors.
Simplex standard_simplex(const Space& space) {
    std::vector<Point> vertices;
    const BarycentricFrame frame = BarycentricFrame::standard(space.dimension());
    for (const Coordinates& vertex : frame.vertices()) vertices.push_back(space.point(vertex));
    return Simplex(std::move(vertices));
}

}  // namespace

Blossom Blossom::from_bezier_net(const Simplex& domain, std::size_t degree, std::span<const Point> net,
                                 const Limits& limits) {
    return from_bezier_net(std::vector{domain}, std::span(&degree, 1), net, limits);
}

Blossom Blossom::from_bezier_net(std::vector<Simplex> domain, std::span<const std::size_t> degrees,
                                 std::span<const Point> net, const Limits& limits) {
    if (degrees.size() != domain.size() || net.empty()) {
        throw Error(ErrorCode::wrong_arity,
                    "a control net needs one degree a simplex and at least one point");
    }
    std::vector<SimplexFactor> factors;
    factors.reserve(domain.size());
    for (std::size_t f = 0; f < domain.size(); ++f) factors.push_back({domain[f].dimension(), degrees[f]});
    BezierPatch patch(NetShape(std::move(factors), limits), coordinates_of(net));
    return {std::move(domain), net.front().space(), std::move(patch), limits};
}

Blossom Blossom::from_bspline(const Space& line, const KnotVector& knots,
                              std::span<const Point> control_points, std::size_t span, const Limits& limits) {
    require_line(line);
    const BezierCurve segment =
        sablonniere(BSplineCurve(knots, coordinates_of(control_points)), span, limits);
    const Simplex domain({line.point({segment.interval().a()}), line.point({segment.interval().b()})});
    return {{domain},
            control_points.front().space(),
            BezierPatch(NetShape::simplex(1, segment.degree(), limits), segment.control_points()),
            limits};
}

Blossom Blossom::from_polynomial(const Space& domain, const Space& range, std::size_t degree,
                                 std::span<const SparsePolynomial> coordinates, const Limits& limits) {
    if (coordinates.size() != range.dimension()) {
        throw Error(ErrorCode::mismatched_dimensions,
                    "a map into a space of dimension " + std::to_string(range.dimension()) +
                        " has as many coordinates, not " + std::to_string(coordinates.size()));
    }
    const PolynomialPatch polynomial(NetShape::simplex(domain.dimension(), degree, limits), coordinates,
                                     limits);
    const Simplex simplex = standard_simplex(domain);
    return {{simplex}, range, control_net(polynomial, std::span(&simplex.frame(), 1), limits), limits};
}

Blossom Blossom::from_values(const Simplex& domain, std::size_t degree,
                             const std::function<Point(const Point&)>& map, const Limits& limits) {
    const Space range = map(domain.vertices().front()).space();
    const auto values = [&](const PatchPoint& point) {
        const Point value = map(domain.point(point.front()));
        require_same_space(range, value.space());
        return value.coordinates();
    };
    return {{domain},
            range,
            control_net_from_values(NetShape::simplex(domain.dimension(), degree, limits), values, limits),
            limits};
}

Blossom Blossom::from_affine_map(const AffineMap& map) {
    return from_bezier_net(map.domain(), 1, map.images());
}

PatchArguments Blossom::arguments(const PointLists& points, const VectorLists& vectors) const {
    if (points.size() != domain_.size() || vectors.size() != domain_.size()) {
        throw Error(ErrorCode::wrong_arity, "the arguments come as " + std::to_string(domain_.size()) +
                                                " lists, one a factor of the domain");
    }
    PatchArguments result;
    for (std::size_t f = 0; f < domain_.size(); ++f) {
        auto& list = result.emplace_back();
        for (const Point& point : points[f]) list.push_back(domain_[f].barycentric(point));
        for (const Vector& vector : vectors[f]) list.push_back(domain_[f].barycentric(vector));
    }
    return result;
}

Point Blossom::operator()(const PointLists& points) const {
    return range_.point(blossom_value(patch_, arguments(points, VectorLists(domain_.size())), limits_));
}

Point Blossom::operator()(std::span<const Point> points) const {
    return (*this)(PointLists{{points.begin(), points.end()}});
}

Vector Blossom::operator()(const PointLists& points, const VectorLists& vectors) const {
    if (std::ranges::all_of(vectors, [](const auto& list) { return list.empty(); })) {
        throw Error(ErrorCode::wrong_arity, "a value is a vector when there is a vector among the arguments");
    }
    return range_.vector(blossom_value(patch_, arguments(points, vectors), limits_));
}

Vector Blossom::operator()(std::span<const Point> points, std::span<const Vector> vectors) const {
    return (*this)(PointLists{{points.begin(), points.end()}}, VectorLists{{vectors.begin(), vectors.end()}});
}

Point Blossom::evaluate(std::span<const Point> point) const {
    PointLists lists;
    for (const Point& own : point) lists.push_back({own});
    PatchPoint tuples;
    for (const auto& list : arguments(lists, VectorLists(domain_.size()))) tuples.push_back(list.front());
    return range_.point(blossom::evaluate(patch_, tuples, limits_));
}

Point Blossom::evaluate(const Point& point) const { return evaluate(std::span(&point, 1)); }

Vector Blossom::derivative(const Point& at, std::span<const Vector> directions) const {
    const PatchArguments tuples = arguments({{at}}, {{directions.begin(), directions.end()}});
    const std::vector<Coordinates>& list = tuples.front();
    return range_.vector(
        blossom::derivative(patch_, {{list.begin() + 1, list.end()}}, PatchPoint{list.front()}, limits_));
}

std::vector<Point> Blossom::bezier_net(const Simplex& simplex) const {
    if (domain_.size() != 1 || simplex.dimension() != domain_.front().dimension()) {
        throw Error(ErrorCode::wrong_arity, "a net over one simplex of dimension " +
                                                std::to_string(simplex.dimension()) +
                                                " needs a domain of this dimension with one factor");
    }
    std::vector<Coordinates> elements;
    for (const Point& vertex : simplex.vertices()) elements.push_back(domain_.front().barycentric(vertex));
    std::vector<Point> net;
    for (Coordinates& point : with_frame(patch_, 0, elements, limits_).control_net().to_points()) {
        net.push_back(range_.point(std::move(point)));
    }
    return net;
}

}  // namespace blossom::geometry
