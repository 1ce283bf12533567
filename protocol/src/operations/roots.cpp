#include <fmt/format.h>
#include <blossom/core/spline/spline_roots.hpp>
#include <blossom/rational/double_conversion.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>

#include "formats/doubles.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

/// What the request asks of a scalar map.
struct RootsOf {
    std::optional<ParameterRange> range;
    Rational width;
    const Limits& limits;

    ParameterRange range_of(const OnePolynomial auto& curve) const {
        if (range) return *range;
        const auto own = own_interval(curve);
        return own ? ParameterRange(*own) : ParameterRange();
    }
    /// The part of the domain; where there is none, what was asked for.
    ParameterRange range_of(const BSplineCurve& curve) const {
        const Interval domain = curve.knots().domain();
        if (!range) return domain;
        const Rational lower = range->lower ? std::max(*range->lower, domain.a()) : domain.a();
        const Rational upper = range->upper ? std::min(*range->upper, domain.b()) : domain.b();
        return lower <= upper ? ParameterRange(lower, upper) : *range;
    }

    Json operator()(const OnePolynomial auto& curve) const {
        const ParameterRange where = range_of(curve);
        return within("map", [&] {
            const Polynomial polynomial = numerator(polynomial_map(curve, limits), limits);
            return result(where, {roots(polynomial, where, width, limits), {}});
        });
    }
    Json operator()(const BSplineCurve& curve) const {
        const ParameterRange where = range_of(curve);
        return within("map", [&] { return result(where, roots(curve, where, width, limits)); });
    }

private:
    Json result(const ParameterRange& where, const SplineRoots& found) const {
        Json::Array list;
        for (const Root& root : found.roots) list.push_back(root_json(root));
        Json::Array zeros;
        for (const auto& [lower, upper] : found.zeros) zeros.push_back(Json::Array{lower, upper});
        Json result = Json::Object{{"interval", to_json(where)}, {"roots", std::move(list)}};
        if (!zeros.empty()) result["zeros"] = std::move(zeros);
        return result;
    }

    Json root_json(const Root& root) const {
        Json entry;
        if (root.is_rational()) {
            entry["value"] = root.lower;
        } else {
            entry["interval"] = Json::Array{root.lower, root.upper};
        }
        entry["multiplicity"] = root.multiplicity;
        if (auto rounded = rounded_root(root)) entry["double"] = *std::move(rounded);
        return entry;
    }

    /// The double nearest to the root: that of both ends of a narrow interval. None beyond the doubles.
    std::optional<Json::Number> rounded_root(Root root) const {
        constexpr std::size_t bits_more = 60;
        const auto bits = [](const Rational& number) {
            return std::bit_cast<std::uint64_t>(nearest_double(number));
        };
        try {
            while (bits(root.lower) != bits(root.upper)) {
                const Rational size = std::max(abs(root.lower), abs(root.upper));
                const Rational smaller = std::min(size, root.upper - root.lower);
                root = narrowed(root, smaller / Rational(Integer(1) << bits_more), limits);
            }
            return double_number(root.lower);
        } catch (const Error& error) {
            if (error.code() != ErrorCode::overflow) throw;
            return std::nullopt;
        }
    }
};

Answer answer_roots(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const auto interval =
        request.optional("interval", [&](const Json& value) { return read_range(value, limits); });
    const auto width =
        request.optional("width", [&](const Json& value) { return read_number(value, limits); });
    request.finish();
    if (point_dimension(map) != 1) {
        throw Error(ErrorCode::wrong_kind,
                    "only a map whose values are numbers has roots; this one has points", Place{"map"});
    }
    if (width && width->sign() <= 0) {
        throw Error(ErrorCode::wrong_kind, "the width of an interval is greater than 0", Place{"width"});
    }
    return dispatch_on_kind<Json>(map, RootsOf{interval, width.value_or(0), limits});
}

/// "There is no root in [0, inf)."
std::string no_root_text(const Json& result) {
    const std::vector<std::string> ends = member_texts(result, "interval");
    const bool from = ends[0] != "-inf";
    const bool to = ends[1] != "inf";
    if (!from && !to) return "There is no real root.\n";
    return fmt::format("There is no root in {}{}, {}{}.\n", from ? "[" : "(", ends[0], ends[1],
                       to ? "]" : ")");
}

std::string render_roots(const Answered& answered) {
    std::string text = description(answered.given()) + "\n\n";
    const Json::Array& list = *answered.result().find("roots")->array();
    const Json* zeros = answered.result().find("zeros");
    if (list.empty() && !zeros) return text + no_root_text(answered.result());
    for (const Json& root : list) {
        const std::string multiplicity = point_text(*root.find("multiplicity"));
        const std::string times = multiplicity == "1" ? "" : ", multiplicity " + multiplicity;
        if (root.find("value")) {
            text += fmt::format("  t = {}{}\n", answered.style.bold(member_text(root, "value")), times);
        } else {
            const std::vector<std::string> ends = member_texts(root, "interval");
            const Json* rounded = root.find("double");
            text += fmt::format("  {} < t < {}{}{}\n", ends[0], ends[1],
                                rounded ? ", t ≈ " + rounded->number()->text : "", times);
        }
    }
    if (!zeros) return text;
    for (const Json& interval : *zeros->array())
        text += fmt::format("  zero between {} and {}\n", point_text((*interval.array())[0]),
                            point_text((*interval.array())[1]));
    return text;
}

/// An interval that may be unbounded.
Shape range_shape() {
    const Shape end = Shape::one_of({ValueKind::number, Shape::words({"-inf", "inf"})});
    return Shape::pair(end, end);
}

Shape root_shape() {
    return Shape::object(
        {{required("multiplicity", ValueKind::count, "the multiplicity of the root"),
          optional("double", ValueKind::nearest_double,
                   "the double nearest to the root; not there where that would be infinite")},
         {{{required("value", ValueKind::number, "a rational root")},
           {required("interval", ValueKind::interval, "an open interval with this root and no other")}}}});
}

}  // namespace

Operation roots_operation() {
    return {
        .summary = "Isolate the real roots of a scalar map, with their multiplicities",
        .documentation = "A rational root is given exactly, any other by an interval that has no other root.",
        .request = {{map_field(),
                     optional("interval", range_shape(),
                              "the closed interval of the roots; by default that of the map, and all numbers "
                              "for a polynomial or taylor map"),
                     optional("width", ValueKind::number,
                              "the maximal width of the intervals around irrational roots")}},
        .result = {{required("interval", range_shape(), "the interval of the roots, in increasing direction"),
                    required("roots", Shape::list(root_shape()), "the roots in increasing order"),
                    optional("zeros", Shape::list(ValueKind::interval),
                             "the intervals between whose ends a spline is zero; their ends are no roots")}},
        .example = {"roots", "(t^2 - 2)(2t - 1)^2", "--interval", "0,2"},
        .options = with_map_options({
            own_interval_option(
                "the interval of the given control points, by default 0,1, or else that of the roots"),
            field_option(
                "--over", "interval", "A,B", number_list,
                "the interval of the roots, where -inf and inf are no ends; by default that of the map, "
                "-inf,inf for a polynomial"),
            field_option("--width", "width", "W", plain_text),
        }),
        .answer = answer_roots,
        .render = render_roots,
    };
}

}  // namespace blossom::protocol
