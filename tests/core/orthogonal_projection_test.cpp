#include <blossom/core/curve/orthogonal_projection.hpp>
#include "core_test.hpp"

#include "support/chebyshev_identity.hpp"

namespace {

const Polynomial s = Polynomial::monomial(1);

}  // namespace

TEST_CASE("the integral over [0, 1] is the sum of c_k / (k + 1)", "[projection]") {
    Random random(341);
    for (int i = 0; i < 300; ++i) {
        const Polynomial p = polynomial(random, 8, i % 4 == 0 ? Size::any : Size::small);
        CHECK(integral_over_unit_interval(p) == integral(p));
    }
    CHECK(integral_over_unit_interval(Polynomial()) == 0);
    CHECK(integral_over_unit_interval(Polynomial(3)) == 3);
}

TEST_CASE("what a projection leaves is orthogonal to all lower polynomials, for every weight",
          "[projection]") {
    Random random(342);
    for (std::size_t i = 0; i < 300; ++i) {
        const Polynomial p = polynomial(random, 8, i % 4 == 0 ? Size::any : Size::small);
        const std::size_t m = random.below(9);
        const std::size_t k = random.below(4);
        CAPTURE(p, m, k);
        const Polynomial nearest = project(p, m, k);
        CHECK(nearest.degree() <= m);
        if (p.degree() <= m) CHECK(nearest == p);
        for (std::size_t j = 0; j <= m; ++j) {
            CHECK(integral((p - nearest) * pow(s, j) * pow(s - s * s, k)) == 0);
        }
        CHECK(project(nearest, m, k) == nearest);
    }
    CHECK(project(Polynomial(), 3, 0).is_zero());
}

TEST_CASE("the Chebyshev polynomials of [0, 1] satisfy the identity that makes them equioscillate",
          "[projection]") {
    CHECK(chebyshev_on_unit_interval(0) == Polynomial(1));
    CHECK(chebyshev_on_unit_interval(1) == Polynomial(2) * s - 1);
    CHECK(chebyshev_on_unit_interval(2) == Polynomial(8) * s * s - Polynomial(8) * s + 1);
    for (std::size_t n = 0; n <= 20; ++n) {
        const Polynomial chebyshev = chebyshev_on_unit_interval(n);
        CHECK(is_chebyshev(chebyshev, n, 1));
        CHECK(chebyshev(1) == 1);
        if (n > 0) CHECK(chebyshev.leading_coefficient() == pow(Rational(2), 2 * n - 1));
    }
    CHECK_FALSE(is_chebyshev(chebyshev_on_unit_interval(4) + 1, 4, 1));
}
