#include "point_comparison.hpp"

#include "certificates/evaluation/second_evaluation.hpp"
#include "point_search.hpp"

#include <blossom/rational/error.hpp>

#include <optional>
#include <set>
#include <utility>

namespace blossom::proofs::second {

namespace {

std::string text_of_value(const AlgebraNumber& value) {
    return value.is_rational() ? to_string(value.constant()) : "an algebraic number";
}

std::string difference_note(const PointField& field, const AlgebraNumber& left, const AlgebraNumber& right) {
    std::string note = "left side " + text_of_value(left) + ", right side " + text_of_value(right) + " at";
    std::size_t shown = 0;
    for (const std::string& name : field.symbols()) {
        if (++shown > 8) return note + " ...";
        note += (shown == 1 ? " " : ", ") + name + " = " + text_of_value(field.value(name));
    }
    return note;
}

std::vector<std::string> symbols_of(const std::vector<Step>& steps) {
    std::vector<std::string> symbols;
    symbols.reserve(steps.size());
    for (const Step& step : steps) symbols.push_back(step.symbol);
    return symbols;
}

/// Evaluates both sides; nullopt if they agree.
std::optional<std::string> difference_of_sides(const Reading& reading, const Case& which, PointField& field) {
    Evaluation<PointField> evaluation(reading, which, field);
    const AlgebraNumber left = evaluation.left();
    const AlgebraNumber right = evaluation.right();
    if (left == right) return std::nullopt;
    return difference_note(field, left, right);
}

}  // namespace

Comparison compare(const Reading& reading, const Case& which, const std::vector<Step>& hint,
                   std::size_t points, std::uint64_t seed) {
    Comparison comparison;
    const bool has_hypotheses = !reading.hypotheses().empty();
    const std::size_t ways = !has_hypotheses ? 1 : hint.empty() ? 2 : 3;
    const std::size_t attempts = points + 5 * ways;
    std::size_t way = 0;
    for (std::size_t attempt = 0; attempt < attempts && comparison.points < points; ++attempt) {
        PointField field(reading.limits(), seed + attempt);
        PointSearch search(reading, which, field, symbols_of(hint), attempt);
        if (way % ways == 1) search.solve_all_by_roots();
        try {
            std::string problem = way % ways == 2 ? search.follow(hint) : search.run();
            if (!problem.empty()) {
                comparison.note = std::move(problem);
                ++way;
                continue;
            }
            std::optional<std::string> difference = difference_of_sides(reading, which, field);
            ++comparison.points;
            if (!difference) continue;
            comparison.result = Comparison::Result::differ;
            comparison.note = std::move(*difference);
            return comparison;
        } catch (const Error& error) {
            if (error.code() != ErrorCode::division_by_zero) throw;
            comparison.note = error.message();
            ++way;
        }
    }
    if (comparison.points > 0) {
        comparison.result = Comparison::Result::agree;
        comparison.note.clear();
    }
    return comparison;
}

Comparison confirm(const Reading& reading, const Case& which,
                   const std::vector<std::pair<std::string, Rational>>& values,
                   const std::vector<std::string>& algebraic, const std::vector<Step>& hint) {
    Comparison comparison;
    constexpr std::size_t turns = 12;  // enough to try all roots of an equation of low degree
    for (std::size_t turn = 0; turn < (algebraic.empty() ? 1 : turns); ++turn) {
        PointField field(reading.limits(), turn + 1);
        for (const auto& [name, value] : values) field.set(name, value);
        for (const std::string& name : algebraic) field.set(name, field.random().number());
        field.require_values();
        PointSearch search(reading, which, field, algebraic, turn);
        search.move_only(std::set<std::string>(algebraic.begin(), algebraic.end()));
        search.solve_all_by_roots();
        try {
            std::string problem = turn % 2 == 0 || hint.empty() ? search.run() : search.follow(hint);
            if (!problem.empty()) {
                if (comparison.points == 0) comparison.note = std::move(problem);
                continue;
            }
            std::optional<std::string> difference = difference_of_sides(reading, which, field);
            ++comparison.points;
            comparison.note = difference.value_or("both sides agree there");
            comparison.result = difference ? Comparison::Result::differ : Comparison::Result::agree;
            if (difference) return comparison;
        } catch (const Error& error) {
            if (error.code() != ErrorCode::division_by_zero && error.code() != ErrorCode::missing_field)
                throw;
            if (comparison.points == 0) comparison.note = error.message();
        }
    }
    return comparison;
}

}  // namespace blossom::proofs::second
