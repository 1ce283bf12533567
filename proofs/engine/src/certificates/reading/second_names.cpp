#include "second_names.hpp"

#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace blossom::proofs::second {

namespace {

constexpr std::array<std::string_view, 17> words_of_functions = {
    "all",      "delta",      "sum",          "prod",    "mean",        "size",
    "binomial", "factorial",  "bernstein",    "bspline", "determinant", "without",
    "subsets",  "partitions", "permutations", "sign",    "if"};

}  // namespace

std::string NameTable::quoted_name(std::uint32_t name) const { return quoted(reading_.names_[name]); }

void NameTable::resolve() {
    enter_names();
    resolve_parameters();
    resolve_maps();
    resolve_clauses();
    for (Statement& statement : reading_.hypotheses_) resolve_statement(statement);
    for (Statement& statement : reading_.assumptions_) resolve_statement(statement);
    for (Statement& statement : reading_.claims_) resolve_statement(statement);
    decide_kinds();
}

void NameTable::enter_bare(std::uint32_t name, Meaning meaning, std::size_t target, std::size_t offset) {
    if (std::ranges::find(words_of_functions, reading_.names_[name]) != words_of_functions.end()) {
        throw Error(ErrorCode::syntax, quoted_name(name) + " is a word of the language", {}, offset);
    }
    if (!bare_.emplace(name, BareName{meaning, static_cast<std::uint32_t>(target)}).second) {
        throw Error(ErrorCode::syntax, quoted_name(name) + " is declared twice", {}, offset);
    }
}

void NameTable::enter_names() {
    for (std::size_t i = 0; i < reading_.parameters_.size(); ++i) {
        enter_bare(reading_.parameters_[i].name, Meaning::parameter, i,
                   node(reading_.parameters_[i].low).offset);
    }
    for (std::size_t i = 0; i < reading_.maps_.size(); ++i) {
        const MapDeclaration& map = reading_.maps_[i];
        enter_bare(map.name, Meaning::map, i, map.offset);
        if (map.kind == MapDeclaration::Kind::net) families_[map.family].is_net = true;
    }
    enter_declarations();
    enter_abbreviations();
}

void NameTable::enter_declarations() {
    for (std::size_t i = 0; i < reading_.declarations_.size(); ++i) {
        const Declaration& declaration = reading_.declarations_[i];
        const auto place = static_cast<std::uint32_t>(i);
        if (!declaration.bare) {
            merge_declaration(place);
            continue;
        }
        enter_bare(declaration.name, Meaning::declared, i, declaration.offset);
        if (declaration.kind != Declaration::Kind::frame) families_[declaration.name].inherited = place;
    }
}

void NameTable::merge_declaration(std::uint32_t later) {
    Declaration& declaration = reading_.declarations_[later];
    FamilyName& family = families_[declaration.name];
    if (!family.own) {
        family.own = later;
        return;
    }
    Declaration& first = reading_.declarations_[*family.own];
    if (first.kind != declaration.kind) {
        throw Error(ErrorCode::syntax,
                    "the family " + quoted_name(declaration.name) + " is declared with two kinds", {},
                    declaration.offset);
    }
    if (declaration.dimension) first.other_dimensions.push_back(*declaration.dimension);
    first.runs.push_back(declaration.runs.front());
}

void NameTable::enter_abbreviations() {
    for (std::size_t i = 0; i < reading_.abbreviations_.size(); ++i) {
        Abbreviation& let = reading_.abbreviations_[i];
        if (let.bare) {
            enter_bare(let.name, Meaning::abbreviation, i, let.clauses.front().offset);
            continue;
        }
        FamilyName& family = families_[let.name];
        family.abbreviation = static_cast<std::uint32_t>(i);
        let.declaration = family.own ? family.own : family.inherited;
        let.inherits = !family.own && family.inherited.has_value();
    }
}

void NameTable::start_frame() {
    locals_.clear();
    most_locals_ = 0;
}

std::uint32_t NameTable::push(std::uint32_t name, Kind kind) {
    locals_.push_back({name, kind});
    const auto count = static_cast<std::uint32_t>(locals_.size());
    most_locals_ = std::max(most_locals_, count);
    return count - 1;
}

void NameTable::resolve_parameters() {
    start_frame();
    for (const Range& range : reading_.parameters_) {
        resolve(range.low);
        resolve(range.high);
    }
    for (Declaration& declaration : reading_.declarations_) {
        if (declaration.dimension) resolve(*declaration.dimension);
        for (const auto& [first, last] : declaration.runs) {
            for (const NodeId index : first) resolve(index);
            for (const NodeId index : last) resolve(index);
        }
    }
}

void NameTable::resolve_maps() {
    for (MapDeclaration& map : reading_.maps_) {
        start_frame();
        for (const NodeId degree : map.degrees) resolve(degree);
        if (map.dimension) resolve(*map.dimension);
        if (map.kind != MapDeclaration::Kind::polynomial && map.kind != MapDeclaration::Kind::net) continue;
        for (const std::uint32_t variable : map.variables) {
            const auto known = bare_.find(variable);
            const bool is_number =
                known != bare_.end() && known->second.meaning == Meaning::declared &&
                reading_.declarations_[known->second.target].kind == Declaration::Kind::number;
            if (known != bare_.end() && !is_number) {
                throw Error(ErrorCode::syntax,
                            quoted_name(variable) + " is declared, so that it is no variable of a polynomial",
                            {}, map.offset);
            }
            push(variable, Kind::number);
        }
        map_line_ = map.line;
        resolve(map.body);
        if (map.kind == MapDeclaration::Kind::net) resolve(map.control_points);
        map_line_ = static_cast<std::size_t>(-1);
        map.slots = most_locals_;
    }
}

void NameTable::resolve_clauses() {
    for (Abbreviation& let : reading_.abbreviations_) {
        for (Clause& clause : let.clauses) {
            start_frame();
            for (std::optional<NodeId>& pattern : clause.patterns) {
                const Node& index = node(*pattern);
                const auto known = bare_.find(index.text);
                const bool is_parameter = known != bare_.end() && known->second.meaning == Meaning::parameter;
                if (index.form != Form::name || is_parameter) continue;
                clause.pattern_names.push_back(index.text);
                pattern.reset();
            }
            for (const std::optional<NodeId>& pattern : clause.patterns) {
                if (pattern) resolve(*pattern);
            }
            for (const std::uint32_t name : clause.pattern_names) push(name, Kind::integer);
            resolve(clause.body);
            clause.slots = most_locals_;
        }
    }
}

void NameTable::resolve_statement(Statement& statement) {
    start_frame();
    bound_families_.clear();
    for (const Range& range : statement.ranges) {
        resolve(range.low);
        resolve(range.high);
        push(range.name, Kind::integer);
    }
    for (Quantified& quantified : statement.for_all) resolve_quantified(statement, quantified);
    resolve(statement.left);
    resolve(statement.right);
    statement.slots = most_locals_;
    bound_families_.clear();
}

void NameTable::resolve_quantified(Statement& statement, Quantified& quantified) {
    const auto refuse = [&](const std::string& what) {
        throw Error(ErrorCode::syntax,
                    "\"for all\" binds " + quoted_name(quantified.name) + ", which is " + what, {},
                    statement.offset);
    };
    const auto take_kind_of = [&](std::uint32_t place) {
        const Declaration& declaration = reading_.declarations_[place];
        if (declaration.kind == Declaration::Kind::frame) refuse("a point of a frame");
        if (declaration.kind == Declaration::Kind::number) return;
        quantified.kind = Kind::geometric;
        quantified.declaration = place;
    };
    if (!quantified.bare) {
        for (const NodeId index : quantified.first) resolve(index);
        for (const NodeId index : quantified.last) resolve(index);
        const FamilyName& family = families_[quantified.name];
        if (const auto declared = family.own ? family.own : family.inherited) take_kind_of(*declared);
        bound_families_.insert(quantified.name);
        return;
    }
    const auto known = bare_.find(quantified.name);
    if (known != bare_.end()) {
        if (known->second.meaning == Meaning::parameter) refuse("a parameter");
        if (known->second.meaning == Meaning::map) refuse("a map");
        if (known->second.meaning == Meaning::abbreviation) refuse("an abbreviation");
        take_kind_of(known->second.target);
    }
    quantified.slot = push(quantified.name, quantified.kind);
}

void NameTable::undeclared(std::uint32_t name, const std::string& shown, std::size_t offset) const {
    static_cast<void>(name);
    if (!reading_.strict_) return;
    throw Error(ErrorCode::syntax, shown + " is not declared", {}, offset);
}

}  // namespace blossom::proofs::second
