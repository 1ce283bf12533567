#pragma once

#include <blossom/rational/integer.hpp>

#include <span>
#include <vector>

namespace blossom {

/// The coefficients of sum_k c_k (X + 1)^k, lowest first.
///
/// Cost: n^2 / 2 additions of vectors of digits, with carries propagated once per fourteen additions if the
/// processor has vector instructions, and about twice the memory of the result. With AVX-512 and more than
/// 512 coefficients: n log n multiply-adds in residues, and n b^2 to combine numbers of b bits.
std::vector<Integer> shifted_by_one(std::span<const Integer> coefficients);

namespace row_recurrences {

/// The same in place over any commutative ring, by Horner's rule in X + 1.
template <class R>
void shift_by_one(std::span<R> row) {
    for (std::size_t level = 1; level < row.size(); ++level) {
        for (std::size_t k = row.size() - 1; k-- + 1 > level;) row[k] += row[k + 1];
    }
}

template <class R>
std::vector<R> shifted_by_one(std::span<const R> coefficients) {
    std::vector<R> result(coefficients.begin(), coefficients.end());
    shift_by_one(std::span(result));
    return result;
}

}  // namespace row_recurrences

}  // namespace blossom
