#pragma once

// Polarization with GMP as an expert would write it: every subset once, in the order of the Gray code, so
// that one argument is added or removed at a time; integers over one denominator, and one reduction at the
// end.

#include <blossom/rational/rational_vector.hpp>

#include <gmp.h>

#include <bit>
#include <string>
#include <vector>

class GrayCodePolarization {
public:
    GrayCodePolarization(const blossom::RationalVector& coefficients,
                         const blossom::RationalVector& arguments) {
        for (const auto& number : coefficients.numerators())
            mpz_init_set_str(next(coefficients_), text(number), 10);
        for (const auto& number : arguments.numerators())
            mpz_init_set_str(next(arguments_), text(number), 10);
        mpz_init_set_str(denominator_, text(coefficients.denominator()), 10);
        mpz_init_set_str(scale_, text(arguments.denominator()), 10);
        mpz_inits(sum_, total_, mass_, power_, term_, nullptr);
        mpq_init(value_);
    }
    GrayCodePolarization(const GrayCodePolarization&) = delete;
    GrayCodePolarization& operator=(const GrayCodePolarization&) = delete;
    ~GrayCodePolarization() {
        for (auto& number : coefficients_) mpz_clear(&number);
        for (auto& number : arguments_) mpz_clear(&number);
        mpz_clears(denominator_, scale_, sum_, total_, mass_, power_, term_, nullptr);
        mpq_clear(value_);
    }

    /// The sum of (-1)^(n - m) sum_k c_k S^k (m q)^(n - k) / (n! q^n) over the sums S / q of m arguments.
    void run() {
        const std::size_t n = arguments_.size();
        mpz_set_ui(sum_, 0);
        mpz_set_ui(total_, 0);
        std::size_t subset = 0;
        for (std::size_t i = 1; i < std::size_t{1} << n; ++i) {
            const auto flipped = static_cast<std::size_t>(std::countr_zero(i));
            subset ^= std::size_t{1} << flipped;
            const bool comes = (subset >> flipped & 1) != 0;
            (comes ? mpz_add : mpz_sub)(total_, total_, &arguments_[flipped]);
            const auto size = static_cast<std::size_t>(std::popcount(subset));
            mpz_mul_ui(mass_, scale_, size);
            mpz_set(term_, &coefficients_[n]);
            mpz_set(power_, mass_);
            for (std::size_t k = n; k-- > 0;) {
                mpz_mul(term_, term_, total_);
                mpz_addmul(term_, &coefficients_[k], power_);
                if (k > 0) mpz_mul(power_, power_, mass_);
            }
            ((n - size) % 2 == 0 ? mpz_add : mpz_sub)(sum_, sum_, term_);
        }
        mpz_set(mpq_numref(value_), sum_);
        mpz_fac_ui(mpq_denref(value_), n);
        mpz_pow_ui(power_, scale_, n);
        mpz_mul(mpq_denref(value_), mpq_denref(value_), power_);
        mpz_mul(mpq_denref(value_), mpq_denref(value_), denominator_);
        mpq_canonicalize(value_);
    }
    std::string text() const {
        char* digits = mpq_get_str(nullptr, 10, value_);
        std::string result = digits;
        void (*release)(void*, std::size_t) = nullptr;
        mp_get_memory_functions(nullptr, nullptr, &release);
        release(digits, result.size() + 1);
        return result;
    }

private:
    static mpz_ptr next(std::vector<__mpz_struct>& numbers) { return &numbers.emplace_back(); }
    const char* text(const blossom::Integer& number) {
        digits_ = to_string(number);
        return digits_.c_str();
    }

    std::vector<__mpz_struct> coefficients_;
    std::vector<__mpz_struct> arguments_;
    std::string digits_;
    mpz_t denominator_;
    mpz_t scale_;
    mpz_t sum_;
    mpz_t total_;
    mpz_t mass_;
    mpz_t power_;
    mpz_t term_;
    mpq_t value_;
};
