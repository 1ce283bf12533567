#pragma once

#include <blossom/proofs/fraction.hpp>
#include <blossom/proofs/ground.hpp>

#include <optional>
#include <vector>

namespace blossom::proofs {

/// Expands nodes to rational functions of the symbols: symbol i is variable i.
///
/// Blossoms are the engine's own construction, run on symbolic arguments. Each one is also
/// computed from an independent definition, `polar_form` on coefficients, and the two must be the same
/// polynomial, so that an error of the engine shows as an error here and never as a proof.
///
/// Errors: `division_by_zero` with the offset of the quotient; `limit_exceeded`; `internal` when engine and
/// definition disagree.
class Expander {
public:
    Expander(const GroundBlock& block, const Limits& limits)
        : block_(block), limits_(limits), field_(limits) {}

    Fraction operator()(NodeId node);
    FractionField& field() { return field_; }

private:
    Fraction expanded(const Node& node);
    Fraction application(const Application& application);
    FractionField::Common over_common_denominator(const NodeArgument& argument);

    const GroundBlock& block_;
    const Limits& limits_;
    FractionField field_;
    std::vector<std::optional<Fraction>> known_;
};

}  // namespace blossom::proofs
