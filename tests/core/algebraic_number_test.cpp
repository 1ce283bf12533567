#include <blossom/core/algebra/elimination.hpp>
#include <blossom/core/curve/algebraic_number.hpp>
#include "core_test.hpp"

namespace {

const Polynomial x = Polynomial::monomial(1);

Root root_of(const Polynomial& polynomial, const Rational& from, const Rational& to) {
    const std::vector<Root> found = roots(polynomial, Interval(from, to));
    REQUIRE(found.size() == 1);
    return found.front();
}

}  // namespace

TEST_CASE("algebraic numbers are compared exactly, whatever their equations are") {
    const Root root_2 = root_of(x * x - 2, 0, 5);
    const Root again = root_of((x * x - 2) * (x * x - 3), 1, Rational(3, 2));
    const Root fourth = root_of(pow(x, 4) - 4, 0, 5);
    const Root root_3 = root_of(x * x - 3, 0, 5);
    CHECK(is_same(root_2, again));
    CHECK(is_same(root_2, fourth));
    CHECK((compare(root_2, root_3) < 0));
    CHECK((compare(root_3, again) > 0));
    CHECK((compare(root_2, rational_root(Rational(7, 5))) > 0));
    CHECK((compare(rational_root(Rational(17, 12)), root_2) > 0));
    // Roots that differ by less than 10^-40.
    const Rational tiny(1, pow(Integer(10), 40));
    const Root near = root_of(x * x - Polynomial(2 + tiny), 0, 5);
    CHECK((compare(root_2, near) < 0));
    CHECK_FALSE(is_same(near, fourth));
}

TEST_CASE("polynomials and quotients have exact values at algebraic numbers") {
    const Root root_2 = root_of(x * x - 2, 0, 5);
    CHECK(vanishes_at(pow(x, 4) - 4, root_2));
    CHECK_FALSE(vanishes_at(x - 1, root_2));
    CHECK(sign_at(x * x - 2, root_2) == 0);
    CHECK(sign_at(x * 100000 - 141421, root_2) == 1);
    CHECK(sign_at(x * 100000 - 141422, root_2) == -1);
    const Limits limits;
    AlgebraicValues square(x * x, Polynomial(1), limits);
    CHECK(square.at(root_2) == rational_root(2));
    AlgebraicValues inverse(Polynomial(2), x, limits);
    CHECK(is_same(inverse.at(root_2), root_2));
    AlgebraicValues shifted(x + 1, x - 1, limits);  // (1 + r) / (r - 1) = (1 + r)^2 = 3 + 2 r
    CHECK(is_same(shifted.at(root_2), root_of(pow(x - 3, 2) - 8, 3, 10)));
}

TEST_CASE("a resultant of polynomials keeps their denominators") {
    // t / 2 - s / 3 and t^2 / 5 - 2: (1/2)^2 g(2 s / 3).
    const Rational f_0[] = {0, Rational(-1, 3)};
    const Polynomial f[] = {Polynomial(f_0), Polynomial(Rational(1, 2))};
    const Polynomial g[] = {Polynomial(-2), Polynomial(), Polynomial(Rational(1, 5)), Polynomial()};
    CHECK(resultant(f, g) == Polynomial(Rational(1, 45)) * x * x - Polynomial(Rational(1, 2)));
}
