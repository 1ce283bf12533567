#include <blossom/core/blossom/change_of_basis.hpp>
#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/blossom/evaluation.hpp>
#include <blossom/core/blossom/inverse_formula.hpp>
#include <blossom/core/curve/degree_reduction.hpp>
#include <blossom/core/curve/orthogonal_projection.hpp>
#include <blossom/rational/error.hpp>

#include <string>

namespace blossom {

namespace {

/// The coordinates as polynomials in s = (t - a) / (b - a).
std::vector<Polynomial> local_coordinates(const BezierCurve& curve) {
    std::vector<Polynomial> coordinates;
    for (const auto row : curve.control_points().rows()) {
        coordinates.emplace_back(RationalVector(constructions::local_monomial_from_bernstein(row),
                                                curve.control_points().denominator()));
    }
    return coordinates;
}

BezierCurve over(const Interval& interval, const std::vector<Polynomial>& local, std::size_t degree,
                 const Limits& limits) {
    return {control_points(PolynomialCurve(local, degree), Interval(), limits).control_points(), interval};
}

/// The line through the ends plus s (1 - s) times the projection of the rest with the weight (s (1 - s))^2.
Polynomial project_between_ends(const Polynomial& polynomial, std::size_t m) {
    const Polynomial s = Polynomial::monomial(1);
    const Polynomial bubble = s - s * s;
    const Polynomial line = Polynomial(polynomial(0)) + Polynomial(polynomial(1) - polynomial(0)) * s;
    const Polynomial rest = divide_exactly(polynomial - line, bubble);
    return m < 2 ? line : line + bubble * project(rest, m - 2, 2);
}

/// Takes the leading term off with the multiple of T_n that has the same one.
Polynomial economised(const Polynomial& polynomial, std::size_t n) {
    if (n == 0) return polynomial;
    const Polynomial chebyshev = chebyshev_on_unit_interval(n);
    return polynomial - Polynomial(polynomial[n] / chebyshev[n]) * chebyshev;
}

void require_method(std::size_t n, std::size_t m, ReductionMethod method) {
    const auto refuse = [&](const std::string& rule) {
        throw Error(
            ErrorCode::degree_too_low,
            "degree " + std::to_string(n) + " cannot be reduced to " + std::to_string(m) + ": " + rule,
            Part::to);
    };
    if (m > n) refuse("the new degree must not be greater; raise it instead");
    if (method == ReductionMethod::uniform && m + 1 < n)
        refuse("the best uniform approximation is by one degree");
    if (method == ReductionMethod::least_squares_endpoints && m == 0 && n > 0) {
        refuse("a constant does not keep two ends");
    }
}

}  // namespace

std::string_view reduction_method_name(ReductionMethod method) {
    switch (method) {
        case ReductionMethod::inverse_formula:
            return "inverse-formula";
        case ReductionMethod::least_squares:
            return "least-squares";
        case ReductionMethod::least_squares_endpoints:
            return "least-squares-endpoints";
        case ReductionMethod::uniform:
            return "uniform";
    }
    return "";
}

Reduction reduce(const BezierCurve& curve, std::size_t m, ReductionMethod method, const Limits& limits) {
    const std::size_t n = curve.degree();
    require_method(n, m, method);
    const std::vector<Polynomial> given = local_coordinates(curve);
    std::vector<Polynomial> reduced;
    for (const Polynomial& coordinate : given) {
        switch (method) {
            case ReductionMethod::inverse_formula:
                break;
            case ReductionMethod::least_squares:
                reduced.push_back(project(coordinate, m, 0));
                break;
            case ReductionMethod::least_squares_endpoints:
                reduced.push_back(m == n ? coordinate : project_between_ends(coordinate, m));
                break;
            case ReductionMethod::uniform:
                reduced.push_back(m == n ? coordinate : economised(coordinate, n));
                break;
        }
    }
    if (method == ReductionMethod::inverse_formula) {
        const auto value = [&](const Rational& s) {
            Coordinates point;
            for (const Polynomial& coordinate : given) point.push_back(coordinate(s));
            return point;
        };
        reduced = local_coordinates(control_points_from_values(m, Interval(), value, limits));
    }

    Reduction result{over(curve.interval(), reduced, m, limits), reduced == given, 0, {}};
    for (std::size_t j = 0; j < given.size(); ++j) {
        const Polynomial difference = given[j] - reduced[j];
        result.l2_squared += integral_over_unit_interval(difference * difference);
        if (method == ReductionMethod::uniform) {
            result.maximum.push_back(n == 0 ? Rational(0)
                                            : abs(difference[n] / chebyshev_on_unit_interval(n)[n]));
        }
    }
    result.l2_squared *= abs(curve.interval().b() - curve.interval().a());
    return result;
}

}  // namespace blossom
