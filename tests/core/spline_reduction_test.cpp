#include <blossom/core/spline/continuity.hpp>
#include <blossom/core/spline/spline_elevation.hpp>
#include <blossom/core/spline/spline_reduction.hpp>
#include "core_test.hpp"

namespace {

constexpr ReductionMethod any_degree[] = {ReductionMethod::inverse_formula, ReductionMethod::least_squares,
                                          ReductionMethod::least_squares_endpoints};

/// The integral of |P - Q|^2 over the domain, by the antiderivative of its polynomial on every span.
Rational squared_distance(const BSplineCurve& p, const BSplineCurve& q) {
    Rational sum;
    const std::vector<BezierCurve> of_p = bezier_segments(p);
    for (const BezierCurve& piece : of_p) {
        const BezierCurve other = sablonniere(q, q.knots().span_at(piece.interval().a()));
        const PolynomialCurve a = monomial_form(piece);
        const PolynomialCurve b = monomial_form(other);
        for (std::size_t j = 0; j < p.dimension(); ++j) {
            const Polynomial difference = a.coordinate(j) - b.coordinate(j);
            const Polynomial square = difference * difference;
            std::vector<Rational> antiderivative{0};
            for (std::size_t k = 0; k <= square.degree(); ++k)
                antiderivative.push_back(square[k] / Rational(k + 1));
            const Polynomial integral{std::span<const Rational>(antiderivative)};
            sum += integral(piece.interval().b()) - integral(piece.interval().a());
        }
    }
    return sum;
}

}  // namespace

TEST_CASE("reducing undoes raising exactly, knots and points, by every method", "[spline_reduction]") {
    Random random(511);
    for (int round = 0; round < 90; ++round) {
        const BSplineCurve curve = spline(random, random.below(7)).curve();
        // Degree 0 has no polar convention to return to.
        if (curve.degree() == 0 && curve.knots().convention() == KnotConvention::polar) continue;
        const std::size_t by = 1 + random.below(2);
        const BSplineCurve raised = elevate(curve, by);
        for (const ReductionMethod method : any_degree) {
            if (method == ReductionMethod::least_squares_endpoints && curve.degree() == 0) continue;
            const SplineReduction reduced = reduce(raised, curve.degree(), method);
            CHECK(reduced.exact);
            CHECK(reduced.l2_squared.is_zero());
            CHECK(reduced.curve == curve);
        }
        const SplineReduction uniform = reduce(elevate(curve, 1), curve.degree(), ReductionMethod::uniform);
        CHECK(uniform.exact);
        CHECK(uniform.curve == curve);
        CHECK(uniform.maximum == Coordinates(curve.dimension()));
    }
}

TEST_CASE("a spline that is not of the lower degree is approximated, with its exact error",
          "[spline_reduction]") {
    Random random(512);
    for (int round = 0; round < 60; ++round) {
        const BSplineCurve curve = spline(random, 1 + random.below(5)).curve();
        const std::size_t m = random.below(curve.degree());
        for (const ReductionMethod method : any_degree) {
            if (method == ReductionMethod::least_squares_endpoints && m == 0) continue;
            const SplineReduction reduced = reduce(curve, m, method);
            CHECK(reduced.curve.degree() == m);
            CHECK(reduced.curve.knots().domain() == curve.knots().domain());
            CHECK(reduced.exact == reduced.l2_squared.is_zero());
            CHECK(reduced.l2_squared == squared_distance(curve, reduced.curve));
        }
    }
}

TEST_CASE("the methods that keep the ends keep a spline continuous, least squares may tear it",
          "[spline_reduction]") {
    const BSplineCurve curve(3, {0, 0, 0, 0, 1, 2, 3, 3, 3, 3}, {{0}, {2}, {-1}, {5}, {0}, {1}});
    for (const ReductionMethod method :
         {ReductionMethod::inverse_formula, ReductionMethod::least_squares_endpoints}) {
        const BSplineCurve reduced = reduce(curve, 2, method).curve;
        for (const int knot : {1, 2}) {
            CHECK(*contact(reduced, knot).order >= 0);
            CHECK(evaluate(reduced, knot) == evaluate(curve, knot));
            CHECK(reduced.knots().multiplicity(knot) == 2);
        }
    }
    const BSplineCurve torn = reduce(curve, 2, ReductionMethod::least_squares).curve;
    CHECK(torn.knots().multiplicity(1) == 3);
    CHECK(*contact(torn, 1).order == -1);
    CHECK(reduce(curve, 2, ReductionMethod::least_squares).l2_squared <
          reduce(curve, 2, ReductionMethod::least_squares_endpoints).l2_squared);
    CHECK(failure_code([&] { reduce(curve, 1, ReductionMethod::uniform); }) == ErrorCode::degree_too_low);
    CHECK(failure_code([&] { reduce(curve, 4, ReductionMethod::least_squares); }) ==
          ErrorCode::degree_too_low);
}

TEST_CASE("ends that have no room for their knots are repeated", "[spline_reduction]") {
    // Simple knots outside the domain: after the reduction there are fewer, and the ends must stay.
    const BSplineCurve open(3, {0, 1, 2, 3, 4, 5, 6, 7}, {{0}, {2}, {-1}, {5}});
    const BSplineCurve reduced = reduce(open, 2, ReductionMethod::inverse_formula).curve;
    CHECK(reduced.knots().knots() == std::vector<Rational>{3, 3, 3, 4, 4, 4});
    const BSplineCurve polar(2, {0, 1, 2, 3}, {{0}, {2}, {-1}});
    CHECK(reduce(polar, 1, ReductionMethod::inverse_formula).curve.knots().knots() ==
          std::vector<Rational>{1, 2});
    CHECK(reduce(polar, 0, ReductionMethod::inverse_formula).curve.knots().knots() ==
          std::vector<Rational>{1, 2});
}
