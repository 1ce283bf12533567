#pragma once

#include <blossom/proofs/expansion.hpp>
#include <blossom/proofs/ground.hpp>
#include <blossom/rational/limits.hpp>

#include <optional>
#include <span>
#include <vector>

namespace blossom::proofs {

/// Values of nodes if every symbol has a number, computed exactly from the definitions. Only the operands of
/// derivatives are expanded.
class Evaluator {
public:
    Evaluator(const GroundBlock& block, std::span<const Rational> symbols)
        : block_(block), symbols_(symbols), expand_(block, limits_) {}

    /// Errors: `division_by_zero`.
    Rational operator()(NodeId node);

private:
    Rational application(const Application& application);

    const GroundBlock& block_;
    std::span<const Rational> symbols_;
    Limits limits_;
    Expander expand_;
    std::vector<std::optional<Rational>> known_;
};

}  // namespace blossom::proofs
