#include "expanded_curve.hpp"

namespace blossom::testing {

namespace {

/// sum_k points[k] basis[k].
std::vector<Polynomial> combination(const PointArray& points, const std::vector<Polynomial>& basis) {
    std::vector<Polynomial> coordinates(points.dimension());
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Coordinates point = points[k];
        for (std::size_t j = 0; j < point.size(); ++j) coordinates[j] += Polynomial(point[j]) * basis[k];
    }
    return coordinates;
}

}  // namespace

std::vector<Polynomial> expanded(const BezierCurve& curve) {
    const Polynomial t = Polynomial::monomial(1);
    const Rational& a = curve.interval().a();
    const Rational& b = curve.interval().b();
    const Polynomial right = (t - Polynomial(a)) * Polynomial(1 / (b - a));
    const Polynomial left = Polynomial(1) - right;
    const std::size_t n = curve.degree();
    std::vector<Polynomial> basis;
    Rational binomial = 1;
    for (std::size_t k = 0; k <= n; ++k) {
        basis.push_back(Polynomial(binomial) * pow(left, n - k) * pow(right, k));
        binomial *= Rational(n - k, k + 1);
    }
    return combination(curve.control_points(), basis);
}

std::vector<Polynomial> expanded(const PolynomialCurve& curve) {
    std::vector<Polynomial> basis;
    for (std::size_t k = 0; k <= curve.degree(); ++k) basis.push_back(Polynomial::monomial(k));
    return combination(curve.coefficients(), basis);
}

std::vector<Polynomial> expanded(const TaylorCurve& curve) {
    const Polynomial local = Polynomial::monomial(1) - Polynomial(curve.center);
    std::vector<Polynomial> basis;
    for (std::size_t k = 0; k < curve.coefficients.size(); ++k) basis.push_back(pow(local, k));
    return combination(curve.coefficients, basis);
}

Rational integral(const Polynomial& polynomial, const Interval& interval) {
    Rational sum;
    for (std::size_t k = 0; k <= polynomial.degree(); ++k) {
        sum += polynomial[k] * (pow(interval.b(), k + 1) - pow(interval.a(), k + 1)) / Rational(k + 1);
    }
    return sum;
}

}  // namespace blossom::testing
