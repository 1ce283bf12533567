#include "second_counting.hpp"

#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <functional>
#include <map>

namespace blossom::proofs::second {

const Clause* Counting::fitting_clause(std::uint32_t abbreviation, const std::vector<long long>& indices,
                                       Scope& scope) {
    Scope outer;
    for (const Clause& clause : reading_.abbreviations()[abbreviation].clauses) {
        if (clause.patterns.size() != indices.size()) continue;
        bool fits = true;
        for (std::size_t i = 0; i < indices.size() && fits; ++i) {
            fits = !clause.patterns[i] || integer(*clause.patterns[i], outer) == indices[i];
        }
        // A name that occurs twice denotes one integer.
        std::map<std::uint32_t, long long> named;
        for (std::size_t i = 0, name = 0; i < indices.size() && fits; ++i) {
            if (!clause.patterns[i])
                fits = named.emplace(clause.pattern_names[name++], indices[i]).first->second == indices[i];
        }
        if (!fits) continue;
        scope.assign(clause.slots, Slot{});
        std::size_t slot = 0;
        for (std::size_t i = 0; i < indices.size(); ++i) {
            if (!clause.patterns[i]) scope[slot++].integer = indices[i];
        }
        return &clause;
    }
    return nullptr;
}

bool Counting::needs_clause(std::uint32_t abbreviation, std::size_t indices) const {
    const std::function<bool(NodeId)> has_name = [&](NodeId id) {
        const Node& node = reading_.node(id);
        return node.form == Form::name || std::ranges::any_of(node.children, has_name);
    };
    return std::ranges::any_of(reading_.abbreviations()[abbreviation].clauses, [&](const Clause& clause) {
        const auto names_any = [&](const std::optional<NodeId>& pattern) {
            return !pattern || has_name(*pattern);
        };
        return clause.patterns.size() == indices && std::ranges::any_of(clause.patterns, names_any);
    });
}

bool Counting::is_declared(const Declaration& declaration, const std::vector<long long>& indices) {
    if (declaration.bare) return true;
    Scope scope;
    for (const auto& [first, last] : declaration.runs) {
        const std::vector<long long> low = integers(first, scope);
        const std::vector<long long> high = integers(last, scope);
        if (low.size() != indices.size()) continue;
        bool fits = indices.back() >= low.back() && indices.back() <= high.back();
        for (std::size_t i = 0; i + 1 < indices.size(); ++i) fits = fits && indices[i] == low[i];
        if (fits) return true;
    }
    return false;
}

std::size_t Counting::dimension(const Declaration& declaration) {
    Scope scope;
    const std::size_t found =
        count(*declaration.dimension, scope, reading_.limits().variables, "a dimension");
    for (const NodeId other : declaration.other_dimensions) {
        if (count(other, scope, reading_.limits().variables, "a dimension") == found) continue;
        throw Error(
            ErrorCode::mismatched_dimensions,
            "the family " + quoted(reading_.name(declaration.name)) + " is declared with two dimensions", {},
            declaration.offset);
    }
    return found;
}

}  // namespace blossom::proofs::second
