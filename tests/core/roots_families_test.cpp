#include <blossom/core/curve/orthogonal_projection.hpp>
#include <blossom/core/curve/roots.hpp>
#include "core_test.hpp"

#include "support/root_check.hpp"

namespace {

const Polynomial t = Polynomial::monomial(1);

/// (t - 1) (t - 2) ... (t - n).
Polynomial wilkinson(int n) {
    Polynomial polynomial = 1;
    for (int k = 1; k <= n; ++k) polynomial *= t - k;
    return polynomial;
}

std::vector<Root> integers(int first, int last) {
    std::vector<Root> expected;
    for (int k = first; k <= last; ++k) expected.push_back({k, k, 1});
    return expected;
}

/// Different signs at the two ends of n disjoint intervals prove n roots, the most that degree n permits.
void check_all_roots_by_signs(const Polynomial& polynomial, const std::vector<Root>& found) {
    CHECK(found.size() == polynomial.degree());
    for (std::size_t i = 0; i < found.size(); ++i) {
        const Root& root = found[i];
        CAPTURE(i, root.lower, root.upper);
        CHECK(root.multiplicity == 1);
        if (root.is_rational()) {
            CHECK(polynomial(root.lower).is_zero());
        } else {
            CHECK(polynomial(root.lower).sign() * polynomial(root.upper).sign() < 0);
        }
        if (i > 0) CHECK(found[i - 1].upper <= root.lower);
    }
}

}  // namespace

TEST_CASE("Wilkinson's polynomials have the integers as roots", "[roots]") {
    CHECK(roots(wilkinson(20), {0, 21}) == integers(1, 20));
    CHECK(roots(wilkinson(20), {1, 20}) == integers(1, 20));
    CHECK(roots(wilkinson(20), {Rational(11, 2), Rational(17, 2)}) == integers(6, 8));
    CHECK(roots(wilkinson(20), {-1000, 1000}) == integers(1, 20));
    CHECK(roots(wilkinson(100), {0, 101}) == integers(1, 100));
    CHECK(roots(wilkinson(20) * pow(t - 7, 3), {6, 8}) == std::vector<Root>{{6, 6, 1}, {7, 7, 4}, {8, 8, 1}});
}

TEST_CASE("Wilkinson's perturbation by 2^-23 leaves ten real roots", "[roots]") {
    const Polynomial perturbed = wilkinson(20) - Polynomial(Rational(1, 1 << 23)) * pow(t, 19);
    const std::vector<Root> found = roots(perturbed, {-100, 100}, Rational(1, 1000));
    CHECK(found.size() == 10);
    check_isolation(perturbed, {-100, 100}, found);
    REQUIRE_FALSE(found.empty());
    CHECK(found.back().lower > Rational(208, 10));
    CHECK(found.back().upper < Rational(209, 10));
}

TEST_CASE("the two close roots of Mignotte's polynomials are separated", "[roots]") {
    for (const auto& [degree, a] : {std::pair<std::size_t, int>{10, 10}, {25, 100}, {60, 10}}) {
        const Polynomial polynomial = pow(t, degree) - Polynomial(2) * pow(Polynomial(a) * t - 1, 2);
        const std::vector<Root> found = roots(polynomial, {0, 1});
        CAPTURE(degree, a);
        REQUIRE(found.size() == 2);
        check_isolation(polynomial, {0, 1}, found);
        CHECK_FALSE(found[0].is_rational());
        CHECK(found[0].upper <= found[1].lower);
        // P(1/a) = a^-n > 0 lies between them, and P < 0 at a distance of 2 a^-(n+2)/2 to either side.
        const Rational middle(1, a);
        const Rational distance = 2 / pow(Rational(a), degree / 2);
        CHECK(found[0].lower < middle);
        CHECK(found[1].upper > middle);
        CHECK(SturmSequence(polynomial).roots_in(middle - distance, middle + distance) == 2);
        const std::vector<Root> narrow =
            roots(polynomial, {middle - distance, middle + distance}, distance / 1000);
        CHECK(narrow.size() == 2);
        check_isolation(polynomial, {middle - distance, middle + distance}, narrow);
    }
}

TEST_CASE("clusters far closer than doubles can tell are found", "[roots]") {
    const Polynomial mignotte = pow(t, 100) - Polynomial(2) * pow(Polynomial(100) * t - 1, 2);
    const std::vector<Root> close = roots(mignotte, {-2, 2});
    const Rational middle(1, 100);
    const Rational distance = 2 / pow(Rational(100), 50);
    REQUIRE(close.size() == 4);
    for (const Root& root : {close[1], close[2]}) {
        CHECK(root.lower > middle - distance);
        CHECK(root.upper < middle + distance);
    }
    CHECK(close[1].upper <= close[2].lower);

    // One real root with two complex ones close to it; four real roots; two clusters.
    for (const Polynomial& polynomial :
         {pow(t, 30) - pow(Polynomial(7) * t - 1, 3),
          pow(t, 25) - pow(pow(Polynomial(9) * t - 4, 2) - Polynomial(Rational(1, 100'000)), 2),
          pow(t, 24) - Polynomial(3) * pow((Polynomial(5) * t - 1) * (Polynomial(7) * t - 3), 2),
          pow(t, 24) + Polynomial(3) * pow((Polynomial(5) * t - 1) * (Polynomial(7) * t - 3), 2)}) {
        check_isolation(polynomial, {0, 1}, roots(polynomial, {0, 1}));
    }
}

TEST_CASE("the Chebyshev polynomials have all their roots inside", "[roots]") {
    for (const std::size_t n : {1U, 2U, 3U, 8U, 33U, 50U}) {
        const Polynomial chebyshev = chebyshev_on_unit_interval(n);
        CAPTURE(n);
        check_all_roots_by_signs(chebyshev, roots(chebyshev, {0, 1}));
    }
    const std::vector<Root> third = roots(chebyshev_on_unit_interval(3), {0, 1});
    REQUIRE(third.size() == 3);
    CHECK(third[1] == Root{Rational(1, 2), Rational(1, 2), 1});
}

TEST_CASE("hundreds of degrees", "[roots]") {
    const std::vector<Root> radical = roots(pow(t, 256) - 2, {0, 2});
    REQUIRE(radical.size() == 1);
    CHECK(pow(radical[0].lower, 256) < 2);
    CHECK(pow(radical[0].upper, 256) > 2);

    const Polynomial two = (pow(t, 300) - Polynomial(Rational(1, 3))) * pow(Polynomial(7) * t - 5, 2);
    const std::vector<Root> found = roots(two, {0, 1});
    REQUIRE(found.size() == 2);
    CHECK(found[0] == Root{Rational(5, 7), Rational(5, 7), 2});
    CHECK(3 * pow(found[1].lower, 300) < 1);
    CHECK(3 * pow(found[1].upper, 300) > 1);
    CHECK(found[1].lower > Rational(5, 7));

    Polynomial many = 1;
    for (int k = 1; k <= 12; ++k) many *= Polynomial(k) * t - 1;
    many *= pow(t, 200) + 1;
    std::vector<Root> expected;
    for (int k = 12; k >= 1; --k) expected.push_back({Rational(1, k), Rational(1, k), 1});
    CHECK(roots(many, {0, 1}) == expected);
}

TEST_CASE("an isolation that needs too many digits is refused", "[roots]") {
    Limits limits;
    limits.digits = 20;
    const Polynomial polynomial = pow(t, 25) - Polynomial(2) * pow(Polynomial(100) * t - 1, 2);
    CHECK(failure_code([&] { roots(polynomial, {0, 1}, 0, limits); }) == ErrorCode::limit_exceeded);
}
