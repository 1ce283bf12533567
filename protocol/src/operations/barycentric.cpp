#include <fmt/format.h>

#include "map_options.hpp"
#include "maps/patch.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

Answer answer_barycentric(Request& request, const Limits& limits) {
    const BarycentricFrame frame =
        request.required("vertices", [&](const Json& value) { return read_vertices(value, limits); });
    const auto coordinates = request.required("at", [&](const Json& value) {
        return read_list(value, [&](const Json& point) {
            return frame.of_point(read_tuple(point, frame.space_dimension(), limits));
        });
    });
    request.finish();
    return Json::Object{{"coordinates", lists_json(coordinates)}};
}

std::string render_barycentric(const Answered& answered) {
    std::string text;
    const Json::Array& points = *answered.request.find("at")->array();
    const std::vector<std::string> coordinates = member_texts(answered.result(), "coordinates");
    for (std::size_t i = 0; i < points.size(); ++i) {
        text += fmt::format("  {} has the barycentric coordinates {}\n", point_text(points[i]),
                            answered.style.bold(coordinates[i]));
    }
    return text;
}

}  // namespace

Operation barycentric_operation() {
    return {
        .summary = "Compute the barycentric coordinates of points with respect to a simplex",
        .documentation =
            "The points lie in the affine hull of the vertices, which may be fewer than span the space.",
        .request = {{required("vertices", tuples_shape(), "the vertices of the simplex"),
                     required("at", tuples_shape(), "the points")}},
        .result = {{required("coordinates", tuples_shape(),
                             "for each point one number per vertex, with the sum 1")}},
        .example = {"barycentric", "--vertices", "0,0; 1,0; 0,1", "--at", "1/4,1/2"},
        .options = {field_option("--vertices", "vertices", "P0;P1;...", tuple_list,
                                 "the vertices of the simplex, \"0,0; 1,0; 0,1\""),
                    field_option("--at", "at", "P;Q;...", tuple_list)},
        .answer = answer_barycentric,
        .render = render_barycentric,
    };
}

}  // namespace blossom::protocol
