#pragma once

// The three constructions of a blossom in symbols u_1, ..., u_n on FLINT's sparse polynomials, each by its
// own formula, and a comparison.

#include <flint/fmpz_mpoly.h>

#include <utility>

#include "flint_numbers.hpp"

namespace flint_peer {

class SymbolicBlossoms {
public:
    /// The blossoms of sum_k coefficients[k] t^k. Polarization takes values from powers of sums, or by
    /// Horner's rule.
    SymbolicBlossoms(std::span<const blossom::Integer> coefficients, bool by_powers)
        : coefficients_(coefficients), n_(coefficients_.size() - 1), by_powers_(by_powers) {
        fmpz_mpoly_ctx_init(context_, n_, ORD_LEX);
        fmpz_init(lcm_);
        fmpz_init(factorial_);
        fmpz_one(lcm_);
        for (slong k = 0; k <= n_; ++k) {
            fmpz_bin_uiui(weights_.at(k), static_cast<ulong>(n_), static_cast<ulong>(k));
            fmpz_lcm(lcm_, lcm_, weights_.at(k));
        }
        for (slong k = 0; k <= n_; ++k) {
            fmpz_divexact(weights_.at(k), lcm_, weights_.at(k));
            fmpz_mul(weights_.at(k), weights_.at(k), coefficients_.at(k));
        }
        fmpz_fac_ui(factorial_, static_cast<ulong>(n_));
    }
    SymbolicBlossoms(const SymbolicBlossoms&) = delete;
    SymbolicBlossoms& operator=(const SymbolicBlossoms&) = delete;
    ~SymbolicBlossoms() {
        fmpz_clear(lcm_);
        fmpz_clear(factorial_);
        fmpz_mpoly_ctx_clear(context_);
    }

    void run() {
        Symbolic symmetric = by_symmetric_functions();
        Symbolic casteljau = by_casteljau();
        Symbolic polarized = by_polarization(0, constant(0), 0);
        const bool same = fmpz_mpoly_equal(symmetric.value, casteljau.value, context_) != 0;
        terms_ = fmpz_mpoly_length(symmetric.value, context_);
        fmpz_mpoly_scalar_mul_fmpz(polarized.value, polarized.value, lcm_, context_);
        fmpz_mpoly_scalar_mul_fmpz(symmetric.value, symmetric.value, factorial_, context_);
        agree_ = same && fmpz_mpoly_equal(symmetric.value, polarized.value, context_) != 0;
    }
    /// Whether they agree, and their number of terms.
    std::string text() const { return std::to_string(agree_) + " " + std::to_string(terms_); }

private:
    struct Symbolic {
        explicit Symbolic(const fmpz_mpoly_ctx_struct* in) : context(in) { fmpz_mpoly_init(value, context); }
        Symbolic(const Symbolic& other) : Symbolic(other.context) {
            fmpz_mpoly_set(value, other.value, context);
        }
        Symbolic(Symbolic&& other) noexcept : Symbolic(other.context) {
            fmpz_mpoly_swap(value, other.value, context);
        }
        Symbolic& operator=(Symbolic other) noexcept {
            fmpz_mpoly_swap(value, other.value, context);
            return *this;
        }
        ~Symbolic() { fmpz_mpoly_clear(value, context); }
        fmpz_mpoly_t value;
        const fmpz_mpoly_ctx_struct* context;
    };

    Symbolic constant(slong number) const {
        Symbolic result(context_);
        fmpz_mpoly_set_si(result.value, number, context_);
        return result;
    }
    Symbolic variable(slong i) const {
        Symbolic result(context_);
        fmpz_mpoly_gen(result.value, i, context_);
        return result;
    }

    /// lcm of the binomials times sum_k c_k e_k / C(n, k).
    Symbolic by_symmetric_functions() const {
        std::vector<Symbolic> functions{constant(1)};
        Symbolic product(context_);
        for (slong i = 0; i < n_; ++i) {
            const Symbolic u = variable(i);
            functions.push_back(constant(0));
            for (std::size_t k = functions.size() - 1; k > 0; --k) {
                fmpz_mpoly_mul(product.value, functions[k - 1].value, u.value, context_);
                fmpz_mpoly_add(functions[k].value, functions[k].value, product.value, context_);
            }
        }
        Symbolic sum(context_);
        for (slong k = 0; k <= n_; ++k) {
            Symbolic& function = functions[static_cast<std::size_t>(k)];
            fmpz_mpoly_scalar_mul_fmpz(function.value, function.value, weights_.at(k), context_);
            fmpz_mpoly_add(sum.value, sum.value, function.value, context_);
        }
        return sum;
    }

    /// The triangle over the control points for [0, 1], p(0^(n-k), 1^k), times the lcm of the binomials.
    Symbolic by_casteljau() const {
        std::vector<Symbolic> row;
        for (slong k = 0; k <= n_; ++k) {
            fmpz_t point;
            fmpz_t binomial;
            fmpz_init(point);
            fmpz_init(binomial);
            for (slong j = 0; j <= k; ++j) {
                fmpz_bin_uiui(binomial, static_cast<ulong>(k), static_cast<ulong>(j));
                fmpz_addmul(point, binomial, weights_.at(j));
            }
            row.emplace_back(context_);
            fmpz_mpoly_set_fmpz(row.back().value, point, context_);
            fmpz_clear(point);
            fmpz_clear(binomial);
        }
        Symbolic difference(context_);
        for (slong i = 0; i < n_; ++i) {
            const Symbolic u = variable(i);
            for (std::size_t j = 0; j + 1 < row.size(); ++j) {
                fmpz_mpoly_sub(difference.value, row[j + 1].value, row[j].value, context_);
                fmpz_mpoly_mul(difference.value, difference.value, u.value, context_);
                fmpz_mpoly_add(row[j].value, row[j].value, difference.value, context_);
            }
            row.pop_back();
        }
        return std::move(row.front());
    }

    /// n! times the blossom: sum_S (-1)^(n-|S|) sum_k c_k |S|^(n-k) (sum of S)^k over the subsets S of
    /// u_first, ..., u_n joined with those in `sum`, by halves.
    Symbolic by_polarization(slong first, const Symbolic& sum, slong size) const {
        if (first == n_) return form(sum, size);
        Symbolic without = by_polarization(first + 1, sum, size);
        Symbolic longer = sum;
        fmpz_mpoly_add(longer.value, sum.value, variable(first).value, context_);
        const Symbolic with = by_polarization(first + 1, longer, size + 1);
        fmpz_mpoly_sub(without.value, with.value, without.value, context_);
        return without;
    }

    /// sum_k c_k size^(n-k) sum^k.
    Symbolic form(const Symbolic& sum, slong size) const {
        return by_powers_ ? form_by_powers(sum, size) : form_by_horner(sum, size);
    }
    Symbolic form_by_powers(const Symbolic& sum, slong size) const {
        Symbolic total = constant(0);
        Symbolic power = constant(1);
        Symbolic scaled = constant(1);
        fmpz_t factor;
        fmpz_init(factor);
        for (slong k = 0; k <= n_; ++k) {
            fmpz_set_si(factor, size);
            fmpz_pow_ui(factor, factor, static_cast<ulong>(n_ - k));
            fmpz_mul(factor, factor, coefficients_.at(k));
            fmpz_mpoly_scalar_mul_fmpz(scaled.value, power.value, factor, context_);
            fmpz_mpoly_add(total.value, total.value, scaled.value, context_);
            if (k < n_) fmpz_mpoly_mul(power.value, power.value, sum.value, context_);
        }
        fmpz_clear(factor);
        return total;
    }
    Symbolic form_by_horner(const Symbolic& sum, slong size) const {
        Symbolic total(context_);
        fmpz_mpoly_set_fmpz(total.value, coefficients_.at(n_), context_);
        fmpz_t factor;
        fmpz_t power;
        fmpz_init(factor);
        fmpz_init(power);
        fmpz_one(power);
        for (slong k = n_; k-- > 0;) {
            fmpz_mul_si(power, power, size);
            fmpz_mpoly_mul(total.value, total.value, sum.value, context_);
            fmpz_mul(factor, coefficients_.at(k), power);
            fmpz_mpoly_add_fmpz(total.value, total.value, factor, context_);
        }
        fmpz_clear(factor);
        fmpz_clear(power);
        return total;
    }

    Integers coefficients_;
    slong n_;
    bool by_powers_;
    Integers weights_{n_ + 1};
    fmpz_t lcm_;
    fmpz_t factorial_;
    fmpz_mpoly_ctx_t context_;
    bool agree_ = false;
    slong terms_ = 0;
};

}  // namespace flint_peer
