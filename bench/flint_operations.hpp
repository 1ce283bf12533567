#pragma once

// Operations on whole polynomials as an expert would write them with FLINT: integers over one denominator,
// FLINT's own Taylor shift and evaluation, and one reduction at the end.

#include <flint/fmpz_poly.h>

#include <utility>

#include "flint_numbers.hpp"

namespace flint_peer {

/// Numerators over one denominator, in lowest terms, as one line.
inline std::string text_of(const Integers& numerators, const fmpz_t denominator) {
    std::string result;
    for (slong k = 0; k < numerators.size(); ++k) result += text_of(numerators.at(k)) + " ";
    return result + "/ " + text_of(denominator);
}

/// Divides by the greatest common divisor of the denominator and all numerators, beginning with the first and
/// the last, which usually have the smallest one.
inline void make_canonical(Integers& numerators, fmpz_t denominator, fmpz_t scratch) {
    fmpz_gcd(scratch, denominator, numerators.at(0));
    fmpz_gcd(scratch, scratch, numerators.at(numerators.size() - 1));
    _fmpz_vec_content_chained(scratch, numerators.data(), numerators.size(), scratch);
    if (fmpz_is_one(scratch)) return;
    _fmpz_vec_scalar_divexact_fmpz(numerators.data(), numerators.data(), numerators.size(), scratch);
    fmpz_divexact(denominator, denominator, scratch);
}

/// sum_k c_k (t + 1)^k for integers c_k.
class TaylorShift {
public:
    explicit TaylorShift(std::span<const blossom::Integer> coefficients)
        : given_(coefficients), shifted_(given_.size()) {}
    void run() {
        _fmpz_vec_set(shifted_.data(), given_.data(), given_.size());
        _fmpz_poly_taylor_shift(shifted_.data(), one_.at(0), given_.size());
    }
    std::string text() const { return text_of(shifted_, one_.at(0)); }

private:
    Integers given_;
    Integers shifted_;
    Integers one_{std::vector<blossom::Integer>{1}};
};

/// The control points over [a/q, b/q]: the shift by a, t - a = (b - a) s, and the homogeneous form in s and
/// 1 - s by one more shift of the reversed coefficients.
class ControlPolygon {
public:
    ControlPolygon(const blossom::RationalVector& coefficients, const blossom::Integer& a,
                   const blossom::Integer& b, const blossom::Integer& q)
        : given_(coefficients.numerators()),
          points_(given_.size()),
          weights_(given_.size()),
          numbers_(std::vector<blossom::Integer>{a, b - a, q, coefficients.denominator(), 1, 1, 1, 1}) {
        const slong n = given_.size() - 1;
        fmpz_t binomial;
        fmpz_init(binomial);
        for (slong k = 0; k <= n; ++k) {
            fmpz_bin_uiui(binomial, static_cast<ulong>(n), static_cast<ulong>(k));
            fmpz_lcm(lcm(), lcm(), binomial);
        }
        for (slong k = 0; k <= n; ++k) {
            fmpz_bin_uiui(binomial, static_cast<ulong>(n), static_cast<ulong>(k));
            fmpz_divexact(weights_.at(k), lcm(), binomial);
        }
        fmpz_clear(binomial);
    }

    void run() {
        const slong n = given_.size() - 1;
        fmpz_one(power());
        for (slong k = n; k >= 0; --k) {
            fmpz_mul(points_.at(k), given_.at(k), power());
            if (k > 0) fmpz_mul(power(), power(), numbers_.at(2));
        }
        fmpz_mul(denominator(), power(), numbers_.at(3));
        fmpz_mul(denominator(), denominator(), lcm());
        _fmpz_poly_taylor_shift(points_.data(), numbers_.at(0), n + 1);
        fmpz_one(power());
        for (slong k = 1; k <= n; ++k) {
            fmpz_mul(power(), power(), numbers_.at(1));
            fmpz_mul(points_.at(k), points_.at(k), power());
        }
        _fmpz_poly_reverse(points_.data(), points_.data(), n + 1, n + 1);
        fmpz_one(power());
        _fmpz_poly_taylor_shift(points_.data(), power(), n + 1);
        _fmpz_poly_reverse(points_.data(), points_.data(), n + 1, n + 1);
        for (slong k = 0; k <= n; ++k) fmpz_mul(points_.at(k), points_.at(k), weights_.at(k));
        make_canonical(points_, denominator(), power());
    }
    std::string text() { return text_of(points_, denominator()); }

private:
    fmpz* lcm() { return numbers_.at(4); }
    fmpz* power() { return numbers_.at(5); }
    fmpz* denominator() { return numbers_.at(6); }

    Integers given_;
    Integers points_;
    Integers weights_;
    Integers numbers_;
};

/// Values at many parameters, where FLINT chooses between Horner's rule and halving.
class Values {
public:
    Values(const blossom::RationalVector& coefficients, std::span<const blossom::Rational> parameters)
        : coefficients_(coefficients.numerators()),
          denominator_(std::vector<blossom::Integer>{coefficients.denominator()}),
          parameters_(parameters),
          values_(_fmpq_vec_init(parameters_.size())) {}
    Values(const Values&) = delete;
    Values& operator=(const Values&) = delete;
    ~Values() { _fmpq_vec_clear(values_, parameters_.size()); }

    void run() {
        for (slong i = 0; i < parameters_.size(); ++i) {
            const fmpq* t = parameters_.data() + i;
            _fmpz_poly_evaluate_fmpq(fmpq_numref(values_ + i), fmpq_denref(values_ + i), coefficients_.data(),
                                     coefficients_.size(), fmpq_numref(t), fmpq_denref(t));
            fmpz_mul(fmpq_denref(values_ + i), fmpq_denref(values_ + i), denominator_.at(0));
            fmpq_canonicalise(values_ + i);
        }
    }
    std::string text() const {
        std::string result;
        for (slong i = 0; i < parameters_.size(); ++i) result += text_of(values_ + i) + " ";
        return result;
    }

private:
    Integers coefficients_;
    Integers denominator_;
    Arguments parameters_;
    fmpq* values_;
};

}  // namespace flint_peer
