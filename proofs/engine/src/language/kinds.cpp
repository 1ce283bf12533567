#include "kinds.hpp"

#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <optional>

namespace blossom::proofs {

namespace {

/// The common kind of two alternatives, such as the branches of a choice or the clauses of an abbreviation.
std::optional<Kind> joined(const Kind& a, const Kind& b) {
    if (a == b || b.name == KindName::unknown) return a;
    if (a.name == KindName::unknown) return b;
    if (a.is_number() && b.is_number()) return number_kind;
    if (a.is_geometric() && b.is_geometric() && a.dimension == b.dimension)
        return Kind{KindName::pair, a.dimension};
    return std::nullopt;
}

}  // namespace

void refuse_kind(const std::string& message, std::size_t offset) {
    throw Error(ErrorCode::syntax, message, {}, offset);
}

std::string to_text(const Kind& kind) {
    const auto of_dimension = [&](std::string_view what) {
        return std::string(what) + " of dimension " + std::to_string(kind.dimension);
    };
    switch (kind.name) {
        case KindName::unknown:
            return "an abbreviation that refers to itself";
        case KindName::integer:
            return "an integer";
        case KindName::number:
            return "a number";
        case KindName::point:
            return of_dimension("a point");
        case KindName::vector:
            return of_dimension("a vector");
        case KindName::pair:
            return of_dimension("a pair");
        case KindName::set:
            return "a set";
        case KindName::sets:
            return "a collection of sets";
        case KindName::partitions:
            return "a collection of partitions";
        case KindName::permutation:
            return "a permutation";
        case KindName::permutations:
            return "a collection of permutations";
    }
    return "";
}

Kinds::Kinds(const Block& block, const Names& names, std::function<std::size_t(const Expression&)> count)
    : block_(block), names_(names), count_(std::move(count)) {
    for (const Statement& statement : block.statements) {
        if (statement.kind == StatementKind::map) {
            Dimensions dimensions(statement.expressions.size(), 1);
            if (!statement.dimension.empty()) dimensions[0] = count_(statement.dimension[0]);
            for (const std::string& name : statement.names) add_map(name, dimensions);
        } else if (statement.kind == StatementKind::polynomial) {
            const std::size_t variables = statement.names.size() - 1;
            add_map(statement.names[0],
                    statement.expressions.size() == 1 ? Dimensions{variables} : Dimensions(variables, 1));
        } else if (statement.kind == StatementKind::raise) {
            if (const Dimensions* source = map_named(statement.names[0]))
                add_map(statement.names[1], *source);
        }
    }
    infer_abbreviations(block);
    for (const Statement& statement : block.statements) check(statement);
}

Kind Kinds::of(const Expression& e) const {
    const auto found = known_.find(&e);
    return found == known_.end() ? Kind{} : found->second;
}

Kind Kinds::of_family(const std::string& name) const {
    const auto found = family_lets_.find(name);
    return found == family_lets_.end() ? Kind{} : found->second;
}

const Dimensions* Kinds::map_named(const std::string& name) const {
    const auto found = maps_.find(name);
    return found == maps_.end() ? nullptr : &found->second;
}

/// Starts with unknown kinds and repeats until nothing changes. Kinds only grow: from integer to number, and
/// from point and vector to pair.
void Kinds::infer_abbreviations(const Block& block) {
    for (bool changed = true; changed;) {
        changed = false;
        for (const Statement& clause : block.statements) {
            if (clause.kind != StatementKind::let) continue;
            const Expression& name = clause.sides[0];
            Kind& known = (name.children.empty() ? bare_lets_ : family_lets_)[name.name];
            const Kind found = clause_kind(clause);
            const std::optional<Kind> both = joined(known, found);
            if (!both) {
                refuse_kind("this line makes " + name.name + "_i " + to_text(found) +
                                ", another one makes it " + to_text(known),
                            clause.sides[1].offset);
            }
            changed = changed || *both != known;
            known = *both;
        }
    }
    for (const auto& [name, kind] : family_lets_) {
        const Declared* family = names_.family(name);
        if (!family) continue;
        const Kind expected = declared(*family);
        const std::optional<Kind> both = joined(expected, kind);
        if (!both || (expected.is_geometric() && *both != expected)) {
            refuse_kind(
                name + "_i is declared as " + to_text(expected) + ", and abbreviates " + to_text(kind),
                names_.clauses(name)->front()->sides[1].offset);
        }
    }
}

Kind Kinds::clause_kind(const Statement& clause) {
    Scope scope(*this);
    for (const Expression& index : clause.sides[0].children) {
        const bool open = index.kind == ExpressionKind::name && index.children.empty();
        const Declared* known = open ? names_.bare(index.name) : nullptr;
        if (open && (!known || known->meaning != Meaning::parameter)) {
            scope.add(index.name, integer_kind);
        } else {
            require_integer(index);
        }
    }
    const Kind kind = infer(clause.sides[1]);
    if (!kind.is_number() && !kind.is_geometric() && kind.name != KindName::unknown) {
        refuse_kind(to_text(kind) + " found; an abbreviation stands for a number, point, vector or pair",
                    clause.sides[1].offset);
    }
    return kind;
}

void Kinds::check(const Statement& statement) {
    switch (statement.kind) {
        case StatementKind::parameter:
        case StatementKind::let:
            break;
        case StatementKind::number:
        case StatementKind::frame:
        case StatementKind::point:
        case StatementKind::vector:
            check_members(statement);
            break;
        case StatementKind::map:
            for (const Expression& degree : statement.expressions) require_integer(degree);
            for (const Expression& point : statement.frame) argument(point, maps_.at(statement.names[0])[0]);
            break;
        case StatementKind::polynomial:
            check_polynomial(statement);
            break;
        case StatementKind::raise:
            for (const Expression& degree : statement.expressions) require_integer(degree);
            if (!map_named(statement.names[0]))
                refuse_kind("there is no map " + quoted(statement.names[0]), statement.offset);
            break;
        case StatementKind::claim:
        case StatementKind::refute:
            try {
                check_relation(statement);
            } catch (const Error& error) {
                unfit_.emplace(&statement, error);
            }
            break;
        default:
            check_relation(statement);
    }
}

void Kinds::check_members(const Statement& statement) {
    for (const Expression& name : statement.expressions) {
        const bool run = name.kind == ExpressionKind::run;
        for (const Expression& end : run ? name.children : std::vector<Expression>{name}) {
            for (const Expression& index : end.children) require_integer(index);
        }
        if (statement.kind == StatementKind::frame && (run || !name.children.empty()))
            refuse_kind("the points of a frame have names without indices", name.offset);
    }
    if (statement.kind != StatementKind::frame) return;
    const std::size_t dimension = count_(statement.dimension[0]);
    if (statement.expressions.size() != dimension + 1) {
        refuse_kind("a frame of a space of dimension " + std::to_string(dimension) + " has " +
                        std::to_string(dimension + 1) + " points, not " +
                        std::to_string(statement.expressions.size()),
                    statement.offset);
    }
}

void Kinds::check_polynomial(const Statement& statement) {
    for (const Expression& degree : statement.expressions) require_integer(degree);
    Scope scope(*this);
    for (std::size_t i = 1; i < statement.names.size(); ++i) {
        const Declared* known = names_.bare(statement.names[i]);
        const auto first = statement.names.begin() + 1;
        const auto place = first + static_cast<std::ptrdiff_t>(i) - 1;
        if ((known && known->meaning != Meaning::number) || std::find(first, place, *place) != place)
            refuse_kind(quoted(statement.names[i]) + " is declared already", statement.offset);
        if (statement.names[i] == "delta")
            refuse_kind("\"delta\" is a word of the language, not a variable", statement.offset);
        scope.add(statement.names[i], number_kind);
    }
    require_number(statement.sides[0]);
}

void Kinds::check_relation(const Statement& statement) {
    Scope scope(*this);
    for (const Range& range : statement.ranges) {
        require_integer(range.first);
        require_integer(range.last);
        scope.add(range.name, integer_kind);
    }
    for (const Expression& quantified : statement.quantified) {
        const bool run = quantified.kind == ExpressionKind::run;
        const Expression& name = run ? quantified.children[0] : quantified;
        const bool bare = name.children.empty();
        const Declared* known = bare ? names_.bare(name.name) : names_.family(name.name);
        const bool variable = !known || known->meaning == Meaning::number ||
                              known->meaning == Meaning::point || known->meaning == Meaning::vector;
        if (name.kind != ExpressionKind::name || !variable || (bare && name.name == "delta")) {
            refuse_kind("\"for all\" takes variables; " + quoted(name.name) + " is something else",
                        name.offset);
        }
        for (const Expression& index : name.children) require_integer(index);
        const bool abbreviated = !bare && names_.clauses(name.name);
        if (!abbreviated) scope.add(name.name, known ? declared(*known) : number_kind, !bare);
    }
    for (const Expression& side : statement.sides) require_number(side);
}

}  // namespace blossom::proofs
