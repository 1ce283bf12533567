#pragma once

#include <blossom/proofs/certificate.hpp>
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

/// A map of a counterexample as text.
struct WitnessMap {
    std::string name;
    std::string text;  ///< "1 + t^2", in t, or in x1, x2, ... for several variables
    std::vector<Direction> directions;
};

/// One value of a map that the counterexample needs.
struct WitnessValue {
    std::string text;     ///< "b[0, 1, delta] = 2"
    std::string command;  ///< "blossom blossom \"t^2\" --degree 3 --at 0,1,delta", or empty
};

/// Where a claim fails: every map and variable of the claim, of its hypotheses and of its assumptions, and
/// the values of both sides.
struct Counterexample {
    Parameters parameters;
    std::vector<WitnessMap> maps;
    std::vector<std::pair<std::string, Rational>> variables;
    std::vector<std::string>
        roots;         ///< "w^2 - 1/2 == 0": variables without a rational value, by their relations
    std::string left;  ///< a number, or an expression in variables without a value
    std::string right;
    std::vector<WitnessValue> values;
};

enum class Verdict {
    proved,   ///< for all maps of the degrees and all values of the variables, on both roads
    refuted,  ///< with a counterexample
    /// with an error: the statement is undefined, its kinds do not match, or a limit is exceeded
    undecided,
    disagreement  ///< with an error: the two roads contradict each other, so that one of them is wrong
};

std::string_view verdict_name(Verdict verdict);

/// Something that must not vanish, otherwise the claim is undefined or not proved.
struct Condition {
    std::string text;      ///< "a != b", "w(t) != 0"
    bool assumed = false;  ///< by a line `assume`

    friend bool operator==(const Condition&, const Condition&) = default;
};

/// The result for one case of a line: one choice of the parameters.
struct CaseDecision {
    Parameters parameters;
    Verdict verdict = Verdict::proved;
    std::size_t terms = 0;  ///< of the normal form of the left side
    std::vector<Condition> conditions;
    /// "a == 0": the case that a pivot excluded and that could not be decided
    std::vector<std::string> open;
    std::vector<std::string> holds_if;  ///< of a refuted case: "a != 0", under which it is proved
    std::optional<Counterexample> counterexample;
    std::optional<Error> error;
};

/// What a line states about its claim.
enum class Expectation {
    proof,           ///< claim: proved in every case
    refutation,      ///< refute: refuted in every case
    some_refutation  ///< refute some: refuted in at least one case
};

/// The result for one line `claim` or `refute`.
struct Decision {
    std::size_t statement = 0;  ///< the number of the line in the block
    std::size_t offset = 0;
    Expectation expectation = Expectation::proof;
    std::vector<CaseDecision> cases;

    /// The worst verdict of all cases: a disagreement, then refuted, then undecided. A line without cases is
    /// undecided.
    Verdict verdict() const;
    bool as_expected() const;
    std::size_t terms() const;
    /// The conditions of all cases, without repetition.
    std::vector<Condition> conditions() const;
    /// The first counterexample of a case, or nullptr.
    const Counterexample* counterexample() const;
    const Error* error() const;
};

/// A proved case of a claim, valid while its expansion exists.
struct ProvedCase {
    const GroundBlock& block;
    const Relation& relation;
    const Fraction& left;                          ///< the normal form of the left side
    const std::vector<SparsePolynomial>& factors;  ///< the factors of its denominator, by number
    const second::Certificate& certificate;        ///< accepted by the checker
};
using ProofListener = std::function<void(const ProvedCase& proved)>;

/// The receiver of proofs.
struct DecisionOptions {
    ProofListener on_proof;
};

/// Decides every claim and refutation of a block, for every choice of the parameters, exactly and on two
/// roads.
///
/// First road: both sides are expanded to rational functions of the coefficients and the variables, and the
/// hypotheses are solved, with a branch for every pivot that may vanish. A case is proved if the difference
/// of the sides is zero in every branch; otherwise a counterexample is found in a branch where it is not.
/// Second road: the text of the block is read again by code that shares nothing with the first road, both
/// sides are evaluated at points that satisfy the hypotheses, and the certificate of the case is checked from
/// the text; a counterexample is evaluated there too. A verdict is given if both roads agree. See
/// docs/identity-language.md.
///
/// Cost: that of the expansions, within `limits.expansion_terms` and `limits.expansion_work` per case. Errors
/// are part of the decisions, each with its offset in the text; an error in one case does not affect the
/// others.
std::vector<Decision> decide(const Block& block, const Limits& limits = {},
                             const DecisionOptions& options = {});

}  // namespace blossom::proofs
