#include <blossom/proofs/formatter.hpp>

#include <blossom/rational/lists.hpp>

#include <algorithm>

#include "statement_words.hpp"

namespace blossom::proofs {

namespace {

/// The binding strength of an expression; an operand that binds less tightly than its context requires is put
/// in parentheses.
enum Binding { loose, additive, multiplicative, prefix, exponential, primary };

Binding binding_of(const Expression& expression) {
    switch (expression.kind) {
        case ExpressionKind::sum:
            return additive;
        case ExpressionKind::product:
            return multiplicative;
        case ExpressionKind::negative:
            return prefix;
        case ExpressionKind::power:
            return exponential;
        default:
            return primary;
    }
}

class Printer {
public:
    /// `tight` omits the blanks around + and -, for indices and exponents.
    explicit Printer(bool tight) : tight_(tight) {}

    std::string print(const Expression& e, Binding least = loose) const {
        std::string text = unbracketed(e);
        return binding_of(e) < least ? "(" + text + ")" : text;
    }

private:
    static std::string tightly(const Expression& e, Binding least = loose) {
        return Printer(true).print(e, least);
    }

    std::string list(const std::vector<Expression>& elements) const {
        return joined(elements, [&](const Expression& element) { return print(element); });
    }

    std::string sum(const Expression& e) const {
        std::string text = print(e.children[0], additive);
        for (std::size_t i = 1; i < e.children.size(); ++i) {
            const std::string sign(1, e.name[i - 1]);
            text += (tight_ ? sign : " " + sign + " ") + print(e.children[i], multiplicative);
        }
        return text;
    }

    std::string product(const Expression& e) const {
        std::string text = print(e.children[0], multiplicative);
        for (std::size_t i = 1; i < e.children.size(); ++i)
            text += e.name[i - 1] + print(e.children[i], prefix);
        return text;
    }

    static std::string name(const Expression& e) {
        if (e.children.empty()) return e.name;
        const Expression& only = e.children.front();
        const bool bare =
            e.children.size() == 1 && (only.kind == ExpressionKind::number ||
                                       (only.kind == ExpressionKind::name && only.children.empty()));
        if (bare) return e.name + "_" + only.name;
        const std::string text =
            joined(e.children, [&](const Expression& index) { return tightly(index); }, ",");
        return e.name + "_{" + text + "}";
    }

    std::string value(const Expression& e) const {
        const std::string arguments = "(" + list(e.groups[0]) + ")";
        if (e.children.empty()) return e.name + arguments;
        const Expression& order = e.children.front();
        if (e.children.size() == 1 && (order.name == "1" || order.name == "2") &&
            order.kind == ExpressionKind::number) {
            return e.name + std::string(order.name == "1" ? "'" : "''") + arguments;
        }
        return "D(" + e.name + ", " + list(e.children) + ")" + arguments;
    }

    std::string blossom_of(const Expression& e) const {
        std::string text;
        for (std::size_t i = 0; i < e.groups.size(); ++i) text += (i == 0 ? "" : "; ") + list(e.groups[i]);
        return e.name + "[" + text + "]";
    }

    std::string family(const Expression& e) const {
        std::string text = print(e.children[0]) + " : " + e.name + " in " + print(e.groups[0][0]);
        if (e.groups[0].size() == 2) text += ".." + print(e.groups[0][1]);
        for (const Expression& excluded : e.groups[1]) text += ", " + e.name + " != " + print(excluded);
        for (const Expression& set : e.groups[2]) text += ", " + e.name + " not in " + print(set);
        return text;
    }

    std::string unbracketed(const Expression& e) const {
        switch (e.kind) {
            case ExpressionKind::number:
                return e.name;
            case ExpressionKind::name:
                return name(e);
            case ExpressionKind::negative:
                return "-" + print(e.children[0], prefix);
            case ExpressionKind::sum:
                return sum(e);
            case ExpressionKind::product:
                return product(e);
            case ExpressionKind::power:
                return print(e.children[0], primary) + "^" + tightly(e.children[1], prefix);
            case ExpressionKind::pair:
                return "<" + list(e.children) + ">";
            case ExpressionKind::point:
                return "(" + list(e.children) + ")";
            case ExpressionKind::comparison:
                return print(e.children[0]) + " " + e.name + " " + print(e.children[1]);
            case ExpressionKind::derivative:
            case ExpressionKind::call:
                return e.name + "(" + list(e.children) + ")";
            case ExpressionKind::value:
                return value(e);
            case ExpressionKind::blossom:
                return blossom_of(e);
            case ExpressionKind::copies:
                return print(e.children[0]) + "{" + tightly(e.children[1]) + "}";
            case ExpressionKind::run:
                return print(e.children[0]) + ".." + print(e.children[1]);
            case ExpressionKind::family:
                return family(e);
        }
        return "";
    }

    bool tight_;
};

std::string listed(const std::vector<Expression>& expressions) {
    return joined(expressions, [](const Expression& expression) { return to_text(expression); });
}

std::string range_text(const Range& range) {
    return "for " + range.name + " in " + to_text(range.first) + ".." + to_text(range.last);
}

std::string degrees_text(const Statement& statement) {
    return (statement.expressions.size() == 1 ? " degree " : " degrees ") + listed(statement.expressions);
}

std::string relation_text(const Statement& statement) {
    const bool differs = statement.kind == StatementKind::assume;
    std::string text = (statement.some ? "some " : "") + to_text(statement.sides[0]) +
                       (differs ? " != " : " == ") + to_text(statement.sides[1]);
    for (const Range& range : statement.ranges) text += " " + range_text(range);
    if (!statement.quantified.empty()) text += " for all " + listed(statement.quantified);
    return text;
}

std::string body_text(const Statement& statement) {
    switch (statement.kind) {
        case StatementKind::map:
            return joined(statement.names) + degrees_text(statement) +
                   (statement.dimension.empty() ? "" : " on simplex " + to_text(statement.dimension[0])) +
                   (statement.net.empty() ? ""
                                          : " net " + statement.net + " over " + listed(statement.frame));
        case StatementKind::number:
            return listed(statement.expressions);
        case StatementKind::point:
        case StatementKind::vector:
        case StatementKind::frame:
            return listed(statement.expressions) + " in " + to_text(statement.dimension[0]);
        case StatementKind::polynomial:
            return statement.names[0] + "(" +
                   joined(std::vector<std::string>(statement.names.begin() + 1, statement.names.end())) +
                   ")" + degrees_text(statement) + " = " + to_text(statement.sides[0]);
        case StatementKind::raise:
            return statement.names[0] + " to " + listed(statement.expressions) + " as " + statement.names[1];
        case StatementKind::let:
            return to_text(statement.sides[0]) + " = " + to_text(statement.sides[1]);
        default:
            return relation_text(statement);
    }
}

/// The lines of the document in order, each with its original offset.
struct Line {
    std::size_t offset;
    std::string text;
    bool begins_block;
};

}  // namespace

std::string to_text(const Expression& expression) { return Printer(false).print(expression); }

std::string to_text(const Statement& statement) {
    if (statement.kind == StatementKind::parameter) return range_text(statement.ranges[0]);
    return std::string(statement_word(statement.kind)) + " " + body_text(statement);
}

std::string formatted(const Document& document) {
    if (!document.errors.empty()) throw Error(document.errors.front());
    std::vector<Line> lines;
    if (document.strict) lines.push_back({*document.strict, "strict", false});
    for (const Block& block : document.blocks) {
        if (block.has_head) {
            const std::string title = block.title.empty() ? "" : " \"" + block.title + "\"";
            lines.push_back({block.offset, "theorem " + block.id + title, true});
        }
        for (const Statement& statement : block.statements) {
            lines.push_back({statement.offset, to_text(statement), !block.has_head && lines.empty()});
        }
    }
    std::string text;
    auto comment = document.comments.begin();
    const auto print_comments_before = [&](std::size_t offset) {
        for (; comment != document.comments.end() && comment->offset < offset; ++comment) {
            if (comment->own_line) {
                text += comment->text + "\n";
            } else if (!text.empty()) {
                text.insert(text.size() - 1, "  " + comment->text);
            }
        }
    };
    for (auto& line : lines) {
        // Comments above a head belong to it: the empty line is written before them, after the comments that
        // follow the last line on the same line.
        while (comment != document.comments.end() && comment->offset < line.offset && !comment->own_line) {
            print_comments_before(comment->offset + 1);
        }
        if (line.begins_block && !text.empty()) text += "\n";
        print_comments_before(line.offset);
        text += line.text + "\n";
    }
    print_comments_before(std::string::npos);
    return text;
}

}  // namespace blossom::proofs
