#include "second_parser.hpp"

#include <blossom/rational/error.hpp>

#include <array>
#include <string>
#include <utility>

namespace blossom::proofs::second {

namespace {

/// A function whose arguments are only expressions.
struct PlainFunction {
    std::string_view name;
    Form form;
    std::size_t arguments;
};

constexpr std::array<PlainFunction, 8> plain_functions = {{{"size", Form::size, 1},
                                                           {"binomial", Form::binomial, 2},
                                                           {"factorial", Form::factorial, 1},
                                                           {"bernstein", Form::bernstein, 3},
                                                           {"sign", Form::sign, 1},
                                                           {"without", Form::without, 2},
                                                           {"subsets", Form::subsets, 2},
                                                           {"partitions", Form::partitions, 1}}};

}  // namespace

NodeId Parser::parse_call(std::string_view name, std::size_t offset) {
    if (name == "sum") return parse_iteration(Form::sum, offset);
    if (name == "prod") return parse_iteration(Form::product, offset);
    if (name == "mean") return parse_iteration(Form::mean, offset);
    if (name == "determinant") return parse_determinant(offset);
    if (name == "bspline") return parse_basis(offset);
    if (name == "if") return parse_choice(offset);
    if (name == "D") return parse_derivative(offset);
    for (const PlainFunction& function : plain_functions) {
        if (function.name != name) continue;
        expect_mark("(");
        std::vector<NodeId> children = parse_list(")");
        require_count(children, function.arguments, function.arguments, name, offset);
        return add(function.form, offset, std::move(children));
    }
    expect_mark("(");
    std::vector<NodeId> children = parse_list(")");
    if (name == "permutations") {
        require_count(children, 1, 1, name, offset);
        return add(Form::permutations, offset, std::move(children));
    }
    const std::uint32_t text = intern(name);
    const NodeId result = add(Form::map_value, offset, std::move(children));
    node(result).text = text;
    return result;
}

void Parser::require_count(const std::vector<NodeId>& found, std::size_t least, std::size_t most,
                           std::string_view what, std::size_t offset) const {
    if (found.size() >= least && found.size() <= most) return;
    throw Error(ErrorCode::wrong_arity,
                std::string(what) + " has " + std::to_string(least) + " arguments, not " +
                    std::to_string(found.size()),
                {}, offset);
}

NodeId Parser::parse_iteration(Form form, std::size_t offset) {
    expect_mark("(");
    const std::uint32_t name = expect_name();
    expect_mark(",");
    std::vector<NodeId> children = parse_list(")");
    require_count(children, 2, 3, "an iteration behind its name", offset);
    if (children.size() == 3) {
        const NodeId interval = add(Form::interval, offset, {children[0], children[1]});
        children = {interval, children[2]};
    }
    const NodeId result = add(form, offset, std::move(children));
    node(result).text = name;
    return result;
}

// The names of rows and columns are bound only in the entry; they are kept as the first two children.
NodeId Parser::parse_determinant(std::size_t offset) {
    expect_mark("(");
    const std::size_t row_offset = next().offset;
    const std::uint32_t row = expect_name();
    expect_mark(",");
    const std::size_t column_offset = next().offset;
    const std::uint32_t column = expect_name();
    expect_mark(",");
    std::vector<NodeId> children = parse_list(")");
    require_count(children, 2, 2, "a determinant behind its names", offset);
    const NodeId row_node = add(Form::name, row_offset);
    node(row_node).text = row;
    const NodeId column_node = add(Form::name, column_offset);
    node(column_node).text = column;
    if (row == column) {
        throw Error(ErrorCode::syntax, "rows and columns of a determinant have different names", {},
                    column_offset);
    }
    return add(Form::determinant, offset, {row_node, column_node, children[0], children[1]});
}

NodeId Parser::parse_basis(std::size_t offset) {
    expect_mark("(");
    const std::vector<NodeId> children = parse_list(")");
    require_count(children, 5, 5, "bspline", offset);
    if (node(children[2]).form != Form::name) {
        throw Error(ErrorCode::syntax, "the knots of bspline are the bare name of a family", {},
                    node(children[2]).offset);
    }
    const std::uint32_t knots = node(children[2]).text;
    const NodeId result = add(Form::basis, offset, {children[0], children[1], children[3], children[4]});
    node(result).text = knots;
    return result;
}

NodeId Parser::parse_choice(std::size_t offset) {
    expect_mark("(");
    std::vector<NodeId> children{parse_condition()};
    expect_mark(",");
    for (const NodeId child : parse_list(")")) children.push_back(child);
    require_count(children, 3, 3, "if", offset);
    return add(Form::choice, offset, std::move(children));
}

NodeId Parser::parse_condition() {
    const NodeId left = parse_expression();
    const std::size_t offset = next().offset;
    if (is_word("in") || is_word("not")) {
        const bool negated = take_word("not");
        expect_word("in");
        const NodeId result = add(Form::membership, offset, {left, parse_set()});
        node(result).relation = negated ? Relation::different : Relation::equal;
        return result;
    }
    constexpr std::array<std::pair<std::string_view, Relation>, 6> relations = {
        {{"==", Relation::equal},
         {"!=", Relation::different},
         {"<", Relation::less},
         {"<=", Relation::less_or_equal},
         {">", Relation::greater},
         {">=", Relation::greater_or_equal}}};
    for (const auto& [mark, relation] : relations) {
        if (!take_mark(mark)) continue;
        const NodeId result = add(Form::comparison, offset, {left, parse_expression()});
        node(result).relation = relation;
        return result;
    }
    fail("a comparison or \"in\"");
}

}  // namespace blossom::proofs::second
