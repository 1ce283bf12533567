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
    auto maps = request.required("document", [&](const Json& value) { return format.read(value, limits); });
    request.finish();
    return answer_of(std::move(maps), "document");
}

}  // namespace

Operation import_operation() {
    return {
        .summary =
            "Read the curves in a file of tinyspline, geomdl or splinepy, with the exact values of its "
            "doubles",
        .documentation = "The files are those of ts_bspline_save, export_json and splinepy.io.json.export.",
        .request = {{format_field(), document_field()}},
        .result = {{maps_member("the curves, as maps of the kind bspline")}},
        .example = {"import", "--format", "tinyspline", "--document",
                    R"({"degree": 1, "dimension": 1, "control_points": [0.1, 2], "knots": [0, 0, 1, 1]})"},
        .options = {format_option(), document_option(R"(the file, "@NAME" or "-", or its text)")},
        .answer = answer_import,
        .render = described_listing,
        .plot = plot_of_result,
    };
}

}  // namespace blossom::protocol
