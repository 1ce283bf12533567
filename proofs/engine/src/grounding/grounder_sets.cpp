#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/lists.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <numeric>

#include "grounder.hpp"

/// Integers, sets, and the elements over which names run.

namespace blossom::proofs {

namespace {

Set interval_to(std::size_t n) {
    Set members(n);
    std::iota(members.begin(), members.end(), 1LL);
    return members;
}

}  // namespace

void require_elements(const Integer& elements, const Limits& limits, std::size_t offset) {
    if (elements <= Integer(limits.expansion_terms)) return;
    throw limit_error("the number of elements or cases exceeds", "expansion_terms", limits.expansion_terms,
                      {}, offset);
}

Grounder::Binding::Binding(Grounder& grounder, const std::string& name, Bound value)
    : grounder_(grounder), name_(name) {
    auto& bound = grounder_.bound_;
    const auto known = bound.find(name);
    if (known != bound.end()) hidden_ = std::move(known->second);
    bound[name] = std::move(value);
    const auto taken = grounder_.variables_.find(name);
    if (taken == grounder_.variables_.end()) return;
    hidden_variable_ = taken->second;
    grounder_.variables_.erase(taken);
}

Grounder::Binding::~Binding() {
    if (hidden_) {
        grounder_.bound_[name_] = std::move(*hidden_);
    } else {
        grounder_.bound_.erase(name_);
    }
    if (hidden_variable_) grounder_.variables_[name_] = std::move(*hidden_variable_);
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
                    {}, e.offset);
    }
    return *word;
}

std::size_t Grounder::count(const Expression& e) {
    const long long value = integer(e);
    if (value < 0) {
        throw Error(ErrorCode::syntax, "a count or degree is at least 0, this is " + std::to_string(value),
                    {}, e.offset);
    }
    if (static_cast<std::size_t>(value) > limits_.degree) {
        throw limit_error("the number " + std::to_string(value) + " exceeds", "degree", limits_.degree, {},
                          e.offset);
    }
    return static_cast<std::size_t>(value);
}

Set Grounder::interval(const Expression& first, const Expression& last) {
    const long long low = integer(first);
    const long long high = integer(last);
    Set members;
    if (high < low) return members;
    require_elements(Integer(high) - Integer(low) + Integer(1), limits_, first.offset);
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
    if (e.kind != ExpressionKind::call || e.name != "without")
        refuse("a set of integers is expected here", e.offset);
    Set members = interval_to(count(e.children[0]));
    const Set excluded = set_of(e.children[1]);
    std::erase_if(members, [&](long long i) { return std::ranges::find(excluded, i) != excluded.end(); });
    return members;
}

/// 1..n for an integer n, or the set itself.
Set Grounder::base_set(const Expression& e) {
    if (kinds_->of(e).name == KindName::set) return set_of(e);
    const std::size_t n = count(e);
    require_elements(Integer(n), limits_, e.offset);
    return interval_to(n);
}

const Permutation* Grounder::permutation(const std::string& name) const {
    const Bound* value = bound(name);
    return value ? std::get_if<Permutation>(value) : nullptr;
}

/// The elements over which a sum over `e` runs: the members of a set, subsets, partitions and their blocks,
/// or permutations.
std::vector<Bound> Grounder::elements_of(const Expression& e) {
    if (e.kind == ExpressionKind::call) {
        if (e.name == "subsets") return subsets(e);
        if (e.name == "partitions") return partitions(e);
        if (e.name == "permutations") return permutations(e);
    }
    std::vector<Bound> elements;
    const Bound* value = e.kind == ExpressionKind::name && e.children.empty() ? bound(e.name) : nullptr;
    if (const auto* blocks = value ? std::get_if<std::vector<Set>>(value) : nullptr) {
        elements.assign(blocks->begin(), blocks->end());
    } else {
        for (const long long member : set_of(e)) elements.emplace_back(member);
    }
    return elements;
}

/// Every subset with k members, in lexicographic order.
std::vector<Bound> Grounder::subsets(const Expression& e) {
    std::vector<Bound> elements;
    const Set base = base_set(e.children[0]);
    const std::size_t n = base.size();
    const long long size = integer(e.children[1]);
    if (size < 0 || static_cast<std::size_t>(size) > n) return elements;
    const auto k = static_cast<std::size_t>(size);
    require_elements(binomial(n, k), limits_, e.offset);
    std::vector<std::size_t> places(k);
    std::iota(places.begin(), places.end(), std::size_t{0});
    while (true) {
        Set members;
        for (const std::size_t place : places) members.push_back(base[place]);
        elements.emplace_back(std::move(members));
        // The last position that can increase does so, and those behind it take the next values.
        std::size_t i = k;
        while (i > 0 && places[i - 1] == n - k + i - 1) --i;
        if (i == 0) return elements;
        std::iota(places.begin() + static_cast<std::ptrdiff_t>(i) - 1, places.end(), places[i - 1] + 1);
    }
}

/// Every partition into non-empty blocks, ordered by their least members: each member in turn joins a block
/// or begins one.
std::vector<Bound> Grounder::partitions(const Expression& e) {
    std::vector<std::vector<Set>> found{{}};
    for (const long long member : base_set(e.children[0])) {
        std::vector<std::vector<Set>> longer;
        for (const std::vector<Set>& blocks : found) {
            for (std::size_t i = 0; i <= blocks.size(); ++i) {
                require_elements(longer.size() + 1, limits_, e.offset);
                longer.push_back(blocks);
                if (i == blocks.size()) longer.back().emplace_back();
                longer.back()[i].push_back(member);
            }
        }
        found = std::move(longer);
    }
    return {found.begin(), found.end()};
}

std::vector<Bound> Grounder::permutations(const Expression& e) {
    const std::size_t n = count(e.children[0]);
    require_within(n, limits_.nesting, "nesting", "the number of permuted integers");
    require_elements(factorial(n), limits_, e.offset);
    std::vector<Bound> elements;
    Set images = interval_to(n);
    do elements.emplace_back(Permutation{images});
    while (std::ranges::next_permutation(images).found);
    return elements;
}

/// Whether the condition of if(...) holds.
bool Grounder::holds(const Expression& comparison) {
    const long long left = integer(comparison.children[0]);
    const Expression& other = comparison.children[1];
    if (comparison.name.ends_with("in")) {
        const Set set = set_of(other);
        return (std::ranges::find(set, left) != set.end()) == (comparison.name == "in");
    }
    const long long right = integer(other);
    if (comparison.name == "==") return left == right;
    if (comparison.name == "!=") return left != right;
    if (comparison.name == "<") return left < right;
    if (comparison.name == "<=") return left <= right;
    return comparison.name == ">" ? left > right : left >= right;
}

/// The values of the last argument of sum, prod or mean.
std::vector<Value> Grounder::over_range(const Expression& call) {
    std::vector<Bound> elements;
    if (call.children.size() == 4) {
        for (const long long i : interval(call.children[1], call.children[2])) elements.emplace_back(i);
    } else {
        elements = elements_of(call.children[1]);
    }
    std::vector<Value> values;
    values.reserve(elements.size());
    for (Bound& element : elements) {
        const Binding binding(*this, call.children[0].name, std::move(element));
        values.push_back(value(call.children.back()));
    }
    return values;
}

/// t_1..t_n with the last index running; descending or empty if the end is before the beginning.
std::vector<Expression> Grounder::run_members(const Expression& run) {
    check_run(run);
    const Expression& first = run.children[0];
    const Expression& last = run.children[1];
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
    const std::string list = joined(indices, std::identity(), ",");
    return name.name + "_{" + list + "}";
}

}  // namespace blossom::proofs
