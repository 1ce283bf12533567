// Hart: Blossoms, lecture slides: the slides on one curve segment.
//
// p is the blossom of a cubic with symbolic coefficients, and the arguments are symbols: each case decides
// its statement for all cubics. Printed forms that do not hold are refuted before the corrected form is
// shown.

#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/maps/argument.hpp>

#include "support/failure.hpp"
#include "support/map_printing.hpp"
#include "support/symbolic_curves.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

Variables variables;
const Symbols k = variables.next(4);
const auto p = SymbolicBlossom::of_coefficients(k);
const Symbol a = variables.next();
const Symbol b = variables.next();
const Symbol c = variables.next();
const Symbol d = variables.next();
const Symbol t = variables.next();
const Symbol alpha = variables.next();

Symbol curve(const Symbol& parameter) { return polynomial_value(k, parameter); }

}  // namespace

TEST_CASE("hart-renaming: the points of de Casteljau's algorithm are p(0,0,t), p(0,t,1), ..., p(t,t,t)",
          "[statement]") {
    const Symbol p00 = p({0, 0, 0});
    const Symbol p01 = p({0, 0, 1});
    const Symbol p11 = p({0, 1, 1});
    const Symbol p111 = p({1, 1, 1});
    const auto between = [](const Symbol& x, const Symbol& y) { return (1 - t) * x + t * y; };
    CHECK(between(p00, p01) == p({0, 0, t}));
    CHECK(between(p01, p11) == p({0, t, 1}));
    CHECK(between(p11, p111) == p({t, 1, 1}));
    CHECK(between(p({0, 0, t}), p({0, t, 1})) == p({0, t, t}));
    CHECK(between(p({0, t, 1}), p({t, 1, 1})) == p({t, t, 1}));
    CHECK(between(p({0, t, t}), p({t, t, 1})) == curve(t));
}

TEST_CASE("hart-nparams: a blossom takes as many parameters as its formal degree", "[statement]") {
    for (std::size_t n = 0; n <= 6; ++n) {
        const Blossom blossom(PolynomialCurve(std::vector<Coordinates>{{1}}, n));
        CHECK(blossom.degree() == n);
        CHECK(blossom(with_copies({}, n, Parameter(5))) == Coordinates{1});
        CHECK(failure_code([&] { blossom(with_copies({}, n + 1, Parameter(5))); }) == ErrorCode::wrong_arity);
        if (n > 0)
            CHECK(failure_code([&] { blossom(with_copies({}, n - 1, Parameter(5))); }) ==
                  ErrorCode::wrong_arity);
    }
}

TEST_CASE("hart-order: p(a,b,c) = p(b,a,c), and so for every order", "[statement]") {
    for (const SymbolicArguments& order :
         {SymbolicArguments{b, a, c}, {a, c, b}, {c, b, a}, {b, c, a}, {c, a, b}}) {
        CHECK(p(order) == p({a, b, c}));
    }
}

TEST_CASE("hart-linear-scale: the sides differ by (alpha-1) p(0,b,c); scaling the homogeneous pair is right",
          "[statement]") {
    CHECK(alpha * p({a, b, c}) - p({alpha * a, b, c}) == (alpha - 1) * p({0, b, c}));
    // p(0,b,c) = k0 + k1 (b + c) / 3 + k2 b c / 3 vanishes for all b and c exactly when k0 = k1 = k2 = 0, P =
    // k3 t^3.
    CHECK(p({0, b, c}) == k[0] + k[1] * (b + c) * fraction(1, 3) + k[2] * b * c * fraction(1, 3));
    // The second equality, p(alpha a,b,c) = p(a,alpha b,c), needs k1 = k2 = 0.
    CHECK(p({alpha * a, b, c}) - p({a, alpha * b, c}) ==
          (alpha - 1) * (a - b) * (k[1] + k[2] * c) * fraction(1, 3));

    CHECK(by_symmetric_functions({1, 0, 0, 0}, {2, 0, 0}) == Symbol(1));
    const Symbols linear{0, 1, 0, 0};
    CHECK(2 * by_symmetric_functions(linear, {1, 1, 0}) == fraction(4, 3));
    CHECK(by_symmetric_functions(linear, {2, 1, 0}) == Symbol(1));
    CHECK(by_symmetric_functions(linear, {2, 0, 0}) == fraction(2, 3));
    CHECK(by_symmetric_functions(linear, {1, 0, 0}) == fraction(1, 3));

    CHECK(p({(1 - alpha) * a + alpha * d, b, c}) == (1 - alpha) * p({a, b, c}) + alpha * p({d, b, c}));
    CHECK(p({SymbolicArgument(alpha * a, alpha), b, c}) == alpha * p({a, b, c}));
}

TEST_CASE(
    "hart-linear-add: p(a,b,d) + p(a,c,d) exceeds p(a,b+c,d) by p(a,0,d); affine combinations are right",
    "[statement]") {
    CHECK(p({a, b, d}) + p({a, c, d}) - p({a, b + c, d}) == p({a, 0, d}));
    CHECK(by_symmetric_functions({1, 0, 0, 0}, {0, 2, 0}) == Symbol(1));
    CHECK(p({a, (1 - alpha) * b + alpha * c, d}) == (1 - alpha) * p({a, b, d}) + alpha * p({a, c, d}));
}

TEST_CASE("hart-lerp: (1-t) p(0,0,0) + t p(1,0,0) = p(t,0,0)", "[statement]") {
    CHECK((1 - t) * p({0, 0, 0}) + t * p({1, 0, 0}) == p({t, 0, 0}));
}

TEST_CASE("hart-lerp-line2: p(0(1-t),0,0) + p(1t,0,0) exceeds the lerp by p(0,0,0)", "[statement]") {
    const Symbol lerp = (1 - t) * p({0, 0, 0}) + t * p({1, 0, 0});
    CHECK(p({0 * (1 - t), 0, 0}) + p({1 * t, 0, 0}) - lerp == p({0, 0, 0}));
    CHECK_FALSE(p({0, 0, 0}).is_zero());
}

TEST_CASE("hart-lerp-line3: p(0(1-t),0,0) + p(1t,0,0) exceeds p(0(1-t)+1t,0,0) by p(0,0,0)", "[statement]") {
    CHECK(p({0 * (1 - t), 0, 0}) + p({1 * t, 0, 0}) - p({0 * (1 - t) + 1 * t, 0, 0}) == p({0, 0, 0}));
    CHECK_FALSE(p({0, 0, 0}).is_zero());
}

TEST_CASE("hart-lerp-line4: p(0(1-t)+1t,0,0) = p(t,0,0)", "[statement]") {
    CHECK(p({0 * (1 - t) + 1 * t, 0, 0}) == p({t, 0, 0}));
}

TEST_CASE("hart-eval-1: p(t) = p(t,t,t) = (1-t) p(t,t,0) + t p(t,t,1)", "[statement]") {
    CHECK(p({t, t, t}) == curve(t));
    CHECK((1 - t) * p({t, t, 0}) + t * p({t, t, 1}) == curve(t));
}

TEST_CASE("hart-eval-2: the second argument expanded in both terms", "[statement]") {
    CHECK((1 - t) * ((1 - t) * p({t, 0, 0}) + t * p({t, 0, 1})) +
              t * ((1 - t) * p({t, 0, 1}) + t * p({t, 1, 1})) ==
          curve(t));
}

TEST_CASE("hart-eval-3: (1-t)^2 p(t,0,0) + 2(1-t)t p(t,0,1) + t^2 p(t,1,1)", "[statement]") {
    CHECK(pow(1 - t, 2) * p({t, 0, 0}) + 2 * (1 - t) * t * p({t, 0, 1}) + pow(t, 2) * p({t, 1, 1}) ==
          curve(t));
}

TEST_CASE("hart-eval-4: the third argument expanded as well", "[statement]") {
    const auto expanded = [](int x, int y) { return (1 - t) * p({0, x, y}) + t * p({1, x, y}); };
    CHECK(pow(1 - t, 2) * expanded(0, 0) + 2 * (1 - t) * t * expanded(0, 1) + pow(t, 2) * expanded(1, 1) ==
          curve(t));
}

TEST_CASE("hart-eval-5: the Bernstein form", "[statement]") {
    CHECK(pow(1 - t, 3) * p({0, 0, 0}) + 3 * pow(1 - t, 2) * t * p({0, 0, 1}) +
              3 * (1 - t) * pow(t, 2) * p({0, 1, 1}) + pow(t, 3) * p({1, 1, 1}) ==
          curve(t));
}
