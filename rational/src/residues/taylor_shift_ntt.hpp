#pragma once

// Taylor shifts by convolution in residues: with the coefficients c_k k! and 1 / m!, the shift by one is a
// product of polynomials (Aho, Steiglitz and Ullman, 1975), computed by number theoretic transforms.

#include <memory>

#include "residue_transforms.hpp"

namespace blossom::residues {

/// 1/x for numbers x that no prime of the group divides; x and 1/x are stored times the radix.
ResidueVector inverse(const Moduli& moduli, const ResidueVector& x);

/// Tables for shifts of at most size / 2 coefficients modulo the primes of one group.
class ShiftTables {
public:
    /// The most recent tables are kept, up to 64 MiB. `size` is a power of 2 for which the group has a
    /// transform.
    static std::shared_ptr<const ShiftTables> of_group(std::size_t group, std::size_t size);

    ShiftTables(const Moduli& moduli, std::size_t size);

    const Moduli& moduli() const { return moduli_; }
    std::size_t size() const { return size_; }
    /// k! and 1 / k!, times the radix, for k < size / 2.
    const ResidueVector* factorials() const { return factorials_.data(); }
    const ResidueVector* inverse_factorials() const { return inverse_factorials_.data(); }

    /// Multiplies the polynomial of `count` <= size / 2 coefficients in `a`, which has room for `size`, by
    /// the sum of all X^m / m!; only the first `count` coefficients of the result are valid.
    void multiply_by_exponential(ResidueVector* a, std::size_t count) const;

private:
    const Moduli& moduli_;
    std::size_t size_;
    std::vector<ResidueVector> factorials_;
    std::vector<ResidueVector> inverse_factorials_;
    std::vector<ResidueVector> exponential_;  ///< the values of the exponential series
    Roots roots_;
};

}  // namespace blossom::residues
