#include "residue_products.hpp"

#include <algorithm>
#include <utility>

#include "residue_system.hpp"

namespace blossom::residues {

namespace {

/// The most terms for which products are computed term by term (by measurement).
constexpr std::size_t basecase = 64;
static_assert(basecase <= most_product_terms);

/// a[0..m) b[0..n) for m > n, in pieces of n terms of a.
void multiply_in_pieces(const Moduli& moduli, const ResidueVector* a, std::size_t m, const ResidueVector* b,
                        std::size_t n, ResidueVector* product, ResidueVector* scratch) {
    std::fill(product, product + m + n - 1, ResidueVector{});
    for (std::size_t begin = 0; begin < m; begin += n) {
        const std::size_t size = std::min(n, m - begin);
        ResidueVector* piece = scratch;
        multiply(moduli, b, n, a + begin, size, piece, scratch + 2 * n);
        operations().add(moduli, product + begin, piece, size + n - 1, product + begin);
    }
}

}  // namespace

void multiply(const Moduli& moduli, const ResidueVector* a, std::size_t m, const ResidueVector* b,
              std::size_t n, ResidueVector* product, ResidueVector* scratch) {
    const Operations& run = operations();
    if (m <= basecase) return run.multiply(moduli, a, m, b, n, product);
    const std::size_t half = (m + 1) / 2;
    if (n <= half) return multiply_in_pieces(moduli, a, m, b, n, product, scratch);
    multiply(moduli, a, half, b, half, product, scratch);
    product[2 * half - 1] = ResidueVector{};
    multiply(moduli, a + half, m - half, b + half, n - half, product + 2 * half, scratch);
    ResidueVector* const sum_a = scratch;
    ResidueVector* const sum_b = sum_a + half;
    ResidueVector* const middle = sum_b + half;
    const auto add_halves = [&](const ResidueVector* from, std::size_t size, ResidueVector* sum) {
        run.add(moduli, from, from + half, size - half, sum);
        std::copy(from + (size - half), from + half, sum + (size - half));
    };
    add_halves(a, m, sum_a);
    add_halves(b, n, sum_b);
    multiply(moduli, sum_a, half, sum_b, half, middle, middle + 2 * half);
    run.subtract(moduli, middle, product, 2 * half - 1, middle);
    run.subtract(moduli, middle, product + 2 * half, m + n - 2 * half - 1, middle);
    run.add(moduli, product + half, middle, std::min(2 * half - 1, m + n - 1 - half), product + half);
}

ProductTree::ProductTree(std::vector<std::size_t> sizes)
    : begins_(begins_of(std::move(sizes))),
      result_(product_size()),
      scratch_(3 * begins_.back() + scratch_size(begins_.back())) {}

std::vector<std::size_t> ProductTree::begins_of(std::vector<std::size_t> sizes) {
    std::size_t size = 0;
    for (std::size_t& entry : sizes) size += std::exchange(entry, size);
    sizes.push_back(size);
    return sizes;
}

const ResidueVector* ProductTree::product(const Moduli& moduli, const ResidueVector* polynomials) {
    multiply(moduli, polynomials, 0, begins_.size() - 1, result_.data(), scratch_.data());
    return result_.data();
}

void ProductTree::multiply(const Moduli& moduli, const ResidueVector* polynomials, std::size_t begin,
                           std::size_t end, ResidueVector* to, ResidueVector* scratch) const {
    if (end - begin == 1) {
        std::copy(polynomials + begins_[begin], polynomials + begins_[end], to);
        return;
    }
    const std::size_t middle = begin + (end - begin + 1) / 2;
    const std::size_t m = product_size(begin, middle);
    const std::size_t n = product_size(middle, end);
    const ResidueVector* left = polynomials + begins_[begin];
    const ResidueVector* right = polynomials + begins_[middle];
    ResidueVector* rest = scratch;
    if (middle - begin > 1) {
        multiply(moduli, polynomials, begin, middle, rest, rest + m);
        left = rest;
        rest += m;
    }
    if (end - middle > 1) {
        multiply(moduli, polynomials, middle, end, rest, rest + n);
        right = rest;
        rest += n;
    }
    if (m < n) {
        residues::multiply(moduli, right, n, left, m, to, rest);
    } else {
        residues::multiply(moduli, left, m, right, n, to, rest);
    }
}

}  // namespace blossom::residues
