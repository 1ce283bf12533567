// How the time of one operation grows with the degree: no peer, but the exponent that is natural.

#include <blossom/core/curve/degree_reduction.hpp>
#include <blossom/core/spline/basis_functions.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/continuity.hpp>
#include <blossom/core/spline/spline_join.hpp>

#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "cases.hpp"
#include "families.hpp"

namespace {

using namespace blossom;

/// A curve of degree n over [0, 1] whose control points have 7 bits.
BezierCurve bezier(std::size_t degree) {
    std::vector<Coordinates> points;
    for (const Rational& coefficient : make_case(degree, 7).coefficients) points.push_back({coefficient});
    return BezierCurve(points, Interval());
}

/// A curve of degree n of so many segments over knots of which each is greater than the last by at most
/// `greatest_gap`, whose control points are integers.
BSplineCurve spline(std::size_t degree, std::size_t segments, std::size_t greatest_gap) {
    std::mt19937_64 random(degree);
    std::vector<Rational> knots{Rational(0)};
    for (std::size_t i = 0; i < segments + 2 * degree; ++i)
        knots.push_back(knots.back() + Rational(1 + random() % greatest_gap));
    std::vector<Coordinates> points;
    for (std::size_t i = 0; i < segments + degree; ++i)
        points.push_back({Rational(number(random, 7).numerator())});
    return {degree, knots, points};
}

Limits unlimited() {
    Limits limits;
    limits.output_digits = std::numeric_limits<std::size_t>::max();
    return limits;
}

/// One operation: `prepare(n)` gives what is timed.
struct Growth {
    const char* work;
    double natural;  ///< the exponent that counts operations on bits
    const char* reason;
    std::function<std::function<void()>(std::size_t)> prepare;
};

template <class Given, class Run>
std::function<void()> timed(Given given, Run run) {
    return [given = std::move(given), run] { run(given); };
}

/// Reduction by one degree, or to half the degree.
std::function<std::function<void()>(std::size_t)> reduction(ReductionMethod method, bool to_half = false) {
    return [method, to_half](std::size_t n) {
        const std::size_t m = to_half ? n / 2 : n - 1;
        return timed(bezier(n), [m, method](const BezierCurve& curve) { reduce(curve, m, method); });
    };
}

/// The same of a spline of three segments over even and over uneven knots.
template <class Run>
void add_for_knots(std::vector<Growth>& list, const char* even, const char* uneven, double natural,
                   const char* reason, Run run) {
    for (const auto& [work, gap] : {std::pair(even, std::size_t{1}), std::pair(uneven, std::size_t{4})})
        list.push_back(
            {work, natural, reason, [run, gap](std::size_t n) { return timed(spline(n, 3, gap), run); }});
}

/// Two curves of degree n over [0, 1/3] and [1/3, 1] that meet with order n / 2.
std::vector<BezierCurve> touching(std::size_t degree) {
    const Case given = make_case(degree, 7);
    std::vector<Rational> other = given.coefficients;
    const Polynomial first{std::span<const Rational>(other)};
    const Polynomial factor = Polynomial::monomial(1) - Polynomial(Rational(1, 3));
    const Polynomial second = first + pow(factor, degree / 2 + 1);
    const Interval left(Rational(0), Rational(1, 3));
    const Interval right(Rational(1, 3), Rational(1));
    return {control_points(PolynomialCurve({first}, degree), left),
            control_points(PolynomialCurve({second}, degree), right)};
}

std::vector<Growth> operations() {
    std::vector<Growth> list{
        {"reduce, inverse formula", 3, "n^2 nodes", reduction(ReductionMethod::inverse_formula)},
        {"reduce to half, inverse formula", 4, "n^2 products of n^2 bits",
         reduction(ReductionMethod::inverse_formula, true)},
        {"reduce, least squares", 3, "n^2 products", reduction(ReductionMethod::least_squares)},
        {"reduce to half, least squares", 3, "n^2 products", reduction(ReductionMethod::least_squares, true)},
        {"reduce, least squares with ends", 3, "n^2 products",
         reduction(ReductionMethod::least_squares_endpoints)},
        {"reduce, uniform", 3, "n^2 products", reduction(ReductionMethod::uniform)},
        {"join, order n / 2", 3, "n^2 combinations",
         [](std::size_t n) {
             return timed(touching(n), [](const std::vector<BezierCurve>& pieces) { join(pieces); });
         }},
    };
    for (const auto& [work, gap] : {std::pair("join, order n - 1, even knots", std::size_t{1}),
                                    std::pair("join, order n - 1, uneven knots", std::size_t{4})})
        list.push_back({work, 3, "n^2 combinations", [gap](std::size_t n) {
                            return timed(bezier_segments(spline(n, 3, gap)),
                                         [](const std::vector<BezierCurve>& pieces) { join(pieces); });
                        }});
    list.push_back({"join, order n - 1, ten segments", 3, "n^2 combinations", [](std::size_t n) {
                        return timed(bezier_segments(spline(n, 10, 4)),
                                     [](const std::vector<BezierCurve>& pieces) { join(pieces); });
                    }});
    list.push_back({"join over given knots", 3, "n^2 combinations", [](std::size_t n) {
                        return timed(spline(n, 3, 4), [](const BSplineCurve& curve) {
                            join(bezier_segments(curve), curve.knots());
                        });
                    }});
    for (const auto& [work, gap] : {std::pair("basis function, even knots", std::size_t{1}),
                                    std::pair("basis function, uneven knots", std::size_t{4})})
        list.push_back({work, 3, "n^2 combinations", [gap](std::size_t n) {
                            return timed(spline(n, n + 1, gap), [n](const BSplineCurve& curve) {
                                basis_function(curve.knots(), n, unlimited());
                            });
                        }});
    add_for_knots(list, "basis values, even knots", "basis values, uneven knots", 3, "n^2 combinations",
                  [](const BSplineCurve& curve) {
                      basis_values(curve.knots(), curve.knots().domain().a() + Rational(1, 3));
                  });
    add_for_knots(list, "segments, even knots", "segments, uneven knots", 3, "n^2 combinations",
                  [](const BSplineCurve& curve) { bezier_segments(curve); });
    add_for_knots(
        list, "continuity, even knots", "continuity, uneven knots", 3, "n^2 combinations",
        [](const BSplineCurve& curve) { contact(curve, curve.knots()[curve.knots().begin_index() + 1]); });
    return list;
}

/// The slope of the line that is nearest to the logarithms of the times.
double exponent(const std::vector<std::pair<std::size_t, double>>& times) {
    double count = 0, sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
    for (const auto& [n, seconds] : times) {
        const double x = std::log(static_cast<double>(n));
        const double y = std::log(seconds);
        count += 1;
        sum_x += x;
        sum_y += y;
        sum_xx += x * x;
        sum_xy += x * y;
    }
    return (count * sum_xy - sum_x * sum_y) / (count * sum_xx - sum_x * sum_x);
}

}  // namespace

void measure_growth(const std::string& only) {
    constexpr double most_seconds = 0.5;
    std::printf("| work | n = 50 | 100 | 200 | 400 | 800 | exponent | natural |\n");
    std::printf("| --- | ---: | ---: | ---: | ---: | ---: | ---: | --- |\n");
    for (const Growth& growth : operations()) {
        if (!only.empty() && only != growth.work) continue;
        std::printf("| %s", growth.work);
        std::vector<std::pair<std::size_t, double>> times;
        for (const std::size_t n : {50U, 100U, 200U, 400U, 800U}) {
            if (!times.empty() && times.back().second > most_seconds) {
                std::printf(" |");
                continue;
            }
            const auto run = growth.prepare(n);
            const double seconds = measure::compare({run}, {5, 0.002, 1}).seconds.front();
            times.emplace_back(n, seconds);
            std::printf(" | %.3g ms", 1e3 * seconds);
            std::fflush(stdout);
        }
        std::printf(" | %.2f | %.1f: %s |\n", exponent(times), growth.natural, growth.reason);
    }
}
