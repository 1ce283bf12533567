#pragma once

#include <blossom/proofs/certificate.hpp>

#include "certificates/reading/second_reading.hpp"
#include "point_algebra.hpp"
#include "point_polynomial.hpp"

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace blossom::proofs::second {

/// Moves a random point to one that satisfies the hypotheses of a case.
class PointSearch {
public:
    /// `dependent` lists symbols to solve for before others; `turn` selects one of several roots.
    PointSearch(const Reading& reading, const Case& which, PointField& field,
                std::vector<std::string> dependent, std::size_t turn);

    /// From now on, only these symbols may be moved.
    void move_only(std::set<std::string> names) { movable_ = std::move(names); }
    /// From now on, equations in values of maps are solved one by one like others, because they are not
    /// linear.
    void solve_all_by_roots() { by_roots_ = true; }

    /// Returns "" if all hypotheses and assumptions hold now, otherwise what is wrong.
    std::string run();
    /// The same, but the equations of `steps` are solved instead of the hypotheses, which are then verified.
    std::string follow(const std::vector<Step>& steps);

private:
    /// One case of a hypothesis.
    struct Equation {
        std::size_t line;
        std::size_t place;
    };
    struct Solved {
        std::string symbol;
        Equation equation;
    };

    std::vector<AlgebraNumber> residuals(std::size_t line);
    AlgebraNumber residual(const Equation& equation) { return residuals(equation.line)[equation.place]; }
    void find_symbols();
    bool may_move(const std::string& name) const;

    // Solves one equation.
    // With `only_linear`, it does nothing if every symbol has more than one root.
    bool solve_by_root(const Equation& equation, bool only_linear);
    std::optional<Equation> unsolved(std::vector<Equation> equations);
    std::vector<std::string> candidates(const Equation& equation) const;
    std::optional<PointPolynomial> numerator(const Equation& equation, const std::string& symbol);
    std::vector<AlgebraNumber> series(const Equation& equation, const std::string& symbol);
    bool move_to(const std::string& symbol, const AlgebraNumber& value, const Equation& equation);
    AlgebraNumber some_root(const PointPolynomial& polynomial);
    std::vector<std::vector<AlgebraNumber>> derivatives_of_solved();
    void correct_solved(const std::vector<std::vector<AlgebraNumber>>& inverse);
    bool solve_again();
    bool all_solved_hold();

    // Solves all equations together.
    std::string solve_linear(const std::vector<std::size_t>& lines);
    std::vector<std::string> map_values(const std::vector<std::size_t>& lines) const;
    void add_linear_numbers(const std::vector<std::size_t>& lines, std::vector<std::string>& unknowns);
    bool is_linear(const std::vector<std::size_t>& lines, const std::vector<std::string>& unknowns);
    std::string solve_linear_for(const std::vector<std::size_t>& lines,
                                 const std::vector<std::string>& unknowns);
    std::vector<std::vector<AlgebraNumber>> linear_rows(std::size_t line,
                                                        const std::vector<std::string>& unknowns);

    std::string verify();

    // The equations of steps.
    std::optional<std::size_t> independent_step(const std::vector<Step>& steps) const;
    AlgebraNumber root_of(const Step& step);

    const Reading& reading_;
    const Case& case_;
    PointField& field_;
    std::vector<std::string> dependent_;
    std::size_t turn_;
    bool by_roots_ = false;
    std::optional<std::set<std::string>> movable_;
    /// the symbols of each line, in the order in which they occur
    std::vector<std::vector<std::string>> symbols_;
    std::vector<Solved> solved_;
    std::vector<AlgebraNumber> generators_;  ///< roots that were adjoined
    std::set<std::string> fixed_;            ///< symbols of equations that are solved by roots
};

}  // namespace blossom::proofs::second
