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
    auto maps = request.required("document", [&](const Json& value) {
        if (floats == Floats::binary64 || value.text()) return format.read(value, floats, limits);
        return format.read(with_decimals(value, limits), floats, limits);
    });
    request.finish();
    return answer_of(std::move(maps), "document");
}

}  // namespace

Operation import_operation() {
    return {
        .summary =
            "Read the curves in a file of tinyspline, geomdl or splinepy, a FITPACK spline or an SVG path, "
            "with "
            "the exact values of its numbers",
        .documentation =
            "The files are those of ts_bspline_save, export_json and splinepy.io.json.export. With "
            "\"floats\": "
            "\"decimal\" their numbers are the decimals that are written.",
        .request = {{format_field(), document_field()}},
        .result = {{maps_member("the curves, as maps of the kind bspline, or bezier of a path")}},
        .example = {"import", "--format", "tinyspline", "--document",
                    R"({"degree": 1, "dimension": 1, "control_points": [0.1, 2], "knots": [0, 0, 1, 1]})"},
        .options = {format_option(), document_option(R"(the file, "@NAME" or "-", or its text)")},
        .answer = answer_import,
        .render = described_listing,
        .plot = plot_of_result,
    };
}

}  // namespace blossom::protocol
