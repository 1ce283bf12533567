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

/// Words with formulas between them.
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

/// A cell of a table. What is `shown` may stand for the value of `meaning`, which is not repeated in each
/// row; words may say that the relation `meaning` holds.
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
    Formula label;  ///< the blossom value that it is
    Formula value;
    std::optional<Formula> left_weight;   ///< on the arrow from node i of the level before
    std::optional<Formula> right_weight;  ///< on that from node i + 1
    bool on_left_edge = false;            ///< marked as a point of the left result
    bool on_right_edge = false;
};

/// De Casteljau's, de Boor's or another triangle: levels[r][i] is made of levels[r-1][i] and
/// levels[r-1][i+1].
struct TrianglePyramid {
    std::string caption;
    std::vector<std::vector<PyramidNode>> levels;
};

using Block = std::variant<Paragraph, Display, Table, TrianglePyramid, Picture>;

/// What stands on a page, in order.
struct Blocks : std::vector<Block> {
    using std::vector<Block>::vector;

    Blocks& say(Text text) { return add(Paragraph{std::move(text)}); }
    Blocks& show(std::vector<Formula> formulas) { return add(Display{std::move(formulas)}); }
    Blocks& add(Block block) {
        push_back(std::move(block));
        return *this;
    }
    /// Nothing where there is no picture.
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
    std::string verdict = "This holds exactly.";  ///< what is said where it holds
};

/// The sentence at the end of a check.
std::string said_of(const Check& check);

/// A map on a triangle, whose vertices may have coordinates.
struct TriangleMap {
    BezierPatch net;
    std::optional<BarycentricFrame> frame;
};

/// Any polynomial map, by what its coefficients are called.
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
    std::string source;  ///< where the literature has it
    std::vector<NamedMap> maps;
    std::vector<NamedPoint> points;
    std::vector<std::string> symbols;  ///< letters that its formulas define
    /// What is claimed in general, in formulas with indices and ranges instead of numbers.
    Blocks general;
    Blocks statement;
    std::vector<Step> steps;
    Blocks result;
    std::optional<Check> check;  ///< a sheet of problems has none, and no result
    /// How blossom values are written unless a reader chooses: where a blossom has the name of its map it
    /// needs brackets.
    BlossomStyle style = BlossomStyle::parentheses;

    Blocks& step(std::string title_of_step) {
        return steps.emplace_back(Step{std::move(title_of_step), {}}).blocks;
    }
};

/// The largest degree of its maps.
std::size_t largest_degree(const Document& document);

}  // namespace blossom::worked
