#include <fmt/format.h>
#include <blossom/core/nurbs/rational_spline.hpp>
#include <blossom/core/spline/periodic_spline.hpp>

#include "contact_order.hpp"
#include "listing.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
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
};

Answer answer_periodic(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    request.finish();
    const auto periodic = dispatch_on_kind<Periodic>(map, MakePeriodic{map, limits});
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
        .request = {{map_field()}},
        .result = {{map_member("the same B-spline over periodic knots"),
                    required("order", order_shape(), "the order of contact at the seam")}},
        .example = {"periodic", "--control-points", "0,0; 2,0; 1,2; 0,0", "--knots", "0,0,1,2,3,3",
                    "--degree", "1"},
        .options = with_map_options({}),
        .answer = answer_periodic,
        .render = render_periodic,
        .plot = plot_of_maps,
    };
}

}  // namespace blossom::protocol
