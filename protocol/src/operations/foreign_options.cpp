#include "foreign_options.hpp"

#include "json/json_text.hpp"
#include "map_options.hpp"

namespace blossom::protocol {

Option format_option() {
    return field_option("--format", "format", "tinyspline|geomdl|splinepy",
                        "the library whose file format is used", plain_text);
}

Option document_option(std::string help) {
    const auto apply = [](Json& request, const std::vector<std::string>& values, const Limits& limits) {
        request["document"] = parse_json(values.front(), limits);
    };
    return {"--document", {"document"}, "JSON", std::move(help), apply};
}

}  // namespace blossom::protocol
