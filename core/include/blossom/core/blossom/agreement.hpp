#pragma once

#include <blossom/core/algebra/sparse_polynomial.hpp>
#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/blossom/patch_blossom.hpp>

#include <optional>
#include <string>
#include <vector>

namespace blossom {

/// What one construction gave, or why it was not run.
template <class Value>
struct ConstructionResult {
    Construction construction = Construction::symmetric;
    std::optional<Value> value;
    std::string skipped;  ///< the reason, when there is no value
};

/// The constructions side by side, in the order of `Construction`.
template <class Value>
struct Agreement {
    std::vector<ConstructionResult<Value>> results;

    /// Whether at least two constructions were run and all that were gave the same. What was skipped agrees
    /// with nothing.
    bool agree() const {
        const Value* first = nullptr;
        std::size_t run = 0;
        for (const auto& result : results) {
            if (!result.value) continue;
            if (first && !(*first == *result.value)) return false;
            first = &*result.value;
            ++run;
        }
        return run >= 2;
    }
};

/// The three values at the given arguments. Beyond its limit polarization is skipped, with the reason, and
/// that of a curve regrouped is run behind it. Errors: `wrong_arity`, `limit_exceeded`; those of
/// `require_arguments`.
Agreement<Coordinates> agreement(const PolynomialMap& map, std::span<const Argument> arguments,
                                 const Limits& limits = {});
Agreement<Coordinates> agreement(const PatchMap& map, const PatchArguments& arguments,
                                 const Limits& limits = {});

/// The three constructions run on symbolic points, one expanded polynomial a coordinate. When they agree,
/// they agree for all arguments. The points of a curve are u_1..u_n (variables 0..n-1); those of a patch are
/// numbered argument by argument in each factor: s variables make up (1, x_1, ..., x_s) for a polynomial and
/// (1 - x_1 - ... - x_s, x_1, ..., x_s) for a net.
///
/// Cost: prod (s + 1)^n terms; polarization prod sum_N C(n, N) C(N s + n, n) term operations, and it is
/// skipped beyond its limit. Errors: `limit_exceeded` when there are more terms than `expansion_terms`.
/// Statements: goldman-thm5, fj-cor1, derose-fig6, derose-thm3, fj-eq21.
Agreement<std::vector<SparsePolynomial>> agreement_for_all_arguments(const PolynomialMap& map,
                                                                     const Limits& limits = {});
Agreement<std::vector<SparsePolynomial>> agreement_for_all_arguments(const PatchMap& map,
                                                                     const Limits& limits = {});

/// sum_k c_k e_k / C(n, k), one coordinate as a polynomial in the elementary symmetric functions e_1..e_n
/// (variables 0..n-1). Statement: derose-eq3.
std::vector<SparsePolynomial> elementary_symmetric_form(const PolynomialMap& map, const Limits& limits = {});

}  // namespace blossom
