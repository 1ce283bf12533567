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
/// Blossoms in one variable are the engine's own construction, run on symbolic arguments; over simplices they
/// are the definition, `polar_form`.
///
/// What a node comes to is given up when all that is made of it is there, and sums take their summands one
/// after the other: of a sum over many values only a few are there at a time.
///
/// Errors: `division_by_zero` with the offset of the quotient; `limit_exceeded`.
class Expander {
public:
    Expander(const GroundBlock& block, const Limits& limits)
        : block_(block),
          limits_(limits),
          own_field_(std::make_unique<FractionField>(limits)),
          field_(*own_field_) {}
    /// Expands in the field of another one, with polynomials in the place of some symbols.
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
        std::size_t next = 0;            ///< the operand that is needed next
        std::optional<FractionSum> sum;  ///< of those before, in a sum
    };

    void count_uses();
    Frame opened(NodeId node);
    /// What a node has come to, for one of its uses.
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
    std::vector<std::size_t> uses_;  ///< that are still to come
    std::vector<bool> was_known_;
};

}  // namespace blossom::proofs
