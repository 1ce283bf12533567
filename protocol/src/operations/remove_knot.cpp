#include <fmt/format.h>
#include <blossom/core/spline/knot_removal.hpp>

#include <algorithm>

#include "along_direction.hpp"
#include "listing.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

struct Removal {
    AnyMap map;
    std::size_t removed = 0;
    std::optional<RemovalObstruction> obstruction;
    std::optional<std::vector<std::size_t>> row;  ///< of a tensor product: where the obstruction is
};

/// The index of a row in a direction: one number for each of the other directions.
std::vector<std::size_t> index_of_row(const TensorBSpline& spline, std::size_t direction, std::size_t row) {
    std::vector<std::size_t> index;
    for (std::size_t d = spline.directions(); d-- > 0;) {
        if (d == direction) continue;
        index.insert(index.begin(), row % spline.knots(d).points());
        row /= spline.knots(d).points();
    }
    return index;
}

struct RemoveKnot {
    const Rational& knot;
    std::size_t times;
    std::size_t direction;

    Removal operator()(const BSplineCurve& curve) const {
        KnotRemoval removal = remove_knot(curve, knot, times);
        return {std::move(removal.curve), removal.removed, std::move(removal.obstruction), {}};
    }
    /// With the first row that does not allow the next removal.
    Removal operator()(const TensorBSpline& spline) const {
        KnotRemoval rows = remove_knot(curve_along(spline, direction), knot, times);
        Removal removal{with_curve_along(spline, direction, rows.curve), rows.removed, {}, {}};
        if (!rows.obstruction) return removal;
        auto& [knots, from_left, from_right] = *rows.obstruction;
        const auto differing = std::ranges::mismatch(from_left, from_right).in1 - from_left.begin();
        const auto dimension = static_cast<std::ptrdiff_t>(spline.dimension());
        const std::ptrdiff_t row = differing / dimension;
        const auto point_of = [&](const Coordinates& points) {
            return Coordinates(points.begin() + row * dimension, points.begin() + (row + 1) * dimension);
        };
        removal.obstruction = RemovalObstruction{knots, point_of(from_left), point_of(from_right)};
        removal.row = index_of_row(spline, direction, static_cast<std::size_t>(row));
        return removal;
    }
};

Answer answer_remove_knot(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const Rational knot =
        request.required("knot", [&](const Json& value) { return read_number(value, limits); });
    const std::size_t times =
        request.optional("times", [&](const Json& value) { return read_count(value, limits); }).value_or(1);
    const std::size_t direction = require_direction(request, map, limits).value_or(0);
    request.finish();
    const auto removal = dispatch_on_kind<Removal>(map, RemoveKnot{knot, times, direction});
    Answer answer = answer_of(like(map, removal.map));
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
        if (const auto& row = removal.row)
            result["obstruction"]["row"] = Json::Array(row->begin(), row->end());
    }
    return answer;
}

std::string render_remove_knot(const Answered& answered) {
    const Json& result = answered.result();
    std::string text = described_listing(answered) + fmt::format("\nTimes that the knot was removed: {}\n",
                                                                 point_text(*result.find("removed")));
    const Json* obstruction = result.find("obstruction");
    if (!obstruction) return text;
    const Json* row = obstruction->find("row");
    return text + fmt::format(
                      "It cannot be removed once more: {}at the knots {} the blossom of the segment on "
                      "the left is {}, that of the segment on the right {}; they differ by {}.\n",
                      row ? "in row " + numbers_text(*row) + ", " : "",
                      numbers_text(*obstruction->find("knots")), member_text(*obstruction, "from_left"),
                      member_text(*obstruction, "from_right"),
                      answered.style.bold(member_text(result, "residual")));
}

Shape obstruction_shape() {
    return Shape::object({{required("knots", numbers_shape(), "would be consecutive after the next removal"),
                           required("from_left", ValueKind::point, "the blossom on the left at these knots"),
                           required("from_right", ValueKind::point, "the blossom on the right"),
                           optional("row", counts_shape(),
                                    "of a tensor product: the index, in the other directions, of the first "
                                    "row of control points that does not allow it")}});
}

}  // namespace

Operation remove_knot_operation() {
    return {
        .summary =
            "Remove a knot from a B-spline without changing the curve, or say why that is not possible",
        .documentation = "The curve never changes: a removal that would change it is not made.",
        .request = {{map_field(), required("knot", ValueKind::number, "the knot to remove"),
                     optional("times", ValueKind::count, "how often to remove it; by default once"),
                     direction_field("of a tensor product: the direction of the knot")}},
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
            direction_option(),
        }),
        .answer = answer_remove_knot,
        .render = render_remove_knot,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
