#include "second_parser.hpp"

#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <utility>

namespace blossom::proofs::second {

void Parser::parse_parameter() {
    reading_.parameters_.push_back(parse_range_of(expect_name()));
    require_within(reading_.parameters_.size(), reading_.limits_.nesting, "nesting",
                   "the number of parameters");
}

std::vector<NodeId> Parser::parse_degrees() {
    if (take_word("degree")) return {parse_expression()};
    if (!take_word("degrees")) fail("degree or degrees");
    std::vector<NodeId> degrees{parse_expression()};
    while (take_mark(",")) degrees.push_back(parse_expression());
    return degrees;
}

void Parser::parse_map(std::size_t offset) {
    std::vector<std::pair<std::uint32_t, std::size_t>> names;
    do {
        const std::size_t at = next().offset;
        names.emplace_back(expect_name(), at);
    } while (take_mark(","));
    MapDeclaration map;
    map.line = line_;
    map.offset = offset;
    map.degrees = parse_degrees();
    if (take_word("on")) {
        expect_word("simplex");
        map.dimension = parse_expression();
    }
    if (take_word("net")) parse_net(map);
    if ((map.dimension || map.kind == MapDeclaration::Kind::net) && map.degrees.size() != 1) {
        throw Error(ErrorCode::syntax, "a map on a simplex has one degree", {}, offset);
    }
    if (map.kind == MapDeclaration::Kind::net && names.size() != 1) {
        throw Error(ErrorCode::syntax, "a net belongs to one map", {}, offset);
    }
    for (const auto& [name, at] : names) {
        map.name = name;
        map.offset = at;
        reading_.maps_.push_back(map);
    }
}

void Parser::parse_net(MapDeclaration& map) {
    map.kind = MapDeclaration::Kind::net;
    map.family = expect_name();
    expect_word("over");
    const std::size_t offset = next().offset;
    std::vector<NodeId> points;
    do {
        points.push_back(parse_argument());
    } while (take_mark(","));
    map.body = add(Form::point_list, offset, std::move(points));
    map.control_points = add(Form::member, offset);
    node(map.control_points).text = map.family;
}

std::pair<std::vector<NodeId>, std::vector<NodeId>> Parser::parse_member_run(std::uint32_t name) {
    std::vector<NodeId> first = parse_indices();
    if (!take_mark("..")) return {first, first};
    const std::size_t offset = next().offset;
    if (expect_name() != name) {
        throw Error(ErrorCode::syntax, "a run goes from one member of a family to another", {}, offset);
    }
    std::vector<NodeId> last = parse_indices();
    if (first.size() != last.size()) {
        throw Error(ErrorCode::syntax, "both ends of a run have the same number of indices", {}, offset);
    }
    return {std::move(first), std::move(last)};
}

void Parser::parse_declaration(Declaration::Kind kind, std::size_t offset) {
    const std::size_t first = reading_.declarations_.size();
    do {
        Declaration declaration;
        declaration.kind = kind;
        declaration.offset = next().offset;
        declaration.name = expect_name();
        if (is_mark("_")) {
            declaration.bare = false;
            declaration.runs.push_back(parse_member_run(declaration.name));
        }
        reading_.declarations_.push_back(std::move(declaration));
    } while (take_mark(","));
    if (kind == Declaration::Kind::number) return;
    if (!take_word("in")) fail("\"in\" and the dimension of the space");
    const NodeId dimension = parse_expression();
    for (std::size_t i = first; i < reading_.declarations_.size(); ++i) {
        reading_.declarations_[i].dimension = dimension;
    }
    static_cast<void>(offset);
}

void Parser::parse_frame(std::size_t offset) {
    parse_declaration(Declaration::Kind::frame, offset);
    std::size_t count = 0;
    const std::optional<NodeId> dimension = reading_.declarations_.back().dimension;
    while (count < reading_.declarations_.size()) {
        const Declaration& declaration = reading_.declarations_[reading_.declarations_.size() - 1 - count];
        if (declaration.kind != Declaration::Kind::frame || declaration.dimension != dimension) break;
        if (!declaration.bare) {
            throw Error(ErrorCode::syntax, "the points of a frame have bare names", {}, declaration.offset);
        }
        ++count;
    }
    for (std::size_t place = 0; place < count; ++place) {
        Declaration& declaration = reading_.declarations_[reading_.declarations_.size() - count + place];
        declaration.place = place;
        declaration.frame_size = count;
    }
}

void Parser::parse_polynomial(std::size_t offset) {
    MapDeclaration map;
    map.kind = MapDeclaration::Kind::polynomial;
    map.line = line_;
    map.offset = next().offset;
    map.name = expect_name();
    expect_mark("(");
    do {
        const std::uint32_t variable = expect_name();
        if (std::ranges::find(map.variables, variable) != map.variables.end()) {
            throw Error(ErrorCode::syntax, "the variables of a polynomial have different names", {}, offset);
        }
        map.variables.push_back(variable);
    } while (take_mark(","));
    expect_mark(")");
    map.degrees = parse_degrees();
    if (map.degrees.size() > 1 && map.degrees.size() != map.variables.size()) {
        throw Error(ErrorCode::wrong_arity, "a tensor product has one degree for each variable", {}, offset);
    }
    expect_mark("=");
    map.body = parse_expression();
    reading_.maps_.push_back(std::move(map));
}

void Parser::parse_raise(std::size_t offset) {
    MapDeclaration map;
    map.kind = MapDeclaration::Kind::raised;
    map.line = line_;
    const std::uint32_t source = expect_name();
    expect_word("to");
    map.degrees.push_back(parse_expression());
    while (take_mark(",")) map.degrees.push_back(parse_expression());
    expect_word("as");
    map.offset = next().offset;
    map.name = expect_name();
    for (std::size_t i = 0; i < reading_.maps_.size(); ++i) {
        if (reading_.maps_[i].name != source) continue;
        map.source = static_cast<std::uint32_t>(i);
        reading_.maps_.push_back(std::move(map));
        return;
    }
    throw Error(ErrorCode::syntax, quoted(reading_.names_[source]) + " is no map that is declared above", {},
                offset);
}

Abbreviation& Parser::abbreviation(std::uint32_t name, bool bare) {
    for (Abbreviation& known : reading_.abbreviations_) {
        if (known.name == name && known.bare == bare) return known;
    }
    Abbreviation made;
    made.name = name;
    made.bare = bare;
    reading_.abbreviations_.push_back(std::move(made));
    return reading_.abbreviations_.back();
}

void Parser::parse_abbreviation(std::size_t offset) {
    const std::uint32_t name = expect_name();
    Clause clause;
    clause.offset = offset;
    const bool bare = !is_mark("_");
    if (!bare) {
        for (const NodeId index : parse_indices()) clause.patterns.emplace_back(index);
    }
    expect_mark("=");
    clause.body = parse_expression();
    Abbreviation& family = abbreviation(name, bare);
    if (bare && !family.clauses.empty()) {
        throw Error(ErrorCode::syntax, quoted(reading_.names_[name]) + " is declared twice", {}, offset);
    }
    family.clauses.push_back(std::move(clause));
}

}  // namespace blossom::proofs::second
