#include <fmt/format.h>
#include <blossom/core/blossom.hpp>

#include <algorithm>

#include "operations/blossom_arguments.hpp"
#include "operations/map_options.hpp"
#include "operations/table.hpp"

namespace blossom::cli {

namespace {

Json answer(Fields& request, const Limits& limits) {
    const Map map = read_map_field(request, limits);
    const std::vector<Argument> arguments = request.required(
        "arguments", [&](const Json& value) { return read_arguments(value, map.form, limits); });
    const auto construction = request.optional("construction", read_construction);
    request.finish();

    const Coordinates value = construction ? blossom_value(map.curve, arguments, *construction, limits)
                                           : Blossom(map.curve, limits)(arguments);
    return Json::Object{{"value", within("arguments", [&] { return to_json(value, map.form); })}};
}

std::string render(const Answered& answered) {
    return fmt::format("{}\n\n  p({}) = {}\n",
                       description(read_map(*answered.request.find("map"), answered.limits)),
                       arguments_text(*answered.request.find("arguments")),
                       answered.style.bold(member_text(answered.result, "value")));
}

}  // namespace

Operation blossom_operation() {
    return {
        .name = "blossom",
        .summary = "The value of the blossom at arguments: points, vectors, or pairs with any mass",
        .example = {"blossom", "1 + 2t + 4t^2 - t^3", "--at", "delta,2,pair:3:2"},
        .options = with_map_options({
            arguments_option("the arguments, as many as the formal degree: T, vector:V, delta, pair:U:MASS"),
            field_option("--construction", "construction", "symmetric|polarization|casteljau",
                         "by which construction; by default the one that suits the map", plain_text),
        }),
        .answer = answer,
        .render = render,
    };
}

}  // namespace blossom::cli
