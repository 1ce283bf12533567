#pragma once

#include <blossom/core/algebra/polynomial.hpp>

namespace blossom::testing {

/// Whether P(s) = scale * T_n(2 s - 1), by T_n((x + 1/x) / 2) = (x^n + x^-n) / 2, where s = (x + 1)^2 / (4
/// x).
///
/// For x = exp(i phi) on the unit circle s = (1 + cos phi) / 2 runs over [0, 1], and the identity says P =
/// scale * cos(n phi): |P| <= |scale|, with equality at n + 1 points and alternating signs. By the
/// alternation theorem such an error is the least.
inline bool is_chebyshev(const Polynomial& polynomial, std::size_t n, const Rational& scale) {
    const Polynomial x = Polynomial::monomial(1);
    Polynomial sum;
    for (std::size_t k = 0; k <= n; ++k) {
        sum += Polynomial(2 * polynomial[k]) * pow(x + 1, 2 * k) * pow(Polynomial(4) * x, n - k);
    }
    return polynomial.degree() <= n && sum == Polynomial(scale * pow(Rational(4), n)) * (pow(x, 2 * n) + 1);
}

}  // namespace blossom::testing
