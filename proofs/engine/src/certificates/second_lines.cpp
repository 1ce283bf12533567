#include "second_parser.hpp"

#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <tuple>
#include <utility>

namespace blossom::proofs::second {

Parser::Parser(std::string_view block_text, Reading& reading)
    : reading_(reading), text_(tokens_of_block(block_text)) {
    reading_.strict_ = text_.strict;
}

const Token& Parser::after(std::size_t count) const {
    return text_.tokens[std::min(place_ + count, text_.tokens.size() - 1)];
}

bool Parser::is_mark(std::string_view mark) const {
    return next().kind == TokenKind::mark && next().text == mark;
}

bool Parser::is_word(std::string_view word) const {
    return next().kind == TokenKind::word && next().text == word;
}

bool Parser::take_mark(std::string_view mark) {
    if (!is_mark(mark)) return false;
    ++place_;
    return true;
}

bool Parser::take_word(std::string_view word) {
    if (!is_word(word)) return false;
    ++place_;
    return true;
}

void Parser::expect_mark(std::string_view mark) {
    if (!take_mark(mark)) fail("\"" + std::string(mark) + "\"");
}

void Parser::expect_word(std::string_view word) {
    if (!take_word(word)) fail("\"" + std::string(word) + "\"");
}

std::uint32_t Parser::expect_name() {
    if (next().kind != TokenKind::word) fail("a name");
    const std::uint32_t name = intern(next().text);
    ++place_;
    return name;
}

void Parser::fail(const std::string& expected) const {
    const bool ends = next().kind == TokenKind::line_end || next().kind == TokenKind::text_end;
    throw Error(
        ErrorCode::syntax,
        (ends ? std::string("the end of the line") : quoted(next().text)) + " found, expected " + expected,
        "", next().offset);
}

std::uint32_t Parser::intern(std::string_view name) {
    const auto found = interned_.find(name);
    if (found != interned_.end()) return found->second;
    const auto text = static_cast<std::uint32_t>(reading_.names_.size());
    reading_.names_.emplace_back(name);
    interned_.emplace(std::string(name), text);
    return text;
}

NodeId Parser::add(Form form, std::size_t offset, std::vector<NodeId> children) {
    Node made;
    made.form = form;
    made.offset = offset;
    made.children = std::move(children);
    reading_.nodes_.push_back(std::move(made));
    return static_cast<NodeId>(reading_.nodes_.size() - 1);
}

void Parser::parse_block() {
    while (next().kind != TokenKind::text_end) {
        if (next().kind != TokenKind::line_end) {
            parse_line();
            if (next().kind != TokenKind::line_end) fail("the end of the line");
        }
        ++place_;
        ++line_;
    }
}

void Parser::parse_line() {
    const std::size_t offset = next().offset;
    if (take_word("for")) return parse_parameter();
    if (take_word("map")) return parse_map(offset);
    if (take_word("point")) return parse_declaration(Declaration::Kind::point, offset);
    if (take_word("vector")) return parse_declaration(Declaration::Kind::vector, offset);
    if (take_word("number")) return parse_declaration(Declaration::Kind::number, offset);
    if (take_word("frame")) return parse_frame(offset);
    if (take_word("poly")) return parse_polynomial(offset);
    if (take_word("raise")) return parse_raise(offset);
    if (take_word("let")) return parse_abbreviation(offset);
    if (take_word("assume")) return parse_statement(Statement::Kind::assume, offset);
    if (take_word("given")) return parse_statement(Statement::Kind::given, offset);
    if (take_word("claim")) return parse_statement(Statement::Kind::claim, offset);
    if (take_word("refute")) {
        // A claim may begin with a number named some.
        const bool of_some = is_word("some") && (after(1).kind != TokenKind::mark || after(1).text == "(" ||
                                                 after(1).text == "<" || after(1).text == "-");
        if (of_some) ++place_;
        return parse_statement(of_some ? Statement::Kind::refute_some : Statement::Kind::refute, offset);
    }
    fail("for, map, point, vector, number, frame, poly, raise, let, assume, given, claim or refute");
}

Range Parser::parse_range_of(std::uint32_t name) {
    expect_word("in");
    const NodeId low = parse_expression();
    expect_mark("..");
    return {name, low, parse_expression()};
}

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
        throw Error(ErrorCode::syntax, "a map on a simplex has one degree", "", offset);
    }
    if (map.kind == MapDeclaration::Kind::net && names.size() != 1) {
        throw Error(ErrorCode::syntax, "a net belongs to one map", "", offset);
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
        throw Error(ErrorCode::syntax, "a run goes from one member of a family to another", "", offset);
    }
    std::vector<NodeId> last = parse_indices();
    if (first.size() != last.size()) {
        throw Error(ErrorCode::syntax, "both ends of a run have the same number of indices", "", offset);
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
            throw Error(ErrorCode::syntax, "the points of a frame have bare names", "", declaration.offset);
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
            throw Error(ErrorCode::syntax, "the variables of a polynomial have different names", "", offset);
        }
        map.variables.push_back(variable);
    } while (take_mark(","));
    expect_mark(")");
    map.degrees = parse_degrees();
    if (map.degrees.size() > 1 && map.degrees.size() != map.variables.size()) {
        throw Error(ErrorCode::wrong_arity, "a tensor product has one degree for each variable", "", offset);
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
    throw Error(ErrorCode::syntax, quoted(reading_.names_[source]) + " is no map that is declared above", "",
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
        throw Error(ErrorCode::syntax, quoted(reading_.names_[name]) + " is declared twice", "", offset);
    }
    family.clauses.push_back(std::move(clause));
}

void Parser::parse_statement(Statement::Kind kind, std::size_t offset) {
    Statement statement;
    statement.kind = kind;
    statement.offset = offset;
    statement.left = parse_expression();
    expect_mark(kind == Statement::Kind::assume ? "!=" : "==");
    statement.right = parse_expression();
    while (take_word("for")) {
        if (kind == Statement::Kind::given && take_word("all")) {
            parse_for_all(statement);
        } else {
            statement.ranges.push_back(parse_range_of(expect_name()));
            require_within(statement.ranges.size(), reading_.limits_.nesting, "nesting",
                           "the number of ranges");
        }
    }
    if (kind == Statement::Kind::given) {
        reading_.hypotheses_.push_back(std::move(statement));
    } else if (kind == Statement::Kind::assume) {
        reading_.assumptions_.push_back(std::move(statement));
    } else {
        reading_.claims_.push_back(std::move(statement));
    }
}

void Parser::parse_for_all(Statement& statement) {
    do {
        Quantified quantified;
        quantified.name = expect_name();
        if (is_mark("_")) {
            quantified.bare = false;
            std::tie(quantified.first, quantified.last) = parse_member_run(quantified.name);
        }
        statement.for_all.push_back(std::move(quantified));
    } while (take_mark(","));
}

}  // namespace blossom::proofs::second
