#include "second_names.hpp"

#include <blossom/rational/error.hpp>
#include <blossom/rational/limits.hpp>

#include <algorithm>
#include <utility>

namespace blossom::proofs::second {

// The least kinds for which every line is correct, since an abbreviation may use itself. Integers are
// numbers; an unknown kind is below both.
void NameTable::decide_kinds() {
    std::size_t work = 0;
    do {
        work += reading_.nodes_.size();
        require_within(work, reading_.limits_.expansion_work, "expansion_work", "the work of finding kinds");
    } while (improve_abbreviations());
    check_ = true;
    for (const Range& range : reading_.parameters_) require_integers({range.low, range.high});
    for (const Declaration& declaration : reading_.declarations_) {
        if (declaration.dimension) require_integers({*declaration.dimension});
        for (const auto& [first, last] : declaration.runs) {
            require_integers(first);
            require_integers(last);
        }
    }
    for (const MapDeclaration& map : reading_.maps_) {
        require_integers(map.degrees);
        if (map.dimension) require_integers({*map.dimension});
        if (map.kind == MapDeclaration::Kind::polynomial) require(map.body, Kind::number, "a polynomial");
        if (map.kind != MapDeclaration::Kind::net) continue;
        infer(map.body);
        require(map.control_points, Kind::number, "the family of a net");
    }
    improve_abbreviations();
    for (const auto* statements : {&reading_.hypotheses_, &reading_.assumptions_, &reading_.claims_}) {
        for (const Statement& statement : *statements) {
            for (const Range& range : statement.ranges) require_integers({range.low, range.high});
            for (const Quantified& quantified : statement.for_all) {
                require_integers(quantified.first);
                require_integers(quantified.last);
            }
            require(statement.left, Kind::number, "a side of an equation");
            require(statement.right, Kind::number, "a side of an equation");
        }
    }
}

bool NameTable::improve_abbreviations() {
    bool changed = false;
    for (Abbreviation& let : reading_.abbreviations_) {
        Kind kind = Kind::unknown;
        for (const Clause& clause : let.clauses) {
            for (const std::optional<NodeId>& pattern : clause.patterns) {
                if (pattern) require_integers({*pattern});
            }
            kind = join(kind, require_value(clause.body), clause.offset);
        }
        if (let.declaration) {
            const Kind declared = kind_of_declaration(*let.declaration);
            const bool fits = kind == Kind::unknown || is_number_kind(kind) == is_number_kind(declared);
            if (!fits && let.inherits) {
                let.declaration.reset();
            } else {
                const Kind least = declared == Kind::number ? Kind::possible_integer : declared;
                kind = join(kind, least, let.clauses.front().offset);
            }
        }
        changed = changed || kind != let.kind;
        let.kind = kind;
    }
    return changed;
}

Kind NameTable::kind_of_declaration(std::uint32_t declaration) const {
    return reading_.declarations_[declaration].kind == Declaration::Kind::number ? Kind::number
                                                                                 : Kind::geometric;
}

Kind NameTable::join(Kind one, Kind other, std::size_t offset) const {
    const Kind greater = std::max(one, other);
    const Kind lesser = std::min(one, other);
    if (greater == Kind::geometric && lesser != Kind::geometric && lesser != Kind::unknown && check_) {
        throw Error(ErrorCode::wrong_kind, "a number here and a point or vector there", {}, offset);
    }
    return greater;
}

Kind NameTable::infer(NodeId id) {
    const Node& current = node(id);
    Kind kind = Kind::number;
    switch (current.form) {
        case Form::number:
            kind = current.value.is_integer() ? Kind::integer : Kind::number;
            break;
        case Form::name:
            kind = infer_name(current);
            break;
        case Form::member:
            require_integers(current.children);
            kind = infer_name(current);
            break;
        case Form::unit_vector:
            kind = Kind::geometric;
            break;
        case Form::pair:
        case Form::tuple:
            for (const NodeId child : current.children) require(child, Kind::number, "a coordinate");
            kind = Kind::geometric;
            break;
        case Form::terms:
            kind = infer_terms(current);
            break;
        case Form::factors:
            kind = infer_factors(current);
            break;
        case Form::negation:
            kind = require_value(current.children.front());
            break;
        case Form::power:
            kind = infer_power(current);
            break;
        case Form::sum:
        case Form::product:
        case Form::mean:
            kind = infer_iteration(current);
            break;
        case Form::choice:
            kind = infer_choice(current);
            break;
        default:
            kind = infer_other(current);
            break;
    }
    node(id).kind = kind;
    return kind;
}

Kind NameTable::infer_name(const Node& name) {
    switch (name.meaning) {
        case Meaning::local:
            return name.kind;
        case Meaning::parameter:
            return Kind::integer;
        case Meaning::abbreviation:
            return kind_of_abbreviation(name);
        case Meaning::declared:
            return kind_of_declaration(name.target);
        default:
            return Kind::number;
    }
}

// If every pattern is a constant, a member that fits no clause is a free number.
Kind NameTable::kind_of_abbreviation(const Node& name) const {
    const Abbreviation& let = reading_.abbreviations_[name.target];
    if (let.bare || let.kind > Kind::integer) return let.kind;
    const bool fits_any = std::ranges::any_of(let.clauses, [&](const Clause& clause) {
        return clause.patterns.size() == name.children.size() && !clause.pattern_names.empty();
    });
    return fits_any ? let.kind : Kind::possible_integer;
}

Kind NameTable::infer_terms(const Node& terms) {
    Kind kind = Kind::unknown;
    for (const NodeId child : terms.children) kind = std::max(kind, require_value(child));
    return kind;
}

Kind NameTable::infer_factors(const Node& factors) {
    Kind kind = Kind::unknown;
    for (std::size_t i = 0; i < factors.children.size(); ++i) {
        const Kind child = require_value(factors.children[i]);
        if (child == Kind::geometric && check_ && (kind == Kind::geometric || factors.flags[i])) {
            throw Error(ErrorCode::wrong_kind,
                        "points and vectors are multiplied and divided by numbers only", {},
                        node(factors.children[i]).offset);
        }
        kind = std::max(kind, child);
    }
    return kind;
}

Kind NameTable::infer_power(const Node& power) {
    const Kind base = require(power.children[0], Kind::number, "the base of a power");
    require(power.children[1], Kind::integer, "an exponent");
    return base;
}

Kind NameTable::infer_choice(const Node& choice) {
    infer(choice.children[0]);
    return join(require_value(choice.children[1]), require_value(choice.children[2]), choice.offset);
}

Kind NameTable::infer_iteration(const Node& iteration) {
    require_set(iteration.children[0]);
    if (iteration.form == Form::product) return require(iteration.children[1], Kind::number, "a factor");
    return require_value(iteration.children[1]);
}

Kind NameTable::require(NodeId id, Kind kind, const char* what) {
    const Kind found = infer(id);
    const bool fits = kind == Kind::number    ? is_number_kind(found)
                      : kind == Kind::integer ? found <= Kind::possible_integer
                                              : found == kind;
    if (!fits && check_) {
        throw Error(ErrorCode::wrong_kind,
                    std::string(what) + (kind == Kind::integer ? " must be an integer" : " has another kind"),
                    {}, node(id).offset);
    }
    return found;
}

Kind NameTable::require_value(NodeId id) {
    const Kind found = infer(id);
    if (found > Kind::geometric && check_) {
        throw Error(ErrorCode::wrong_kind, "a number, a point or a vector is expected here", {},
                    node(id).offset);
    }
    return found;
}

void NameTable::require_integers(const std::vector<NodeId>& children) {
    for (const NodeId child : children) require(child, Kind::integer, "this");
}

}  // namespace blossom::proofs::second
