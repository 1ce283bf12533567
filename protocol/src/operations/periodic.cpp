#include <fmt/format.h>
#include <blossom/core/nurbs/rational_spline.hpp>
#include <blossom/core/patch/tensor_bspline_contact.hpp>
#include <blossom/core/spline/periodic_spline.hpp>

#include "along_direction.hpp"
#include "contact_order.hpp"
#include "listing.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

struct Periodic {
    Map map;
    std::optional<std::ptrdiff_t> order;
};

struct MakePeriodic {
    const Map& map;
    std::size_t direction;
    const Limits& limits;

    Periodic operator()(const BSplineCurve& curve) const {
        if (map.form.separate_weights()) {
            const auto order = projected_seam_contact(curve, limits).order;
            const std::size_t m = rational_seam_multiplicity(curve, limits);
            return {like(map, over_periodic_knots(curve, m, limits)), order};
        }
        const Contact contact = seam_contact(curve, limits);
        const std::size_t m = seam_multiplicity(curve.degree(), contact, curve.knots().domain().b());
        return {like(map, over_periodic_knots(curve, m, limits)), contact.order};
    }
    Periodic operator()(const TensorBSpline& spline) const {
        const PatchContact contact = map.form.separate_weights()
                                         ? projected_seam_contact(spline, direction, limits)
                                         : seam_contact(spline, direction, limits);
        if (contact.order && *contact.order < 0) {
            throw Error(
                ErrorCode::not_continuous,
                "the map is not closed in this direction. " +
                    (map.form.separate_weights() ? projected_contact_text(contact) : to_string(contact)),
                Place{"map"});
        }
        const BSplineCurve rows = curve_along(spline, direction);
        const std::size_t m =
            map.form.separate_weights()
                ? rational_seam_multiplicity(rows, limits)
                : seam_multiplicity(rows.degree(), seam_contact(rows, limits), rows.knots().domain().b());
        return {like(map, with_curve_along(spline, direction, over_periodic_knots(rows, m, limits))),
                contact.order};
    }
};

Answer answer_periodic(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const std::size_t direction = require_direction(request, map, limits).value_or(0);
    request.finish();
    const auto periodic = dispatch_on_kind<Periodic>(map, MakePeriodic{map, direction, limits});
    Answer answer = answer_of(periodic.map);
    answer.result["order"] = order_json(periodic.order);
    return answer;
}

std::string render_periodic(const Answered& answered) {
    return described_listing(answered) +
           fmt::format("\nOrder of contact at the seam: {}\n", point_text(*answered.result().find("order")));
}

}  // namespace

Operation periodic_operation() {
    return {
        .summary =
            "Write a closed B-spline over periodic knots, on which its last control points are its first",
        .documentation = "The seam is a knot as often as the order of contact there needs.",
        .request = {{map_field(),
                     direction_field("of a tensor product: the direction in which it is closed")}},
        .result = {{map_member("the same B-spline over periodic knots"),
                    required("order", order_shape(), "the order of contact at the seam")}},
        .example = {"periodic", "--control-points", "0,0; 2,0; 1,2; 0,0", "--knots", "0,0,1,2,3,3",
                    "--degree", "1"},
        .options = with_map_options({direction_option()}),
        .answer = answer_periodic,
        .render = render_periodic,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
