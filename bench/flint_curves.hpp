#pragma once

// Operations on Bezier curves as an expert would write them with FLINT: integers over one denominator,
// triangles in place at low degree, Taylor shifts and products of polynomials at high degree, and one
// reduction at the end.

#include <flint/fmpq_poly.h>
#include <flint/fmpz_poly.h>

#include "cases.hpp"
#include "flint_operations.hpp"

namespace flint_peer {

/// From this degree on a Taylor shift is cheaper than a triangle of additions.
inline constexpr slong degree_of_shifts = 60;

/// Both edges of the triangle (q - p) P_i + p P_(i+1) for t = p/q.
class Subdivision {
public:
    explicit Subdivision(const Case& given)
        : given_(curve_of(given).coefficients().numbers().numerators()),
          row_(given_.size()),
          left_(given_.size()),
          right_(given_.size()),
          numbers_(std::vector<blossom::Integer>{
              given.arguments[0].numerator(),
              given.arguments[0].denominator() - given.arguments[0].numerator(),
              given.arguments[0].denominator(), curve_of(given).coefficients().denominator(), 1, 1, 1}) {}

    void run() {
        const slong n = given_.size() - 1;
        n < degree_of_shifts ? triangle(n) : shifts(n);
        // Point i of the left polygon is over q^i, point i of the right one over q^(n - i).
        fmpz_one(power());
        for (slong i = n; i >= 0; --i) {
            fmpz_mul(left_.at(i), left_.at(i), power());
            fmpz_mul(right_.at(n - i), right_.at(n - i), power());
            if (i > 0) fmpz_mul(power(), power(), q());
        }
        fmpz_mul(left_denominator(), power(), denominator());
        fmpz_set(right_denominator(), left_denominator());
        make_canonical(left_, left_denominator(), power());
        make_canonical(right_, right_denominator(), power());
    }
    std::string text() {
        return text_of(left_, left_denominator()) + "; " + text_of(right_, right_denominator());
    }

private:
    void triangle(slong n) {
        _fmpz_vec_set(row_.data(), given_.data(), n + 1);
        for (slong r = 0; r <= n; ++r) {
            fmpz_set(left_.at(r), row_.at(0));
            fmpz_set(right_.at(n - r), row_.at(n - r));
            for (slong i = 0; i < n - r; ++i) {
                fmpz_mul(row_.at(i), row_.at(i), rest());
                fmpz_addmul(row_.at(i), row_.at(i + 1), p());
            }
        }
    }

    /// Point i of the left polygon is sum_k C(i, k) p^k q^(i - k) (difference k of the first point).
    void shifts(slong n) {
        edge(n, left_, false, p());
        edge(n, right_, true, rest());
        _fmpz_poly_reverse(right_.data(), right_.data(), n + 1, n + 1);
    }
    void edge(slong n, Integers& edge, bool reversed, const fmpz* step) {
        _fmpz_vec_set(edge.data(), given_.data(), n + 1);
        if (reversed) _fmpz_poly_reverse(edge.data(), edge.data(), n + 1, n + 1);
        convolve(n, edge, -1);
        fmpz_one(power());
        for (slong k = 1; k <= n; ++k) {
            fmpz_mul(power(), power(), step);
            fmpz_mul(edge.at(k), edge.at(k), power());
        }
        fmpz_one(power());
        for (slong k = n; k >= 0; --k) {
            fmpz_mul(edge.at(k), edge.at(k), power());
            if (k > 0) fmpz_mul(power(), power(), q());
        }
        convolve(n, edge, 1);
        // All numbers are over q^n; divides by q^(n - i)
        fmpz_one(power());
        for (slong i = n; i >= 0; --i) {
            fmpz_divexact(edge.at(i), edge.at(i), power());
            if (i > 0) fmpz_mul(power(), power(), q());
        }
    }
    /// Binomial convolution with (sign)^(i - k): numbers weighted by C(n, .), shifted in reversed order, then
    /// divided by the weights.
    void convolve(slong n, Integers& numbers, slong sign) {
        binomial(n);
        for (slong k = 0; k <= n; ++k) fmpz_mul(numbers.at(k), numbers.at(k), row_.at(k));
        _fmpz_poly_reverse(numbers.data(), numbers.data(), n + 1, n + 1);
        fmpz_set_si(power(), sign);
        _fmpz_poly_taylor_shift(numbers.data(), power(), n + 1);
        _fmpz_poly_reverse(numbers.data(), numbers.data(), n + 1, n + 1);
        for (slong k = 0; k <= n; ++k) fmpz_divexact(numbers.at(k), numbers.at(k), row_.at(k));
    }
    void binomial(slong n) {
        fmpz_one(row_.at(0));
        for (slong k = 1; k <= n; ++k) {
            fmpz_mul_si(row_.at(k), row_.at(k - 1), n - k + 1);
            fmpz_divexact_si(row_.at(k), row_.at(k), k);
        }
    }

    fmpz* p() { return numbers_.at(0); }
    fmpz* rest() { return numbers_.at(1); }
    fmpz* q() { return numbers_.at(2); }
    fmpz* denominator() { return numbers_.at(3); }
    fmpz* power() { return numbers_.at(4); }
    fmpz* left_denominator() { return numbers_.at(5); }
    fmpz* right_denominator() { return numbers_.at(6); }

    Integers given_;
    Integers row_;
    Integers left_;
    Integers right_;
    Integers numbers_;
};

/// The control points over [0, 1]: sum_k C(j, k) c_k / C(n, k), by additions at low degree.
class ControlPoints {
public:
    explicit ControlPoints(const Case& given)
        : given_(curve_of(given).coefficients().numbers().numerators()),
          points_(given_.size()),
          weights_(given_.size()),
          numbers_(std::vector<blossom::Integer>{curve_of(given).coefficients().denominator(), 1, 1, 1}) {
        const slong n = given_.size() - 1;
        for (slong k = 0; k <= n; ++k) {
            fmpz_bin_uiui(weights_.at(k), static_cast<ulong>(n), static_cast<ulong>(k));
            fmpz_lcm(lcm(), lcm(), weights_.at(k));
        }
        for (slong k = 0; k <= n; ++k) fmpz_divexact(weights_.at(k), lcm(), weights_.at(k));
    }
    void run() {
        compute();
        make_canonical(points_, denominator(), scratch());
    }
    std::string text() { return text_of(points_, denominator()); }

protected:
    void compute() {
        const slong n = given_.size() - 1;
        fmpz_mul(denominator(), numbers_.at(0), lcm());
        if (n < degree_of_shifts) {
            for (slong k = 0; k <= n; ++k) fmpz_mul(points_.at(k), given_.at(k), weights_.at(k));
            for (slong i = 1; i <= n; ++i) {
                for (slong k = n; k >= i; --k) fmpz_add(points_.at(k), points_.at(k), points_.at(k - 1));
            }
            return;
        }
        _fmpz_poly_reverse(points_.data(), given_.data(), n + 1, n + 1);
        fmpz_one(scratch());
        _fmpz_poly_taylor_shift(points_.data(), scratch(), n + 1);
        _fmpz_poly_reverse(points_.data(), points_.data(), n + 1, n + 1);
        for (slong k = 0; k <= n; ++k) fmpz_mul(points_.at(k), points_.at(k), weights_.at(k));
    }
    fmpz* denominator() { return numbers_.at(2); }

    Integers given_;
    Integers points_;

private:
    fmpz* lcm() { return numbers_.at(1); }
    fmpz* scratch() { return numbers_.at(3); }

    Integers weights_;
    Integers numbers_;
};

/// The same, with each point in lowest terms.
class Points : public ControlPoints {
public:
    explicit Points(const Case& given) : ControlPoints(given), reduced_(given.coefficients) {}
    void run() {
        compute();
        for (slong k = 0; k < points_.size(); ++k)
            fmpq_set_fmpz_frac(reduced_.data() + k, points_.at(k), denominator());
    }
    std::string text() const {
        std::string result;
        for (slong k = 0; k < reduced_.size(); ++k) result += text_of(reduced_.data() + k) + " ";
        return result;
    }

private:
    Arguments reduced_;
};

/// Raises the degree by n: C(2n, i) Q_i = sum_j C(n, j) P_j C(n, i - j), a product of polynomials.
class Elevation {
public:
    explicit Elevation(const Case& given)
        : given_(curve_of(given).coefficients().numbers().numerators()),
          binomials_(given_.size()),
          weighted_(given_.size()),
          raised_(2 * given_.size() - 1),
          weights_(2 * given_.size() - 1),
          numbers_(std::vector<blossom::Integer>{curve_of(given).coefficients().denominator(), 1, 1, 1}) {
        const slong n = given_.size() - 1;
        for (slong k = 0; k <= n; ++k)
            fmpz_bin_uiui(binomials_.at(k), static_cast<ulong>(n), static_cast<ulong>(k));
        for (slong k = 0; k <= 2 * n; ++k) {
            fmpz_bin_uiui(weights_.at(k), static_cast<ulong>(2 * n), static_cast<ulong>(k));
            fmpz_lcm(numbers_.at(1), numbers_.at(1), weights_.at(k));
        }
        for (slong k = 0; k <= 2 * n; ++k) fmpz_divexact(weights_.at(k), numbers_.at(1), weights_.at(k));
    }
    void run() {
        const slong n = given_.size() - 1;
        for (slong k = 0; k <= n; ++k) fmpz_mul(weighted_.at(k), given_.at(k), binomials_.at(k));
        _fmpz_poly_mul(raised_.data(), weighted_.data(), n + 1, binomials_.data(), n + 1);
        for (slong k = 0; k <= 2 * n; ++k) fmpz_mul(raised_.at(k), raised_.at(k), weights_.at(k));
        fmpz_mul(numbers_.at(2), numbers_.at(0), numbers_.at(1));
        make_canonical(raised_, numbers_.at(2), numbers_.at(3));
    }
    std::string text() { return text_of(raised_, numbers_.at(2)); }

private:
    Integers given_;
    Integers binomials_;
    Integers weighted_;
    Integers raised_;
    Integers weights_;
    Integers numbers_;
};

/// One value of the blossom from the given coefficients: the product of the linear factors and one inner
/// product.
class OneValue {
public:
    explicit OneValue(const Case& given)
        : given_(curve_of(given).coefficients().numbers().numerators()),
          arguments_(std::span(given.coefficients).first(given.degree)),
          product_(given_.size()),
          numbers_(std::vector<blossom::Integer>{curve_of(given).coefficients().denominator(), 1, 1, 1}),
          value_(std::vector<blossom::Rational>(1)) {}
    void run() {
        const slong n = given_.size() - 1;
        fmpz* const binomial = numbers_.at(1);
        fmpz* const multiple = numbers_.at(2);
        fmpz* const scratch = numbers_.at(3);
        expand(n);
        fmpz_one(multiple);
        fmpz_one(binomial);
        for (slong k = 0; k <= n; ++k) {
            fmpz_lcm(multiple, multiple, binomial);
            fmpz_mul_si(binomial, binomial, n - k);
            fmpz_divexact_si(binomial, binomial, k + 1);
        }
        fmpz* const sum = fmpq_numref(value_.data());
        fmpz_zero(sum);
        fmpz_one(binomial);
        for (slong k = 0; k <= n; ++k) {
            fmpz_divexact(scratch, multiple, binomial);
            fmpz_mul(scratch, scratch, given_.at(k));
            fmpz_addmul(sum, scratch, product_.at(k));
            fmpz_mul_si(binomial, binomial, n - k);
            fmpz_divexact_si(binomial, binomial, k + 1);
        }
        fmpz* const below = fmpq_denref(value_.data());
        fmpz_mul(below, multiple, numbers_.at(0));
        for (slong i = 0; i < n; ++i) fmpz_mul(below, below, fmpq_denref(arguments_.data() + i));
        fmpq_canonicalise(value_.data());
    }
    std::string text() const { return text_of(value_.data()); }

private:
    /// product_ = prod (v_i + u_i X): by loops at low degree; above, by FLINT's product tree over the roots
    /// -u/v of the reversed polynomial.
    void expand(slong n) {
        fmpz* const p = product_.data();
        if (n < degree_of_shifts) {
            fmpz_one(p);
            for (slong i = 0; i < n; ++i) {
                const fmpq* const t = arguments_.data() + i;
                fmpz_mul(p + i + 1, p + i, fmpq_numref(t));
                for (slong k = i; k > 0; --k) {
                    fmpz_mul(p + k, p + k, fmpq_denref(t));
                    fmpz_addmul(p + k, p + k - 1, fmpq_numref(t));
                }
                fmpz_mul(p, p, fmpq_denref(t));
            }
            return;
        }
        // prod (v_i X - u_i)
        _fmpz_poly_product_roots_fmpq_vec(p, arguments_.data(), n);
        _fmpz_poly_reverse(p, p, n + 1, n + 1);
        for (slong k = 1; k <= n; k += 2) fmpz_neg(p + k, p + k);
    }

    Integers given_;
    Arguments arguments_;
    Integers product_;
    Integers numbers_;
    Arguments value_;
};

}  // namespace flint_peer
