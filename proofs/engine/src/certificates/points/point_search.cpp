#include "point_search.hpp"

#include "certificates/evaluation/second_evaluation.hpp"

#include <blossom/rational/error.hpp>

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

namespace blossom::proofs::second {

PointSearch::PointSearch(const Reading& reading, const Case& which, PointField& field,
                         std::vector<std::string> dependent, std::size_t turn)
    : reading_(reading), case_(which), field_(field), dependent_(std::move(dependent)), turn_(turn) {}

std::vector<AlgebraNumber> PointSearch::residuals(std::size_t line) {
    Evaluation<PointField> evaluation(reading_, case_, field_);
    std::vector<AlgebraNumber> found;
    for (const auto& [left, right] : evaluation.hypotheses(line)) {
        found.push_back(field_.algebra().difference(left, right));
    }
    return found;
}

void PointSearch::find_symbols() {
    for (std::size_t line = 0; line < reading_.hypotheses().size(); ++line) {
        std::vector<std::string> names;
        std::set<std::string> seen;
        field_.watch([&](const std::string& name) {
            if (seen.insert(name).second) names.push_back(name);
        });
        const AtEnd stop([&] { field_.watch({}); });
        residuals(line);
        symbols_.push_back(std::move(names));
    }
}

bool PointSearch::may_move(const std::string& name) const { return !movable_ || movable_->contains(name); }

std::string PointSearch::run() {
    if (movable_ && movable_->empty()) return verify();
    if (!reading_.hypotheses().empty()) {
        find_symbols();
        std::vector<std::size_t> linear;
        std::vector<Equation> equations;
        for (std::size_t line = 0; line < symbols_.size(); ++line) {
            const bool has_map_value = std::ranges::any_of(
                symbols_[line], [&](const std::string& name) { return reading_.is_map_value(name); });
            if (!reading_.hypotheses()[line].for_all.empty() || (has_map_value && !by_roots_)) {
                linear.push_back(line);
                continue;
            }
            const std::size_t count = residuals(line).size();
            for (std::size_t place = 0; place < count; ++place) equations.push_back({line, place});
            fixed_.insert(symbols_[line].begin(), symbols_[line].end());
        }
        if (const std::optional<Equation> left = unsolved(std::move(equations)))
            return "hypothesis " + std::to_string(left->line + 1) + " was not solved for a symbol";
        const std::string problem = solve_linear(linear);
        if (!problem.empty()) return problem;
    }
    return verify();
}

std::string PointSearch::verify() {
    for (std::size_t line = 0; line < reading_.hypotheses().size(); ++line) {
        const std::size_t times = reading_.hypotheses()[line].for_all.empty() ? 1 : 3;
        for (std::size_t i = 0; i < times; ++i) {
            if (std::ranges::all_of(residuals(line), &AlgebraNumber::is_zero)) continue;
            return "hypothesis " + std::to_string(line + 1) + " does not hold at the point that was found";
        }
    }
    if (reading_.assumptions().empty()) return "";
    Evaluation<PointField> evaluation(reading_, case_, field_);
    for (const auto& [left, right] : evaluation.assumptions()) {
        const AlgebraNumber difference = field_.algebra().difference(left, right);
        try {
            field_.algebra().inverse(difference);
        } catch (const Error& error) {
            if (error.code() != ErrorCode::division_by_zero) throw;
            return "an assumption does not hold at the point that was found";
        }
    }
    return "";
}

std::vector<std::string> PointSearch::map_values(const std::vector<std::size_t>& lines) const {
    std::vector<std::string> found;
    std::set<std::string> seen(fixed_.begin(), fixed_.end());
    const auto take = [&](const std::string& name) {
        if (reading_.is_map_value(name) && may_move(name) && seen.insert(name).second) found.push_back(name);
    };
    std::set<std::string> present;
    for (const std::size_t line : lines) present.insert(symbols_[line].begin(), symbols_[line].end());
    for (const std::string& name : dependent_) {
        if (present.contains(name)) take(name);
    }
    for (const std::size_t line : lines) {
        for (const std::string& name : symbols_[line]) take(name);
    }
    return found;
}

std::string PointSearch::solve_linear(const std::vector<std::size_t>& lines) {
    if (lines.empty()) return "";
    std::vector<std::string> unknowns = map_values(lines);
    const std::string problem = solve_linear_for(lines, unknowns);
    if (problem.empty()) return "";
    const std::size_t count = unknowns.size();
    add_linear_numbers(lines, unknowns);
    return unknowns.size() == count ? problem : solve_linear_for(lines, unknowns);
}

// Adds to the values of maps those numbers that no other equation determines and in which all lines are
// linear.
void PointSearch::add_linear_numbers(const std::vector<std::size_t>& lines,
                                     std::vector<std::string>& unknowns) {
    std::vector<std::string> others;
    std::map<std::string, std::size_t> lines_of;
    for (const std::size_t line : lines) {
        for (const std::string& name : symbols_[line]) {
            if (++lines_of[name] == 1) others.push_back(name);
        }
    }
    // The factors of a product cannot both be unknown. Symbols that occur in many lines come first, and every
    // turn uses another order.
    std::ranges::stable_sort(others, std::greater(), [&](const std::string& name) { return lines_of[name]; });
    if (!others.empty())
        std::ranges::rotate(others, others.begin() + static_cast<long>(turn_ % others.size()));
    std::vector<std::string> offered = dependent_;
    offered.insert(offered.end(), others.begin(), others.end());
    std::set<std::string> seen(unknowns.begin(), unknowns.end());
    for (const std::string& name : offered) {
        if (!field_.knows(name) || fixed_.contains(name) || !may_move(name) || !seen.insert(name).second)
            continue;
        unknowns.push_back(name);
        if (!is_linear(lines, unknowns)) unknowns.pop_back();
    }
}

bool PointSearch::is_linear(const std::vector<std::size_t>& lines, const std::vector<std::string>& unknowns) {
    const RandomNumbers random = field_.random();
    std::vector<AlgebraNumber> expected;
    std::vector<AlgebraNumber> steps;
    steps.reserve(unknowns.size());
    RandomNumbers step_random(turn_ + unknowns.size());
    for (std::size_t i = 0; i < unknowns.size(); ++i) steps.emplace_back(step_random.number());
    const Algebra& algebra = field_.algebra();
    for (const std::size_t line : lines) {
        for (const std::vector<AlgebraNumber>& row : linear_rows(line, unknowns)) {
            AlgebraNumber value = algebra.negative(row.back());
            for (std::size_t i = 0; i < steps.size(); ++i)
                value = algebra.sum(value, algebra.product(row[i], steps[i]));
            expected.push_back(std::move(value));
        }
    }
    std::vector<AlgebraNumber> kept;
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        kept.push_back(field_.value(unknowns[i]));
        field_.set(unknowns[i], algebra.sum(kept.back(), steps[i]));
    }
    const AtEnd restore([&] {
        for (std::size_t i = 0; i < unknowns.size(); ++i) field_.set(unknowns[i], kept[i]);
    });
    field_.random() = random;
    std::size_t place = 0;
    for (const std::size_t line : lines) {
        for (const AlgebraNumber& value : residuals(line)) {
            if (value != expected[place++]) return false;
        }
    }
    return true;
}

// The equations in the distances of the unknowns from their current values.
std::vector<std::vector<AlgebraNumber>> PointSearch::linear_rows(std::size_t line,
                                                                 const std::vector<std::string>& unknowns) {
    Algebra& algebra = field_.algebra();
    std::vector<AlgebraNumber> kept;
    kept.reserve(unknowns.size());
    for (const std::string& name : unknowns) kept.push_back(field_.value(name));
    const std::vector<AlgebraNumber> generators = algebra.adjoin_first_order(unknowns.size());
    const AtEnd restore([&] {
        algebra.drop_level();
        for (std::size_t i = 0; i < unknowns.size(); ++i) field_.set(unknowns[i], kept[i]);
    });
    for (std::size_t i = 0; i < unknowns.size(); ++i)
        field_.set(unknowns[i], algebra.sum(kept[i], generators[i]));
    std::vector<std::vector<AlgebraNumber>> rows;
    for (const AlgebraNumber& value : residuals(line)) {
        std::vector<AlgebraNumber> row = algebra.parts(value);
        std::ranges::rotate(row, row.begin() + 1);
        row.back() = algebra.negative(row.back());
        rows.push_back(std::move(row));
    }
    return rows;
}

std::string PointSearch::solve_linear_for(const std::vector<std::size_t>& lines,
                                          const std::vector<std::string>& unknowns) {
    LinearSystem system(field_.algebra(), unknowns.size());
    for (const std::size_t line : lines) {
        // A line with bound variables gives one equation for each of their values, until these add no
        // information.
        const bool repeats = !reading_.hypotheses()[line].for_all.empty();
        std::size_t idle = 0;
        while (idle < (repeats ? 2U : 1U)) {
            bool gained = false;
            for (std::vector<AlgebraNumber>& row : linear_rows(line, unknowns)) {
                const LinearSystem::Effect effect = system.add(std::move(row));
                if (effect == LinearSystem::Effect::impossible) {
                    return "hypothesis " + std::to_string(line + 1) + " contradicts others at random numbers";
                }
                gained = gained || effect == LinearSystem::Effect::new_pivot;
            }
            idle = gained && repeats ? 0 : idle + 1;
        }
    }
    const std::vector<AlgebraNumber> steps = system.solution();
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        if (steps[i].is_zero()) continue;
        field_.set(unknowns[i], field_.algebra().sum(field_.value(unknowns[i]), steps[i]));
    }
    return "";
}

}  // namespace blossom::proofs::second
