#include <blossom/core/curve/degree_reduction.hpp>
#include "core_test.hpp"

#include "support/chebyshev_identity.hpp"

namespace {

constexpr ReductionMethod methods[] = {ReductionMethod::inverse_formula, ReductionMethod::least_squares,
                                       ReductionMethod::least_squares_endpoints, ReductionMethod::uniform};

bool allowed(std::size_t n, std::size_t m, ReductionMethod method) {
    if (m > n) return false;
    if (method == ReductionMethod::uniform) return m + 1 >= n;
    return method != ReductionMethod::least_squares_endpoints || m > 0 || n == 0;
}

/// The coordinates of P - Q as polynomials in t.
std::vector<Polynomial> differences(const BezierCurve& p, const BezierCurve& q) {
    std::vector<Polynomial> result = expanded(p);
    const std::vector<Polynomial> other = expanded(q);
    for (std::size_t j = 0; j < result.size(); ++j) result[j] -= other[j];
    return result;
}

/// A curve of formal degree n whose actual degree is m in half of the cases.
BezierCurve curve_for(Random& random, std::size_t n, std::size_t m, Size size) {
    const BezierCurve curve = bezier_map(random, n, size).curve();
    if (m > n || random.one_in(2)) return curve;
    return elevate(bezier_map(random, m, size).curve(), n - m);
}

}  // namespace

TEST_CASE("a reduction says exactly what it lost", "[degree_reduction]") {
    Random random(351);
    std::size_t exact = 0;
    std::size_t lossy = 0;
    for (std::size_t i = 0; i < 900; ++i) {
        const std::size_t n = random.below(9);
        const std::size_t m = n - random.below(std::min<std::size_t>(n, 3) + 1);
        const ReductionMethod method = methods[i % 4];
        if (!allowed(n, m, method)) continue;
        const BezierCurve curve = curve_for(random, n, m, i % 16 < 4 ? Size::any : Size::small);
        CAPTURE(i, n, m, reduction_method_name(method));
        const Reduction reduction = reduce(curve, m, method);
        CHECK(reduction.curve.degree() == m);
        CHECK(reduction.curve.interval() == curve.interval());

        const std::vector<Polynomial> lost = differences(curve, reduction.curve);
        Rational squared;
        bool nothing = true;
        for (const Polynomial& coordinate : lost) {
            squared += abs(integral(coordinate * coordinate, curve.interval()));
            nothing = nothing && coordinate.is_zero();
        }
        CHECK(reduction.l2_squared == squared);
        CHECK(reduction.exact == nothing);
        if (monomial_form(curve).actual_degree() <= m) CHECK(reduction.exact);
        CHECK(reduction.maximum.size() == (method == ReductionMethod::uniform ? curve.dimension() : 0));
        ++(nothing ? exact : lossy);
    }
    CHECK(exact > 200);
    CHECK(lossy > 150);
}

TEST_CASE("least squares leaves an error orthogonal to every polynomial of the lower degree",
          "[degree_reduction]") {
    Random random(352);
    for (std::size_t i = 0; i < 240; ++i) {
        const std::size_t n = i % 9;
        const std::size_t m = random.below(n + 1);
        const BezierCurve curve = bezier_map(random, n, i % 4 == 0 ? Size::any : Size::small).curve();
        CAPTURE(i, n, m);
        for (const Polynomial& lost :
             differences(curve, reduce(curve, m, ReductionMethod::least_squares).curve)) {
            for (std::size_t k = 0; k <= m; ++k) {
                CHECK(integral(lost * Polynomial::monomial(k), curve.interval()) == 0);
            }
        }
    }
}

TEST_CASE("with fixed ends the error is orthogonal to all that vanish at the ends", "[degree_reduction]") {
    Random random(353);
    for (std::size_t i = 0; i < 240; ++i) {
        const std::size_t n = 1 + i % 8;
        const std::size_t m = 1 + random.below(n);
        const BezierCurve curve = bezier_map(random, n, i % 4 == 0 ? Size::any : Size::small).curve();
        CAPTURE(i, n, m);
        const BezierCurve reduced = reduce(curve, m, ReductionMethod::least_squares_endpoints).curve;
        CHECK(reduced.control_points()[0] == curve.control_points()[0]);
        CHECK(reduced.control_points()[m] == curve.control_points()[n]);
        const Polynomial t = Polynomial::monomial(1);
        const Polynomial bubble =
            (t - Polynomial(curve.interval().a())) * (t - Polynomial(curve.interval().b()));
        for (const Polynomial& lost : differences(curve, reduced)) {
            for (std::size_t k = 0; k + 2 <= m; ++k) {
                CHECK(integral(lost * bubble * Polynomial::monomial(k), curve.interval()) == 0);
            }
        }
    }
}

TEST_CASE("of the three methods for any degree, each is nearer the less it is held to",
          "[degree_reduction]") {
    Random random(354);
    for (std::size_t i = 0; i < 120; ++i) {
        const std::size_t n = 2 + i % 7;
        const std::size_t m = 1 + random.below(n - 1);
        const BezierCurve curve = bezier_map(random, n, Size::small).curve();
        const Rational free = reduce(curve, m, ReductionMethod::least_squares).l2_squared;
        const Rational held = reduce(curve, m, ReductionMethod::least_squares_endpoints).l2_squared;
        const Rational inverse = reduce(curve, m, ReductionMethod::inverse_formula).l2_squared;
        CHECK(free <= held);
        CHECK(held <= inverse);
    }
}

TEST_CASE("reduction by the inverse formula is the inverse formula of the lower degree",
          "[degree_reduction]") {
    Random random(355);
    for (std::size_t i = 0; i < 120; ++i) {
        const std::size_t n = i % 9;
        const std::size_t m = random.below(n + 1);
        const BezierCurve curve = bezier_map(random, n, i % 4 == 0 ? Size::any : Size::small).curve();
        const auto value = [&](const Rational& t) { return evaluate(curve, t); };
        CHECK(reduce(curve, m, ReductionMethod::inverse_formula).curve ==
              control_points_from_values(m, curve.interval(), value));
    }
}

TEST_CASE("the error of the best uniform reduction equioscillates", "[degree_reduction]") {
    Random random(356);
    for (std::size_t i = 0; i < 160; ++i) {
        const std::size_t n = 1 + i % 8;
        const BezierCurve curve = bezier_map(random, n, i % 4 == 0 ? Size::any : Size::small).curve();
        CAPTURE(i, n);
        const Reduction reduction = reduce(curve, n - 1, ReductionMethod::uniform);
        const auto lost = differences(curve, reduction.curve);
        const Rational& a = curve.interval().a();
        const Polynomial local =
            Polynomial(a) + Polynomial(curve.interval().b() - a) * Polynomial::monomial(1);
        for (std::size_t j = 0; j < lost.size(); ++j) {
            const Polynomial error = compose(lost[j], local);
            const Rational signed_maximum = error(1);
            CHECK(is_chebyshev(error, n, signed_maximum));
            CHECK(reduction.maximum[j] == abs(signed_maximum));
        }
    }
}

TEST_CASE("a reduction to what cannot be is refused", "[degree_reduction]") {
    for (std::size_t n = 0; n <= 5; ++n) {
        const BezierCurve curve(std::vector<Coordinates>(n + 1, Coordinates{1, 2}));
        for (std::size_t m = 0; m <= 7; ++m) {
            for (const ReductionMethod method : methods) {
                CAPTURE(n, m, reduction_method_name(method));
                const auto error = failure([&] { reduce(curve, m, method); });
                CHECK(error.has_value() != allowed(n, m, method));
                if (!error) continue;
                CHECK(error->code() == ErrorCode::degree_too_low);
                CHECK(error->place() == Part::to);
                CHECK(error->message().find("to " + std::to_string(m)) != std::string::npos);
            }
        }
    }
}

TEST_CASE("the methods are called as in the protocol", "[degree_reduction]") {
    CHECK(reduction_method_name(ReductionMethod::inverse_formula) == "inverse-formula");
    CHECK(reduction_method_name(ReductionMethod::least_squares) == "least-squares");
    CHECK(reduction_method_name(ReductionMethod::least_squares_endpoints) == "least-squares-endpoints");
    CHECK(reduction_method_name(ReductionMethod::uniform) == "uniform");
}
