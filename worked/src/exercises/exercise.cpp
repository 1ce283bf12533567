#include <blossom/rational/error.hpp>
#include <blossom/rational/lists.hpp>
#include <blossom/rational/number_text.hpp>
#include <blossom/worked/chapters.hpp>
#include <blossom/worked/exercise.hpp>
#include <blossom/worked/triangle_chapters.hpp>

#include <algorithm>
#include <array>
#include <utility>

#include "problem_numbers.hpp"

namespace blossom::worked {

namespace {

struct Topic {
    std::string_view name;
    std::string_view title;
    Document (*make)(ProblemNumbers& numbers);
};

constexpr std::array<Topic, 16> topics{
    {{"blossom", "Blossom values in three ways",
      [](ProblemNumbers& numbers) {
          const PolynomialCurve curve = numbers.polynomial();
          return three_ways({curve}, numbers.arguments(curve.degree()));
      }},
     {"homogenisation", "Blossoming and homogenising",
      [](ProblemNumbers& numbers) { return homogenisation({numbers.polynomial()}); }},
     {"evaluation", "De Casteljau's algorithm",
      [](ProblemNumbers& numbers) {
          const BezierCurve curve = numbers.polygon();
          return evaluation_at({curve}, numbers.inside(curve.interval()));
      }},
     {"derivative", "Derivatives by delta",
      [](ProblemNumbers& numbers) {
          const PolynomialCurve curve = numbers.polynomial();
          const std::size_t order = numbers.level() == 1 ? 1 : 2;
          return derivative_by_delta({curve}, order, numbers.inside(Interval(0, 2)));
      }},
     {"control-points", "Control points over an interval",
      [](ProblemNumbers& numbers) {
          return control_points_over({numbers.polynomial()}, numbers.interval());
      }},
     {"subdivision", "Subdivision",
      [](ProblemNumbers& numbers) {
          const BezierCurve curve = numbers.polygon();
          return subdivision_at({curve}, numbers.inside(curve.interval()));
      }},
     {"degree-raising", "Degree raising",
      [](ProblemNumbers& numbers) { return degree_raised({numbers.polygon()}, 1); }},
     {"conversion", "From coefficients to control points",
      [](ProblemNumbers& numbers) { return coefficients_to_control_points({numbers.polynomial()}); }},
     {"coefficients", "From control points to coefficients",
      [](ProblemNumbers& numbers) { return control_points_to_coefficients({numbers.polygon()}); }},
     {"spline-to-bezier", "From B-splines to Bézier curves",
      [](ProblemNumbers& numbers) { return spline_to_bezier(numbers.spline()); }},
     {"de-boor", "De Boor's algorithm",
      [](ProblemNumbers& numbers) {
          const BSplineCurve curve = numbers.spline();
          return de_boor_at(curve, numbers.inside(curve.knots().domain()));
      }},
     {"knot-insertion", "Knot insertion",
      [](ProblemNumbers& numbers) {
          const BSplineCurve curve = numbers.spline();
          return knots_inserted(curve, std::array{numbers.inside(curve.knots().domain())});
      }},
     {"continuity", "Continuity at a knot",
      [](ProblemNumbers& numbers) { return continuity_at(numbers.joint(), 1); }},
     {"rational-arc", "Rational arcs",
      [](ProblemNumbers& numbers) {
          const BezierCurve curve = numbers.weighted_polygon();
          return rational_arc({curve}, numbers.inside(curve.interval()));
      }},
     {"triangle", "De Casteljau's algorithm on a triangle",
      [](ProblemNumbers& numbers) {
          const BezierPatch net = numbers.triangle();
          return triangle_evaluation({net, {}, {}, false}, numbers.inside_triangle());
      }},
     {"triangle-subdivision", "Subdivision of a triangle", [](ProblemNumbers& numbers) {
          const BezierPatch net = numbers.triangle();
          return triangle_subdivision({net, {}, {}, false}, numbers.inside_triangle());
      }}}};

const Topic& find_topic(std::string_view name) {
    const auto found = std::ranges::find(topics, name, &Topic::name);
    if (found != topics.end()) return *found;
    throw Error(ErrorCode::unknown_op, "there are no exercises on " + quoted(name) + "; there are on " +
                                           joined(topics, &Topic::name));
}

/// The problems of one topic.
struct Source {
    const Topic& topic;
    ProblemNumbers numbers;

    Source(const Topic& own, const SheetRequest& request)
        : topic(own), numbers(request.seed, request.level, own.name) {}
};

class Renaming {
public:
    Renaming(const Document& document, std::string index)
        : symbols_(document.symbols), index_(std::move(index)) {
        for (const NamedMap& map : document.maps) {
            names_.push_back(map.map);
            names_.push_back(map.blossom);
        }
        for (const NamedPoint& point : document.points) {
            if (!is_vertex(point)) symbols_.push_back(point.name);
        }
    }

    /// Vertices have the same names in every problem.
    static bool is_vertex(const NamedPoint& point) {
        return std::ranges::count(point.barycentric, Rational(1)) == 1 &&
               std::ranges::count(point.barycentric, Rational(0)) == 2;
    }

    void apply(NamedPoint& point) const {
        if (!is_vertex(point)) point.name += index_;
    }

    void apply(std::string& name) const {
        if (std::ranges::find(names_, name) != names_.end()) name += index_;
    }

    void apply(Formula& formula) const {
        const bool named = std::ranges::find(symbols_, formula.name) != symbols_.end();
        if (formula.kind == FormulaKind::symbol && named) {
            formula = symbol(formula.name + index_);
            return;
        }
        if (formula.kind != FormulaKind::symbol && formula.kind != FormulaKind::words) apply(formula.name);
        for (Formula& part : formula.parts) apply(part);
    }

    void apply(Text& text) const {
        Text renamed;
        for (Text::Part part : text.parts()) {
            if (auto* formula = std::get_if<Formula>(&part)) apply(*formula);
            renamed.append(Text{std::move(part)});
        }
        text = std::move(renamed);
    }

    void apply(Blocks& blocks) const {
        for (Block& block : blocks) std::visit([&](auto& content) { apply(content); }, block);
    }

    void apply(Paragraph& paragraph) const { apply(paragraph.text); }

    void apply(Display& display) const {
        for (Formula& formula : display.formulas) apply(formula);
    }

    void apply(Table& table) const {
        for (Text& title : table.header) apply(title);
        for (auto& row : table.rows) {
            for (Cell& cell : row) {
                apply(cell.shown);
                if (cell.meaning) apply(*cell.meaning);
            }
        }
    }

    void apply(TrianglePyramid& pyramid) const {
        for (auto& level : pyramid.levels) {
            for (PyramidNode& node : level) apply(node.label);
        }
    }

    void apply(Picture& picture) const {
        for (PicturePoint& point : picture.points) {
            apply(point.label);
            if (point.meaning) apply(*point.meaning);
        }
    }

private:
    std::vector<std::string> names_;
    std::vector<std::string> symbols_;
    std::string index_;
};

/// The document with an index behind the names of its maps and blossoms, P1 and p1, so that several documents
/// can stand side by side.
Document renamed(Document document, const std::string& index) {
    const Renaming renaming(document, index);
    for (NamedMap& map : document.maps) {
        renaming.apply(map.map);
        renaming.apply(map.blossom);
    }
    for (NamedPoint& point : document.points) renaming.apply(point);
    renaming.apply(document.statement);
    for (Step& step : document.steps) renaming.apply(step.blocks);
    renaming.apply(document.result);
    if (document.check) renaming.apply(document.check->blocks);
    return document;
}

/// The contents of a document as the blocks of one step, each of its steps under its title.
Step solution(const Document& document, std::string title) {
    Step step{std::move(title), document.statement};
    const auto append = [&](const std::string& heading, const std::vector<Block>& blocks) {
        step.blocks.say(heading + ".");
        step.blocks.insert(step.blocks.end(), blocks.begin(), blocks.end());
    };
    for (const Step& part : document.steps) append(part.title, part.blocks);
    append("Result", document.result);
    append("Check", document.check->blocks);
    return step;
}

/// Whether two problems have the same formulas.
bool alike(const Document& a, const Document& b) {
    const auto what = [](const Document& document) {
        std::vector<Formula> formulas;
        for (const Block& block : document.statement) {
            if (const auto* display = std::get_if<Display>(&block)) {
                formulas.insert(formulas.end(), display->formulas.begin(), display->formulas.end());
            }
        }
        return formulas;
    };
    return what(a) == what(b);
}

}  // namespace

std::vector<std::string_view> exercise_topics() { return mapped(topics, &Topic::name); }

void require_topic(std::string_view name) { find_topic(name); }

Sheet exercise_sheet(const SheetRequest& request) {
    if (request.topics.empty()) throw Error(ErrorCode::wrong_arity, "a sheet needs a topic", Part::topic);
    if (request.count < request.topics.size()) {
        throw Error(ErrorCode::wrong_arity,
                    "a sheet on " + std::to_string(request.topics.size()) +
                        " topics has at least as many problems, not " + std::to_string(request.count),
                    Part::count);
    }
    require_within(request.count, most_problems, "problems of a sheet", "number of problems", Part::count);
    if (request.level < 1 || request.level > 3) {
        throw Error(ErrorCode::wrong_arity, "the level is 1, 2 or 3, not " + std::to_string(request.level),
                    Part::level);
    }
    std::vector<Source> sources =
        mapped(request.topics, [&](const std::string& name) { return Source(find_topic(name), request); });
    std::vector<Document> problems;
    while (problems.size() < request.count) {
        Source& source = sources[problems.size() % sources.size()];
        Document problem = source.topic.make(source.numbers);
        const bool repeated =
            std::ranges::any_of(problems, [&](const Document& earlier) { return alike(earlier, problem); });
        if (!repeated) problems.push_back(std::move(problem));
    }
    const std::string title = joined(sources, [](const Source& source) { return source.topic.title; }) +
                              ", level " + std::to_string(request.level) + ", sheet " +
                              std::to_string(request.seed);
    Sheet sheet;
    sheet.problems.title = title;
    sheet.solutions.title = title + ": solutions";
    for (std::size_t i = 0; i < problems.size(); ++i) {
        const Document problem = renamed(problems[i], std::to_string(i + 1));
        sheet.problems.steps.push_back({"Problem", problem.statement});
        sheet.solutions.steps.push_back(solution(problem, "Problem"));
        for (Document* document : {&sheet.problems, &sheet.solutions}) {
            const auto& maps = problem.maps;
            const auto end = document == &sheet.problems ? maps.begin() + 1 : maps.end();
            document->maps.insert(document->maps.end(), maps.begin(), end);
            document->points.insert(document->points.end(), problem.points.begin(), problem.points.end());
        }
    }
    return sheet;
}

}  // namespace blossom::worked
