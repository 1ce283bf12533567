#include <fmt/format.h>
#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/roots.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>

#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

/// The numerator of a scalar curve without the factors that it shares with the denominator.
Polynomial numerator(const PolynomialMap& map, const PointForm& form, const Limits& limits) {
    const PolynomialCurve curve = monomial_form(map, limits);
    if (!form.rational) return curve.coordinate(0);
    const Polynomial common = gcd(curve.coordinate(0), curve.coordinate(1));
    return divide_exactly(curve.coordinate(0), common);
}

Interval increasing(const Interval& interval) {
    return interval.a() < interval.b() ? interval : Interval(interval.b(), interval.a());
}

struct RootsOf {
    const PointForm& form;
    std::optional<Interval> interval;
    Rational width;
    const Limits& limits;

    std::vector<Root> operator()(const OnePolynomial auto& curve) const {
        const Interval where = increasing(interval.value_or(interval_of(curve)));
        return within("map", [&] {
            return roots(numerator(polynomial_map(curve, limits), form, limits), where, width, limits);
        });
    }
    /// A root at a joint belongs to the segment on its right, as in evaluation.
    std::vector<Root> operator()(const BSplineCurve& curve) const {
        const Interval domain = curve.knots().domain();
        const Interval where = increasing(interval.value_or(domain));
        std::vector<Root> all;
        for (const BezierCurve& segment : bezier_segments(curve, limits)) {
            const Rational& begin = std::max(segment.interval().a(), where.a());
            const Rational& end = std::min(segment.interval().b(), where.b());
            if (end < begin || (begin == end && end != domain.b())) continue;
            append(segment, begin, end, end == where.b() || end == domain.b(), all);
        }
        return all;
    }

private:
    void append(const BezierCurve& segment, const Rational& begin, const Rational& end, bool with_end,
                std::vector<Root>& all) const {
        const Interval inside = begin == end ? segment.interval() : Interval(begin, end);
        for (const Root& root : RootsOf{form, inside, width, limits}(segment)) {
            const bool wanted = begin <= root.lower && root.upper <= end;
            if (wanted && (with_end || root.lower != end)) all.push_back(root);
        }
    }
};

Answer answer_roots(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const auto interval =
        request.optional("interval", [&](const Json& value) { return read_interval(value, limits); });
    const auto width =
        request.optional("width", [&](const Json& value) { return read_number(value, limits); });
    request.finish();
    if (!map.form.scalar) {
        throw Error(ErrorCode::wrong_kind,
                    "only a map whose values are numbers has roots; this one has points", Place{"map"});
    }
    if (width && width->sign() <= 0) {
        throw Error(ErrorCode::wrong_kind, "the width of an interval is greater than 0", Place{"width"});
    }
    const auto found =
        dispatch_on_kind<std::vector<Root>>(map, RootsOf{map.form, interval, width.value_or(0), limits});
    Json::Array list;
    for (const Root& root : found) {
        Json entry;
        if (root.is_rational()) {
            entry["value"] = root.lower;
        } else {
            entry["interval"] = Json::Array{root.lower, root.upper};
        }
        entry["multiplicity"] = root.multiplicity;
        list.push_back(std::move(entry));
    }
    return Json::Object{{"roots", std::move(list)}};
}

std::string render_roots(const Answered& answered) {
    std::string text = description(answered.given()) + "\n\n";
    const Json::Array& list = *answered.result().find("roots")->array();
    if (list.empty()) return text + "There is no root in this interval.\n";
    for (const Json& root : list) {
        const std::string multiplicity = point_text(*root.find("multiplicity"));
        const std::string times = multiplicity == "1" ? "" : ", multiplicity " + multiplicity;
        if (root.find("value")) {
            text += fmt::format("  t = {}{}\n", answered.style.bold(member_text(root, "value")), times);
        } else {
            const std::vector<std::string> ends = member_texts(root, "interval");
            text += fmt::format("  {} < t < {}{}\n", ends[0], ends[1], times);
        }
    }
    return text;
}

Shape root_shape() {
    return Shape::object(
        {{required("multiplicity", ValueKind::count, "the multiplicity of the root")},
         {{{required("value", ValueKind::number, "a rational root")},
           {required("interval", ValueKind::interval, "an open interval with this root and no other")}}}});
}

}  // namespace

Operation roots_operation() {
    return {
        .summary = "Isolate the real roots of a scalar map in an interval, with their multiplicities",
        .documentation = "A rational root is given exactly, any other by an interval that has no other root.",
        .request = {{map_field(),
                     optional("interval", ValueKind::interval,
                              "the closed interval of the roots; by default that of the map, or [0, 1]"),
                     optional("width", ValueKind::number,
                              "the maximal width of the intervals around irrational roots")}},
        .result = {{required("roots", Shape::list(root_shape()), "the roots in increasing order")}},
        .example = {"roots", "(t^2 - 2)(2t - 1)^2", "--interval", "0,2"},
        .options = with_map_options({
            own_interval_option(
                "the interval of the given control points, or else that of the roots; by default 0,1"),
            field_option("--over", "interval", "A,B", number_list,
                         "the interval of the roots; by default that of the map, 0,1 for a polynomial"),
            field_option("--width", "width", "W", plain_text),
        }),
        .answer = answer_roots,
        .render = render_roots,
    };
}

}  // namespace blossom::protocol
