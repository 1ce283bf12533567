#pragma once

#include <blossom/proofs/ground.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "elimination.hpp"

namespace blossom::proofs {

/// The polynomial with a number substituted for a variable.
SparsePolynomial specialised(const SparsePolynomial& polynomial, std::size_t variable, const Rational& value);

/// Chooses values for the symbols of one branch.
class WitnessSearch {
public:
    WitnessSearch(const GroundBlock& block, std::span<const Substitution> steps,
                  std::vector<SparsePolynomial> nonzero);

    /// Chooses the values. With a higher `attempt`, the values of variables on which roots depend begin
    /// further on in the list, so that roots may become rational. Returns false if some root has no rational
    /// value.
    bool choose(std::size_t attempt);

    /// Whether some roots satisfy all conditions: no power of the product of all conditions is zero modulo
    /// the relations. Also true if this is undecided because a leading coefficient is not a number.
    bool is_witness() const;

    const std::vector<Rational>& values() const { return values_; }
    const std::vector<std::size_t>& algebraic() const { return algebraic_; }
    /// Whether the symbol has no rational value, but is a root of its relation.
    bool is_root(std::size_t symbol) const;
    const std::vector<SparsePolynomial>& relations() const { return relations_; }

private:
    void put(std::size_t symbol, const Rational& value);

    bool is_possible(std::size_t symbol, const Rational& value) const;

    /// Takes the first possible value of the list from number `first` on. There is one, because each
    /// polynomial excludes at most as many values as its degree.
    void give_value(std::size_t symbol, std::size_t first);

    /// Computes the value of the symbol of a step if all other symbols of its relation have one.
    bool solve(std::size_t number);

    /// The polynomial modulo the relations of the symbols that are roots; nullopt if that is undecided.
    std::optional<SparsePolynomial> remainder(SparsePolynomial polynomial) const;

    bool leave(std::size_t symbol);

    const GroundBlock& block_;
    std::span<const Substitution> steps_;
    std::vector<SparsePolynomial> nonzero_;
    std::vector<SparsePolynomial> relations_;
    std::vector<Rational> values_;
    std::vector<std::size_t> algebraic_;
};

}  // namespace blossom::proofs
