#pragma once

// Blossoms over the ring of polynomials in many variables: an identity here holds for all values of the
// variables.

#include <blossom/core/algebra/sparse_polynomial.hpp>
#include <blossom/core/constructions/constructions.hpp>

#include <cstddef>
#include <initializer_list>
#include <vector>

namespace blossom::testing {

using Symbol = SparsePolynomial;
using Symbols = std::vector<SparsePolynomial>;

/// Hands out new variables.
class Variables {
public:
    Symbol next() { return SparsePolynomial::variable(used_++); }
    Symbols next(std::size_t n);

private:
    std::size_t used_ = 0;
};

/// An argument of a symbolic blossom; a bare symbol is a point.
struct SymbolicArgument : HomogeneousPair<Symbol> {
    SymbolicArgument(Symbol point)
        : HomogeneousPair{std::move(point), 1} {}                     // NOLINT(google-explicit-constructor)
    SymbolicArgument(int point) : SymbolicArgument(Symbol(point)) {}  // NOLINT(google-explicit-constructor)
    SymbolicArgument(Symbol first, Symbol second) : HomogeneousPair{std::move(first), std::move(second)} {}
};

using SymbolicArguments = std::vector<SymbolicArgument>;

/// (1, 0).
inline const SymbolicArgument symbolic_delta{1, 0};

SymbolicArguments points(const Symbols& symbols);
/// n pairs (u_i, v_i) of variables.
SymbolicArguments generic_pairs(Variables& variables, std::size_t n);
SymbolicArguments copies(std::size_t k, const SymbolicArgument& argument);
SymbolicArguments joined(std::initializer_list<SymbolicArguments> lists);

Symbol by_symmetric_functions(const Symbols& coefficients, const SymbolicArguments& arguments);
/// The blossom from values of the homogeneous polynomial sum_k c_k u^k v^(n-k) alone.
Symbol by_polarization(const Symbols& coefficients, const SymbolicArguments& arguments);
/// The blossom from control points over [a/q, b/q].
Symbol by_casteljau(const Symbols& control_points, const Integer& a, const Integer& b, const Integer& q,
                    const SymbolicArguments& arguments);

/// sum_k c_k t^k.
Symbol polynomial_value(const Symbols& coefficients, const Symbol& t);
/// sum_k c_k u^k v^(n-k).
Symbol form_value(const Symbols& coefficients, const Symbol& u, const Symbol& v);
/// sum_k P_k C(n, k) x^k y^(n-k).
Symbol bernstein_value(const Symbols& control_points, const Symbol& x, const Symbol& y);
/// The average over all k-subsets of the product of their symbols, from the definition.
Symbol subset_average(const Symbols& symbols, std::size_t k);
Symbol scaled(const Integer& factor, const Symbol& symbol);

}  // namespace blossom::testing
