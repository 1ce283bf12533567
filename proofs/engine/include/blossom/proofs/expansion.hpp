#pragma once

#include <blossom/proofs/fraction.hpp>
#include <blossom/proofs/ground.hpp>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace blossom::proofs {

/// Expands nodes to rational functions of the symbols: symbol i is variable i.
///
/// Blossoms in one variable are computed by the engine's own construction on symbolic arguments, those over
/// simplices by their definition, `polar_form`.
///
/// The value of a node is dropped after its last use, and sums add their summands one after the other, so
/// that only a few summands of a long sum exist at a time.
///
/// Errors: `division_by_zero` with the offset of the quotient; `limit_exceeded`.
class Expander {
public:
    Expander(const GroundBlock& block, const Limits& limits)
        : block_(block),
          limits_(limits),
          own_field_(std::make_unique<FractionField>(limits)),
          field_(*own_field_) {}
    /// Expands in the field of another expander, with polynomials substituted for some symbols.
    Expander(const Expander& other, std::map<std::size_t, SparsePolynomial> replaced)
        : block_(other.block_),
          limits_(other.limits_),
          field_(other.field_),
          replaced_(std::move(replaced)) {}

    Fraction operator()(NodeId node);
    FractionField& field() { return field_; }

private:
    struct Frame {
        NodeId node;
        std::vector<NodeId> operands;
        std::size_t next = 0;            ///< the next operand that is needed
        std::optional<FractionSum> sum;  ///< of the previous operands, if the node is a sum
    };

    void count_uses();
    Frame opened(NodeId node);
    /// The value of a node, for one of its uses.
    Fraction use(NodeId node);
    void give_up_use(NodeId node);
    Fraction expanded(const Node& node);
    Fraction application(const Application& application);
    FractionField::Common over_common_denominator(const NodeArgument& argument);

    const GroundBlock& block_;
    const Limits& limits_;
    std::unique_ptr<FractionField> own_field_;
    FractionField& field_;
    std::map<std::size_t, SparsePolynomial> replaced_;
    std::vector<std::optional<Fraction>> known_;
    std::vector<std::size_t> uses_;  ///< the remaining uses of each node
    std::vector<bool> was_known_;
};

}  // namespace blossom::proofs
