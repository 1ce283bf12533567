// How the time of one operation grows with the degree: no peer, but the exponent that is natural.

#include <blossom/core/curve/degree_reduction.hpp>
#include <blossom/core/spline/basis_functions.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/continuity.hpp>
#include <blossom/core/spline/spline_join.hpp>

#include <cmath>
#include <cstdio>
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

/// A curve of degree n of three segments over the knots 0, 1, ..., whose control points are integers.
BSplineCurve spline(std::size_t degree) {
    constexpr std::size_t segments = 3;
    std::mt19937_64 random(degree);
    std::vector<Rational> knots;
    for (std::size_t i = 0; i < segments + 2 * degree + 1; ++i) knots.emplace_back(i);
    std::vector<Coordinates> points;
    for (std::size_t i = 0; i < segments + degree; ++i)
        points.push_back({Rational(number(random, 7).numerator())});
    return {degree, knots, points};
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

std::function<std::function<void()>(std::size_t)> reduction(ReductionMethod method) {
    return [method](std::size_t n) {
        return timed(bezier(n), [n, method](const BezierCurve& curve) { reduce(curve, n - 1, method); });
    };
}

std::vector<Growth> operations() {
    const auto middle = [](const BSplineCurve& curve) {
        return curve.knots()[curve.knots().begin_index() + 1];
    };
    return {
        {"reduce, inverse formula", 3, "n^2 nodes", reduction(ReductionMethod::inverse_formula)},
        {"reduce, least squares", 3, "n^2 products", reduction(ReductionMethod::least_squares)},
        {"reduce, least squares with ends", 3, "n^2 products",
         reduction(ReductionMethod::least_squares_endpoints)},
        {"reduce, uniform", 3, "n^2 products", reduction(ReductionMethod::uniform)},
        {"basis function", 4, "n pieces of n^2 combinations",
         [](std::size_t n) {
             return timed(spline(n), [n](const BSplineCurve& curve) { basis_function(curve.knots(), n); });
         }},
        {"basis values", 3, "n^2 combinations",
         [](std::size_t n) {
             return timed(spline(n), [n](const BSplineCurve& curve) {
                 basis_values(curve.knots(), Rational(3 * n + 1, 3));
             });
         }},
        {"segments", 3, "n^2 combinations",
         [](std::size_t n) {
             return timed(spline(n), [](const BSplineCurve& curve) { bezier_segments(curve); });
         }},
        {"join", 3, "n^2 combinations",
         [](std::size_t n) {
             return timed(bezier_segments(spline(n)), [](const std::vector<BezierCurve>& pieces) { join(pieces); });
         }},
        {"continuity", 3, "n^2 combinations",
         [middle](std::size_t n) {
             return timed(spline(n), [middle](const BSplineCurve& curve) { contact(curve, middle(curve)); });
         }},
    };
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
    constexpr double most_seconds = 2;
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
