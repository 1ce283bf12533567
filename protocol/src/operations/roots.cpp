#include <fmt/format.h>
#include <blossom/core/queries/cuts.hpp>
#include <blossom/core/spline/spline_roots.hpp>

#include "geometric_curve.hpp"
#include "map_list.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "real_numbers.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

void require_scalar(const Map& map, const Place& place) {
    if (point_dimension(map) == 1) return;
    throw Error(ErrorCode::wrong_kind, "only a map whose values are numbers has roots; this one has points",
                place);
}

/// What the request asks of scalar maps.
struct RootsOf {
    std::optional<ParameterRange> range;
    Rational width;
    const std::vector<Map>& others;  ///< maps that have the same roots
    const Limits& limits;

    Json operator()(const OnePolynomial auto& curve) const {
        const ParameterRange where = asked_range(curve, range);
        if (!others.empty())
            return common(where,
                          curve_pieces(polynomial_map(curve, limits), is_rational(curve), where, limits));
        return within("map", [&] {
            const Polynomial polynomial = numerator(polynomial_map(curve, limits), limits);
            return result(where, {roots(polynomial, where, width, limits), {}});
        });
    }
    Json operator()(const BSplineCurve& curve) const {
        const ParameterRange where = asked_range(curve, range);
        if (!others.empty()) return common(where, curve_pieces(curve, is_rational(curve), where, limits));
        return within("map", [&] { return result(where, roots(curve, where, width, limits)); });
    }

private:
    static bool is_rational(const auto& curve) { return curve.dimension() == 2; }

    Json common(const ParameterRange& where, std::vector<CurvePiece> pieces) const {
        std::vector<std::vector<CurvePiece>> curves{std::move(pieces)};
        for (std::size_t i = 0; i < others.size(); ++i) {
            const Place place = Place{"with"} / i;
            require_scalar(others[i], place);
            curves.push_back(geometric_curve(others[i], ParameterRange(), limits, place).pieces);
        }
        return result(where, common_roots(curves, width, limits));
    }

    Json result(const ParameterRange& where, const SplineRoots& found) const {
        Json::Array list;
        for (const Root& root : found.roots) {
            Json::Object entry = real_members(root, limits);
            entry.insert(entry.begin() + 1, {"multiplicity", root.multiplicity});
            list.emplace_back(std::move(entry));
        }
        Json result = Json::Object{{"interval", to_json(where)}, {"roots", std::move(list)}};
        if (!found.zeros.empty()) result["zeros"] = ranges_json(found.zeros);
        return result;
    }
};

Answer answer_roots(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const auto others = request.optional("with", [&](const Json& value) {
        return read_list(value, [&](const Json& other) { return read_map(other, limits); });
    });
    const auto interval =
        request.optional("interval", [&](const Json& value) { return read_range(value, limits); });
    const Rational width = read_width(request, limits);
    request.finish();
    require_scalar(map, Place{"map"});
    const std::vector<Map> none;
    return dispatch_on_kind<Json>(map, RootsOf{interval, width, others ? *others : none, limits});
}

std::string render_roots(const Answered& answered) {
    std::string text;
    for (const Json& root : *answered.result().find("roots")->array()) {
        const std::string multiplicity = point_text(*root.find("multiplicity"));
        text += fmt::format("  {}{}\n", real_equation(root, "t", answered.style),
                            multiplicity == "1" ? "" : ", multiplicity " + multiplicity);
    }
    if (const Json* zeros = answered.result().find("zeros")) {
        for (const Json& interval : *zeros->array())
            text += fmt::format("  zero between {} and {}\n", point_text((*interval.array())[0]),
                                point_text((*interval.array())[1]));
    }
    const bool common = answered.request.find("with") != nullptr;
    return curve_answer_text(answered, std::move(text), common ? "common root" : "real root");
}

}  // namespace

Operation roots_operation() {
    return {
        .summary = "Isolate the real roots of a scalar map, with their multiplicities",
        .documentation = "A rational root is given exactly, any other by an interval that has no other root.",
        .request = {{map_field(),
                     optional("with", Shape::list(ValueKind::map),
                              "other scalar maps: only the roots that all of them have are wanted"),
                     range_field("roots"), width_field("roots")}},
        .result = {{range_member("roots"),
                    required("roots",
                             Shape::list(Shape::object(real_number_members(
                                 {required("multiplicity", ValueKind::count,
                                           "the multiplicity of the root, of several maps the least")},
                                 "root"))),
                             "the roots in increasing order"),
                    ranges_member(
                        "zeros",
                        "the intervals between whose ends a spline is zero; their ends are no roots")}},
        .example = {"roots", "(t^2 - 2)(2t - 1)^2", "--interval", "0,2"},
        .options = with_range_options({other_maps_option("--with", "with")}, "roots"),
        .answer = answer_roots,
        .render = render_roots,
    };
}

}  // namespace blossom::protocol
