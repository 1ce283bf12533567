#include <blossom/core/queries/inflections.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>

namespace blossom {

namespace {

/// What counts of a piece.
struct Bend {
    Polynomial determinant;  ///< without the factors of the weight
    Polynomial curvature;    ///< has the sign of the curvature wherever the curve is finite
    std::vector<Polynomial> velocity;
    Polynomial stops;  ///< the common factor of the velocity

    explicit Bend(const CurvePiece& piece)
        : velocity(blossom::velocity(piece)), stops(gcd(velocity[0], velocity[1])) {
        // With v = x' w - x w', this is w det(F, F', F''), and w^4 times x' y'' - x'' y' of x / w and y / w.
        curvature = velocity[0] * derivative(velocity[1]) - derivative(velocity[0]) * velocity[1];
        determinant = without_factors_of(curvature, piece.weight());
    }

    InflectionKind kind_at(const Root& root) const {
        std::size_t order = 0;
        for (Polynomial rest = stops; vanishes_at(rest, root); rest = derivative(rest)) ++order;
        if (order > 0) return order % 2 == 1 ? InflectionKind::cusp : InflectionKind::singular;
        return root.multiplicity % 2 == 1 ? InflectionKind::inflection : InflectionKind::flat;
    }
};

Coordinates values_of(std::span<const Polynomial> polynomials, const Rational& t) {
    Coordinates values;
    for (const Polynomial& polynomial : polynomials) values.push_back(polynomial(t));
    return values;
}

void require_plane(const CurvePiece& piece) {
    if (piece.dimension() == 2) return;
    throw Error(ErrorCode::mismatched_dimensions,
                "only a plane curve has inflections; the points of this one have " +
                    std::to_string(piece.dimension()) +
                    (piece.dimension() == 1 ? " coordinate" : " coordinates"),
                Part::map);
}

/// Whether the curve passes a knot with one tangent, and is regular on both sides.
bool is_smooth(const CurvePiece& left, const Bend& before, const CurvePiece& right, const Bend& behind,
               const Rational& knot) {
    const Rational left_weight = left.weight()(knot);
    const Rational right_weight = right.weight()(knot);
    if (left_weight.is_zero() || right_weight.is_zero()) return false;
    for (std::size_t j = 0; j < 2; ++j) {
        if (left.coordinates[j](knot) * right_weight != right.coordinates[j](knot) * left_weight)
            return false;
    }
    const Coordinates in = values_of(before.velocity, knot);
    const Coordinates out = values_of(behind.velocity, knot);
    return (in[0] * out[1] - in[1] * out[0]).is_zero() && (in[0] * out[0] + in[1] * out[1]).sign() > 0;
}

/// What happens at a knot between two pieces.
std::optional<Inflection> at_knot(const CurvePiece& left, const Bend& before, const CurvePiece& right,
                                  const Bend& behind, const Rational& knot, std::size_t multiplicity) {
    Root root = rational_root(knot);
    root.multiplicity = multiplicity;
    if (vanishes_at(behind.stops, root) && multiplicity > 0 && !right.weight()(knot).is_zero())
        return Inflection{root, multiplicity, behind.kind_at(root)};
    if (before.determinant.is_zero() || behind.determinant.is_zero()) return std::nullopt;
    if (!is_smooth(left, before, right, behind, knot)) return std::nullopt;
    if (sign_beside(before.curvature, knot, -1) != sign_beside(behind.curvature, knot, 1))
        return Inflection{root, multiplicity, InflectionKind::inflection};
    if (multiplicity == 0) return std::nullopt;
    return Inflection{root, multiplicity, InflectionKind::flat};
}

/// Adds a range to those in rising order, or to the last of them where it follows this one.
void add_range(std::vector<ParameterRange>& ranges, const ParameterRange& range) {
    if (!ranges.empty() && ranges.back().upper == range.lower) {
        ranges.back().upper = range.upper;
    } else {
        ranges.push_back(range);
    }
}

}  // namespace

Inflections inflections(std::span<const CurvePiece> pieces, const Rational& width, const Limits& limits) {
    Inflections found;
    std::vector<Bend> bends;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        require_plane(pieces[i]);
        bends.emplace_back(pieces[i]);
        std::vector<Root> zeros;
        if (bends[i].determinant.is_zero()) {
            add_range(found.straight, pieces[i].range);
        } else {
            const RangedPolynomial determinant{bends[i].determinant, pieces[i].range, pieces[i].closed};
            zeros = roots(std::span(&determinant, 1), width, limits).roots;
        }
        const auto& knot = pieces[i].range.lower;
        const bool begins_inside = i > 0 && knot && pieces[i - 1].range.upper == knot;
        const bool at_begin =
            begins_inside && !zeros.empty() && zeros.front().is_rational() && zeros.front().lower == *knot;
        if (begins_inside) {
            if (auto point = at_knot(pieces[i - 1], bends[i - 1], pieces[i], bends[i], *knot,
                                     at_begin ? zeros.front().multiplicity : 0))
                found.points.push_back(*std::move(point));
        }
        for (const Root& root : std::span(zeros).subspan(at_begin ? 1 : 0))
            found.points.push_back({root, root.multiplicity, bends[i].kind_at(root)});
    }
    return found;
}

}  // namespace blossom
