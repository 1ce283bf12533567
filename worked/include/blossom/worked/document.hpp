#pragma once

#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/maps/barycentric_frame.hpp>
#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/worked/formula.hpp>
#include <blossom/worked/notation.hpp>
#include <blossom/worked/picture.hpp>

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace blossom::worked {

/// Text with formulas in it.
class Text {
public:
    using Part = std::variant<std::string, Formula>;

    Text() = default;
    Text(std::string words) : parts_{std::move(words)} {}    // NOLINT(google-explicit-constructor)
    Text(const char* words) : parts_{std::string(words)} {}  // NOLINT(google-explicit-constructor)
    Text(Formula formula) : parts_{std::move(formula)} {}    // NOLINT(google-explicit-constructor)
    Text(std::initializer_list<Part> parts) : parts_(parts) {}

    const std::vector<Part>& parts() const { return parts_; }
    bool empty() const { return parts_.empty(); }
    void append(const Text& more) { parts_.insert(parts_.end(), more.parts_.begin(), more.parts_.end()); }

    friend bool operator==(const Text&, const Text&) = default;

private:
    std::vector<Part> parts_;
};

struct Paragraph {
    Text text;
};

/// Formulas on lines of their own.
struct Display {
    std::vector<Formula> formulas;
};

/// A cell of a table. `shown` may be only the value of `meaning`, so that the rows do not repeat
/// the formula; words may state that the relation `meaning` holds.
struct Cell {
    Text shown;
    std::optional<Formula> meaning;

    Cell(Text text) : shown(std::move(text)) {}           // NOLINT(google-explicit-constructor)
    Cell(Formula formula) : shown(std::move(formula)) {}  // NOLINT(google-explicit-constructor)
    Cell(const char* words) : shown(words) {}             // NOLINT(google-explicit-constructor)
    Cell(const char* words, Formula means) : shown(words), meaning(std::move(means)) {}
    Cell(Formula formula, Formula means) : shown(std::move(formula)), meaning(std::move(means)) {}
};

struct Table {
    std::string caption;
    std::vector<Text> header;
    std::vector<std::vector<Cell>> rows;
};

/// One node of a pyramid; those of level 0 have no weights.
struct PyramidNode {
    Formula label;  ///< the blossom value at the node
    Formula value;
    std::optional<Formula> left_weight;   ///< on the arrow from node i of the level before
    std::optional<Formula> right_weight;  ///< on the arrow from node i + 1
    bool on_left_edge = false;            ///< marked as a point of the left result
    bool on_right_edge = false;
};

/// De Casteljau's, de Boor's or another triangle: levels[r][i] is a combination of levels[r-1][i] and
/// levels[r-1][i+1].
struct TrianglePyramid {
    std::string caption;
    std::vector<std::vector<PyramidNode>> levels;
};

using Block = std::variant<Paragraph, Display, Table, TrianglePyramid, Picture>;

/// The contents of a page, in order.
struct Blocks : std::vector<Block> {
    using std::vector<Block>::vector;

    Blocks& say(Text text) { return add(Paragraph{std::move(text)}); }
    Blocks& show(std::vector<Formula> formulas) { return add(Display{std::move(formulas)}); }
    Blocks& add(Block block) {
        push_back(std::move(block));
        return *this;
    }
    /// No block if there is no picture.
    Blocks& add_if(std::optional<Picture> picture) { return picture ? add(std::move(*picture)) : *this; }
};

struct Step {
    std::string title;
    Blocks blocks;
};

/// What was verified, and whether it holds.
struct Check {
    Blocks blocks;
    bool holds = true;
    std::string verdict = "This holds exactly.";  ///< the last sentence if it holds
};

/// The sentence at the end of a check.
std::string said_of(const Check& check);

/// A map on a triangle, whose vertices may have coordinates.
struct TriangleMap {
    BezierPatch net;
    std::optional<BarycentricFrame> frame;
};

/// An arbitrary polynomial map, by the name of its coefficients.
struct SymbolicMap {
    std::vector<Formula> coefficients;
};

/// A map that the formulas name: `map`(t) and its blossom.
struct NamedMap {
    std::string map = "P";
    std::string blossom = "p";
    std::string variable = "t";
    std::variant<PolynomialMap, BSplineCurve, TriangleMap, SymbolicMap> definition;
};

/// An argument that the formulas name, by its barycentric coordinates.
struct NamedPoint {
    std::string name;
    Coordinates barycentric;
};

/// One worked example.
struct Document {
    std::string title;
    std::string source;  ///< the place in the literature
    std::vector<NamedMap> maps;
    std::vector<NamedPoint> points;
    std::vector<std::string> symbols;  ///< the symbols that its formulas define
    /// The general claim, in formulas with indices and ranges instead of numbers.
    Blocks general;
    Blocks statement;
    std::vector<Step> steps;
    Blocks result;
    std::optional<Check> check;  ///< a sheet of problems has none, and no result
    /// The default notation of blossom values: if a blossom has the name of its map, it
    /// needs brackets.
    BlossomStyle style = BlossomStyle::parentheses;

    Blocks& step(std::string title_of_step) {
        return steps.emplace_back(Step{std::move(title_of_step), {}}).blocks;
    }
};

/// The largest degree of its maps.
std::size_t largest_degree(const Document& document);

}  // namespace blossom::worked
