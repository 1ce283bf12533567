#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include "kinds.hpp"

/// The kinds of numbers, names, sums and products.

namespace blossom::proofs {

Kind Kinds::infer(const Expression& e) { return known_[&e] = inferred(e); }

Kind Kinds::inferred(const Expression& e) {
    switch (e.kind) {
        case ExpressionKind::number:
            return std::ranges::all_of(e.name, [](char c) { return c >= '0' && c <= '9'; }) ? integer_kind
                                                                                            : number_kind;
        case ExpressionKind::name:
            return e.children.empty() ? name(e) : member(e);
        case ExpressionKind::negative: {
            const Kind kind = infer(e.children[0]);
            if (kind.name == KindName::point) return {KindName::pair, kind.dimension};
            if (kind.is_number() || kind.is_geometric() || kind.name == KindName::unknown) return kind;
            refuse_kind(to_text(kind) + " has no negative", e.offset);
        }
        case ExpressionKind::sum:
            return sum(e);
        case ExpressionKind::product:
            return product(e);
        case ExpressionKind::power: {
            const Kind base = require_number(e.children[0]);
            require_integer(e.children[1]);
            return base;
        }
        case ExpressionKind::pair:
            for (const Expression& entry : e.children) require_number(entry);
            return {KindName::pair, 1};
        case ExpressionKind::point:
            for (const Expression& entry : e.children) require_number(entry);
            return {KindName::point, e.children.size()};
        case ExpressionKind::call:
            return call(e);
        case ExpressionKind::value:
            return value(e);
        case ExpressionKind::blossom:
            return blossom(e);
        case ExpressionKind::derivative:
            return derivative(e);
        case ExpressionKind::comparison:
            refuse_kind("a comparison stands in if(...) only", e.offset);
        case ExpressionKind::copies:
        case ExpressionKind::run:
        case ExpressionKind::family:
            break;
    }
    refuse_kind("copies, runs and families stand among the arguments of a blossom only", e.offset);
}

Kind Kinds::name(const Expression& e) {
    const auto local = scope_.find(e.name);
    if (local != scope_.end() && !local->second.empty()) return local->second.back();
    if (e.name == "delta") return {KindName::vector, 1};
    const Declared* known = names_.bare(e.name);
    if (known && known->meaning == Meaning::map) {
        refuse_kind(quoted(e.name) + " is a map, expected an expression such as " + e.name + "(t) or " +
                        e.name + "[...]",
                    e.offset);
    }
    if (known) return known->meaning == Meaning::let ? bare_lets_[e.name] : declared(*known);
    if (block_.strict)
        refuse_kind(quoted(e.name) + " is not declared; in a strict text every name is", e.offset);
    return number_kind;
}

Kind Kinds::member(const Expression& e) {
    for (const Expression& index : e.children) require_integer(index);
    const auto local = family_scope_.find(e.name);
    if (local != family_scope_.end() && !local->second.empty()) return local->second.back();
    const auto* clauses = names_.clauses(e.name);
    if (clauses && (may_fit(*clauses, e) || family_lets_[e.name].is_geometric())) return family_lets_[e.name];
    if (const Declared* known = names_.family(e.name)) return declared(*known);
    if (block_.strict)
        refuse_kind(quoted(e.name) + "_i is not declared; in a strict text every name is", e.offset);
    return number_kind;
}

Kind Kinds::declared(const Declared& declared) {
    const Statement& statement = *declared.statements.front();
    switch (declared.meaning) {
        case Meaning::parameter:
            return integer_kind;
        case Meaning::point:
        case Meaning::frame:
            return {KindName::point, count_(statement.dimension[0])};
        case Meaning::vector:
            return {KindName::vector, count_(statement.dimension[0])};
        default:
            return number_kind;
    }
}

/// Masses are added: a point plus a vector is a point, a point minus a point a vector, and the sum of two
/// points a pair.
Kind Kinds::sum(const Expression& e) {
    Kind kind = infer(e.children[0]);
    for (std::size_t i = 1; i < e.children.size(); ++i)
        kind = sum(kind, infer(e.children[i]), e.name[i - 1] == '-', e.offset);
    return kind;
}

Kind Kinds::sum(Kind a, Kind b, bool difference, std::size_t offset) {
    if (a.name == KindName::unknown || b.name == KindName::unknown) {
        const Kind known = a.name == KindName::unknown ? b : a;
        return known.name == KindName::point ? Kind{KindName::pair, known.dimension} : known;
    }
    if (a.is_number() && b.is_number()) return a == b ? a : number_kind;
    // A number beside a point or vector of the line is the point with this coordinate.
    for (Kind* kind : {&a, &b}) {
        if (kind->is_number()) *kind = {KindName::point, 1};
    }
    if (!a.is_geometric() || !b.is_geometric() || a.dimension != b.dimension)
        refuse_kind(to_text(a) + " and " + to_text(b) + " cannot be added", offset);
    const auto mass = [](const Kind& kind) { return kind.name == KindName::point ? 1 : 0; };
    if (a.name == KindName::pair || b.name == KindName::pair) return {KindName::pair, a.dimension};
    const int sum = mass(a) + (difference ? -mass(b) : mass(b));
    return {sum == 0 ? KindName::vector : sum == 1 ? KindName::point : KindName::pair, a.dimension};
}

Kind Kinds::product(const Expression& e) {
    Kind kind = infer(e.children[0]);
    for (std::size_t i = 1; i < e.children.size(); ++i) {
        const Kind next = infer(e.children[i]);
        kind = e.name[i - 1] == '*' ? product(kind, next, e.offset)
                                    : quotient(kind, next, e.offset, e.children[i].offset);
    }
    return kind;
}

Kind Kinds::product(const Kind& a, const Kind& b, std::size_t offset) {
    if (a.is_number() && b.is_number()) return a == b ? a : number_kind;
    if (a.name == KindName::unknown && b.name == KindName::unknown) return a;
    if (a.is_geometric() && b.is_geometric())
        refuse_kind("two points or vectors cannot be multiplied", offset);
    for (const Kind& kind : {a, b}) {
        if (kind.is_geometric())
            return {kind.name == KindName::vector ? kind.name : KindName::pair, kind.dimension};
        if (!kind.is_number() && kind.name != KindName::unknown)
            refuse_kind(to_text(kind) + " cannot be multiplied", offset);
    }
    return {};
}

Kind Kinds::quotient(const Kind& a, const Kind& b, std::size_t offset, std::size_t divisor_offset) {
    if (!b.is_number() && b.name != KindName::unknown)
        refuse_kind(to_text(b) + " cannot divide", divisor_offset);
    if (a.is_geometric()) return {a.name == KindName::vector ? a.name : KindName::pair, a.dimension};
    if (a.is_number()) return a == b ? a : number_kind;
    if (a.name == KindName::unknown) return a;
    refuse_kind(to_text(a) + " cannot be divided", offset);
}

void Kinds::require_integer(const Expression& e) {
    const Kind kind = infer(e);
    if (kind.name == KindName::integer || kind.name == KindName::unknown) return;
    refuse_kind(kind.name == KindName::number ? "an expression with variables found, expected an integer"
                                              : to_text(kind) + " found, expected an integer",
                e.offset);
}

Kind Kinds::require_number(const Expression& e) {
    const Kind kind = infer(e);
    if (kind.is_number() || kind.name == KindName::unknown) return kind;
    refuse_kind(to_text(kind) + " found, expected a number", e.offset);
}

void Kinds::require_set(const Expression& e) {
    const Kind kind = infer(e);
    if (kind.name != KindName::set)
        refuse_kind(to_text(kind) + " found, expected a set of integers", e.offset);
}

}  // namespace blossom::proofs
