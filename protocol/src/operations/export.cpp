#include "foreign_options.hpp"
#include "formats/formats.hpp"
#include "map_list.hpp"
#include "map_options.hpp"
#include "maps/kind.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

/// The map as a spline that is valid with rounded numbers. Its numbers have places in the map if it is one.
Map valid_spline(const ForeignFormat& format, const Map& map, const Limits& limits) {
    Map spline = as_foreign_spline(format, map, limits);
    try {
        if (!format.pieces) require_valid_as_doubles(spline);
    } catch (const Error& error) {
        throw name_of(map) == name_of(spline) ? error : error.at(Place());
    }
    return spline;
}

Answer answer_export(Request& request, const Limits& limits) {
    const ForeignFormat& format = request.required(
        "format", [](const Json& value) -> const ForeignFormat& { return read_format(value); });
    const bool several = request.has("maps");
    std::vector<Map> maps =
        several ? read_maps_field(request, limits) : std::vector<Map>{request.map(limits)};
    request.finish();
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const auto spline = [&] { return valid_spline(format, maps[i], limits); };
        maps[i] = several ? within("maps", [&] { return within(i, spline); }) : within("map", spline);
    }
    return Json::Object{{"document", within(several ? "maps" : "map", [&] { return format.write(maps); })}};
}

/// The document alone, as the other library reads it.
std::string render_export(const Answered& answered) {
    const Json& document = *answered.result().find("document");
    return (document.text() ? *document.text() : to_text(document)) + "\n";
}

}  // namespace

Operation export_operation() {
    return {
        .summary =
            "Write curves, surfaces and volumes as a file of another library, or curves as an SVG path, each "
            "number correctly rounded",
        .documentation = "A map that is one polynomial becomes a B-spline of one segment.",
        .request = {{format_field()}, {{{map_field()}, {maps_field("several maps")}}}},
        .result = {{required("document", ValueKind::document, "the file, as the other library reads it")}},
        .example = {"export", "--format", "tinyspline", "--control-points", "0,0; 1/3,2; 3,0"},
        .options = with_map_options({
            format_option(),
            maps_option("--maps",
                        "instead of a map: a list of maps, or the --json output of another command"),
        }),
        .answer = answer_export,
        .render = render_export,
    };
}

}  // namespace blossom::protocol
