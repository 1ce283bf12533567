// The Taylor coefficients at 1 of a polynomial with integer coefficients.

#include <blossom/core/maps/taylor_curve.hpp>

#include <memory>

#include "cases.hpp"
#include "families.hpp"
#include "flint_operations.hpp"

namespace {

using namespace blossom;

std::string text_of(const PointArray& points) {
    std::string result;
    for (const Integer& numerator : points.numbers().numerators()) result += to_string(numerator) + " ";
    return result + "/ " + to_string(points.denominator());
}

void compare_shift(const Report& report, std::size_t degree, std::size_t bits) {
    const Case given = make_case(degree, bits);
    std::vector<Integer> coefficients;
    for (const Rational& coefficient : given.coefficients) coefficients.push_back(coefficient.numerator());
    const PolynomialCurve curve(PointArray(1, RationalVector(coefficients, 1)));
    std::optional<TaylorCurve> shifted;
    flint_peer::TaylorShift flint(coefficients);
    report.compare(
        "operations", "Taylor shift", degree, bits,
        {{"engine", [&] { shifted = taylor_form(curve, 1); }, [&] { return text_of(shifted->coefficients); }},
         {"FLINT", [&] { flint.run(); }, [&] { return flint.text(); }}});
}

void compare_control_points(const Report& report, std::size_t degree, std::size_t bits) {
    const Case given = make_case(degree, bits);
    const PolynomialCurve curve = curve_of(given);
    const Interval interval(given.arguments[0], given.arguments[1]);
    const Integer q = lcm(interval.a().denominator(), interval.b().denominator());
    std::optional<BezierCurve> polygon;
    flint_peer::ControlPolygon flint(curve.coefficients().numbers(), (interval.a() * q).numerator(),
                                     (interval.b() * q).numerator(), q);
    report.compare("operations", "control points", degree, bits,
                   {{"engine", [&] { polygon = control_points(curve, interval); },
                     [&] { return text_of(polygon->control_points()); }},
                    {"FLINT", [&] { flint.run(); }, [&] { return flint.text(); }}});
}

}  // namespace

void measure_operations(const Report& report) {
    for (const std::size_t degree : {30U, 100U, 300U, 1000U, 3000U}) {
        if (report.quick() && degree > 300) continue;
        if (report.wants("Taylor shift", degree, 64)) compare_shift(report, degree, 64);
    }
    for (const std::size_t degree : {10U, 30U, 100U, 300U, 1000U}) {
        if (report.quick() && degree > 300) continue;
        if (report.wants("control points", degree, 7)) compare_control_points(report, degree, 7);
    }
}
