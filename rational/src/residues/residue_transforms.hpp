#pragma once

// Sums over products of linear factors by number theoretic transforms. A polynomial of degree below L = 2^k
// is represented by its values at the powers of a root of unity of order L, where products are taken value by
// value. The sum of its coefficients times given numbers is a sum of its values times transformed numbers.

#include <cstddef>
#include <vector>

#include "residue_products.hpp"

namespace blossom::residues {

/// How n factors are split: into 2^levels leaves of nearly equal degrees, each below `leaf`.
struct TransformPlan {
    std::size_t leaf = 0;    ///< a power of 2; 0 if other ways are faster
    std::size_t levels = 0;  ///< the transform has leaf * 2^levels values

    explicit operator bool() const { return leaf != 0; }
    std::size_t size() const { return leaf << levels; }
    std::size_t leaves() const { return std::size_t{1} << levels; }
    /// The first factor of leaf i, for i <= leaves().
    std::size_t begin(std::size_t i, std::size_t factors) const { return i * factors >> levels; }
};

TransformPlan transform_plan(std::size_t factors);

/// Whether the primes of a group have roots of unity of order `size`.
inline bool has_transform(const Moduli& moduli, std::size_t size) {
    return size <= std::size_t{1} << moduli.root_order;
}

/// The powers of roots of unity for transforms of up to `size` values.
class Roots {
public:
    Roots(const Moduli& moduli, std::size_t size);
    const ResidueVector* data() const { return powers_.data(); }

private:
    Buffer powers_;
};

/// Sets `values` for numbers c_k, k < count <= size, such that sum_k c_k p_k = sum_j values[j] P_j / radix
/// for every polynomial p with fewer than `size` coefficients p_k and the values P_j, in the order of
/// `product_values`.
void transform_numbers(const Moduli& moduli, const Roots& roots, const ResidueVector* numbers,
                       std::size_t count, std::size_t size, ResidueVector* values);

/// The values of the product of the leaves at the roots of unity of order plan.size(). `leaves` holds
/// plan.leaf coefficients per leaf, which are overwritten.
void product_values(const Moduli& moduli, const Roots& roots, const TransformPlan& plan,
                    ResidueVector* leaves, ResidueVector* values);

}  // namespace blossom::residues
