#pragma once

#include <blossom/proofs/evaluation.hpp>
#include <blossom/proofs/expansion.hpp>
#include <blossom/proofs/ground.hpp>
#include <blossom/worked/formula.hpp>

#include <span>
#include <string>
#include <vector>

namespace blossom::worked {

/// Whether every map of a ground statement has one argument, a number, so that its values can be written, no
/// number has the name of a coefficient, and only maps are differentiated.
bool is_written(const proofs::GroundBlock& block);

/// The nodes of a ground statement as formulas, in its variables or with numbers for them.
class GroundFormulas {
public:
    explicit GroundFormulas(const proofs::GroundBlock& block, std::span<const Rational> values = {})
        : block_(block), values_(values), evaluate_(block, values) {}

    Formula operator()(proofs::NodeId node);
    /// A symbol, "t_1" with its index.
    Formula symbol_formula(std::size_t i) const;
    /// A rational function of the symbols.
    Formula expanded(const proofs::Fraction& fraction, const std::vector<SparsePolynomial>& factors) const;

private:
    Formula product_formula(const proofs::Node& node);
    Formula application(const proofs::Application& application);
    Formula argument(const proofs::NodeArgument& argument);
    bool has_values() const { return !values_.empty(); }

    const proofs::GroundBlock& block_;
    std::span<const Rational> values_;
    proofs::Evaluator evaluate_;
};

}  // namespace blossom::worked
