#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// The tree of a file of the identity language. The parser makes it, the formatter prints it, and grounding
/// turns it into one identity for each choice of the integer parameters.

namespace blossom::proofs {

enum class ExpressionKind {
    number,      ///< name: the text as written
    name,        ///< name; children: the indices of t_3, t_{i,j}
    negative,    ///< -x
    sum,         ///< x + y - z; name: the signs between the children, "+-"
    product,     ///< x * y / z; name: the signs, "*/"
    power,       ///< x ^ y
    pair,        ///< <u, v>
    point,       ///< (x, y): the point with these coordinates
    call,        ///< a function of the language; name; children: its arguments
    comparison,  ///< i == j, i in S and the like, in if(...); name: the sign
    value,       ///< b(t), b'(t), D(b, k)(t); name: the map; children: orders or directions; groups[0]: the
                 ///< arguments
    derivative,  ///< D(e, t, k): the derivative of an expression; children: e, t and, if written, k
    blossom,     ///< b[...]; name: the map; groups: the arguments, one list per direction
    copies,      ///< t{k} among arguments
    run,         ///< t_1..t_n among arguments
    family,      ///< t_i : i in 1..n, i != k; name: i; children: the member; groups: range, excluded, sets
};

/// An expression and its position, in bytes from the beginning of the text. Comparison ignores the position.
struct Expression {
    ExpressionKind kind = ExpressionKind::number;
    std::size_t offset = 0;
    std::string name;
    std::vector<Expression> children;
    std::vector<std::vector<Expression>> groups;

    friend bool operator==(const Expression& a, const Expression& b) {
        return a.kind == b.kind && a.name == b.name && a.children == b.children && a.groups == b.groups;
    }
};

/// `for n in first..last`
struct Range {
    std::string name;
    Expression first;
    Expression last;
    std::size_t offset = 0;

    friend bool operator==(const Range& a, const Range& b) {
        return a.name == b.name && a.first == b.first && a.last == b.last;
    }
};

enum class StatementKind {
    parameter,  ///< for: ranges[0]
    map,     ///< names; expressions: the degrees; dimension: that of `on simplex s`; net and frame, if given
    point,   ///< expressions: names and runs; dimension
    vector,  ///< as for point
    frame,   ///< as for point, with names only
    number,  ///< expressions: names and runs
    polynomial,  ///< names: P and its variables; expressions: the degrees; left: the polynomial
    raise,       ///< names: p, q; expressions: the degrees
    let,         ///< left: the name with its index patterns; right: the expression
    assume,      ///< left != right
    given,       ///< left == right, ranges, quantified
    claim,       ///< left == right, ranges
    refute,      ///< left == right, ranges; some: one false case suffices
};

/// One line of a block.
struct Statement {
    StatementKind kind = StatementKind::claim;
    std::size_t offset = 0;
    std::vector<std::string> names;
    std::vector<Expression> expressions;
    std::vector<Expression> dimension;  ///< at most one
    std::vector<Expression> sides;      ///< left, or left and right
    std::vector<Range> ranges;
    std::vector<Expression> quantified;  ///< of `given ... for all x, y_1..y_k`
    std::string net;                     ///< of `map q degree n on simplex s net c over r, s, t`
    std::vector<Expression> frame;       ///< the points of the frame in such a line
    bool some = false;                   ///< of `refute some`

    friend bool operator==(const Statement& a, const Statement& b) {
        return a.kind == b.kind && a.names == b.names && a.expressions == b.expressions &&
               a.dimension == b.dimension && a.sides == b.sides && a.ranges == b.ranges &&
               a.quantified == b.quantified && a.net == b.net && a.frame == b.frame && a.some == b.some;
    }
};

/// A block: `theorem ID "title"` and the lines up to the next one. Lines before the first head form a block
/// without id. Comparison ignores positions and the original text.
struct Block {
    std::string id;
    std::string title;
    std::size_t offset = 0;
    bool has_head = false;
    bool strict = false;  ///< every name must be declared
    std::string text;     ///< the original text, from the head to the next block
    std::vector<Statement> statements;

    friend bool operator==(const Block& a, const Block& b) {
        return a.id == b.id && a.title == b.title && a.has_head == b.has_head && a.strict == b.strict &&
               a.statements == b.statements;
    }
};

/// A comment, from `#` to the end of its line.
struct Comment {
    std::size_t offset = 0;
    bool own_line = false;  ///< whether only blanks precede it in its line
    std::string text;
};

}  // namespace blossom::proofs
