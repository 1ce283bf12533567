#include "names.hpp"

#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <functional>

#include "functions.hpp"

namespace blossom::proofs {

namespace {

[[noreturn]] void refuse_name(const std::string& message, std::size_t offset) {
    throw Error(ErrorCode::syntax, message, {}, offset);
}

Meaning meaning_of(StatementKind kind) {
    switch (kind) {
        case StatementKind::parameter:
            return Meaning::parameter;
        case StatementKind::point:
            return Meaning::point;
        case StatementKind::vector:
            return Meaning::vector;
        case StatementKind::frame:
            return Meaning::frame;
        case StatementKind::let:
            return Meaning::let;
        case StatementKind::number:
            return Meaning::number;
        default:
            return Meaning::map;
    }
}

/// Whether an index of a clause is a bare name.
bool is_open_index(const Expression& index) {
    return index.kind == ExpressionKind::name && index.children.empty();
}

bool contains_name(const Expression& e) {
    return e.kind == ExpressionKind::name || std::ranges::any_of(e.children, contains_name);
}

}  // namespace

Names::Names(const Block& block) {
    for (const Statement& statement : block.statements) declare(statement);
    // The control points of a net are numbers, unless a line declares them otherwise.
    for (const Statement& statement : block.statements) {
        if (!statement.net.empty() && !family(statement.net) && !clauses(statement.net))
            families_.emplace(statement.net, Declared{Meaning::number, {&statement}, {}});
    }
}

const Declared* Names::bare(const std::string& name) const {
    const auto found = bare_.find(name);
    return found == bare_.end() ? nullptr : &found->second;
}

const Declared* Names::family(const std::string& name) const {
    const auto found = families_.find(name);
    if (found != families_.end()) return &found->second;
    if (clauses_.contains(name)) return nullptr;
    const Declared* declared = bare(name);
    const bool spreads =
        declared && (declared->meaning == Meaning::number || declared->meaning == Meaning::point ||
                     declared->meaning == Meaning::vector);
    return spreads ? declared : nullptr;
}

const std::vector<const Statement*>* Names::clauses(const std::string& name) const {
    const auto found = clauses_.find(name);
    return found == clauses_.end() ? nullptr : &found->second;
}

void Names::declare_bare(const std::string& name, Meaning meaning, const Statement& statement,
                         std::size_t offset) {
    const bool reserved =
        name == "delta" || name == "all" || is_function(name) || (name == "D" && meaning == Meaning::map);
    if (reserved) {
        refuse_name(quoted(name) + " is a word of the language and cannot be declared", offset);
    }
    if (!bare_.try_emplace(name, Declared{meaning, {&statement}, {}}).second)
        refuse_name(quoted(name) + " is declared already", offset);
}

void Names::declare_member(const Expression& name_or_run, Meaning meaning, const Statement& statement) {
    const Expression& name = name_or_run.kind == ExpressionKind::run ? name_or_run.children[0] : name_or_run;
    if (name.children.empty()) {
        declare_bare(name.name, meaning, statement, name.offset);
        return;
    }
    Declared& family = families_.try_emplace(name.name, Declared{meaning, {}, {}}).first->second;
    const bool agrees = family.meaning == meaning &&
                        (family.statements.empty() || family.statements[0]->dimension == statement.dimension);
    if (!agrees) {
        refuse_name("the members of " + name.name + "_i are declared already, as something else",
                    name.offset);
    }
    if (std::ranges::any_of(family.members, [&](const Expression* known) { return *known == name_or_run; }))
        refuse_name(quoted(name.name) + " with these indices is declared already", name.offset);
    family.statements.push_back(&statement);
    family.members.push_back(&name_or_run);
}

/// Two names as indices fit the same members, unless one of them is a parameter or occurs several times.
bool Names::fit_same_members(const std::vector<Expression>& a, const std::vector<Expression>& b) const {
    const auto is_any = [&](const Expression& index) {
        const Declared* known = is_open_index(index) ? bare(index.name) : nullptr;
        return is_open_index(index) && (!known || known->meaning != Meaning::parameter);
    };
    const auto first_place = [](const std::vector<Expression>& indices, std::size_t place) {
        return std::ranges::find(indices, indices[place].name, &Expression::name) - indices.begin();
    };
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const bool any = is_any(a[i]) && is_any(b[i]);
        if (any ? first_place(a, i) != first_place(b, i) : a[i] != b[i]) return false;
    }
    return true;
}

void Names::declare_let(const Statement& statement) {
    const Expression& name = statement.sides[0];
    if (name.kind != ExpressionKind::name) refuse_name("an abbreviation has a name, not a run", name.offset);
    if (name.children.empty()) {
        declare_bare(name.name, Meaning::let, statement, name.offset);
        return;
    }
    auto& clauses = clauses_[name.name];
    for (const Statement* known : clauses) {
        if (fit_same_members(known->sides[0].children, name.children))
            refuse_name(quoted(name.name) + " with these indices is declared already", name.offset);
    }
    clauses.push_back(&statement);
}

void Names::declare(const Statement& statement) {
    const Meaning meaning = meaning_of(statement.kind);
    switch (statement.kind) {
        case StatementKind::parameter:
            declare_bare(statement.ranges[0].name, meaning, statement, statement.ranges[0].offset);
            break;
        case StatementKind::map:
            for (const std::string& name : statement.names)
                declare_bare(name, meaning, statement, statement.offset);
            break;
        case StatementKind::polynomial:
            declare_bare(statement.names[0], meaning, statement, statement.offset);
            break;
        case StatementKind::raise:
            declare_bare(statement.names[1], meaning, statement, statement.offset);
            break;
        case StatementKind::point:
        case StatementKind::vector:
        case StatementKind::frame:
        case StatementKind::number:
            for (const Expression& name : statement.expressions) declare_member(name, meaning, statement);
            break;
        case StatementKind::let:
            declare_let(statement);
            break;
        default:
            break;
    }
}

bool has_open_index(const std::vector<const Statement*>& clauses, std::size_t indices) {
    return std::ranges::any_of(clauses, [&](const Statement* clause) {
        const auto& patterns = clause->sides[0].children;
        return patterns.size() == indices && std::ranges::any_of(patterns, contains_name);
    });
}

bool may_fit(const std::vector<const Statement*>& clauses, const Expression& member) {
    const auto differ = [](const Expression& pattern, const Expression& index) {
        return pattern.kind == ExpressionKind::number && index.kind == ExpressionKind::number &&
               pattern.name != index.name;
    };
    return std::ranges::any_of(clauses, [&](const Statement* clause) {
        const auto& patterns = clause->sides[0].children;
        if (patterns.size() != member.children.size()) return false;
        for (std::size_t i = 0; i < patterns.size(); ++i) {
            if (differ(patterns[i], member.children[i])) return false;
        }
        return true;
    });
}

}  // namespace blossom::proofs
