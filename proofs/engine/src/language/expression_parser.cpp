#include "expression_parser.hpp"

#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include "functions.hpp"

namespace blossom::proofs {

namespace {

/// Moves the children, which an initializer list would copy.
template <class... Children>
std::vector<Expression> children(Children... of) {
    std::vector<Expression> list;
    list.reserve(sizeof...(of));
    (list.push_back(std::move(of)), ...);
    return list;
}

/// The sum or product of `left` and `right`. Operands of the same kind form one list, not a deep tree; a
/// parenthesised left operand is merged too: (x + y) + z is x + y + z.
Expression appended(ExpressionKind kind, Expression left, char sign, Expression right) {
    if (left.kind != kind) {
        const std::size_t offset = left.offset;
        left = {kind, offset, "", children(std::move(left)), {}};
    }
    left.name += sign;
    left.children.push_back(std::move(right));
    return left;
}

/// Counts nested calls of the parser during its lifetime.
class Nesting {
public:
    Nesting(std::size_t& depth, const Limits& limits, std::size_t offset) : depth_(depth) {
        if (++depth_ <= limits.nesting) return;
        --depth_;
        throw limit_error("the nesting of the expression exceeds", "nesting", limits.nesting, {}, offset);
    }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;
    Nesting(Nesting&&) = delete;
    Nesting& operator=(Nesting&&) = delete;
    ~Nesting() { --depth_; }

private:
    std::size_t& depth_;
};

}  // namespace

Expression ExpressionParser::expression() { return sum(); }

Expression ExpressionParser::sum() {
    Expression left = product();
    while (is("+") || is("-")) {
        const char sign = next().text.front();
        skip();
        left = appended(ExpressionKind::sum, std::move(left), sign, product());
    }
    return left;
}

Expression ExpressionParser::product() {
    Expression left = signed_factor();
    while (is("*") || is("/")) {
        const char sign = next().text.front();
        skip();
        left = appended(ExpressionKind::product, std::move(left), sign, signed_factor());
    }
    return left;
}

Expression ExpressionParser::signed_factor() {
    const Nesting nesting(depth_, limits_, next().offset);
    const std::size_t offset = next().offset;
    if (take("-")) return {ExpressionKind::negative, offset, "", {signed_factor()}, {}};
    return power();
}

Expression ExpressionParser::power() {
    Expression base = primary();
    if (!take("^")) return base;
    const std::size_t offset = base.offset;
    return {ExpressionKind::power, offset, "", children(std::move(base), signed_factor()), {}};
}

Expression ExpressionParser::primary() {
    const std::size_t offset = next().offset;
    if (next().kind == TokenKind::number) {
        Expression number{ExpressionKind::number, offset, std::string(next().text), {}, {}};
        skip();
        return number;
    }
    if (take("(")) return parenthesis(offset);
    if (take("<")) {
        Expression first = expression();
        expect(",", "between the two entries of a pair");
        Expression second = expression();
        expect(">", "to close the pair");
        return {ExpressionKind::pair, offset, "", {std::move(first), std::move(second)}, {}};
    }
    if (next().kind != TokenKind::identifier) refuse("an expression");
    return named();
}

/// (e) or the point (x, y).
Expression ExpressionParser::parenthesis(std::size_t offset) {
    std::vector<Expression> entries = expressions();
    expect(")", "to close the parenthesis");
    if (entries.size() == 1) return std::move(entries.front());
    return {ExpressionKind::point, offset, "", std::move(entries), {}};
}

std::vector<Expression> ExpressionParser::expressions() {
    std::vector<Expression> elements;
    do elements.push_back(expression());
    while (take(","));
    return elements;
}

std::vector<Expression> ExpressionParser::list(std::string_view close) {
    std::vector<Expression> elements = expressions();
    expect(close, "or \",\" in the list");
    return elements;
}

/// A comparison: i == j, i < j, i in S, i not in S and the like.
Expression ExpressionParser::comparison() {
    Expression left = expression();
    const std::size_t offset = left.offset;
    for (const std::string_view sign : {"==", "!=", "<=", ">=", "<", ">"}) {
        if (take(sign)) {
            return {
                ExpressionKind::comparison, offset, std::string(sign), {std::move(left), expression()}, {}};
        }
    }
    const bool negative = take_word("not");
    expect_word("in", negative ? "after \"not\"" : "or a comparison such as \"==\" in the condition");
    return {
        ExpressionKind::comparison, offset, negative ? "not in" : "in", {std::move(left), expression()}, {}};
}

Expression ExpressionParser::call(Expression name) {
    expect("(", "before the arguments");
    std::vector<Expression> arguments;
    if (name.name == "if") {
        arguments.push_back(comparison());
        if (take(",")) std::ranges::move(expressions(), std::back_inserter(arguments));
        expect(")", "or \",\" in the list");
    } else {
        arguments = list(")");
    }
    return {ExpressionKind::call, name.offset, std::move(name.name), std::move(arguments), {}};
}

Expression ExpressionParser::indices(Expression name) {
    if (!take("_")) return name;
    const std::size_t offset = next().offset;
    if (take("{")) {
        name.children = list("}");
    } else if (next().kind == TokenKind::number) {
        name.children.push_back({ExpressionKind::number, offset, std::string(next().text), {}, {}});
        skip();
    } else {
        name.children.push_back({ExpressionKind::name, offset, identifier("an index"), {}, {}});
    }
    return name;
}

Expression ExpressionParser::named() {
    const std::size_t offset = next().offset;
    Expression name{ExpressionKind::name, offset, identifier("a name"), {}, {}};
    if (name.name == "D" && is("(")) return derivative(offset);
    if (is_function(name.name) && is("(")) return call(std::move(name));
    name = indices(std::move(name));
    std::size_t primes = 0;
    for (; take("'"); ++primes) {
    }
    if (primes > 0 && !is("(")) refuse("\"(\" after the mark of a derivative");
    if (is("(")) {
        std::vector<Expression> orders;
        if (primes > 0) orders.push_back({ExpressionKind::number, offset, std::to_string(primes), {}, {}});
        return value(std::move(name), std::move(orders));
    }
    return is("[") ? blossom_of(std::move(name)) : name;
}

/// D(b, k)(t), or D(e, t) and D(e, t, k) of an expression.
Expression ExpressionParser::derivative(std::size_t offset) {
    expect("(", "after D");
    std::vector<Expression> entries = list(")");
    if (entries.size() == 1) {
        refuse(
            "\",\" and, after the map, an order, or after an expression, the name of a variable, within "
            "D(...)");
    }
    if (is("(")) {
        Expression map = std::move(entries.front());
        if (map.kind != ExpressionKind::name) {
            throw Error(ErrorCode::syntax, "the first entry of D(b, k)(t) is the name of a map", {},
                        map.offset);
        }
        entries.erase(entries.begin());
        map.offset = offset;
        return value(std::move(map), std::move(entries));
    }
    if (entries.size() > 3) refuse("\"(\" with the place of the derivative");
    return {ExpressionKind::derivative, offset, "D", std::move(entries), {}};
}

Expression ExpressionParser::value(Expression map, std::vector<Expression> orders) {
    if (!map.children.empty()) {
        throw Error(ErrorCode::syntax, "a map has no indices, " + quoted(map.name) + " has", {}, map.offset);
    }
    expect("(", "before the arguments");
    return {ExpressionKind::value, map.offset, std::move(map.name), std::move(orders), {list(")")}};
}

Expression ExpressionParser::blossom_of(Expression map) {
    if (!map.children.empty()) {
        throw Error(ErrorCode::syntax, "a map has no indices, " + quoted(map.name) + " has", {}, map.offset);
    }
    expect("[", "before the arguments");
    Expression result{ExpressionKind::blossom, map.offset, std::move(map.name), {}, {{}}};
    while (!take("]")) {
        if (take(";")) {
            result.groups.emplace_back();
            continue;
        }
        result.groups.back().push_back(argument());
        if (!is("]") && !is(";")) {
            expect(",", R"(";" or "]" after an argument)");
            if (is("]") || is(";")) refuse("an argument");
        }
    }
    return result;
}

Expression ExpressionParser::argument() {
    Expression first = expression();
    const std::size_t offset = first.offset;
    if (take("..")) return {ExpressionKind::run, offset, "", {std::move(first), expression()}, {}};
    if (take(":")) return family(std::move(first));
    if (!take("{")) return first;
    Expression count = expression();
    expect("}", "after the number of copies");
    return {ExpressionKind::copies, offset, "", {std::move(first), std::move(count)}, {}};
}

/// t_i : i in 1..n, i != k and t_i : i in S, i not in T
Expression ExpressionParser::family(Expression member) {
    const std::size_t offset = member.offset;
    Expression result{ExpressionKind::family,
                      offset,
                      identifier("the index of the family"),
                      {std::move(member)},
                      {{}, {}, {}}};
    expect_word("in", "after the index of a family");
    result.groups[0].push_back(expression());
    if (take("..")) result.groups[0].push_back(expression());
    const auto condition_follows = [&] {
        return is(",") && peek(1).kind == TokenKind::identifier &&
               (peek(2).text == "!=" || peek(2).text == "not");
    };
    while (condition_follows()) {
        skip();
        if (next().text != result.name) refuse("the index " + result.name + " of the family");
        skip();
        if (take("!=")) {
            result.groups[1].push_back(expression());
            continue;
        }
        expect_word("not", "in the condition");
        expect_word("in", "after \"not\"");
        result.groups[2].push_back(expression());
    }
    return result;
}

Expression ExpressionParser::name_or_run(std::string_view what) {
    const std::size_t offset = next().offset;
    Expression first = indices({ExpressionKind::name, offset, identifier(what), {}, {}});
    if (!take("..")) return first;
    const std::size_t last_offset = next().offset;
    Expression last = indices({ExpressionKind::name, last_offset, identifier("the end of the run"), {}, {}});
    return {ExpressionKind::run, offset, "", {std::move(first), std::move(last)}, {}};
}

Range ExpressionParser::range() {
    const std::size_t offset = next().offset;
    Range result{identifier("the name of a parameter"), {}, {}, offset};
    expect_word("in", "after the name of the parameter");
    result.first = expression();
    expect("..", "between the bounds");
    result.last = expression();
    return result;
}

}  // namespace blossom::proofs
