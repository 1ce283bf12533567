#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <numeric>

#include "grounder.hpp"

/// Integers, sets and what runs over them.

namespace blossom::proofs {

Grounder::Binding::Binding(Grounder& grounder, const std::string& name, Bound value)
    : grounder_(grounder), name_(name) {
    const auto known = grounder_.bound_.find(name);
    if (known != grounder_.bound_.end()) hidden_ = known->second;
    grounder_.bound_[name] = std::move(value);
}

Grounder::Binding::~Binding() {
    if (hidden_) {
        grounder_.bound_[name_] = std::move(*hidden_);
    } else {
        grounder_.bound_.erase(name_);
    }
}

const Bound* Grounder::bound(const std::string& name) const {
    const auto found = bound_.find(name);
    return found == bound_.end() ? nullptr : &found->second;
}

long long Grounder::integer(const Expression& e) {
    const Rational* value = constant_value(scalar(e));
    const auto word = value && value->is_integer() ? value->numerator().to_int64() : std::nullopt;
    constexpr long long greatest = 1LL << 60;
    if (!word || *word > greatest || *word < -greatest) {
        throw Error(ErrorCode::syntax,
                    value && word ? "the integer " + to_string(*value) + " is too large here"
                    : value       ? to_string(*value) + " found, expected an integer"
                                  : "an expression with variables found, expected an integer",
                    "", e.offset);
    }
    return *word;
}

std::size_t Grounder::count(const Expression& e) {
    const long long value = integer(e);
    if (value < 0) {
        throw Error(ErrorCode::syntax, "a count or degree is at least 0, this is " + std::to_string(value),
                    "", e.offset);
    }
    if (static_cast<std::size_t>(value) > limits_.degree) {
        throw Error(ErrorCode::limit_exceeded,
                    "the number " + std::to_string(value) +
                        " exceeds the limit degree = " + std::to_string(limits_.degree),
                    "", e.offset);
    }
    return static_cast<std::size_t>(value);
}

Set Grounder::interval(const Expression& first, const Expression& last) {
    const long long low = integer(first);
    const long long high = integer(last);
    Set members;
    if (high < low) return members;
    if (static_cast<unsigned long long>(high) - static_cast<unsigned long long>(low) >=
        limits_.expansion_terms) {
        throw Error(ErrorCode::limit_exceeded,
                    "the number of members exceeds the limit expansion_terms = " +
                        std::to_string(limits_.expansion_terms),
                    "", first.offset);
    }
    members.resize(static_cast<std::size_t>(high - low) + 1);
    std::iota(members.begin(), members.end(), low);
    return members;
}

Set Grounder::set_of(const Expression& e) {
    if (e.kind == ExpressionKind::name && e.children.empty()) {
        const Bound* value = bound(e.name);
        const Set* set = value ? std::get_if<Set>(value) : nullptr;
        if (set) return *set;
    }
    if (e.kind == ExpressionKind::call && e.name == "without" && e.children.size() == 2) {
        Set members;
        const Set excluded = set_of(e.children[1]);
        const std::size_t n = count(e.children[0]);
        for (std::size_t i = 1; i <= n; ++i) {
            const auto member = static_cast<long long>(i);
            if (std::ranges::find(excluded, member) == excluded.end()) members.push_back(member);
        }
        return members;
    }
    throw Error(ErrorCode::syntax, "a set is expected here: one bound by sum, or without(n, S)", "",
                e.offset);
}

/// What a sum over `e` runs over: the members of a set, or the subsets of 1..n with k members.
std::vector<Bound> Grounder::elements_of(const Expression& e) {
    std::vector<Bound> elements;
    if (e.kind != ExpressionKind::call || e.name != "subsets" || e.children.size() != 2) {
        for (const long long member : set_of(e)) elements.emplace_back(member);
        return elements;
    }
    const std::size_t n = count(e.children[0]);
    const long long size = integer(e.children[1]);
    if (size < 0 || static_cast<std::size_t>(size) > n) return elements;
    const auto k = static_cast<std::size_t>(size);
    if (binomial(n, k) > Integer(limits_.expansion_terms)) {
        throw Error(ErrorCode::limit_exceeded,
                    "the number of subsets exceeds the limit expansion_terms = " +
                        std::to_string(limits_.expansion_terms),
                    "", e.offset);
    }
    Set members(k);
    std::iota(members.begin(), members.end(), 1);
    while (true) {
        elements.emplace_back(members);
        // The last member that can grow does, and those behind follow it.
        std::size_t i = k;
        while (i > 0 && members[i - 1] == static_cast<long long>(n) - static_cast<long long>(k - i)) --i;
        if (i == 0) return elements;
        std::iota(members.begin() + static_cast<std::ptrdiff_t>(i) - 1, members.end(), members[i - 1] + 1);
    }
}

/// The values of the last argument of sum, prod or mean.
std::vector<Grounder::Value> Grounder::over_range(const Expression& call) {
    const Expression& binder = call.children[0];
    if (binder.kind != ExpressionKind::name || !binder.children.empty()) {
        throw Error(ErrorCode::syntax, "the first argument of " + call.name + " is the name that runs", "",
                    binder.offset);
    }
    std::vector<Bound> elements;
    if (call.children.size() == 4) {
        for (const long long i : interval(call.children[1], call.children[2])) elements.emplace_back(i);
    } else {
        elements = elements_of(call.children[1]);
    }
    std::vector<Value> values;
    for (Bound& element : elements) {
        const Binding binding(*this, binder.name, std::move(element));
        values.push_back(value(call.children.back()));
    }
    return values;
}

/// t_1..t_n with its last index running; descending or empty when the end lies before the beginning.
std::vector<Expression> Grounder::run_members(const Expression& run) {
    const Expression& first = run.children[0];
    const Expression& last = run.children[1];
    const bool fits = first.kind == ExpressionKind::name && last.kind == ExpressionKind::name &&
                      first.name == last.name && !first.children.empty() &&
                      first.children.size() == last.children.size() &&
                      std::equal(first.children.begin(), first.children.end() - 1, last.children.begin());
    if (!fits) {
        throw Error(ErrorCode::syntax, "a run goes from a name with an index to the same name, as t_1..t_n",
                    "", first.offset);
    }
    std::vector<Expression> members;
    for (const long long i : interval(first.children.back(), last.children.back())) {
        Expression member = first;
        const bool negative = i < 0;
        Expression index{ExpressionKind::number, first.offset, std::to_string(negative ? -i : i), {}, {}};
        if (negative) index = {ExpressionKind::negative, first.offset, "", {std::move(index)}, {}};
        member.children.back() = std::move(index);
        members.push_back(std::move(member));
    }
    return members;
}

std::vector<Expression> Grounder::members(const Expression& name_or_run) {
    if (name_or_run.kind == ExpressionKind::run) return run_members(name_or_run);
    return {name_or_run};
}

/// The values of the index of t_i : i in 1..n, i != k, i not in S.
std::vector<long long> Grounder::family_indices(const Expression& family) {
    const auto& range = family.groups[0];
    Set members = range.size() == 2 ? interval(range[0], range[1]) : set_of(range[0]);
    for (const Expression& excluded : family.groups[1]) std::erase(members, integer(excluded));
    for (const Expression& set : family.groups[2]) {
        const Set excluded = set_of(set);
        std::erase_if(members, [&](long long i) { return std::ranges::find(excluded, i) != excluded.end(); });
    }
    return members;
}

std::string Grounder::full_name(const Expression& name) {
    if (name.children.empty()) return name.name;
    std::vector<std::string> indices;
    indices.reserve(name.children.size());
    for (const Expression& index : name.children) indices.push_back(std::to_string(integer(index)));
    if (indices.size() == 1 && indices[0].front() != '-') return name.name + "_" + indices[0];
    std::string list;
    for (const std::string& index : indices) list += (list.empty() ? "" : ",") + index;
    return name.name + "_{" + list + "}";
}

}  // namespace blossom::proofs
