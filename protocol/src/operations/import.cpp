#include <blossom/rational/lists.hpp>

#include "floats.hpp"
#include "foreign_options.hpp"
#include "formats/formats.hpp"
#include "json/json_text.hpp"
#include "listing.hpp"
#include "map_options.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

Answer answer_import(Request& request, const Limits& limits) {
    const ForeignFormat& format = request.required(
        "format", [](const Json& value) -> const ForeignFormat& { return read_format(value); });
    const Floats floats = request.optional("floats", read_floats).value_or(format.floats);
    auto splines = request.required(
        "document", [&](const Json& value) { return read_document(format, value, floats, limits); });
    request.finish();
    // Points are written without their weight, whatever the document has.
    for (ForeignSpline& spline : splines) spline.map.form.homogeneous = false;
    return answer_of(mapped(splines, &ForeignSpline::map), "document");
}

}  // namespace

Operation import_operation() {
    return {
        .summary =
            "Read the curves, surfaces and volumes in a file of another library, or the curves of an SVG "
            "path, "
            "with the exact values of its numbers",
        .documentation = "With \"floats\": \"decimal\" its numbers are the decimals that are written.",
        .request = {{format_field(), document_field()}},
        .result = {{maps_member(
            "its curves, surfaces and volumes, as maps of the kind bspline, or bezier of a path")}},
        .example = {"import", "--format", "tinyspline", "--document",
                    R"({"degree": 1, "dimension": 1, "control_points": [0.1, 2], "knots": [0, 0, 1, 1]})"},
        .options = {format_option(), document_option(R"(the file, "@NAME" or "-", or its text)")},
        .answer = answer_import,
        .render = described_listing,
        .plot = plot_of_result,
    };
}

}  // namespace blossom::protocol
