#pragma once

#include <blossom/proofs/fraction.hpp>
#include <blossom/proofs/ground.hpp>
#include <blossom/proofs/parser.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/limits.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace blossom::proofs {

/// A map of a counterexample, written out, with the application of it that the identity contains.
struct WitnessMap {
    std::string name;
    std::string text;  ///< "1 + t^2", in t, or x1, x2, ... when there are several variables
    std::vector<Direction> directions;
};

/// One value of a map that the counterexample needs.
struct WitnessValue {
    std::string text;     ///< "b[0, 1, delta] = 2"
    std::string command;  ///< "blossom blossom \"t^2\" --degree 3 --at 0,1,delta", or empty
};

/// Where a claim fails: all that it depends on, and both sides there.
struct Counterexample {
    std::vector<std::pair<std::string, long long>> parameters;
    std::vector<WitnessMap> maps;
    std::vector<std::pair<std::string, Rational>> variables;
    Rational left;
    Rational right;
    std::vector<WitnessValue> values;
};

enum class Verdict {
    proved,    ///< for all maps of the degrees, all values of the variables and all parameters
    refuted,   ///< with a counterexample
    undecided  ///< with an error: what the statement says is not defined, or exceeds a limit
};

std::string_view verdict_name(Verdict verdict);

/// What became of one line `claim` or `refute`.
struct Decision {
    std::size_t statement = 0;  ///< its number in the block
    std::size_t offset = 0;
    bool expects_proof = true;
    Verdict verdict = Verdict::proved;
    std::size_t cases = 0;                ///< choices of parameters that were decided
    std::size_t terms = 0;                ///< terms of the normal forms of the left sides, over all cases
    std::vector<std::string> conditions;  ///< "a != b": what must hold for the sides to be defined
    std::optional<Counterexample> counterexample;
    std::optional<Error> error;

    bool as_expected() const { return verdict == (expects_proof ? Verdict::proved : Verdict::refuted); }
};

/// One case of a claim that was proved, while its expansion is at hand.
struct ProvedCase {
    const GroundBlock& block;
    const Relation& relation;
    const Fraction& left;                          ///< the normal form of the left side
    const std::vector<SparsePolynomial>& factors;  ///< those of its denominator, by number
    std::vector<std::size_t> solved;               ///< the symbols that the hypotheses gave, in order
};
using ProofListener = std::function<void(const ProvedCase& proved)>;

/// Decides every claim and refutation of a block, for every choice of the parameters, exactly.
///
/// A claim is proved when both sides, expanded to rational functions of the coefficients and the variables,
/// have the same normal form in each case, after the hypotheses have been solved for coefficients. Otherwise
/// the least case with a difference gives the counterexample. No sampling: see docs/identity-language.md.
///
/// Cost: that of the expansions, within `limits.expansion_terms` and `limits.expansion_work` for each case.
/// Errors are in the decisions, each with its offset in the text. `on_proof` hears of every case of a claim
/// that was proved.
std::vector<Decision> decide(const Block& block, const Limits& limits = {},
                             const ProofListener& on_proof = {});

}  // namespace blossom::proofs
