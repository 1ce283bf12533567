// How the time of one operation grows with the degree n: without a peer, but with the expected exponent, in
// operations on words. The denominators of splines over small integer knots divide products like n!, so that
// numbers have n log n bits, and one operation on a number and a word takes n operations on words.

#include <blossom/core/curve/degree_reduction.hpp>
#include <blossom/core/spline/basis_functions.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/continuity.hpp>
#include <blossom/core/spline/spline_join.hpp>

#include <cmath>
#include <cstdio>
#include <limits>

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

/// A curve of degree n with `segments` segments and integer control points; the differences of successive
/// knots are at most `greatest_gap`.
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

using Prepared = std::function<void()>;

/// One operation: `prepare(n)` returns the function to be timed.
struct Growth {
    std::string work;
    const char* natural;
    std::function<Prepared(std::size_t)> prepare;
};

template <class Given, class Run>
Prepared timed(Given given, Run run) {
    return [given = std::move(given), run] { run(given); };
}

/// Reduction by one degree, or to half the degree.
std::vector<Growth> reductions() {
    const auto reduction = [](ReductionMethod method, bool to_half) {
        return [method, to_half](std::size_t n) {
            const std::size_t m = to_half ? n / 2 : n - 1;
            return timed(bezier(n), [m, method](const BezierCurve& curve) { reduce(curve, m, method); });
        };
    };
    using enum ReductionMethod;
    return {
        {"reduce, inverse formula", "3: n^2 operations on a number and a word",
         reduction(inverse_formula, false)},
        {"reduce to half, inverse formula", "4: n^2 products of numbers, of n^2 bits as in the result",
         reduction(inverse_formula, true)},
        {"reduce, least squares", "2: a product of polynomials", reduction(least_squares, false)},
        {"reduce to half, least squares", "4: n^2 products of numbers of n bits",
         reduction(least_squares, true)},
        {"reduce with ends, least squares", "2: a product of polynomials",
         reduction(least_squares_endpoints, false)},
        {"reduce, uniform", "3: n^2 sums of numbers of n bits", reduction(uniform, false)},
    };
}

/// Over the knots 0, 1, 2, ... and over uneven knots.
std::vector<Growth> of_splines() {
    constexpr const char* combinations = "3: n^2 combinations of numbers with words";
    std::vector<Growth> list;
    for (const auto& [knots, gap] :
         {std::pair("even", std::size_t{1}), std::pair("uneven", std::size_t{4})}) {
        const auto add = [&](const char* work, const char* natural, auto run) {
            list.push_back({work + std::string(", ") + knots + " knots", natural,
                            [run, gap](std::size_t n) { return timed(spline(n, 3, gap), run); }});
        };
        add("basis values", combinations, [](const BSplineCurve& curve) {
            basis_values(curve.knots(), curve.knots().domain().a() + Rational(1, 3));
        });
        add("segments", combinations, [](const BSplineCurve& curve) { bezier_segments(curve); });
        add("continuity", combinations, [](const BSplineCurve& curve) {
            contact(curve, curve.knots()[curve.knots().begin_index() + 1]);
        });
        list.push_back({std::string("basis function, ") + knots + " knots", "3: n^2 numbers in the result",
                        [gap](std::size_t n) {
                            return timed(spline(n, n + 1, gap), [n](const BSplineCurve& curve) {
                                basis_function(curve.knots(), n, unlimited());
                            });
                        }});
        list.push_back({std::string("join, ") + knots + " knots", "3: n values of n^2 operations on words",
                        [gap](std::size_t n) {
                            return timed(bezier_segments(spline(n, 3, gap)),
                                         [](const std::vector<BezierCurve>& pieces) { join(pieces); });
                        }});
    }
    return list;
}

std::vector<Growth> operations() {
    std::vector<Growth> list = reductions();
    list.push_back({"join with order n / 2", "3: n values of n^2 operations on words", [](std::size_t n) {
                        return timed(touching(n),
                                     [](const std::vector<BezierCurve>& pieces) { join(pieces); });
                    }});
    for (Growth& growth : of_splines()) list.push_back(std::move(growth));
    return list;
}

/// The slope of the regression line through the logarithms of the times.
double exponent(const std::vector<std::pair<std::size_t, double>>& times) {
    const auto count = static_cast<double>(times.size());
    double x = 0;
    double y = 0;
    for (const auto& [n, seconds] : times) {
        x += std::log(static_cast<double>(n)) / count;
        y += std::log(seconds) / count;
    }
    double above = 0;
    double below = 0;
    for (const auto& [n, seconds] : times) {
        const double step = std::log(static_cast<double>(n)) - x;
        above += step * (std::log(seconds) - y);
        below += step * step;
    }
    return above / below;
}

}  // namespace

void measure_growth(const std::string& only) {
    constexpr double most_seconds = 0.6;
    std::printf("| work | n = 50 | 100 | 200 | 400 | 800 | exponent | natural |\n");
    std::printf("| --- | ---: | ---: | ---: | ---: | ---: | ---: | --- |\n");
    for (const Growth& growth : operations()) {
        if (!only.empty() && only != growth.work) continue;
        std::printf("| %s", growth.work.c_str());
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
        std::printf(" | %.2f | %s |\n", exponent(times), growth.natural);
    }
}
