#pragma once

// The operations as templates over the vectors of a level, several of which make a residue vector, and its
// sums of products.

#include "residue_lanes.hpp"
#include "residue_transform_steps.hpp"

namespace blossom::residues {

/// Level provides: prime_bits, radix_bits; Vector, of which `parts` make a residue vector, with load, store,
/// broadcast; Sum of up to `most_summed` products of residues below 2 p, zero by default, with add_product;
/// Total of up to most_terms products, with collect(total, sum); Constants of one part of the moduli;
/// reduced(constants, sum) and reduced(constants, total), divided by the radix, and product(constants, a, b),
/// all below 2 p; sum and difference of residues; below_prime(constants, a); product_of_difference(constants,
/// a, b, c), which is (a - b) c / radix for c below p; horner_step(constants, value, x, coefficient), which
/// is value x / radix + coefficient for a coefficient from p to 2 p, and whose results are valid for `value`
/// and as factors.
template <class Level>
struct OperationsOf {
    using Vector = typename Level::Vector;
    using Sum = typename Level::Sum;
    using Total = typename Level::Total;
    using Constants = typename Level::Constants;

    static ResidueVector dot(const Moduli& moduli, const ResidueVector* a, const ResidueVector* b,
                             std::size_t count) {
        constexpr std::size_t chains = 4;
        ResidueVector result{};
        for (std::size_t part = 0; part < Level::parts; ++part) {
            const Constants constants(moduli, part);
            Total total = {};
            Sum rest_of_terms = {};  // Fewer than `chains`; only the last round has any.
            for (std::size_t begin = 0; begin < count; begin += chains * Level::most_summed) {
                const std::size_t rest = count - begin;
                const std::size_t end =
                    begin + (rest < chains * Level::most_summed ? rest : chains * Level::most_summed);
                Sum sums[chains] = {};
                std::size_t k = begin;
                for (; k + chains <= end; k += chains) {
#pragma GCC unroll 4
                    for (std::size_t i = 0; i < chains; ++i)
                        Level::add_product(sums[i], Level::load(a[k + i], part), Level::load(b[k + i], part));
                }
                for (; k < end; ++k)
                    Level::add_product(rest_of_terms, Level::load(a[k], part), Level::load(b[k], part));
#pragma GCC unroll 4
                for (const Sum& sum : sums) Level::collect(total, sum);
            }
            Level::collect(total, rest_of_terms);
            Level::store(result, part, Level::reduced(constants, total));
        }
        return result;
    }

    /// Four numbers at once share the loaded powers, as long as all four have digits.
    static void residues_of_digits(const Moduli& moduli, const std::uint64_t* digits,
                                   const std::size_t* begins, std::size_t count, const ResidueVector* powers,
                                   ResidueVector* residues) {
        for (std::size_t part = 0; part < Level::parts; ++part) {
            const Constants constants(moduli, part);
            std::size_t i = 0;
            for (; i + 4 <= count; i += 4)
                several<4>(constants, part, digits, begins + i, powers, residues + i);
            for (; i < count; ++i) several<1>(constants, part, digits, begins + i, powers, residues + i);
        }
    }

    /// Four coefficients at once share the loaded `b`; zeros around `a` make them equally long.
    static void multiply(const Moduli& moduli, const ResidueVector* a, std::size_t m, const ResidueVector* b,
                         std::size_t n, ResidueVector* product) {
        constexpr std::size_t step = Level::coefficients_at_once;
        constexpr std::size_t longest = most_product_terms;
        const std::size_t size = m + n - 1;
        Vector padded[longest + 2 * step - 2];
        for (std::size_t part = 0; part < Level::parts; ++part) {
            const Constants constants(moduli, part);
            const Vector zero = Level::broadcast(0);
            for (std::size_t k = 0; k < step - 1; ++k) padded[k] = padded[m + step - 1 + k] = zero;
            for (std::size_t k = 0; k < m; ++k) padded[k + step - 1] = Level::load(a[k], part);
            for (std::size_t k = 0; k < size; k += step) {
                const std::size_t last = k + step - 1;
                const std::size_t begin = k >= m ? k - m + 1 : 0;
                const std::size_t end = last < n ? last + 1 : n;
                Sum sums[step] = {};
                const Vector* terms = padded + (last - begin);
                for (std::size_t j = begin; j < end; ++j, --terms) {
                    const Vector factor = Level::load(b[j], part);
#pragma GCC unroll 8
                    for (std::size_t i = 0; i < step; ++i) Level::add_product(sums[i], terms[i], factor);
                }
                // All indices are constants, so that the sums stay in registers.
#pragma GCC unroll 8
                for (std::size_t i = 0; i < step; ++i)
                    if (k + i < size) Level::store(product[k + i], part, Level::reduced(constants, sums[i]));
            }
        }
    }

    static void scale(const Moduli& moduli, const ResidueVector* a, const ResidueVector& factor,
                      std::size_t count, ResidueVector* product) {
        each(moduli, count, product, [&](const Constants& constants, std::size_t k, std::size_t part) {
            return Level::product(constants, Level::load(a[k], part), Level::load(factor, part));
        });
    }
    static void add(const Moduli& moduli, const ResidueVector* a, const ResidueVector* b, std::size_t count,
                    ResidueVector* sum) {
        each(moduli, count, sum, [&](const Constants& constants, std::size_t k, std::size_t part) {
            return Level::sum(constants, Level::load(a[k], part), Level::load(b[k], part));
        });
    }
    static void subtract(const Moduli& moduli, const ResidueVector* a, const ResidueVector* b,
                         std::size_t count, ResidueVector* difference) {
        each(moduli, count, difference, [&](const Constants& constants, std::size_t k, std::size_t part) {
            return Level::difference(constants, Level::load(a[k], part), Level::load(b[k], part));
        });
    }

    static void multiply_each(const Moduli& moduli, const ResidueVector* a, const ResidueVector* b,
                              std::size_t count, ResidueVector* product) {
        each(moduli, count, product, [&](const Constants& constants, std::size_t k, std::size_t part) {
            return Level::product(constants, Level::load(a[k], part), Level::load(b[k], part));
        });
    }
    static void reduce(const Moduli& moduli, ResidueVector* a, std::size_t count) {
        each(moduli, count, a, [&](const Constants& constants, std::size_t k, std::size_t part) {
            return Level::below_prime(constants, Level::load(a[k], part));
        });
    }

    static void transform(const Moduli& moduli, const ResidueVector* roots, ResidueVector* a,
                          std::size_t size) {
        for (std::size_t part = 0; part < Level::parts; ++part)
            Transform<Level>(moduli, roots, part).forward(a, size);
    }
    static void inverse_transform(const Moduli& moduli, const ResidueVector* roots, ResidueVector* a,
                                  std::size_t size) {
        for (std::size_t part = 0; part < Level::parts; ++part)
            Transform<Level>(moduli, roots, part).backward(a, size);
    }

    /// Several values at once, because each waits for its last product.
    static void add_values(const Moduli& moduli, const std::uint64_t* const* rows, std::size_t terms,
                           const ResidueVector& base, const ResidueVector* offsets,
                           const ResidueVector& weight, std::size_t count, ResidueVector* sums) {
        constexpr std::size_t step = Level::values_at_once;
        for (std::size_t part = 0; part < Level::parts; ++part) {
            const Constants constants(moduli, part);
            std::size_t i = 0;
            for (; i + step <= count; i += step) {
                add_several_values<step>(constants, part, rows + i, terms, base, offsets + i, weight,
                                         sums + i);
            }
            for (; i < count; ++i)
                add_several_values<1>(constants, part, rows + i, terms, base, offsets + i, weight, sums + i);
        }
    }

    static constexpr Operations table{Level::prime_bits,
                                      Level::radix_bits,
                                      Level::delta_bits,
                                      Level::root_order,
                                      dot,
                                      residues_of_digits,
                                      multiply,
                                      scale,
                                      add,
                                      subtract,
                                      multiply_each,
                                      reduce,
                                      transform,
                                      inverse_transform,
                                      add_values};

private:
    template <class Entry>
    static void each(const Moduli& moduli, std::size_t count, ResidueVector* results, const Entry& entry) {
        for (std::size_t part = 0; part < Level::parts; ++part) {
            const Constants constants(moduli, part);
            for (std::size_t k = 0; k < count; ++k) Level::store(results[k], part, entry(constants, k, part));
        }
    }

    template <std::size_t Count>
    static void add_several_values(const Constants& constants, std::size_t part,
                                   const std::uint64_t* const* rows, std::size_t terms,
                                   const ResidueVector& base, const ResidueVector* offsets,
                                   const ResidueVector& weight, ResidueVector* sums) {
        Vector x[Count];
        Vector values[Count];
#pragma GCC unroll 8
        for (std::size_t i = 0; i < Count; ++i) {
            x[i] = Level::sum(constants, Level::load(base, part), Level::load(offsets[i], part));
            values[i] = Level::broadcast(rows[i][0]);
        }
        for (std::size_t k = 1; k < terms; ++k) {
#pragma GCC unroll 8
            for (std::size_t i = 0; i < Count; ++i)
                values[i] = Level::horner_step(constants, values[i], x[i], Level::broadcast(rows[i][k]));
        }
#pragma GCC unroll 8
        for (std::size_t i = 0; i < Count; ++i) {
            const Vector term = Level::product(constants, values[i], Level::load(weight, part));
            Level::store(sums[i], part, Level::sum(constants, Level::load(sums[i], part), term));
        }
    }

    template <std::size_t Numbers>
    static void several(const Constants& constants, std::size_t part, const std::uint64_t* digits,
                        const std::size_t* begins, const ResidueVector* powers, ResidueVector* residues) {
        Total totals[Numbers] = {};
        std::size_t common = begins[1] - begins[0];
        for (std::size_t i = 1; i < Numbers; ++i) {
            const std::size_t size = begins[i + 1] - begins[i];
            common = size < common ? size : common;
        }
        for (std::size_t begin = 0; begin < common; begin += Level::most_summed) {
            const std::size_t end = common - begin < Level::most_summed ? common : begin + Level::most_summed;
            Sum sums[Numbers] = {};
            for (std::size_t k = begin; k < end; ++k) {
                const Vector power = Level::load(powers[k], part);
#pragma GCC unroll 4
                for (std::size_t i = 0; i < Numbers; ++i)
                    Level::add_product(sums[i], Level::broadcast(digits[begins[i] + k]), power);
            }
#pragma GCC unroll 4
            for (std::size_t i = 0; i < Numbers; ++i) Level::collect(totals[i], sums[i]);
        }
#pragma GCC unroll 4
        for (std::size_t i = 0; i < Numbers; ++i) {
            const std::size_t size = begins[i + 1] - begins[i];
            for (std::size_t begin = common; begin < size; begin += Level::most_summed) {
                const std::size_t end = size - begin < Level::most_summed ? size : begin + Level::most_summed;
                Sum sum = {};
                for (std::size_t k = begin; k < end; ++k) {
                    Level::add_product(sum, Level::broadcast(digits[begins[i] + k]),
                                       Level::load(powers[k], part));
                }
                Level::collect(totals[i], sum);
            }
            Level::store(residues[i], part, Level::reduced(constants, totals[i]));
        }
    }
};

}  // namespace blossom::residues
