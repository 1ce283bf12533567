#include <blossom/core/maps/taylor_curve.hpp>
#include "core_test.hpp"

namespace {

Coordinates scaled(Coordinates point, const Rational& factor) {
    for (Rational& coordinate : point) coordinate *= factor;
    return point;
}

}  // namespace

TEST_CASE("Taylor coefficients are derivatives over factorials and blossom values with delta", "[taylor]") {
    Random random(321);
    for (std::size_t i = 0; i < 180; ++i) {
        const std::size_t n = i % 9;
        const Size size = i % 4 == 0 ? Size::any : Size::small;
        const PolynomialCurve curve = polynomial_map(random, n, size).curve();
        const Rational center = number(random, size);
        CAPTURE(i, n, center);
        const TaylorCurve taylor = taylor_form(curve, center);
        CHECK(taylor.center == center);
        REQUIRE(taylor.coefficients.size() == n + 1);
        CHECK(expanded(taylor) == expanded(curve));
        for (std::size_t k = 0; k <= n; ++k) {
            CHECK(taylor.coefficients[k] == scaled(derivative(curve, k, center), Rational(1, factorial(k))));
            const auto label = with_copies(with_copies({}, n - k, Parameter(center)), k, delta);
            CHECK(taylor.coefficients[k] ==
                  scaled(blossom_value(curve, label, Construction::symmetric), binomial(n, k)));
        }
    }
}

TEST_CASE("the monomial, Bernstein and Taylor forms give each other back", "[taylor][conversion]") {
    Random random(322);
    for (std::size_t i = 0; i < 270; ++i) {
        const std::size_t n = i % 9;
        const Size size = i % 4 == 0 ? Size::any : Size::small;
        const PolynomialCurve monomial = polynomial_map(random, n, size).curve();
        const Interval over = interval(random, size);
        const Interval other = interval(random, size);
        const Rational center = number(random, size);
        CAPTURE(i, n, over.a(), over.b(), center);

        const BezierCurve bezier = control_points(monomial, over);
        const TaylorCurve taylor = taylor_form(monomial, center);
        CHECK(monomial_form(bezier) == monomial);
        CHECK(monomial_form(taylor) == monomial);
        CHECK(monomial_form(bezier).degree() == n);
        CHECK(monomial_form(taylor).degree() == n);
        CHECK(control_points(monomial_form(taylor), over) == bezier);
        CHECK(taylor_form(monomial_form(bezier), center) == taylor);
        CHECK(control_points(control_points(bezier, other), over) == bezier);
        CHECK(control_points(bezier, other) == control_points(monomial, other));
        CHECK(expanded(bezier) == expanded(monomial));
        CHECK(taylor_form(monomial, 0).coefficients == monomial.coefficients());
    }
}

TEST_CASE("a Taylor form is refused when its numbers would have too many digits", "[taylor]") {
    Limits limits;
    limits.digits = 10;
    const PolynomialCurve curve(Polynomial::monomial(8));
    CHECK(failure_code([&] { taylor_form(curve, 1, limits); }) == std::nullopt);
    CHECK(failure_code([&] { taylor_form(curve, 1'000'000, limits); }) == ErrorCode::limit_exceeded);
    CHECK(failure_code([&] { monomial_form(taylor_form(curve, 1'000'000), limits); }) ==
          ErrorCode::limit_exceeded);
}
