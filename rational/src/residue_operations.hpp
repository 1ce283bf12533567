#pragma once

// The operations written once over what a level calls a vector and an accumulator of products.

#include "residue_lanes.hpp"

namespace blossom::residues {

/// Level: Vector; Accumulator, zero by default; load, broadcast, store; add_product(accumulator, a, b);
/// negated(moduli, residues); reduced(moduli, accumulator), the sum of up to 4096 products divided by 2^52,
/// below p.
template <class Level>
struct OperationsOf {
    using Accumulator = typename Level::Accumulator;

    static Octet dot(const Moduli& moduli, const Octet* a, const Octet* b, std::size_t count) {
        Accumulator sums[2] = {};
        for (std::size_t k = 0; k + 1 < count; k += 2) {
            Level::add_product(sums[0], Level::load(a[k]), Level::load(b[k]));
            Level::add_product(sums[1], Level::load(a[k + 1]), Level::load(b[k + 1]));
        }
        if (count % 2 == 1) Level::add_product(sums[0], Level::load(a[count - 1]), Level::load(b[count - 1]));
        Level::add(sums[0], sums[1]);
        return Level::reduced(moduli, sums[0]);
    }

    static Octet digit_dot(const Moduli& moduli, const std::uint64_t* digits, const Octet* powers,
                           std::size_t count) {
        Accumulator sum = {};
        for (std::size_t k = 0; k < count; ++k)
            Level::add_product(sum, Level::broadcast(digits[k]), Level::load(powers[k]));
        return Level::reduced(moduli, sum);
    }

    static void residues_of_words(const Moduli& moduli, const std::int64_t* words, std::size_t count,
                                  const Octet* powers, Octet* residues) {
        for (std::size_t i = 0; i < count; ++i) {
            const auto bits = static_cast<std::uint64_t>(words[i]);
            const std::uint64_t size = words[i] < 0 ? 0 - bits : bits;
            Accumulator sum = {};
            Level::add_product(sum, Level::broadcast(size & ((std::uint64_t{1} << 50) - 1)),
                               Level::load(powers[0]));
            Level::add_product(sum, Level::broadcast(size >> 50), Level::load(powers[1]));
            residues[i] = Level::reduced(moduli, sum);
            if (words[i] < 0) residues[i] = Level::negated(moduli, residues[i]);
        }
    }

    static void multiply_linear(const Moduli& moduli, const Octet* factors, std::size_t count,
                                Octet* product) {
        product[0] = factors[0];
        product[1] = factors[1];
        for (std::size_t i = 1; i < count; ++i) {
            const auto constant = Level::load(factors[2 * i]);
            const auto slope = Level::load(factors[2 * i + 1]);
            Accumulator top = {};
            Level::add_product(top, Level::load(product[i]), slope);
            product[i + 1] = Level::reduced(moduli, top);
            for (std::size_t k = i; k > 0; --k) {
                Accumulator sum = {};
                Level::add_product(sum, Level::load(product[k]), constant);
                Level::add_product(sum, Level::load(product[k - 1]), slope);
                product[k] = Level::reduced(moduli, sum);
            }
            Accumulator bottom = {};
            Level::add_product(bottom, Level::load(product[0]), constant);
            product[0] = Level::reduced(moduli, bottom);
        }
    }

    /// Four coefficients at a time share what is loaded of `b`, where all four have the term; the few terms
    /// that not all of them have are added apart.
    static void multiply(const Moduli& moduli, const Octet* a, std::size_t m, const Octet* b, std::size_t n,
                         Octet* product) {
        const auto add_terms = [&](Accumulator& sum, std::size_t k, std::size_t begin, std::size_t end) {
            for (std::size_t j = begin; j < end; ++j)
                Level::add_product(sum, Level::load(a[k - j]), Level::load(b[j]));
        };
        const auto begin_of = [&](std::size_t k) { return k > m ? k - m : 0; };
        const auto end_of = [&](std::size_t k) { return (k < n ? k : n) + 1; };
        std::size_t k = 0;
        for (; k + 3 <= m + n; k += 4) {
            Accumulator sums[4] = {};
            const std::size_t begin = begin_of(k + 3);
            const std::size_t end = end_of(k);
            for (std::size_t j = begin; j < end; ++j) {
                const auto factor = Level::load(b[j]);
                const Octet* terms = a + (k - j);
#pragma GCC unroll 4
                for (int i = 0; i < 4; ++i) Level::add_product(sums[i], Level::load(terms[i]), factor);
            }
#pragma GCC unroll 4
            for (std::size_t i = 0; i < 4; ++i) {
                const std::size_t middle = begin < end ? begin : end_of(k + i);
                add_terms(sums[i], k + i, begin_of(k + i), middle);
                if (begin < end) add_terms(sums[i], k + i, end, end_of(k + i));
                product[k + i] = Level::reduced(moduli, sums[i]);
            }
        }
        for (; k <= m + n; ++k) {
            Accumulator sum = {};
            add_terms(sum, k, begin_of(k), end_of(k));
            product[k] = Level::reduced(moduli, sum);
        }
    }

    static constexpr Operations table{dot, digit_dot, residues_of_words, multiply_linear, multiply};
};

}  // namespace blossom::residues
