#include <blossom/core/blossom/change_of_basis.hpp>
#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/degree_reduction.hpp>
#include <blossom/core/curve/orthogonal_projection.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <bit>
#include <string>

namespace blossom {

namespace {

/// The coordinates as polynomials in s = (t - a) / (b - a).
std::vector<Polynomial> local_coordinates(const BezierCurve& curve) {
    std::vector<Polynomial> coordinates;
    for (const auto row : curve.control_points().rows()) {
        coordinates.emplace_back(RationalVector(constructions::local_monomial_from_bernstein(row),
                                                curve.control_points().denominator()));
    }
    return coordinates;
}

BezierCurve over(const Interval& interval, const std::vector<Polynomial>& local, std::size_t degree,
                 const Limits& limits) {
    return {control_points(PolynomialCurve(local, degree), Interval(), limits).control_points(), interval};
}

/// The image of s^j under the polarization formula of degree m, for j = m + 1, m + 2, ...:
/// sum_r (-1)^(m-r) S(j, r) (r - 1)! / m! h_(j-m-1)(1/r, ..., 1/m) s^r, r = 1..m, with the Stirling numbers S
/// of the second kind and the complete symmetric functions h.
///
/// In falling powers of the index, sum_I C(i, I) C(m - i, N - I) I^j is the sum over r of S(j, r) C(m - r, N
/// - r) i (i - 1) ... (i - r + 1), and the falling powers are m! / (m - r)! times the control points of s^r.
/// The remaining factor, sum_N (-1)^(m-N) C(m - r, N - r) / N^(j-m), is a difference of order m - r, and that
/// of 1 / (N - y) is (-1)^(m-r) (m - r)! / prod_N (N - y).
class PolarizedPower {
public:
    explicit PolarizedPower(std::size_t m)
        : m_(m), denominator_(factorial(m)), partitions_(m + 1), functions_(m + 1, 1) {
        for (std::size_t r = 2; r <= m; ++r) common_ = lcm(common_, r);
        while (j_ <= m) next_partitions();
    }

    /// Advances to s^(j+1), and multiplies the denominator by `common`.
    void advance() {
        next_partitions();
        denominator_ *= common_;
        for (std::size_t r = m_; r > 0; --r) {
            functions_[r] *= divide_exactly(common_, r);
            if (r < m_) functions_[r] += functions_[r + 1];
        }
    }

    /// The numerator of the coefficient of s^r, r >= 1.
    Integer operator[](std::size_t r) const {
        Integer product = partitions_[r] * functions_[r];
        if ((m_ - r) % 2 == 1) product.negate();
        return product;
    }
    const Integer& denominator() const { return denominator_; }
    const Integer& common() const { return common_; }

private:
    void next_partitions() {
        ++j_;
        for (std::size_t r = std::min(j_, m_); r > 1; --r) {
            partitions_[r] *= r;
            partitions_[r].add_product(partitions_[r - 1], r - 1);
        }
        if (m_ > 0) partitions_[1] = 1;
    }

    std::size_t m_;
    std::size_t j_ = 0;
    Integer common_ = 1;  ///< the least common multiple of 1, ..., m
    Integer denominator_;
    std::vector<Integer> partitions_;  ///< S(j, r) (r - 1)!
    std::vector<Integer> functions_;   ///< common^(j-m-1) h_(j-m-1)(1/r, ..., 1/m)
};

/// Applies the polarization formula of degree m to each of the polynomials. It keeps s^j for j <= m.
std::vector<Polynomial> by_inverse_formula(std::vector<Polynomial> polynomials, std::size_t m,
                                           const Limits& limits) {
    const std::size_t n = std::ranges::max(polynomials, {}, &Polynomial::degree).degree();
    if (n <= m) return polynomials;
    std::size_t bits = 0;
    for (const Polynomial& polynomial : polynomials)
        bits = std::max(bits, greatest_bit_length(polynomial.coefficients().numerators()));
    // The least common multiple of 1, ..., m is below 4^m.
    const auto bits_of_index = static_cast<std::size_t>(std::bit_width(m));
    require_result_bits(bits + n * bits_of_index + 2 * (n - m) * m, limits, polynomials.size() * (m + 1));

    std::vector<std::vector<Integer>> sums(polynomials.size(), std::vector<Integer>(m + 1));
    PolarizedPower power(m);
    for (std::size_t j = m + 1; j <= n; ++j) {
        if (j > m + 1) {
            power.advance();
            for (auto& sum : sums)
                for (Integer& entry : sum) entry *= power.common();
        }
        for (std::size_t r = 1; r <= m; ++r) {
            const Integer weight = power[r];
            for (std::size_t i = 0; i < sums.size(); ++i) {
                if (j <= polynomials[i].degree())
                    sums[i][r].add_product(polynomials[i].coefficients().numerators()[j], weight);
            }
        }
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const RationalVector& given = polynomials[i].coefficients();
        std::vector<Integer> kept = given.numerators();
        kept.resize(std::min(kept.size(), m + 1));
        polynomials[i] =
            Polynomial(given.over_same_denominator(std::move(kept))) +
            Polynomial(RationalVector(std::move(sums[i]), given.denominator() * power.denominator()));
    }
    return polynomials;
}

/// The line through the ends, plus s (1 - s) times the projection of the remainder with the weight (s (1 -
/// s))^2.
Polynomial project_between_ends(const Polynomial& polynomial, std::size_t m) {
    const Polynomial s = Polynomial::monomial(1);
    const Polynomial bubble = s - s * s;
    const Polynomial line = Polynomial(polynomial(0)) + Polynomial(polynomial(1) - polynomial(0)) * s;
    const Polynomial rest = divide_exactly(polynomial - line, bubble);
    return m < 2 ? line : line + bubble * project(rest, m - 2, 2);
}

/// Subtracts the multiple of T_n with the same leading term.
Polynomial economised(const Polynomial& polynomial, std::size_t n) {
    if (n == 0) return polynomial;
    const Polynomial chebyshev = chebyshev_on_unit_interval(n);
    return polynomial - Polynomial(polynomial[n] / chebyshev[n]) * chebyshev;
}

void require_method(std::size_t n, std::size_t m, ReductionMethod method) {
    const auto refuse = [&](const std::string& rule) {
        throw Error(
            ErrorCode::degree_too_low,
            "degree " + std::to_string(n) + " cannot be reduced to " + std::to_string(m) + ": " + rule,
            Part::to);
    };
    if (m > n) refuse("the new degree must not be greater; raise it instead");
    if (method == ReductionMethod::uniform && m + 1 < n)
        refuse("the best uniform approximation is by one degree");
    if (method == ReductionMethod::least_squares_endpoints && m == 0 && n > 0) {
        refuse("a constant does not keep two ends");
    }
}

}  // namespace

std::string_view reduction_method_name(ReductionMethod method) {
    switch (method) {
        case ReductionMethod::inverse_formula:
            return "inverse-formula";
        case ReductionMethod::least_squares:
            return "least-squares";
        case ReductionMethod::least_squares_endpoints:
            return "least-squares-endpoints";
        case ReductionMethod::uniform:
            return "uniform";
    }
    return "";
}

Reduction reduce(const BezierCurve& curve, std::size_t m, ReductionMethod method, const Limits& limits) {
    const std::size_t n = curve.degree();
    require_method(n, m, method);
    const std::vector<Polynomial> given = local_coordinates(curve);
    std::vector<Polynomial> reduced;
    for (const Polynomial& coordinate : given) {
        switch (method) {
            case ReductionMethod::inverse_formula:
                break;
            case ReductionMethod::least_squares:
                reduced.push_back(project(coordinate, m, 0));
                break;
            case ReductionMethod::least_squares_endpoints:
                reduced.push_back(m == n ? coordinate : project_between_ends(coordinate, m));
                break;
            case ReductionMethod::uniform:
                reduced.push_back(m == n ? coordinate : economised(coordinate, n));
                break;
        }
    }
    if (method == ReductionMethod::inverse_formula) {
        reduced = by_inverse_formula(given, m, limits);
    }

    Reduction result{over(curve.interval(), reduced, m, limits), reduced == given, 0, {}};
    for (std::size_t j = 0; j < given.size(); ++j) {
        const Polynomial difference = given[j] - reduced[j];
        result.l2_squared += integral_over_unit_interval(difference * difference);
        if (method == ReductionMethod::uniform) {
            result.maximum.push_back(n == 0 ? Rational(0)
                                            : abs(difference[n] / chebyshev_on_unit_interval(n)[n]));
        }
    }
    result.l2_squared *= abs(curve.interval().b() - curve.interval().a());
    return result;
}

}  // namespace blossom
