#include <blossom/rational/number_text.hpp>
#include "core_test.hpp"

#include "support/logarithms.hpp"

// Fernandez-Jambrina: Inverse Relations for Blossoms and Parametrisations of Rational Curves and Surfaces
// (2024), example 3: ln on [1/2, 1] as a cubic. Values are vectors of rational coefficients on (1, ln 2, ln
// 3, ln 5), so that the control points are exact; the errors are decided in rational enclosures of width
// below 10^-30.

namespace {

const Interval domain(Rational(1, 2), 1);

/// The cubic of the inverse formula as a curve in Q^4.
BezierCurve cubic() { return control_points_from_values(3, domain, logarithm); }

/// The integral of t^k ln t over the domain: t^(k+1) ln t / (k+1) - t^(k+1) / (k+1)^2, where ln 1 = 0 and
/// ln(1/2) = -ln 2.
Coordinates moment(std::size_t k) {
    const Rational lower = pow(Rational(1, 2), k + 1);
    const Rational next(k + 1);
    return {-(1 - lower) / (next * next), lower / next, 0, 0};
}

/// The integral of polynomial * ln over the domain.
Enclosure integral_with_logarithm(const Polynomial& polynomial) {
    Enclosure sum(0);
    for (std::size_t k = 0; k <= polynomial.degree(); ++k)
        sum = sum + Enclosure(polynomial[k]) * enclosed(moment(k));
    return sum;
}

/// The integral of ln^2 over the domain: t ln^2 t - 2 t ln t + 2 t at 1 less that at 1/2.
Enclosure integral_of_square() {
    const Enclosure ln2 = enclosed({0, 1, 0, 0});
    return Enclosure(1) - ln2 * ln2 * Enclosure(Rational(1, 2)) - ln2;
}

/// The integral of (p - ln)^2, where p = p_0 + p_1 ln 2 + p_2 ln 3 + p_3 ln 5.
Enclosure squared_error(const std::vector<Polynomial>& p) {
    Enclosure sum = integral_of_square();
    for (std::size_t i = 0; i < 4; ++i) {
        Coordinates unit(4);
        unit[i] = 1;
        const Enclosure factor = enclosed(unit);
        sum = sum - Enclosure(2) * factor * integral_with_logarithm(p[i]);
        for (std::size_t j = 0; j < 4; ++j) {
            Coordinates other(4);
            other[j] = 1;
            sum = sum + factor * enclosed(other) * Enclosure(integral(p[i] * p[j], domain));
        }
    }
    return sum;
}

/// The least integral of (q - ln)^2 over all cubics q: the integral of ln^2 minus the squares of its
/// components in an orthogonal basis.
Enclosure least_squared_error() {
    Enclosure sum = integral_of_square();
    std::vector<Polynomial> basis;
    for (std::size_t k = 0; k <= 3; ++k) {
        Polynomial next = Polynomial::monomial(k);
        for (const Polynomial& element : basis) {
            const Rational part = integral(next * element, domain) / integral(element * element, domain);
            next -= Polynomial(part) * element;
        }
        const Enclosure product = integral_with_logarithm(next);
        sum = sum - product * product * Enclosure(1 / integral(next * next, domain));
        basis.push_back(std::move(next));
    }
    return sum;
}

/// Whether a number is `digits`, correct to the last digit.
bool reads(const Enclosure& number, const char* digits, const char* half_unit) {
    const Rational printed = parse_rational(digits);
    const Rational tolerance = parse_rational(half_unit);
    return number.lower > printed - tolerance && number.upper < printed + tolerance;
}

Rational r(int p, int q) { return {p, q}; }

}  // namespace

TEST_CASE("the enclosures of logarithms are narrow and consistent", "[statement]") {
    for (const int t : {2, 3, 5, 6, 10, 30}) CHECK(enclosed(logarithm(t)).width() < parse_rational("1e-45"));
    CHECK(reads(enclosed(logarithm(2)), "0.693147180559945309417232", "1e-24"));
    CHECK(reads(enclosed(logarithm(3)), "1.098612288668109691395245", "1e-24"));
    CHECK(reads(enclosed(logarithm(5)), "1.609437912434100374600759", "1e-24"));
    CHECK(logarithm(r(9, 40)) == Coordinates{0, -3, 2, -1});
}

TEST_CASE("fj-ex3-polygon: -ln2, (65 ln2 - 43 ln3)/6, (27 ln5 + 4 ln2 - 43 ln3)/6, 0 over 1/2, 2/3, 5/6, 1",
          "[statement]") {
    CHECK(cubic().control_points().to_points() ==
          std::vector<Coordinates>{
              {0, -1, 0, 0}, {0, r(65, 6), r(-43, 6), 0}, {0, r(4, 6), r(-43, 6), r(27, 6)}, {0, 0, 0, 0}});
    const BezierCurve abscissae =
        control_points_from_values(3, domain, [](const Rational& t) { return Coordinates{t}; });
    CHECK(abscissae.control_points().to_points() ==
          std::vector<Coordinates>{{r(1, 2)}, {r(2, 3)}, {r(5, 6)}, {1}});
}

TEST_CASE(
    "fj-ex3-error: 1.97566e-7 is the squared L2 error, the norm is 4.4448e-4; the best cubic has 3.47877e-8",
    "[statement]") {
    const Enclosure error = squared_error(expanded(cubic()));
    CHECK(error.width() < parse_rational("1e-30"));
    CHECK(reads(error, "1.97566002200e-7", "5e-18"));
    const Enclosure least = least_squared_error();
    CHECK(least.width() < parse_rational("1e-30"));
    CHECK(reads(least, "3.47877012717e-8", "5e-19"));
    // The printed 2e-7 is the integral itself; the norm by the paper's own definition is its square root.
    CHECK(reads(error, "2e-7", "5e-8"));
    const Rational norm = parse_rational("0.00044448397");
    CHECK(pow(norm - parse_rational("1e-11"), 2) < error.lower);
    CHECK(pow(norm + parse_rational("1e-11"), 2) > error.upper);
    // The ratio to the best error is 5.679, so that the errors are "of the same order" only as powers of ten.
    CHECK(error.lower > parse_rational("5.679") * least.upper);
    CHECK(error.upper < parse_rational("5.680") * least.lower);
}
