#pragma once

// Products of polynomials modulo the primes of one group.

#include <cstddef>
#include <memory>
#include <vector>

#include "vectors/residue_lanes.hpp"

namespace blossom::residues {

/// Memory for residue vectors, not cleared.
class Buffer {
public:
    explicit Buffer(std::size_t size) : vectors_(std::make_unique_for_overwrite<ResidueVector[]>(size)) {}
    ResidueVector* data() const { return vectors_.get(); }

private:
    std::unique_ptr<ResidueVector[]> vectors_;  // NOLINT(modernize-avoid-c-arrays): a vector would clear it
};

/// The product of polynomials that are stored one after the other, by a balanced tree.
class ProductTree {
public:
    /// `sizes` are the numbers of coefficients of the factors, none of them 0.
    explicit ProductTree(std::vector<std::size_t> sizes);

    /// The number of coefficients of the product.
    std::size_t product_size() const { return product_size(0, begins_.size() - 1); }
    std::size_t product_size(std::size_t begin, std::size_t end) const {
        return begins_[end] - begins_[begin] - (end - begin - 1);
    }

    /// The coefficients of the product; they and those of the factors are stored times the radix. Valid until
    /// the next call.
    const ResidueVector* product(const Moduli& moduli, const ResidueVector* polynomials);
    /// Writes the product of the polynomials [begin, end) to `to`.
    void product(const Moduli& moduli, const ResidueVector* polynomials, std::size_t begin, std::size_t end,
                 ResidueVector* to) const {
        multiply(moduli, polynomials, begin, end, to, scratch_.data());
    }

private:
    /// Multiplies the polynomials [begin, end) to `to`.
    void multiply(const Moduli& moduli, const ResidueVector* polynomials, std::size_t begin, std::size_t end,
                  ResidueVector* to, ResidueVector* scratch) const;
    static std::vector<std::size_t> begins_of(std::vector<std::size_t> sizes);

    std::vector<std::size_t> begins_;
    Buffer result_;
    Buffer scratch_;
};

/// The coefficients of the product of a[0..m) and b[0..n), divided by the radix; m >= n >= 1. Cost: n^1.58
/// for m = n by Karatsuba's method, above a threshold. `scratch` has `scratch_size(m)` elements.
void multiply(const Moduli& moduli, const ResidueVector* a, std::size_t m, const ResidueVector* b,
              std::size_t n, ResidueVector* product, ResidueVector* scratch);
constexpr std::size_t scratch_size(std::size_t m) { return 6 * m + 256; }

}  // namespace blossom::residues
