#include "foreign/formats.hpp"
#include "foreign_options.hpp"
#include "json_text.hpp"
#include "listing.hpp"
#include "map_options.hpp"
#include "svg/plot.hpp"
#include "table.hpp"

namespace blossom::cli {

namespace {

Json answer(Fields& request, const Limits& limits) {
    const ForeignFormat& format = request.required(
        "format", [](const Json& value) -> const ForeignFormat& { return read_format(value); });
    const auto maps =
        request.required("document", [&](const Json& value) { return format.read(value, limits); });
    request.finish();
    Json::Array list;
    for (const Map& map : maps) list.push_back(to_json(map));
    return Json::Object{{"maps", std::move(list)}};
}

}  // namespace

Operation import_operation() {
    return {
        .name = "import",
        .summary =
            "Read the curves in a file of tinyspline, geomdl or splinepy, with the exact values of its "
            "doubles",
        .example = {"import", "--format", "tinyspline", "--document",
                    R"({"degree": 1, "dimension": 1, "control_points": [0.1, 2], "knots": [0, 0, 1, 1]})"},
        .options = {format_option(), document_option(R"(the file, "@NAME" or "-", or its text)")},
        .answer = answer,
        .render = described_listing,
        .plot = plot_of_result,
    };
}

}  // namespace blossom::cli
