// Reads a pack of B-splines, evaluates each case with Eigen and with the GNU Scientific Library, and prints
// how far their doubles are from the exact values.

#include <blossom/rational/number_text.hpp>
#include <blossom/testing/ulps.hpp>

#include <gsl/gsl_bspline.h>
#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <unsupported/Eigen/Splines>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

using Point = std::vector<double>;

struct Curve {
    std::size_t degree;
    std::vector<double> knots;
    std::vector<Point> control_points;
};

// One spline per coordinate: those of Eigen have a dimension that is known when they are compiled.
Point value_by_eigen(const Curve& curve, double t) {
    using Spline = Eigen::Spline<double, 1>;
    const Spline::KnotVectorType knots = Eigen::Map<const Eigen::RowVectorXd>(
        curve.knots.data(), static_cast<Eigen::Index>(curve.knots.size()));
    Point value;
    for (std::size_t j = 0; j < curve.control_points.front().size(); ++j) {
        Spline::ControlPointVectorType points(1, static_cast<Eigen::Index>(curve.control_points.size()));
        for (std::size_t i = 0; i < curve.control_points.size(); ++i)
            points(0, static_cast<Eigen::Index>(i)) = curve.control_points[i][j];
        value.push_back(Spline(knots, points)(t)(0));
    }
    return value;
}

// The knots of a workspace of GSL begin and end with degree + 1 equal ones.
Point value_by_gsl(const Curve& curve, double t) {
    const std::size_t order = curve.degree + 1;
    const std::size_t breaks = curve.knots.size() - 2 * curve.degree;
    gsl_bspline_workspace* workspace = gsl_bspline_alloc(order, breaks);
    gsl_vector_const_view knots = gsl_vector_const_view_array(curve.knots.data() + curve.degree, breaks);
    gsl_bspline_knots(&knots.vector, workspace);
    gsl_vector* basis = gsl_vector_alloc(curve.control_points.size());
    gsl_bspline_eval(t, basis, workspace);
    Point value(curve.control_points.front().size(), 0.0);
    for (std::size_t i = 0; i < curve.control_points.size(); ++i) {
        for (std::size_t j = 0; j < value.size(); ++j)
            value[j] += gsl_vector_get(basis, i) * curve.control_points[i][j];
    }
    gsl_vector_free(basis);
    gsl_bspline_free(workspace);
    return value;
}

struct Worst {
    blossom::Rational ulps;
    std::string place = "-";
    std::size_t numbers = 0;
    std::size_t not_finite = 0;

    void add(double computed, const blossom::Rational& exact, const std::string& where) {
        ++numbers;
        if (!std::isfinite(computed)) {
            ++not_finite;
            return;
        }
        const blossom::Rational distance = blossom::ulps(computed, exact);
        if (distance <= ulps) return;
        ulps = distance;
        place = where;
    }
};

bool is_clamped(const Curve& curve) {
    const auto& knots = curve.knots;
    return knots[0] == knots[curve.degree] && knots.back() == knots[knots.size() - 1 - curve.degree];
}

}  // namespace

int main() {
    std::map<std::string, Worst> found;
    for (std::string line; std::getline(std::cin, line);) {
        const auto json = nlohmann::json::parse(line);
        if (!json.contains("case")) continue;
        const auto& request = json["request"];
        const auto& map = request["map"];
        const Curve curve{map["degree"], map["knots"], map["control_points"]};
        if (!is_clamped(curve)) continue;  // GSL evaluates only these
        for (std::size_t k = 0; k < request["at"].size(); ++k) {
            const double t = request["at"][k];
            for (const auto& [library, value] :
                 {std::pair("Eigen", value_by_eigen(curve, t)), std::pair("GSL", value_by_gsl(curve, t))}) {
                Worst& worst = found[library + std::string(", ") + json["difficulty"].get<std::string>()];
                for (std::size_t j = 0; j < value.size(); ++j) {
                    worst.add(value[j],
                              blossom::parse_rational(json["result"]["values"][k][j].get<std::string>()),
                              "case " + json["case"].dump());
                }
            }
        }
    }
    for (const auto& [name, worst] : found) {
        std::printf("%-24s %5zu numbers, %4zu not finite, greatest error %.3g ulp (%s)\n", name.c_str(),
                    worst.numbers, worst.not_finite, blossom::nearest_double(worst.ulps),
                    worst.place.c_str());
    }
}
