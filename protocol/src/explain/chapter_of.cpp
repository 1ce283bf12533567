#include "chapter_of.hpp"

#include <blossom/rational/lists.hpp>
#include <blossom/rational/number_text.hpp>
#include <blossom/worked/chapters.hpp>
#include <blossom/worked/proof_chapter.hpp>
#include <blossom/worked/triangle_chapters.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "floats.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "operations/blossom_arguments.hpp"
#include "operations/table.hpp"
#include "responses.hpp"

namespace blossom::protocol {

namespace {

using worked::Document;
using worked::GivenMap;

Error one_parameter(std::size_t asked) {
    return Error(ErrorCode::wrong_arity,
                 "a worked example is made for one parameter, not for " + std::to_string(asked), Place{"at"});
}

/// A request that was answered, so that its fields are known to be right.
class Asked {
public:
    Asked(const Json& request, const Answer& answer, const Limits& allowed)
        : limits(allowed), request_(request), answer_(answer) {}

    const Map& map() const { return answer_.given.front(); }
    const Json* find(std::string_view name) const { return request_.find(name); }
    std::vector<Argument> arguments() const {
        return read_arguments(*find("arguments"), {.scalar = true}, limits);
    }
    std::size_t count(std::string_view name, std::size_t otherwise) const {
        const Json* value = find(name);
        return value ? read_count(*value, limits) : otherwise;
    }
    Interval interval(const Interval& otherwise) const {
        const Json* value = find("interval");
        return value ? read_interval(*value, limits) : otherwise;
    }
    /// The only parameter of the field "at". Errors: `wrong_arity` for several: a page has one.
    Rational parameter() const {
        const Json& at = *find("at");
        if (!at.array()) return read_number(at, limits);
        if (at.array()->size() != 1) throw one_parameter(at.array()->size());
        return within("at", [&] {
            return within(std::size_t{0}, [&] { return read_number(at.array()->front(), limits); });
        });
    }

    const Limits& limits;

private:
    const Json& request_;
    const Answer& answer_;
};

GivenMap one_polynomial_of(const Asked& asked) {
    return {one_polynomial(asked.map(), asked.limits), asked.map().variable};
}

Document agreement_chapter(const Asked& asked) {
    const GivenMap given = one_polynomial_of(asked);
    if (!asked.find("arguments")) return worked::homogenisation(given, asked.limits);
    return worked::three_ways(given, asked.arguments(), asked.limits);
}

const BSplineCurve* spline_of(const Asked& asked) { return std::get_if<BSplineCurve>(&asked.map().value); }

/// The spline of an operation that takes only splines here. Errors: `wrong_kind`.
const BSplineCurve& required_spline(const Asked& asked) {
    const BSplineCurve* spline = spline_of(asked);
    if (!spline)
        throw Error(ErrorCode::wrong_kind, "a worked example is made for a bspline here", Place{"map"});
    return *spline;
}

/// The point of a page on a triangle, in barycentric coordinates. Errors: those of reading it.
Coordinates barycentric_point(const Patch& patch, const Json& at, const Limits& limits) {
    const std::vector<Rational> numbers = read_tuple(at, patch.parameters(), limits);
    if (patch.is_polynomial()) return BarycentricFrame::standard(2).of_point(numbers);
    return engine_arguments(patch, numbers, 1).front();
}

using TriangleChapter = Document (*)(const worked::GivenTriangle&, const Coordinates&, const Limits&);

/// Errors: `wrong_kind` unless the domain is one triangle; `wrong_arity` for several points.
Document triangle_chapter(const Asked& asked, TriangleChapter chapter) {
    const auto& patch = std::get<Patch>(asked.map().value);
    const NetShape& shape = patch.shape();
    if (shape.factors() != 1 || shape[0].dimension != 2) {
        throw Error(ErrorCode::wrong_kind,
                    "a worked example of a patch is made for one on a triangle, or for a polynomial in two "
                    "variables with a total degree",
                    Place{"map"});
    }
    worked::GivenTriangle given{patch.map, {}, patch.variables, asked.map().form.rational};
    if (!patch.frames.empty()) given.frame = patch.frames.front();
    const Json* at = asked.find("at");
    const bool list = at->array() && !at->array()->empty() && at->array()->front().array();
    if (list && at->array()->size() > 1) throw one_parameter(at->array()->size());
    if (at->text()) {
        throw Error(ErrorCode::wrong_kind,
                    "a worked example divides a triangle at a point, not at " + quoted(*at->text()),
                    Place{"at"});
    }
    return chapter(given, barycentric_point(patch, list ? at->array()->front() : *at, asked.limits),
                   asked.limits);
}

bool has_patch(const Asked& asked) { return std::holds_alternative<Patch>(asked.map().value); }

Document evaluation_chapter(const Asked& asked) {
    if (has_patch(asked)) return triangle_chapter(asked, worked::triangle_evaluation);
    if (const BSplineCurve* spline = spline_of(asked)) {
        return worked::de_boor_at(*spline, asked.parameter(), asked.limits);
    }
    if (asked.map().form.separate_weights()) {
        return worked::rational_arc(one_polynomial_of(asked), asked.parameter(), asked.limits);
    }
    return worked::evaluation_at(one_polynomial_of(asked), asked.parameter(), asked.limits);
}

Document derivative_chapter(const Asked& asked) {
    if (!asked.find("at")) {
        throw Error(ErrorCode::missing_field, "a worked example of a derivative needs a parameter",
                    Place{"at"});
    }
    return worked::derivative_by_delta(one_polynomial_of(asked), asked.count("order", 1), asked.parameter(),
                                       asked.limits);
}

Document control_points_chapter(const Asked& asked) {
    const GivenMap given = one_polynomial_of(asked);
    const auto* bezier = std::get_if<BezierCurve>(&given.map);
    return worked::control_points_over(given, asked.interval(bezier ? bezier->interval() : Interval()),
                                       asked.limits);
}

Document subdivision_chapter(const Asked& asked) {
    if (has_patch(asked)) return triangle_chapter(asked, worked::triangle_subdivision);
    return worked::subdivision_at(one_polynomial_of(asked), asked.parameter(), asked.limits);
}

Document elevation_chapter(const Asked& asked) {
    return worked::degree_raised(one_polynomial_of(asked), asked.count("by", 1), asked.limits);
}

Document conversion_chapter(const Asked& asked) {
    const GivenMap given = one_polynomial_of(asked);
    const std::string& to = *asked.find("to")->text();
    if (to == "monomial") return worked::control_points_to_coefficients(given, asked.limits);
    if (to != "bernstein") {
        throw Error(ErrorCode::wrong_kind,
                    "a worked example is made of a conversion to monomial or bernstein, not to " + to,
                    Place{"to"});
    }
    const Interval interval = asked.interval(Interval());
    if (std::holds_alternative<PolynomialCurve>(given.map) && interval == Interval()) {
        return worked::coefficients_to_control_points(given, asked.limits);
    }
    return worked::control_points_over(given, interval, asked.limits);
}

Document segments_chapter(const Asked& asked) {
    return worked::spline_to_bezier(required_spline(asked), asked.limits);
}

Document insertion_chapter(const Asked& asked) {
    const std::vector<Rational> knots = read_numbers(*asked.find("knots"), asked.limits);
    return worked::knots_inserted(required_spline(asked), knots, asked.limits);
}

Document continuity_chapter(const Asked& asked) {
    return worked::continuity_at(required_spline(asked), asked.parameter(), asked.limits);
}

/// A page for each claim of one statement, or of several.
std::vector<Document> pages_of_claims(const Json& statement, const Limits& limits) {
    if (!statement.array()) return worked::claims_decided(read_text(statement), limits);
    if (statement.array()->empty()) throw Error(ErrorCode::wrong_arity, "there is no statement");
    std::vector<Document> pages;
    for (auto& of_one : read_list(statement, [&](const Json& one) { return pages_of_claims(one, limits); }))
        std::ranges::move(of_one, std::back_inserter(pages));
    return pages;
}

/// The pages decide the claims, so that a request to prove is not answered first.
std::vector<Document> proof_pages(const Json& request, const Limits& limits) {
    Fields fields(request);
    for (const std::string_view name : {"op", "id", "numbers"})
        static_cast<void>(fields.optional(name, [](const Json& value) { return &value; }));
    std::vector<Document> pages = fields.required(
        "statement", [&](const Json& statement) { return pages_of_claims(statement, limits); });
    fields.finish();
    return pages;
}

/// Says of a rational curve what its points mean, unless its page says so itself.
Document with_weights(Document document, const Json& request, const Answer& answer) {
    if (answer.given.empty()) return document;
    const Map& map = answer.given.front();
    const bool said =
        std::holds_alternative<Patch>(map.value) ||
        (*request.find("op")->text() == "evaluate" && !std::holds_alternative<BSplineCurve>(map.value));
    if (!map.form.rational || (said && !map.form.homogeneous)) return document;
    document.statement.emplace_back(worked::Paragraph{
        "The curve is rational, and all its values here are homogeneous: the last coordinate is a weight, "
        "and "
        "a point of the curve has the others divided by it. All that is said is of the homogeneous curve."});
    return document;
}

struct Chapter {
    std::string_view operation;
    Document (*make)(const Asked& asked);
};

constexpr std::array<Chapter, 11> chapters{{{"agree", agreement_chapter},
                                            {"blossom", agreement_chapter},
                                            {"evaluate", evaluation_chapter},
                                            {"derivative", derivative_chapter},
                                            {"control-points", control_points_chapter},
                                            {"convert", conversion_chapter},
                                            {"subdivide", subdivision_chapter},
                                            {"elevate", elevation_chapter},
                                            {"insert-knots", insertion_chapter},
                                            {"segments", segments_chapter},
                                            {"continuity", continuity_chapter}}};

}  // namespace

std::vector<std::string_view> chapter_names() {
    std::vector<std::string_view> names = mapped(chapters, &Chapter::operation);
    names.push_back(prove_name);
    return names;
}

bool has_chapter(std::string_view operation) {
    const std::vector<std::string_view> names = chapter_names();
    return std::ranges::find(names, operation) != names.end();
}

std::string no_chapter(std::string_view operation) {
    return "there is no chapter for the operation " + quoted(operation) + "; there is for " +
           joined(chapter_names());
}

std::vector<Document> chapters_of(const Json& given, const Limits& limits) {
    const std::optional<Json> exact = with_exact_floats(given, limits);
    const Json& request = exact ? *exact : given;
    const Json* name = request.find("op");
    if (name && name->text() && *name->text() == prove_name) return proof_pages(request, limits);
    const Answer answer = find_answer(request, limits);
    const auto* chapter = std::ranges::find(chapters, *name->text(), &Chapter::operation);
    if (chapter == chapters.end()) throw Error(ErrorCode::unknown_op, no_chapter(*name->text()), Place{"op"});
    return {with_weights(chapter->make(Asked(request, answer, limits)), request, answer)};
}

}  // namespace blossom::protocol
