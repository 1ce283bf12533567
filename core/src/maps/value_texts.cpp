// The texts of maps, which streams and failed comparisons print.

#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/core/maps/hermite_curve.hpp>
#include <blossom/core/maps/polynomial_patch.hpp>
#include <blossom/core/maps/taylor_curve.hpp>
#include <blossom/rational/lists.hpp>

#include <string>

namespace blossom {

namespace {

constexpr auto text_of = [](const auto& value) { return to_string(value); };

}  // namespace

std::string to_string(const PolynomialCurve& curve) {
    return "(" + joined(coordinates_of(curve), text_of) + ") of degree " + std::to_string(curve.degree());
}

std::string to_string(const BezierCurve& curve) {
    return "control points " + to_string(curve.control_points()) + " over " + to_string(curve.interval());
}

std::string to_string(const TaylorCurve& curve) {
    return "Taylor coefficients " + to_string(curve.coefficients) + " at " + to_string(curve.center);
}

std::string to_string(const HermiteCurve& curve) {
    return to_string(curve.derivatives()) + ", the first " + std::to_string(curve.left_count()) + " at " +
           to_string(curve.interval().a()) + ", the others at " + to_string(curve.interval().b());
}

std::string to_string(const KnotVector& knots) {
    return "degree " + std::to_string(knots.degree()) + ", knots " + joined(knots.knots(), text_of);
}

std::string to_string(const BSplineCurve& curve) {
    return to_string(curve.knots()) + ", control points " +
           joined(curve.control_points(),
                  [](const Coordinates& point) { return to_string(RationalVector(point)); });
}

std::string to_string(const NetShape& shape) { return joined(shape.list(), text_of); }

std::string to_string(const BezierPatch& patch) {
    return to_string(patch.shape()) + ", control net " + to_string(patch.control_net());
}

std::string to_string(const PolynomialPatch& patch) {
    return to_string(patch.shape()) + ", coefficients " + to_string(patch.coefficients());
}

}  // namespace blossom
