#include "second_parser.hpp"

#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <utility>

namespace blossom::proofs::second {

namespace {

/// Counts one level of nesting during its lifetime.
class NestingLevel {
public:
    NestingLevel(std::size_t& depth, const Limits& limits, std::size_t offset) : depth_(depth) {
        constexpr std::size_t most = 1000;  // fits the stack
        if (++depth_ > std::min(limits.nesting, most)) {
            --depth_;
            throw limit_error("the expressions within expressions exceed", "nesting", limits.nesting, {},
                              offset);
        }
    }
    NestingLevel(const NestingLevel&) = delete;
    NestingLevel& operator=(const NestingLevel&) = delete;
    NestingLevel(NestingLevel&&) = delete;
    NestingLevel& operator=(NestingLevel&&) = delete;
    ~NestingLevel() { --depth_; }

private:
    std::size_t& depth_;
};

}  // namespace

// Sums and products are lists, so that a long one is not a deep tree.
NodeId Parser::parse_expression() {
    const NestingLevel level(depth_, reading_.limits_, next().offset);
    const std::size_t offset = next().offset;
    std::vector<NodeId> children{parse_factors()};
    std::vector<bool> subtracted{false};
    while (is_mark("+") || is_mark("-")) {
        subtracted.push_back(is_mark("-"));
        ++place_;
        children.push_back(parse_factors());
    }
    if (children.size() == 1) return children.front();
    const NodeId result = add(Form::terms, offset, std::move(children));
    node(result).flags = std::move(subtracted);
    return result;
}

NodeId Parser::parse_factors() {
    const std::size_t offset = next().offset;
    std::vector<NodeId> children{parse_signed()};
    std::vector<bool> divides{false};
    while (is_mark("*") || is_mark("/")) {
        divides.push_back(is_mark("/"));
        ++place_;
        children.push_back(parse_signed());
    }
    if (children.size() == 1) return children.front();
    const NodeId result = add(Form::factors, offset, std::move(children));
    node(result).flags = std::move(divides);
    return result;
}

NodeId Parser::parse_signed() {
    if (!is_mark("-")) return parse_power();
    const NestingLevel level(depth_, reading_.limits_, next().offset);
    const std::size_t offset = next().offset;
    ++place_;
    return add(Form::negation, offset, {parse_signed()});
}

NodeId Parser::parse_power() {
    const std::size_t offset = next().offset;
    const NodeId base = parse_operand();
    if (!take_mark("^")) return base;
    const NestingLevel level(depth_, reading_.limits_, next().offset);
    return add(Form::power, offset, {base, parse_signed()});
}

NodeId Parser::parse_operand() {
    const Token& token = next();
    if (token.kind == TokenKind::number) {
        ++place_;
        const NodeId result = add(Form::number, token.offset);
        node(result).value = parse_rational(token.text, reading_.limits_);
        return result;
    }
    if (token.kind == TokenKind::word) return parse_word();
    if (is_mark("(")) return parse_bracket();
    if (is_mark("<")) return parse_pair();
    fail(R"(a number, a name, "(" or "<")");
}

NodeId Parser::parse_bracket() {
    const std::size_t offset = next().offset;
    expect_mark("(");
    std::vector<NodeId> children = parse_list(")");
    if (children.size() == 1) return children.front();
    return add(Form::tuple, offset, std::move(children));
}

NodeId Parser::parse_pair() {
    const std::size_t offset = next().offset;
    expect_mark("<");
    const NodeId coordinate = parse_expression();
    expect_mark(",");
    const NodeId mass = parse_expression();
    expect_mark(">");
    return add(Form::pair, offset, {coordinate, mass});
}

std::vector<NodeId> Parser::parse_list(std::string_view close) {
    std::vector<NodeId> children{parse_expression()};
    while (take_mark(",")) children.push_back(parse_expression());
    expect_mark(close);
    return children;
}

NodeId Parser::parse_word() {
    const Token word = next();
    ++place_;
    if (is_mark("(")) return parse_call(word.text, word.offset);
    const std::uint32_t name = intern(word.text);
    if (is_mark("[")) return parse_blossom(name, word.offset);
    if (is_mark("'")) return parse_primes(name, word.offset);
    if (is_mark("_")) {
        const NodeId result = add(Form::member, word.offset, parse_indices());
        node(result).text = name;
        return result;
    }
    const NodeId result = add(Form::name, word.offset);
    node(result).text = name;
    return result;
}

std::vector<NodeId> Parser::parse_indices() {
    const NestingLevel level(depth_, reading_.limits_, next().offset);
    expect_mark("_");
    if (take_mark("{")) return parse_list("}");
    const Token token = next();
    if (token.kind == TokenKind::number) return {parse_operand()};
    if (token.kind != TokenKind::word) fail("an index");
    ++place_;
    const NodeId result = add(Form::name, token.offset);
    node(result).text = intern(token.text);
    return {result};
}

NodeId Parser::parse_primes(std::uint32_t name, std::size_t offset) {
    long long order = 0;
    while (take_mark("'")) ++order;
    const NodeId node_of_order = add(Form::number, offset);
    node(node_of_order).value = Rational(order);
    const NodeId map = add(Form::name, offset);
    node(map).text = name;
    return derivative_of_map(map, {node_of_order}, offset);
}

NodeId Parser::derivative_of_map(NodeId map, std::vector<NodeId> orders, std::size_t offset) {
    if (node(map).form != Form::name) {
        throw Error(ErrorCode::syntax, "D( ... )( ... ) differentiates a map, and this is no name of one", {},
                    node(map).offset);
    }
    const std::uint32_t name = node(map).text;
    expect_mark("(");
    const std::size_t order_count = orders.size();
    for (const NodeId argument : parse_list(")")) orders.push_back(argument);
    const NodeId result = add(Form::map_derivative, offset, std::move(orders));
    node(result).text = name;
    node(result).groups = {order_count};
    return result;
}

NodeId Parser::parse_derivative(std::size_t offset) {
    expect_mark("(");
    std::vector<NodeId> children = parse_list(")");
    if (is_mark("(")) {
        const NodeId map = children.front();
        children.erase(children.begin());
        if (children.empty()) fail("an order of differentiation before the argument");
        return derivative_of_map(map, std::move(children), offset);
    }
    require_count(children, 2, 3, "D", offset);
    const Form form = node(children[1]).form;
    if (form != Form::name && form != Form::member) {
        throw Error(ErrorCode::syntax, "D differentiates with respect to a name", {},
                    node(children[1]).offset);
    }
    return add(Form::derivative, offset, std::move(children));
}

NodeId Parser::parse_blossom(std::uint32_t name, std::size_t offset) {
    const NestingLevel level(depth_, reading_.limits_, next().offset);
    expect_mark("[");
    std::vector<NodeId> children;
    std::vector<std::size_t> groups;
    while (true) {
        while (!is_mark(";") && !is_mark("]")) {
            children.push_back(parse_argument());
            if (!take_mark(",")) break;
        }
        groups.push_back(children.size());
        if (!take_mark(";")) break;
    }
    expect_mark("]");
    const NodeId result = add(Form::blossom, offset, std::move(children));
    node(result).text = name;
    node(result).groups = std::move(groups);
    return result;
}

NodeId Parser::parse_argument() {
    const std::size_t offset = next().offset;
    const NodeId expression = parse_expression();
    if (take_mark("{")) {
        const NodeId count = parse_expression();
        expect_mark("}");
        return add(Form::copies, offset, {expression, count});
    }
    if (take_mark("..")) {
        const NodeId last = parse_expression();
        const Node& from = node(expression);
        const Node& to = node(last);
        if (from.form != Form::member || to.form != Form::member || from.text != to.text ||
            from.children.size() != to.children.size()) {
            throw Error(ErrorCode::syntax, "a run goes from one member of a family to another", {}, offset);
        }
        return add(Form::run, offset, {expression, last});
    }
    if (is_mark(":")) return parse_family(expression);
    return expression;
}

NodeId Parser::parse_family(NodeId expression) {
    const std::size_t offset = next().offset;
    expect_mark(":");
    const std::uint32_t name = expect_name();
    expect_word("in");
    std::vector<NodeId> children{parse_set()};
    while (is_mark(",") && after(1).kind == TokenKind::word && after(1).text == reading_.names_[name] &&
           (after(2).text == "!=" || after(2).text == "not")) {
        place_ += 2;
        const std::size_t at = next().offset;
        if (take_mark("!=")) {
            children.push_back(add(Form::excluded, at, {parse_expression()}));
        } else {
            expect_word("not");
            expect_word("in");
            children.push_back(add(Form::excluded_set, at, {parse_set()}));
        }
    }
    children.push_back(expression);
    const NodeId result = add(Form::family, offset, std::move(children));
    node(result).text = name;
    return result;
}

NodeId Parser::parse_set() {
    const std::size_t offset = next().offset;
    const NodeId first = parse_expression();
    if (!take_mark("..")) return first;
    return add(Form::interval, offset, {first, parse_expression()});
}

}  // namespace blossom::proofs::second
