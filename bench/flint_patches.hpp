#pragma once

// Patches as an expert would write them with FLINT: integers over one denominator, sums of products along
// rows, and one reduction per result. Memory is allocated once, before the timed part.

#include <flint/fmpz_poly.h>

#include <vector>

#include "flint_operations.hpp"

namespace flint_peer {

/// The data for values of patches: form coefficients over one denominator, places, and scratch memory.
class PatchValues {
public:
    PatchValues(slong degree, std::span<const blossom::Integer> form, const blossom::Integer& denominator,
                std::span<const blossom::Rational> u, std::span<const blossom::Rational> v)
        : degree_(degree),
          form_(form),
          numbers_(std::vector<blossom::Integer>(12)),
          u_(u),
          v_(v),
          values_(std::vector<blossom::Rational>(u.size())) {
        set(numbers_.at(11), denominator);
    }
    void run() {
        for (slong i = 0; i < u_.size(); ++i) evaluate(u_.data() + i, v_.data() + i, values_.data() + i);
    }
    std::string text() const {
        std::string result;
        for (slong i = 0; i < values_.size(); ++i) result += text_of(values_.data() + i) + " ";
        return result;
    }

protected:
    ~PatchValues() = default;
    virtual void evaluate(const fmpq* u, const fmpq* v, fmpq* result) = 0;

    fmpz* number(slong i) const { return numbers_.at(i); }
    const fmpz* denominator() const { return numbers_.at(11); }

    slong degree_;
    Integers form_;

private:
    Integers numbers_;
    Arguments u_;
    Arguments v_;
    Arguments values_;
};

/// A triangle: block b of the coefficients is a form of degree b in y and z; Horner's rule in x sums the
/// blocks.
class TriangleValues final : public PatchValues {
public:
    using PatchValues::PatchValues;

private:
    void evaluate(const fmpq* u, const fmpq* v, fmpq* result) override {
        fmpz* scale = number(0);
        fmpz* x = number(1);
        fmpz* y = number(2);
        fmpz* z = number(3);
        fmpz* inner = number(4);
        fmpz_lcm(scale, fmpq_denref(u), fmpq_denref(v));
        fmpz_divexact(y, scale, fmpq_denref(u));
        fmpz_mul(y, y, fmpq_numref(u));
        fmpz_divexact(z, scale, fmpq_denref(v));
        fmpz_mul(z, z, fmpq_numref(v));
        fmpz_sub(x, scale, y);
        fmpz_sub(x, x, z);
        fmpz_one(powers_.at(0));
        for (slong k = 0; k < degree_; ++k) fmpz_mul(powers_.at(k + 1), powers_.at(k), z);
        fmpz* sum = fmpq_numref(result);
        fmpz_zero(sum);
        const fmpz* coefficient = form_.data();
        for (slong block = 0; block <= degree_; ++block) {
            fmpz_set(inner, coefficient++);
            for (slong k = 1; k <= block; ++k) {
                fmpz_mul(inner, inner, y);
                fmpz_addmul(inner, coefficient++, powers_.at(k));
            }
            fmpz_mul(sum, sum, x);
            fmpz_add(sum, sum, inner);
        }
        fmpz_pow_ui(fmpq_denref(result), scale, static_cast<ulong>(degree_));
        fmpz_mul(fmpq_denref(result), fmpq_denref(result), denominator());
        fmpq_canonicalise(result);
    }

    Integers powers_{degree_ + 1};
};

/// A tensor product of degree n in both directions: each row is multiplied by the monomials in v, and the
/// results by those in u.
class TensorValues final : public PatchValues {
public:
    using PatchValues::PatchValues;

private:
    /// (1 - t)^(n-k) t^k times the power of the denominator.
    void set_monomials(const fmpq* t) {
        fmpz* rest = number(0);
        fmpz* power = number(1);
        fmpz_sub(rest, fmpq_denref(t), fmpq_numref(t));
        fmpz_one(power);
        for (slong k = 0; k <= degree_; ++k) {
            fmpz_set(monomials_.at(k), power);
            fmpz_mul(power, power, fmpq_numref(t));
        }
        fmpz_one(power);
        for (slong k = degree_; k-- > 0;) {
            fmpz_mul(power, power, rest);
            fmpz_mul(monomials_.at(k), monomials_.at(k), power);
        }
    }

    void evaluate(const fmpq* u, const fmpq* v, fmpq* result) override {
        set_monomials(v);
        for (slong i = 0; i <= degree_; ++i)
            _fmpz_vec_dot(column_.at(i), form_.at(i * (degree_ + 1)), monomials_.data(), degree_ + 1);
        set_monomials(u);
        _fmpz_vec_dot(fmpq_numref(result), column_.data(), monomials_.data(), degree_ + 1);
        fmpz_mul(number(0), fmpq_denref(u), fmpq_denref(v));
        fmpz_pow_ui(fmpq_denref(result), number(0), static_cast<ulong>(degree_));
        fmpz_mul(fmpq_denref(result), fmpq_denref(result), denominator());
        fmpq_canonicalise(result);
    }

    Integers monomials_{degree_ + 1};
    Integers column_{degree_ + 1};
};

/// The net of a triangle with its degree raised by 1: the points i - e_k, weighted by i_k.
class RaisedTriangle {
public:
    RaisedTriangle(slong degree, const blossom::RationalVector& net)
        : degree_(degree),
          net_(net.numerators()),
          raised_((degree + 2) * (degree + 3) / 2),
          numbers_(std::vector<blossom::Integer>{net.denominator(), 0, 0}) {}

    void run() {
        for (slong b = 0; b <= degree_ + 1; ++b) {
            const slong row = b * (b + 1) / 2;
            for (slong j = 0; j <= b; ++j) {
                fmpz* point = raised_.at(row + j);
                fmpz_zero(point);
                if (b <= degree_)
                    fmpz_addmul_ui(point, net_.at(row + j), static_cast<ulong>(degree_ + 1 - b));
                if (j < b) fmpz_addmul_ui(point, net_.at(row - b + j), static_cast<ulong>(b - j));
                if (j > 0) fmpz_addmul_ui(point, net_.at(row - b + j - 1), static_cast<ulong>(j));
            }
        }
        fmpz_mul_ui(numbers_.at(1), numbers_.at(0), static_cast<ulong>(degree_ + 1));
        make_canonical(raised_, numbers_.at(1), numbers_.at(2));
    }
    std::string text() const { return text_of(raised_, numbers_.at(1)); }

private:
    slong degree_;
    Integers net_;
    Integers raised_;
    Integers numbers_;
};

/// The three triangles at the point (u, v): one pyramid, from which each takes its points.
class DividedTriangle {
public:
    DividedTriangle(slong degree, const blossom::RationalVector& net, const blossom::Rational& u,
                    const blossom::Rational& v)
        : degree_(degree),
          size_((degree + 1) * (degree + 2) / 2),
          net_(net.numerators()),
          level_(size_),
          corners_{Integers(size_), Integers(size_), Integers(size_)},
          powers_(degree + 1),
          denominators_(3),
          numbers_(std::vector<blossom::Integer>{net.denominator(), 0, 0, 0, 0, 0}),
          place_(std::vector<blossom::Rational>{u, v}) {}

    void run() {
        fmpz* scale = numbers_.at(1);
        fmpz* x = numbers_.at(2);
        fmpz* y = numbers_.at(3);
        fmpz* z = numbers_.at(4);
        const fmpq* u = place_.data();
        const fmpq* v = place_.data() + 1;
        fmpz_lcm(scale, fmpq_denref(u), fmpq_denref(v));
        fmpz_divexact(y, scale, fmpq_denref(u));
        fmpz_mul(y, y, fmpq_numref(u));
        fmpz_divexact(z, scale, fmpq_denref(v));
        fmpz_mul(z, z, fmpq_numref(v));
        fmpz_sub(x, scale, y);
        fmpz_sub(x, x, z);
        fmpz_one(powers_.at(0));
        for (slong k = 0; k < degree_; ++k) fmpz_mul(powers_.at(k + 1), powers_.at(k), scale);
        _fmpz_vec_set(level_.data(), net_.data(), size_);
        for (slong r = 0; r <= degree_; ++r) {
            const slong n = degree_ - r;
            for (slong b = 0; b <= n; ++b) {  // i_0 = n - b, i_1 = b - j, i_2 = j
                for (slong j = 0; j <= b; ++j) {
                    const fmpz* point = level_.at(place(b, j));
                    if (b == n) put(0, r, b - j, j, point);
                    if (j == b) put(1, n - b, r, j, point);
                    if (j == 0) put(2, n - b, b, r, point);
                }
            }
            for (slong b = 0; b < n; ++b) {
                for (slong j = 0; j <= b; ++j) {
                    fmpz* point = level_.at(place(b, j));
                    fmpz_mul(point, point, x);
                    fmpz_addmul(point, level_.at(place(b + 1, j)), y);
                    fmpz_addmul(point, level_.at(place(b + 1, j + 1)), z);
                }
            }
        }
        for (slong k = 0; k < 3; ++k) {
            fmpz_mul(denominators_.at(k), numbers_.at(0), powers_.at(degree_));
            make_canonical(corners_[k], denominators_.at(k), numbers_.at(5));
        }
    }
    std::string text() const {
        std::string result;
        for (slong k = 0; k < 3; ++k) result += text_of(corners_[k], denominators_.at(k)) + " ";
        return result;
    }

private:
    static slong place(slong b, slong j) { return b * (b + 1) / 2 + j; }
    /// Level r of the pyramid is over scale^r.
    void put(slong corner, slong i, slong j, slong k, const fmpz* point) {
        const slong r = corner == 0 ? i : corner == 1 ? j : k;
        fmpz_mul(corners_[corner].at(place(degree_ - i, k)), point, powers_.at(degree_ - r));
    }

    slong degree_;
    slong size_;
    Integers net_;
    Integers level_;
    Integers corners_[3];
    Integers powers_;
    Integers denominators_;
    Integers numbers_;
    Arguments place_;
};

/// The two halves of a tensor product of degree n in both directions at u = t.
class DividedTensor {
public:
    DividedTensor(slong degree, const blossom::RationalVector& net, const blossom::Rational& t)
        : degree_(degree),
          size_((degree + 1) * (degree + 1)),
          net_(net.numerators()),
          halves_{Integers(size_), Integers(size_)},
          powers_(degree + 1),
          denominators_(2),
          numbers_(std::vector<blossom::Integer>{net.denominator(), 0, 0}),
          place_(std::vector<blossom::Rational>{t}) {}

    void run() {
        const slong width = degree_ + 1;
        const fmpq* t = place_.data();
        fmpz* rest = numbers_.at(1);
        fmpz_sub(rest, fmpq_denref(t), fmpq_numref(t));
        fmpz_one(powers_.at(0));
        for (slong k = 0; k < degree_; ++k) fmpz_mul(powers_.at(k + 1), powers_.at(k), fmpq_denref(t));
        Integers& right = halves_[1];
        Integers& left = halves_[0];
        _fmpz_vec_set(right.data(), net_.data(), size_);
        for (slong r = 0; r <= degree_; ++r) {
            _fmpz_vec_scalar_mul_fmpz(left.at(r * width), right.data(), width, powers_.at(degree_ - r));
            for (slong i = 0; i < degree_ - r; ++i) {
                _fmpz_vec_scalar_mul_fmpz(right.at(i * width), right.at(i * width), width, rest);
                _fmpz_vec_scalar_addmul_fmpz(right.at(i * width), right.at((i + 1) * width), width,
                                             fmpq_numref(t));
            }
        }
        for (slong i = 0; i <= degree_; ++i)
            _fmpz_vec_scalar_mul_fmpz(right.at(i * width), right.at(i * width), width, powers_.at(i));
        for (slong k = 0; k < 2; ++k) {
            fmpz_mul(denominators_.at(k), numbers_.at(0), powers_.at(degree_));
            make_canonical(halves_[k], denominators_.at(k), numbers_.at(2));
        }
    }
    std::string text() const {
        return text_of(halves_[1], denominators_.at(1)) + " " + text_of(halves_[0], denominators_.at(0)) +
               " ";
    }

private:
    slong degree_;
    slong size_;
    Integers net_;
    Integers halves_[2];
    Integers powers_;
    Integers denominators_;
    Integers numbers_;
    Arguments place_;
};

/// The net of a tensor product with its degree in u raised by 1.
class RaisedTensor {
public:
    RaisedTensor(slong degree, const blossom::RationalVector& net)
        : degree_(degree),
          net_(net.numerators()),
          raised_((degree + 2) * (degree + 1)),
          numbers_(std::vector<blossom::Integer>{net.denominator(), 0, 0}) {}

    void run() {
        const slong width = degree_ + 1;
        for (slong i = 0; i <= degree_ + 1; ++i) {
            fmpz* row = raised_.at(i * width);
            if (i <= degree_) {
                _fmpz_vec_scalar_mul_si(row, net_.at(i * width), width, degree_ + 1 - i);
            } else {
                _fmpz_vec_zero(row, width);
            }
            if (i > 0) _fmpz_vec_scalar_addmul_si(row, net_.at((i - 1) * width), width, i);
        }
        fmpz_mul_ui(numbers_.at(1), numbers_.at(0), static_cast<ulong>(degree_ + 1));
        make_canonical(raised_, numbers_.at(1), numbers_.at(2));
    }
    std::string text() const { return text_of(raised_, numbers_.at(1)); }

private:
    slong degree_;
    Integers net_;
    Integers raised_;
    Integers numbers_;
};

}  // namespace flint_peer
