#pragma once

// Blossoms over the ring of polynomials in many variables: what is shown here is shown for all values of the
// variables.

#include <blossom/core/algebra/sparse_polynomial.hpp>
#include <blossom/core/constructions/constructions.hpp>

#include <cstddef>
#include <initializer_list>
#include <vector>

namespace blossom::testing {

using Symbol = SparsePolynomial;
using Symbols = std::vector<SparsePolynomial>;

/// Hands out variables, each once.
class Variables {
public:
    Symbol next() { return SparsePolynomial::variable(used_++); }
    Symbols next(std::size_t n);
    std::size_t used() const { return used_; }

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
SymbolicArguments without(SymbolicArguments arguments, std::size_t index);
SymbolicArguments replaced(SymbolicArguments arguments, std::size_t index, const SymbolicArgument& argument);

/// The blossom of a scalar map whose n + 1 coefficients or control points are any elements of the ring.
class SymbolicBlossom {
public:
    enum class Source { coefficients, control_points };

    /// By elementary symmetric functions.
    static SymbolicBlossom of_coefficients(Symbols coefficients) {
        return {Source::coefficients, std::move(coefficients)};
    }
    /// By de Casteljau's algorithm over [0, 1].
    static SymbolicBlossom of_control_points(Symbols control_points) {
        return {Source::control_points, std::move(control_points)};
    }

    std::size_t degree() const { return numbers_.size() - 1; }
    Symbol operator()(const SymbolicArguments& arguments) const;

private:
    SymbolicBlossom(Source source, Symbols numbers) : source_(source), numbers_(std::move(numbers)) {}

    Source source_;
    Symbols numbers_;
};

/// P(t) = sum_k c_k t^k with variables c_0..c_n and its blossom.
struct GenericPolynomial {
    explicit GenericPolynomial(std::size_t n)
        : c(variables.next(n + 1)), p(SymbolicBlossom::of_coefficients(c)) {}
    Symbol operator()(const Symbol& t) const;

    Variables variables;
    Symbols c;
    SymbolicBlossom p;
};

/// Q(u) = sum_k v_k C(n, k) u^k (1 - u)^(n-k) with variables v_0..v_n and its blossom.
struct GenericBezier {
    explicit GenericBezier(std::size_t n)
        : v(variables.next(n + 1)), q(SymbolicBlossom::of_control_points(v)) {}
    Symbol operator()(const Symbol& u) const;

    Variables variables;
    Symbols v;
    SymbolicBlossom q;
};

/// The rank of the conditions that `identities` = 0, for all values of the variables from number `unknowns`
/// on, put on the variables before it. Every term holds exactly one unknown.
std::size_t rank_of_conditions(const Symbols& identities, std::size_t unknowns);

Symbol by_symmetric_functions(const Symbols& coefficients, const SymbolicArguments& arguments);
/// From values of the homogeneous polynomial sum_k c_k u^k v^(n-k) alone.
Symbol by_polarization(const Symbols& coefficients, const SymbolicArguments& arguments);
/// From control points over [a/q, b/q].
Symbol by_casteljau(const Symbols& control_points, const Integer& a, const Integer& b, const Integer& q,
                    const SymbolicArguments& arguments);

/// sum_k c_k t^k.
Symbol polynomial_value(const Symbols& coefficients, const Symbol& t);
/// sum_k c_k u^k v^(n-k).
Symbol form_value(const Symbols& coefficients, const Symbol& u, const Symbol& v);
/// sum_k P_k C(n, k) x^k y^(n-k).
Symbol bernstein_value(const Symbols& control_points, const Symbol& x, const Symbol& y);
/// The coefficients of the derivative of order k in t.
Symbols derivative_coefficients(Symbols coefficients, std::size_t order);
/// The average over all k-subsets of the product of their symbols, from the definition.
Symbol subset_average(const Symbols& symbols, std::size_t k);
Symbol product(const Symbols& symbols);
Symbol scaled(const Integer& factor, const Symbol& symbol);

}  // namespace blossom::testing
