#include "point_search.hpp"

#include <blossom/rational/error.hpp>

#include <algorithm>
#include <utility>

namespace blossom::proofs::second {

namespace {

bool occurs(const std::string& symbol, const Step& step) {
    return std::ranges::any_of(step.relation, [&](const NamedTerm& term) {
        return std::ranges::any_of(term.powers, [&](const auto& power) { return power.first == symbol; });
    });
}

}  // namespace

std::string PointSearch::follow(const std::vector<Step>& steps) {
    std::vector<Step> open;
    std::ranges::copy_if(steps, std::back_inserter(open),
                         [&](const Step& step) { return may_move(step.symbol); });
    while (!open.empty()) {
        const std::optional<std::size_t> next = independent_step(open);
        if (!next) return "every symbol that was solved for depends on another one";
        const Step step = open[*next];
        open.erase(open.begin() + static_cast<std::ptrdiff_t>(*next));
        field_.set(step.symbol, root_of(step));
    }
    return verify();
}

/// A step whose relation contains no symbol of the other steps.
std::optional<std::size_t> PointSearch::independent_step(const std::vector<Step>& steps) const {
    const auto depends = [&](const Step& step) {
        return std::ranges::any_of(steps, [&](const Step& other) {
            return other.symbol != step.symbol && occurs(other.symbol, step);
        });
    };
    const auto found = std::ranges::find_if_not(steps, depends);
    if (found == steps.end()) return std::nullopt;
    return static_cast<std::size_t>(found - steps.begin());
}

AlgebraNumber PointSearch::root_of(const Step& step) {
    const Algebra& algebra = field_.algebra();
    PointPolynomial polynomial(1);
    for (const NamedTerm& term : step.relation) {
        AlgebraNumber coefficient = term.coefficient;
        std::size_t degree = 0;
        for (const auto& [name, exponent] : term.powers) {
            if (name == step.symbol) {
                degree = exponent;
            } else {
                coefficient = algebra.product(coefficient, algebra.power(field_.symbol(name), exponent));
            }
        }
        if (polynomial.size() <= degree) polynomial.resize(degree + 1);
        polynomial[degree] = algebra.sum(polynomial[degree], coefficient);
    }
    while (!polynomial.empty() && polynomial.back().is_zero()) polynomial.pop_back();
    if (polynomial.size() < 2)
        throw Error(ErrorCode::division_by_zero, "a step has no equation at the point");
    if (polynomial.size() == 2) return algebra.negative(algebra.quotient(polynomial[0], polynomial[1]));
    return some_root(squarefree_part(algebra, polynomial));
}

}  // namespace blossom::proofs::second
