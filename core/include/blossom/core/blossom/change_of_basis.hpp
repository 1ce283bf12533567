#pragma once

#include <blossom/core/constructions/constructions.hpp>

#include <vector>

/// Conversions between the monomial and the Bernstein basis, over any commutative ring R that contains the
/// integers. They do not use elementary symmetric functions, so that control points are an independent source
/// for de Casteljau's algorithm.

namespace blossom::constructions {

/// The coefficients of sum_k c_k (a + d X)^k q^(n-k), by Horner's rule. Cost: n^2 multiply-adds.
template <class R>
std::vector<R> substitute_line(std::span<const R> coefficients, const Integer& a, const Integer& d,
                               const Integer& q) {
    // NOLINTBEGIN(performance-unnecessary-copy-initialization): R can be another ring than Integer
    const R constant(a);
    const R slope(d);
    // NOLINTEND(performance-unnecessary-copy-initialization)
    std::vector<R> result{coefficients.back()};
    Integer power = 1;
    for (std::size_t k = coefficients.size() - 1; k-- > 0;) {
        power *= q;
        result.push_back(slope * result.back());
        for (std::size_t j = result.size() - 2; j > 0; --j)
            result[j] = constant * result[j] + slope * result[j - 1];
        result.front() = constant * result.front() + coefficients[k] * R(power);
    }
    return result;
}

/// The Bernstein coefficients over [a/q, b/q] of a polynomial in the monomial basis: substitute t = (a + (b -
/// a) s) / q, divide by binomials, then add at every node of a triangle.
///
/// Cost: n^2 multiply-adds and n^2 / 2 additions. Source: Goldman, figure 11(b). Statement: goldman-fig11b.
template <class R>
Quotients<R> bernstein_from_monomial(std::span<const R> coefficients, const Integer& a, const Integer& b,
                                     const Integer& q) {
    const std::size_t n = coefficients.size() - 1;
    const std::vector<R> local = substitute_line(coefficients, a, b - a, q);
    Quotients<R> result = normalised_coefficients(std::span<const R>(local));
    auto& points = result.numerators;
    for (std::size_t level = 1; level <= n; ++level) {
        for (std::size_t k = n; k >= level; --k) points[k] += points[k - 1];
    }
    result.denominator *= pow(q, n);
    return result;
}

/// The coefficients C(n, k) Delta^k P_0 of sum_k P_k C(n, k) s^k (1 - s)^(n-k) in powers of s: subtract at
/// every node of a triangle, then multiply by binomials.
///
/// Cost: n^2 / 2 subtractions. Source: Goldman, figure 11(a). Statement: goldman-fig11a.
template <class R>
std::vector<R> local_monomial_from_bernstein(std::span<const R> control_points) {
    const std::size_t n = control_points.size() - 1;
    std::vector<R> local(control_points.begin(), control_points.end());
    for (std::size_t level = 1; level <= n; ++level) {
        for (std::size_t k = n; k >= level; --k) local[k] -= local[k - 1];
    }
    const std::vector<Integer> binomials = binomial_row(n);
    for (std::size_t k = 0; k <= n; ++k) local[k] = local[k] * R(binomials[k]);
    return local;
}

/// The monomial coefficients of a polynomial in the Bernstein basis over [a/q, b/q]: the local coefficients
/// with s = (q t - a) / (b - a) substituted.
///
/// Cost: n^2 / 2 subtractions and n^2 multiply-adds. Source: Goldman, exercise 10c. Statement:
/// goldman-ex-10c.
template <class R>
Quotients<R> monomial_from_bernstein(std::span<const R> control_points, const Integer& a, const Integer& b,
                                     const Integer& q) {
    const std::vector<R> local = local_monomial_from_bernstein(control_points);
    return {substitute_line(std::span<const R>(local), -a, q, b - a), pow(b - a, control_points.size() - 1)};
}

/// P_k C(n, k): the coefficients of x^k y^(n-k) in (b - a)^n F(u, v), where x = q u - a v and y = b v - q u.
template <class R>
std::vector<R> bernstein_form(std::span<const R> control_points) {
    std::vector<R> form(control_points.begin(), control_points.end());
    const std::vector<Integer> binomials = binomial_row(form.size() - 1);
    for (std::size_t k = 0; k < form.size(); ++k) form[k] = form[k] * R(binomials[k]);
    return form;
}

}  // namespace blossom::constructions
