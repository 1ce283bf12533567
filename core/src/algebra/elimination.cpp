#include <blossom/core/algebra/elimination.hpp>
#include <blossom/rational/integer_polynomials.hpp>

#include <algorithm>
#include <vector>

namespace blossom {

namespace {

/// Integer coefficients: the given ones times `denominator`.
struct ClearedRows {
    std::vector<IntegerPolynomial> rows;
    Integer denominator = 1;
    std::size_t bits = 0;
};

ClearedRows cleared_rows(std::span<const Polynomial> polynomials) {
    ClearedRows cleared;
    for (const Polynomial& polynomial : polynomials)
        cleared.denominator = lcm(cleared.denominator, polynomial.coefficients().denominator());
    for (const Polynomial& polynomial : polynomials) {
        const Integer scale = divide_exactly(cleared.denominator, polynomial.coefficients().denominator());
        IntegerPolynomial row = polynomial.coefficients().numerators();
        for (Integer& coefficient : row) coefficient *= scale;
        cleared.bits = std::max(cleared.bits, greatest_bit_length(row));
        cleared.rows.push_back(std::move(row));
    }
    while (!cleared.rows.empty() && cleared.rows.back().empty()) cleared.rows.pop_back();
    return cleared;
}

}  // namespace

Polynomial resultant(std::span<const Polynomial> f, std::span<const Polynomial> g, const Limits& limits) {
    const ClearedRows first = cleared_rows(f);
    const ClearedRows second = cleared_rows(g);
    if (first.rows.empty() || second.rows.empty()) return {};
    const std::size_t m = first.rows.size() - 1;
    const std::size_t n = second.rows.size() - 1;
    require_result_bits(n * (first.bits + 1) + m * (second.bits + 1), limits);
    return Polynomial(RationalVector(resultant(first.rows, second.rows),
                                     pow(first.denominator, n) * pow(second.denominator, m)));
}

}  // namespace blossom
