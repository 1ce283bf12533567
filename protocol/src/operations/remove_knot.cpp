#include <fmt/format.h>
#include <blossom/core/spline/knot_removal.hpp>

#include "listing.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

Answer answer_remove_knot(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const Rational knot =
        request.required("knot", [&](const Json& value) { return read_number(value, limits); });
    const std::size_t times =
        request.optional("times", [&](const Json& value) { return read_count(value, limits); }).value_or(1);
    request.finish();
    const auto removal = dispatch_on_kind<KnotRemoval>(
        map, [&](const BSplineCurve& curve) { return remove_knot(curve, knot, times); });
    Answer answer = answer_of(like(map, removal.curve));
    Json& result = answer.result;
    result["removed"] = removal.removed;
    if (removal.obstruction) {
        const RemovalObstruction& obstruction = *removal.obstruction;
        // Differences of homogeneous points: undivided, with the difference of the weights last.
        const PointForm form{.scalar = map.form.scalar && !map.form.rational};
        result["residual"] = to_json(obstruction.residual(), form);
        result["obstruction"] =
            Json::Object{{"knots", Json::Array(obstruction.knots.begin(), obstruction.knots.end())},
                         {"from_left", to_json(obstruction.from_left, form)},
                         {"from_right", to_json(obstruction.from_right, form)}};
    }
    return answer;
}

std::string render_remove_knot(const Answered& answered) {
    const Json& result = answered.result();
    std::string text = described_listing(answered) + fmt::format("\nTimes that the knot was removed: {}\n",
                                                                 point_text(*result.find("removed")));
    const Json* obstruction = result.find("obstruction");
    if (!obstruction) return text;
    return text + fmt::format(
                      "It cannot be removed once more: at the knots {} the blossom of the segment on "
                      "the left is {}, that of the segment on the right {}; they differ by {}.\n",
                      numbers_text(*obstruction->find("knots")), member_text(*obstruction, "from_left"),
                      member_text(*obstruction, "from_right"),
                      answered.style.bold(member_text(result, "residual")));
}

Shape obstruction_shape() {
    return Shape::object({{required("knots", numbers_shape(), "would be consecutive after the next removal"),
                           required("from_left", ValueKind::point, "the blossom on the left at these knots"),
                           required("from_right", ValueKind::point, "the blossom on the right")}});
}

}  // namespace

Operation remove_knot_operation() {
    return {
        .summary =
            "Remove a knot from a B-spline without changing the curve, or say why that is not possible",
        .documentation = "The curve never changes: a removal that would change it is not made.",
        .request = {{map_field(), required("knot", ValueKind::number, "the knot to remove"),
                     optional("times", ValueKind::count, "how often to remove it; by default once")}},
        .result = {{map_member("the same B-spline without the knot"),
                    required("removed", ValueKind::count, "how often the knot was removed"),
                    optional("residual", ValueKind::point,
                             "by how much the two values of `obstruction` differ"),
                    optional("obstruction", obstruction_shape(), "why it is not removed once more")}},
        .example = {"remove-knot", "--control-points", "0,0; 5/6,5/3; 2,5/2; 10/3,8/3; 5,1", "--knots",
                    "0,1,2,5/2,3,4,5", "--degree", "3", "--knot", "5/2"},
        .options = with_map_options({
            field_option("--knot", "knot", "X", plain_text),
            field_option("--times", "times", "N", count),
        }),
        .answer = answer_remove_knot,
        .render = render_remove_knot,
        .plot = plot_of_maps,
    };
}

}  // namespace blossom::protocol
