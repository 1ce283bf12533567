#include "point_search.hpp"

#include "certificates/evaluation/second_evaluation.hpp"

#include <blossom/rational/error.hpp>

#include <algorithm>
#include <utility>

namespace blossom::proofs::second {

namespace {

constexpr std::size_t length_of_series = 12;

}  // namespace

// Equations that are linear in a symbol come first, because solving another one by a root uses up a symbol
// that they may need.
std::optional<PointSearch::Equation> PointSearch::unsolved(std::vector<Equation> equations) {
    while (!equations.empty()) {
        const auto solves = [&](bool only_linear) {
            const auto solved = std::ranges::find_if(
                equations, [&](const Equation& equation) { return solve_by_root(equation, only_linear); });
            if (solved == equations.end()) return false;
            equations.erase(solved);
            return true;
        };
        if (!solves(true) && !solves(false)) return equations.front();
    }
    return std::nullopt;
}

bool PointSearch::solve_by_root(const Equation& equation, bool only_linear) {
    if (residual(equation).is_zero()) return true;
    std::vector<std::pair<std::string, PointPolynomial>> nonlinear;
    const std::vector<std::string> names = candidates(equation);
    for (const std::string& name : names) {
        try {
            std::optional<PointPolynomial> polynomial = numerator(equation, name);
            if (!polynomial || polynomial->size() < 2) continue;
            if (polynomial->size() > 2) {
                nonlinear.emplace_back(name, std::move(*polynomial));
                continue;
            }
            const Algebra& algebra = field_.algebra();
            const AlgebraNumber step = algebra.negative(algebra.quotient((*polynomial)[0], (*polynomial)[1]));
            if (move_to(name, algebra.sum(field_.value(name), step), equation)) return true;
        } catch (const Error& error) {
            if (error.code() != ErrorCode::division_by_zero) throw;
        }
    }
    if (only_linear) return false;
    return std::ranges::any_of(nonlinear, [&](const auto& candidate) {
        const auto& [name, polynomial] = candidate;
        try {
            const Algebra& algebra = field_.algebra();
            const PointPolynomial absolute = shifted_back(algebra, polynomial, field_.value(name));
            return move_to(name, some_root(squarefree_part(algebra, absolute)), equation);
        } catch (const Error& error) {
            if (error.code() != ErrorCode::division_by_zero) throw;
            return false;
        }
    });
}

// The symbols of the equation, those of the equations solved for one of them, and so on.
std::vector<std::string> PointSearch::candidates(const Equation& equation) const {
    std::vector<std::string> reached;
    std::set<std::string> seen;
    const auto reach = [&](std::size_t line) {
        for (const std::string& name : symbols_[line]) {
            if (seen.insert(name).second) reached.push_back(name);
        }
    };
    reach(equation.line);
    std::size_t place = 0;
    while (place < reached.size()) {
        for (const Solved& solved : solved_) {
            if (solved.symbol == reached[place]) reach(solved.equation.line);
        }
        ++place;
    }
    std::vector<std::string> found;
    std::set<std::string> taken;
    for (const Solved& solved : solved_) taken.insert(solved.symbol);
    for (const std::string& name : dependent_) {
        if (seen.contains(name) && may_move(name) && taken.insert(name).second) found.push_back(name);
    }
    for (const std::string& name : reached) {
        if (may_move(name) && taken.insert(name).second) found.push_back(name);
    }
    return found;
}

std::optional<PointPolynomial> PointSearch::numerator(const Equation& equation, const std::string& symbol) {
    const std::vector<AlgebraNumber> terms = series(equation, symbol);
    if (std::all_of(terms.begin() + 1, terms.end(),
                    [](const AlgebraNumber& term) { return term.is_zero(); })) {
        return std::nullopt;
    }
    return numerator_of_series(field_.algebra(), terms);
}

// The equation as a series near the value of the symbol. The solved symbols follow: each step of Newton's
// iteration gives one more correct coefficient.
std::vector<AlgebraNumber> PointSearch::series(const Equation& equation, const std::string& symbol) {
    std::vector<std::vector<AlgebraNumber>> inverse = derivatives_of_solved();
    Algebra& algebra = field_.algebra();
    std::vector<std::pair<std::string, AlgebraNumber>> kept{{symbol, field_.value(symbol)}};
    for (const Solved& solved : solved_) kept.emplace_back(solved.symbol, field_.value(solved.symbol));
    const AlgebraNumber step = algebra.adjoin_nilpotent(length_of_series);
    const AtEnd restore([&] {
        algebra.drop_level();
        for (const auto& [name, value] : kept) field_.set(name, value);
    });
    field_.set(symbol, algebra.sum(kept.front().second, step));
    for (std::size_t i = 0; i < length_of_series && !all_solved_hold(); ++i) correct_solved(inverse);
    return algebra.parts(residual(equation));
}

bool PointSearch::all_solved_hold() {
    return std::ranges::all_of(solved_,
                               [&](const Solved& solved) { return residual(solved.equation).is_zero(); });
}

// The inverse of the matrix of the derivatives of the solved equations with respect to the symbols for which
// they were solved.
std::vector<std::vector<AlgebraNumber>> PointSearch::derivatives_of_solved() {
    const std::size_t size = solved_.size();
    if (size == 0) return {};
    std::vector<std::string> names;
    names.reserve(size);
    for (const Solved& solved : solved_) names.push_back(solved.symbol);
    std::vector<std::vector<AlgebraNumber>> rows;
    rows.reserve(size);
    for (const Solved& solved : solved_)
        rows.push_back(linear_rows(solved.equation.line, names)[solved.equation.place]);
    std::vector<std::vector<AlgebraNumber>> inverse(size, std::vector<AlgebraNumber>(size));
    for (std::size_t column = 0; column < size; ++column) {
        LinearSystem system(field_.algebra(), size);
        for (std::size_t row = 0; row < size; ++row) {
            std::vector<AlgebraNumber> one_row = rows[row];
            one_row.back() = row == column ? AlgebraNumber(Rational(1)) : AlgebraNumber();
            if (system.add(std::move(one_row)) != LinearSystem::Effect::new_pivot) {
                throw Error(ErrorCode::division_by_zero, "the equations solved are not independent");
            }
        }
        const std::vector<AlgebraNumber> solution = system.solution();
        for (std::size_t row = 0; row < size; ++row) inverse[row][column] = solution[row];
    }
    return inverse;
}

void PointSearch::correct_solved(const std::vector<std::vector<AlgebraNumber>>& inverse) {
    const Algebra& algebra = field_.algebra();
    std::vector<AlgebraNumber> errors;
    errors.reserve(solved_.size());
    for (const Solved& solved : solved_) errors.push_back(residual(solved.equation));
    for (std::size_t i = 0; i < solved_.size(); ++i) {
        AlgebraNumber value = field_.value(solved_[i].symbol);
        for (std::size_t k = 0; k < errors.size(); ++k) {
            value = algebra.difference(value, algebra.product(inverse[i][k], errors[k]));
        }
        field_.set(solved_[i].symbol, std::move(value));
    }
}

bool PointSearch::move_to(const std::string& symbol, const AlgebraNumber& value, const Equation& equation) {
    std::vector<std::pair<std::string, AlgebraNumber>> kept{{symbol, field_.value(symbol)}};
    for (const Solved& solved : solved_) kept.emplace_back(solved.symbol, field_.value(solved.symbol));
    bool done = false;
    const AtEnd restore([&] {
        if (done) return;
        for (const auto& [name, old] : kept) field_.set(name, old);
    });
    field_.set(symbol, value);
    done = solve_again() && residual(equation).is_zero();
    if (done) solved_.push_back({symbol, equation});
    return done;
}

// Solves the earlier equations at another value of a symbol: at once if they are linear, otherwise one by one
// from the last.
bool PointSearch::solve_again() {
    if (all_solved_hold()) return true;
    try {
        correct_solved(derivatives_of_solved());
        if (all_solved_hold()) return true;
    } catch (const Error& error) {
        if (error.code() != ErrorCode::division_by_zero) throw;
    }
    const std::vector<Solved> all = solved_;
    const AtEnd restore([&] { solved_ = all; });
    for (std::size_t round = 0; round < all.size(); ++round) {
        for (std::size_t i = all.size(); i-- > 0;) {
            solved_ = all;
            const AlgebraNumber error = residual(all[i].equation);
            if (error.is_zero()) continue;
            solved_.clear();
            const std::optional<PointPolynomial> polynomial = numerator(all[i].equation, all[i].symbol);
            if (!polynomial || polynomial->size() != 2) return false;
            const Algebra& algebra = field_.algebra();
            const AlgebraNumber step = algebra.quotient((*polynomial)[0], (*polynomial)[1]);
            field_.set(all[i].symbol, algebra.difference(field_.value(all[i].symbol), step));
        }
        solved_ = all;
        if (all_solved_hold()) return true;
    }
    return false;
}

// A rational root, a root that was adjoined before or its negative, or a root of the remaining factor, in
// turn: an equation that factors has several kinds of points.
AlgebraNumber PointSearch::some_root(const PointPolynomial& polynomial) {
    Algebra& algebra = field_.algebra();
    std::vector<AlgebraNumber> roots;
    for (const Rational& root : rational_roots(polynomial)) roots.emplace_back(root);
    PointPolynomial rest = polynomial;
    for (const AlgebraNumber& root : roots) rest = divided_by_root(algebra, rest, root).quotient;
    for (const AlgebraNumber& generator : generators_) {
        for (const AlgebraNumber& root : {generator, algebra.negative(generator)}) {
            DividedByRoot divided = divided_by_root(algebra, rest, root);
            if (!divided.value.is_zero() || divided.quotient.empty()) continue;
            rest = std::move(divided.quotient);
            roots.push_back(root);
        }
    }
    const std::size_t choice = turn_ % (roots.size() + (rest.size() > 1 ? 1 : 0));
    if (choice < roots.size()) return roots[choice];
    rest.pop_back();
    generators_.push_back(algebra.adjoin_root(std::move(rest)));
    return generators_.back();
}

}  // namespace blossom::proofs::second
