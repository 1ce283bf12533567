#include <blossom/worked/render.hpp>

#include <nlohmann/json.hpp>

#include <string>

#include "document/overloaded.hpp"
#include "formula_json.hpp"
#include "pyramid_text.hpp"

namespace blossom::worked {

namespace {

using Json = nlohmann::ordered_json;

Json coordinates(const Place& place) { return {to_string(place.x), to_string(place.y)}; }

Json places(const std::vector<Place>& list) {
    Json json = Json::array();
    for (const Place& place : list) json.push_back(coordinates(place));
    return json;
}

Json points(const std::vector<Coordinates>& list) {
    Json json = Json::array();
    for (const Coordinates& point : list) {
        Json& entry = json.emplace_back(Json::array());
        for (const Rational& coordinate : point) entry.push_back(to_string(coordinate));
    }
    return json;
}

Json numbers(const std::vector<Rational>& list) {
    Json json = Json::array();
    for (const Rational& value : list) json.push_back(to_string(value));
    return json;
}

struct DefinitionWriter {
    Json operator()(const PolynomialCurve& curve) const {
        return {{"kind", "polynomial"}, {"coefficients", points(curve.coefficients().to_points())}};
    }
    Json operator()(const BezierCurve& curve) const {
        return {{"kind", "bezier"},
                {"interval", numbers({curve.interval().a(), curve.interval().b()})},
                {"control_points", points(curve.control_points().to_points())}};
    }
    Json operator()(const BSplineCurve& curve) const {
        return {{"kind", "bspline"},
                {"degree", curve.degree()},
                {"knots", numbers(curve.knots().knots())},
                {"control_points", points(curve.control_points())}};
    }
    Json operator()(const TriangleMap& triangle) const {
        Json json{{"kind", "triangle"},
                  {"degree", triangle.net.shape()[0].degree},
                  {"control_net", points(triangle.net.control_net().to_points())}};
        if (triangle.frame) json["vertices"] = points(triangle.frame->vertices());
        return json;
    }
    Json operator()(const SymbolicMap& any) const {
        Json coefficients = Json::array();
        for (const Formula& coefficient : any.coefficients) coefficients.push_back(to_json(coefficient));
        return {{"kind", "symbolic"}, {"coefficients", std::move(coefficients)}};
    }
    Json operator()(const PolynomialMap& map) const { return std::visit(*this, map); }
};

class JsonWriter {
public:
    explicit JsonWriter(const Notation& notation) : notation_(notation) {}

    Json write(const Document& document) const {
        Json maps = Json::array();
        for (const NamedMap& map : document.maps) {
            maps.push_back({{"map", map.map},
                            {"blossom", map.blossom},
                            {"variable", map.variable},
                            {"definition", std::visit(DefinitionWriter(), map.definition)}});
        }
        Json steps = Json::array();
        for (const Step& step : document.steps) {
            steps.push_back({{"title", step.title}, {"blocks", blocks(step.blocks)}});
        }
        Json json{{"title", document.title},
                  {"source", document.source},
                  {"maps", std::move(maps)},
                  {"points", Json::object()},
                  {"statement", blocks(document.statement)},
                  {"steps", std::move(steps)},
                  {"result", blocks(document.result)}};
        if (!document.general.empty()) json["general"] = blocks(document.general);
        for (const NamedPoint& point : document.points) {
            json["points"][point.name] = numbers(point.barycentric);
        }
        if (document.check) {
            json["check"] = {{"blocks", blocks(document.check->blocks)}, {"holds", document.check->holds}};
        }
        return json;
    }

private:
    Json blocks(const std::vector<Block>& list) const {
        Json json = Json::array();
        for (const Block& block : list) {
            json.push_back(std::visit([&](const auto& content) { return this->block(content); }, block));
        }
        return json;
    }

    Json block(const Paragraph& paragraph) const { return {{"paragraph", text(paragraph.text)}}; }

    Json block(const Display& display) const {
        Json formulas = Json::array();
        for (const Formula& formula : display.formulas) formulas.push_back(this->formula(formula));
        return {{"display", std::move(formulas)}};
    }

    Json block(const Table& table) const {
        Json header = Json::array();
        for (const Text& title : table.header) header.push_back(text(title));
        Json rows = Json::array();
        for (const auto& cells : table.rows) {
            Json& row = rows.emplace_back(Json::array());
            for (const Cell& cell : cells) {
                row.push_back({{"shown", text(cell.shown)}});
                if (cell.meaning) row.back()["meaning"] = to_json(*cell.meaning);
            }
        }
        return {{"table",
                 {{"caption", table.caption}, {"header", std::move(header)}, {"rows", std::move(rows)}}}};
    }

    Json block(const TrianglePyramid& pyramid) const {
        Json levels = Json::array();
        for (const auto& nodes : pyramid.levels) {
            Json& level = levels.emplace_back(Json::array());
            for (const PyramidNode& node : nodes) level.push_back(this->node(node));
        }
        return {{"pyramid", {{"caption", pyramid.caption}, {"levels", std::move(levels)}}}};
    }

    Json block(const Picture& picture) const {
        Json json{{"caption", picture.caption}, {"description", picture.description},
                  {"graph", picture.graph},     {"curves", Json::array()},
                  {"lines", Json::array()},     {"points", Json::array()}};
        if (!picture.projection.empty()) json["projection"] = points(picture.projection);
        if (!picture.corners.empty()) json["corners"] = places(picture.corners);
        for (const PictureCurve& curve : picture.curves) {
            json["curves"].push_back(
                {{"role", role_name(curve.role)}, {"cubic", curve.cubic}, {"places", places(curve.places)}});
        }
        for (const PictureLine& line : picture.lines) {
            json["lines"].push_back({{"role", role_name(line.role)}, {"places", places(line.places)}});
        }
        for (const PicturePoint& point : picture.points) {
            json["points"].push_back({{"role", role_name(point.role)},
                                      {"place", coordinates(point.place)},
                                      {"label", formula(point.label)}});
            if (point.meaning) json["points"].back()["meaning"] = to_json(*point.meaning);
        }
        return {{"picture", std::move(json)}};
    }

    Json node(const PyramidNode& node) const {
        Json json{{"label", formula(node.label)}, {"value", to_json(node.value)}};
        if (node.left_weight) json["left_weight"] = to_json(*node.left_weight);
        if (node.right_weight) json["right_weight"] = to_json(*node.right_weight);
        if (node.on_left_edge) json["on_left_edge"] = true;
        if (node.on_right_edge) json["on_right_edge"] = true;
        return json;
    }

    /// A formula with how it reads, for who does not want to print trees.
    Json formula(const Formula& formula) const {
        return {{"tree", to_json(formula)},
                {"text", to_text(formula, notation_)},
                {"latex", to_latex(formula, notation_)}};
    }

    Json text(const Text& text) const {
        Json json = Json::array();
        for (const Text::Part& part : text.parts()) {
            json.push_back(
                std::visit(Overloaded{[](const std::string& words) { return Json(words); },
                                      [&](const Formula& formula) { return this->formula(formula); }},
                           part));
        }
        return json;
    }

    const Notation& notation_;
};

}  // namespace

std::string render_json(const Document& document, const Notation& notation) {
    return JsonWriter(notation).write(document).dump(1) + "\n";
}

}  // namespace blossom::worked
