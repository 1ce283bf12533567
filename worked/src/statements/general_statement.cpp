#include <blossom/proofs/case_groups.hpp>
#include <blossom/worked/general_statement.hpp>

#include <algorithm>
#include <optional>
#include <utility>

#include "sentences.hpp"
#include "statement_formulas.hpp"

namespace blossom::worked {

namespace {

using proofs::Statement;
using proofs::StatementKind;

std::vector<Formula> symbols_of(const std::vector<std::string>& names) {
    std::vector<Formula> symbols;
    symbols.reserve(names.size());
    for (const std::string& name : names) symbols.push_back(symbol(name));
    return symbols;
}

/// The lines before the claims in sentences.
class Declarations {
public:
    explicit Declarations(const proofs::Block& block) : formulas_(block) {
        for (const Statement& line : block.statements) {
            append(line);
            last_ = line.kind;
        }
    }

    Text text() && {
        if (!text_.empty()) say(".");
        return std::move(text_);
    }

private:
    template <class... Parts>
    void say(const Parts&... parts) {
        (text_.append(Text(parts)), ...);
    }

    /// The stop of a sentence is written when the next begins.
    void begin(const std::string& words) { say((text_.empty() ? "" : ". ") + words); }

    /// Continues the sentence where the line before was of the same kind.
    void begin(StatementKind kind, const std::string& words, const std::string& more) {
        if (last_ == kind) return say(more);
        begin(words);
    }

    void append(const Statement& line) {
        switch (line.kind) {
            case StatementKind::map:
                return map(line);
            case StatementKind::point:
                return points(line, "a point", "points", "of an affine space of dimension ");
            case StatementKind::vector:
                return points(line, "a vector", "vectors", "of an affine space of dimension ");
            case StatementKind::frame:
                return points(line, "a point", "points",
                              "in general position, which span an affine space of dimension ");
            case StatementKind::number:
                return points(line, "a number", "numbers", "");
            case StatementKind::polynomial:
                begin("Let ");
                say(equation({StatementFormulas::at_variables(line.names), formulas_(line.sides[0])}),
                    ", of formal ");
                return degrees(line);
            case StatementKind::raise:
                begin("Let ");
                say(symbol(line.names[1]), " be ", symbol(line.names[0]), " as a polynomial of formal ");
                return degrees(line);
            case StatementKind::let:
                begin(line.kind, "Let ", ", ");
                return say(equation({formulas_(line.sides[0]), formulas_(line.sides[1])}));
            case StatementKind::assume:
            case StatementKind::given:
                return hypothesis(line);
            default:
                return;
        }
    }

    void degrees(const Statement& line) {
        say(line.expressions.size() == 1 ? "degree " : "degrees ", list_of(formulas_.list(line.expressions)));
    }

    void map(const Statement& line) {
        begin("Let ");
        append_list(text_, symbols_of(line.names));
        say(line.names.size() == 1 ? " be a polynomial of formal " : " be polynomials of formal ");
        degrees(line);
        if (line.expressions.size() > 1) say(" in ", number(line.expressions.size()), " variables");
        if (!line.dimension.empty()) say(" on an affine space of dimension ", formulas_(line.dimension[0]));
        if (!line.net.empty()) net(line);
    }

    /// q[r^<i_0>, s^<i_1>] = c_{i_0,i_1}
    void net(const Statement& line) {
        const bool curve = line.dimension.empty();
        const Formula n = formulas_(line.expressions[0]);
        std::vector<Formula> indices;
        std::vector<Formula> arguments;
        const std::vector<Formula> points = formulas_.list(line.frame);
        for (std::size_t k = 0; k < points.size(); ++k) {
            indices.push_back(curve ? symbol("i") : index(symbol("i"), number(k)));
            arguments.push_back(repeated(
                points[k], curve && k == 0 ? sum({n, product({number(-1), symbol("i")})}) : indices.back()));
        }
        const std::vector<Formula> subscripts = curve ? std::vector{symbol("i")} : indices;
        say(". Its control points over ");
        append_list(text_, points);
        say(" are ",
            equation({blossom_of(line.names[0], arguments), index(symbol(line.net), list_of(subscripts))}));
        say(", for ", curve ? equation({symbol("i"), list_of({number(0), symbol("…"), n})})
                            : equation({sum(indices), n}));
    }

    void points(const Statement& line, const std::string& one, const std::string& several,
                const std::string& of) {
        const std::vector<Formula> names = formulas_.list(line.expressions);
        begin("Let ");
        append_list(text_, names);
        say(" be " + (names.size() == 1 ? one : several));
        if (!of.empty()) say(" " + of, formulas_(line.dimension[0]));
    }

    void hypothesis(const Statement& line) {
        const std::string sign = line.kind == StatementKind::assume ? "≠" : "=";
        begin(line.kind, "Suppose that ", ", and that ");
        say(relation(sign, {formulas_(line.sides[0]), formulas_(line.sides[1])}));
        std::vector<Text> scope;
        scope.reserve(line.ranges.size() + 1);
        for (const proofs::Range& range : line.ranges) scope.emplace_back(formulas_.range(range));
        if (!line.quantified.empty()) {
            Text all("all ");
            append_list(all, formulas_.list(line.quantified));
            scope.push_back(std::move(all));
        }
        if (!scope.empty()) say(" for ");
        append_list(text_, scope);
    }

    StatementFormulas formulas_;
    Text text_;
    std::optional<StatementKind> last_;
};

}  // namespace

Formula formula_of(const proofs::Block& block, const proofs::Expression& expression) {
    return StatementFormulas(block)(expression);
}

Text declarations_in_words(const proofs::Block& block) { return Declarations(block).text(); }

ClaimInWords claim_in_words(const proofs::Block& block, const Statement& line, const std::string& opening) {
    StatementFormulas formulas(block);
    ClaimInWords result;
    result.claim = equation({formulas(line.sides[0]), formulas(line.sides[1])});
    result.before = opening;
    if (line.kind == StatementKind::refute) {
        result.before += opening.empty() ? "It is not true " : " it is not true ";
        result.before += line.some ? "in every case that" : "that";
    }
    std::vector<Formula> ranges;
    for (const proofs::Range& range : proofs::ranges_of(block, line)) ranges.push_back(formulas.range(range));
    if (ranges.empty()) return result;
    result.after = "for ";
    append_list(result.after, ranges);
    result.after.append(".");
    return result;
}

}  // namespace blossom::worked
