#include <blossom/rational/lists.hpp>
#include <blossom/worked/json.hpp>
#include <blossom/worked/render.hpp>

#include <array>
#include <string>

#include "document/overloaded.hpp"

namespace blossom::worked {

namespace {

/// In the order of `FormulaKind`.
constexpr std::array<std::string_view, 25> kind_names{
    "number",    "symbol",   "words",       "sum",        "product", "fraction",   "power",
    "index",     "call",     "application", "derivative", "blossom", "elementary", "binomial",
    "factorial", "tuple",    "list",        "repeated",   "pair",    "size",       "cases",
    "set",       "interval", "summation",   "relation"};
static_assert(kind_names.size() == static_cast<std::size_t>(FormulaKind::relation) + 1);

bool has_value(FormulaKind kind) {
    return kind == FormulaKind::number || kind == FormulaKind::derivative || kind == FormulaKind::elementary;
}

Json::Array array_of(const auto& items, const auto& write) {
    Json::Array list;
    list.reserve(items.size());
    for (const auto& item : items) list.emplace_back(write(item));
    return list;
}

Json tree(const Formula& formula) {
    Json json = Json::Object{{"kind", kind_names[static_cast<std::size_t>(formula.kind)]}};
    if (has_value(formula.kind)) json["value"] = formula.value;
    if (formula.kind == FormulaKind::blossom && formula.value.sign() > 0) {
        json["span"] = Json::Number{to_string(formula.value - Rational(1))};
    }
    if (!formula.name.empty()) json["name"] = formula.name;
    if (!formula.parts.empty()) json["parts"] = array_of(formula.parts, tree);
    return json;
}

Json numbers(const std::vector<Rational>& list) { return Json::Array(list.begin(), list.end()); }

Json points(const std::vector<Coordinates>& list) { return array_of(list, numbers); }

Json coordinates(const PlanePoint& place) { return Json::Array{place.x, place.y}; }

Json places(const std::vector<PlanePoint>& list) { return array_of(list, coordinates); }

struct DefinitionWriter {
    Json operator()(const PolynomialCurve& curve) const {
        return Json::Object{{"kind", "polynomial"},
                            {"coefficients", points(curve.coefficients().to_points())}};
    }
    Json operator()(const BezierCurve& curve) const {
        return Json::Object{{"kind", "bezier"},
                            {"interval", numbers({curve.interval().a(), curve.interval().b()})},
                            {"control_points", points(curve.control_points().to_points())}};
    }
    Json operator()(const BSplineCurve& curve) const {
        return Json::Object{{"kind", "bspline"},
                            {"degree", curve.degree()},
                            {"knots", numbers(curve.knots().knots())},
                            {"control_points", points(curve.control_points())}};
    }
    Json operator()(const TriangleMap& triangle) const {
        Json json = Json::Object{{"kind", "triangle"},
                                 {"degree", triangle.net.shape()[0].degree},
                                 {"control_net", points(triangle.net.control_net().to_points())}};
        if (triangle.frame) json["vertices"] = points(triangle.frame->vertices());
        return json;
    }
    Json operator()(const SymbolicMap& any) const {
        return Json::Object{{"kind", "symbolic"}, {"coefficients", array_of(any.coefficients, tree)}};
    }
    Json operator()(const PolynomialMap& map) const { return std::visit(*this, map); }
};

/// A formula with how it reads, for who does not want to print trees.
struct FormulaWriter {
    const Notation& notation;

    Json operator()(const Formula& formula) const {
        return Json::Object{{"tree", tree(formula)},
                            {"text", to_text(formula, notation)},
                            {"latex", to_latex(formula, notation)}};
    }
};

class JsonWriter {
public:
    explicit JsonWriter(const Notation& notation) : formula_{notation} {}

    Json write(const Document& document) const {
        const auto map = [](const NamedMap& named) {
            return Json::Object{{"map", named.map},
                                {"blossom", named.blossom},
                                {"variable", named.variable},
                                {"definition", std::visit(DefinitionWriter(), named.definition)}};
        };
        const auto step = [&](const Step& one) {
            return Json::Object{{"title", one.title}, {"blocks", blocks(one.blocks)}};
        };
        Json json = Json::Object{{"title", document.title},
                                 {"source", document.source},
                                 {"maps", array_of(document.maps, map)},
                                 {"points", Json::Object()},
                                 {"statement", blocks(document.statement)},
                                 {"steps", array_of(document.steps, step)},
                                 {"result", blocks(document.result)}};
        if (!document.general.empty()) json["general"] = blocks(document.general);
        for (const NamedPoint& point : document.points) {
            json["points"][point.name] = numbers(point.barycentric);
        }
        if (document.check) {
            json["check"] =
                Json::Object{{"blocks", blocks(document.check->blocks)}, {"holds", document.check->holds}};
        }
        return json;
    }

private:
    Json blocks(const std::vector<Block>& list) const {
        return array_of(list, [&](const Block& block) {
            return std::visit([&](const auto& content) { return this->block(content); }, block);
        });
    }

    Json block(const Paragraph& paragraph) const { return Json::Object{{"paragraph", text(paragraph.text)}}; }

    Json block(const Display& display) const {
        return Json::Object{{"display", array_of(display.formulas, formula_)}};
    }

    Json block(const Table& table) const {
        const auto cell = [&](const Cell& one) {
            Json json = Json::Object{{"shown", text(one.shown)}};
            if (one.meaning) json["meaning"] = tree(*one.meaning);
            return json;
        };
        const auto title = [&](const Text& one) { return text(one); };
        const auto row = [&](const std::vector<Cell>& cells) { return array_of(cells, cell); };
        return Json::Object{{"table", Json::Object{{"caption", table.caption},
                                                   {"header", array_of(table.header, title)},
                                                   {"rows", array_of(table.rows, row)}}}};
    }

    Json block(const TrianglePyramid& pyramid) const {
        const auto node = [&](const PyramidNode& one) { return this->node(one); };
        const auto level = [&](const std::vector<PyramidNode>& nodes) { return array_of(nodes, node); };
        return Json::Object{{"pyramid", Json::Object{{"caption", pyramid.caption},
                                                     {"levels", array_of(pyramid.levels, level)}}}};
    }

    Json block(const Picture& picture) const {
        const auto curve = [](const PictureCurve& one) {
            return Json::Object{
                {"role", role_name(one.role)}, {"cubic", one.cubic}, {"places", places(one.places)}};
        };
        const auto line = [](const PictureLine& one) {
            return Json::Object{{"role", role_name(one.role)}, {"places", places(one.places)}};
        };
        const auto point = [&](const PicturePoint& one) {
            Json json = Json::Object{{"role", role_name(one.role)},
                                     {"place", coordinates(one.place)},
                                     {"label", formula_(one.label)}};
            if (one.meaning) json["meaning"] = tree(*one.meaning);
            return json;
        };
        Json json = Json::Object{{"caption", picture.caption},
                                 {"description", picture.description},
                                 {"graph", picture.graph},
                                 {"curves", array_of(picture.curves, curve)},
                                 {"lines", array_of(picture.lines, line)},
                                 {"points", array_of(picture.points, point)}};
        if (!picture.projection.empty()) json["projection"] = points(picture.projection);
        if (!picture.corners.empty()) json["corners"] = places(picture.corners);
        return Json::Object{{"picture", std::move(json)}};
    }

    Json node(const PyramidNode& node) const {
        Json json = Json::Object{{"label", formula_(node.label)}, {"value", tree(node.value)}};
        if (node.left_weight) json["left_weight"] = tree(*node.left_weight);
        if (node.right_weight) json["right_weight"] = tree(*node.right_weight);
        if (node.on_left_edge) json["on_left_edge"] = true;
        if (node.on_right_edge) json["on_right_edge"] = true;
        return json;
    }

    Json text(const Text& text) const {
        return array_of(text.parts(), [&](const Text::Part& part) {
            return std::visit(Overloaded{[](const std::string& words) { return Json(words); }, formula_},
                              part);
        });
    }

    FormulaWriter formula_;
};

}  // namespace

std::string render_json(const Document& document, const Notation& notation) {
    return to_text(JsonWriter(notation).write(document), 1) + "\n";
}

}  // namespace blossom::worked
