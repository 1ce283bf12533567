#pragma once

#include "certificates/symbolic/plain_polynomial.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace blossom::proofs::second {

/// The knowledge in a branch of a case: equations, factors that do not vanish, and the difference of the two
/// sides. All are reduced by the steps so far, and hold up to factors that do not vanish.
class BranchState {
public:
    BranchState(const std::vector<PlainPolynomial>& equations, const std::vector<PlainPolynomial>& nonzero,
                PlainPolynomial difference, Budget& budget);

    /// Replaces a symbol by means of a relation. Returns what is wrong with this, or "".
    std::string take_step(std::size_t symbol, std::size_t degree, const PlainPolynomial& relation);

    void require_nonzero(const PlainPolynomial& pivot);
    void require_zero(const PlainPolynomial& pivot);

    /// Whether the difference of the sides is 0, or has a power that is 0 after multiplication by factors
    /// that do not vanish.
    bool agrees();
    /// Whether some equation cannot hold, or something that must not vanish is 0.
    bool is_impossible() const { return impossible_; }
    /// The terms of all polynomials in the state, which are the cost of a copy.
    std::size_t size() const;

private:
    /// `cofactor` * symbol + `rest` == 0
    struct LinearStep {
        std::size_t symbol;
        PlainPolynomial cofactor;
        PlainPolynomial rest;
    };
    /// A relation whose leading coefficient in the powers of the symbol does not vanish.
    struct PowerStep {
        std::size_t symbol;
        PlainPolynomial relation;
    };

    PlainPolynomial reduced(PlainPolynomial a);
    PlainPolynomial replaced(const PlainPolynomial& a, const LinearStep& step);
    PlainPolynomial with_low_powers(const PlainPolynomial& a, const PowerStep& step);
    PlainPolynomial with_low_powers(PlainPolynomial a);
    /// The primitive polynomial after division by factors that do not vanish.
    PlainPolynomial stripped(PlainPolynomial a);
    bool is_zero_where(const PlainPolynomial& equation, const PlainPolynomial& relation, std::size_t powers);
    bool is_known_nonzero(const PlainPolynomial& a);

    /// Reduces everything by one more step.
    void reduce_all(const LinearStep* step);
    void reduce_power_steps(const LinearStep& step);
    void add_nonzero(PlainPolynomial factor);
    void add_nonzero_part(PlainPolynomial factor);
    void add_equation(const PlainPolynomial& equation);

    Budget* budget_;
    std::vector<PlainPolynomial> equations_;  ///< none of them constant
    std::vector<PlainPolynomial> nonzero_;    ///< none of them constant
    PlainPolynomial difference_;
    std::vector<std::size_t> solved_;
    std::vector<LinearStep> linear_steps_;
    std::vector<PowerStep> power_steps_;
    bool impossible_ = false;
};

}  // namespace blossom::proofs::second
