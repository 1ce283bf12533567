#pragma once

#include <blossom/core/algebra/sparse_polynomial.hpp>
#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/blossom/patch_blossom.hpp>

#include <optional>
#include <string>
#include <vector>

namespace blossom {

/// The result of one construction, or the reason why it was not run.
template <class Value>
struct ConstructionResult {
    Construction construction = Construction::symmetric;
    std::optional<Value> value;
    std::string skipped;  ///< the reason if there is no value
};

/// The results of the constructions, in the order of `Construction`.
template <class Value>
struct Agreement {
    std::vector<ConstructionResult<Value>> results;

    /// Whether at least two constructions were run and all results are equal. A construction that was skipped
    /// agrees with nothing.
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

/// The three values at the given arguments. Polarization beyond its limit is skipped, with the reason, and
/// regrouped polarization is run instead for a curve. Errors: `wrong_arity`, `limit_exceeded`; those of
/// `require_arguments`.
Agreement<Coordinates> agreement(const PolynomialMap& map, std::span<const Argument> arguments,
                                 const Limits& limits = {});
Agreement<Coordinates> agreement(const PatchMap& map, const PatchArguments& arguments,
                                 const Limits& limits = {});

/// The results of the three constructions at symbolic points, one expanded polynomial per coordinate. If they
/// agree, the constructions agree for all arguments. The points of a curve are u_1..u_n (variables 0..n-1).
/// Those of a patch are numbered argument by argument in each factor; s variables form (1, x_1, ..., x_s) for
/// a polynomial and (1 - x_1 - ... - x_s, x_1, ..., x_s) for a net.
///
/// Cost: prod (s + 1)^n terms; polarization takes prod sum_N C(n, N) C(N s + n, n) term operations, and is
/// skipped beyond its limit. Errors: `limit_exceeded` if there are more terms than `expansion_terms`.
/// Statements: goldman-thm5, fj-cor1, derose-fig6, derose-thm3, fj-eq21.
Agreement<std::vector<SparsePolynomial>> agreement_for_all_arguments(const PolynomialMap& map,
                                                                     const Limits& limits = {});
Agreement<std::vector<SparsePolynomial>> agreement_for_all_arguments(const PatchMap& map,
                                                                     const Limits& limits = {});

/// sum_k c_k e_k / C(n, k), per coordinate a polynomial in the elementary symmetric functions e_1..e_n
/// (variables 0..n-1). Statement: derose-eq3.
std::vector<SparsePolynomial> elementary_symmetric_form(const PolynomialMap& map, const Limits& limits = {});

}  // namespace blossom
