#include <fmt/format.h>
#include <blossom/core/patch/net_bounds.hpp>

#include "common_domain.hpp"
#include "jacobian.hpp"
#include "map_options.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

constexpr std::string_view bounded_names[] = {"values", "jacobian"};
constexpr std::string_view positivity_names[] = {"positive", "not positive", "undecided"};
constexpr std::size_t default_depth = 10;

/// A parameter as a request gives it: a number for a curve.
Json parameter_json(const ValueAt& found, bool is_curve) {
    if (is_curve) return found.at.front().front();
    Json::Array numbers;
    for (const Coordinates& point : found.at) numbers.insert(numbers.end(), point.begin(), point.end());
    return numbers;
}

Answer answer_bounds(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const bool of_jacobian =
        request
            .optional(
                "of",
                [](const Json& value) { return read_alternative(value, bounded_names, "what is bounded"); })
            .value_or(0) == 1;
    const std::size_t depth =
        request.optional("depth", [&](const Json& value) { return read_count(value, limits); })
            .value_or(default_depth);
    request.finish();
    CommonMaps given = on_own_domain(map, limits);
    if (of_jacobian) given = on_own_domain(jacobian_of(given, limits), limits);
    if (given.dimension(0) != 1) {
        throw Error(ErrorCode::mismatched_dimensions,
                    fmt::format("the map has {} coordinates; bounds are those of a scalar map, or with "
                                "\"of\": \"jacobian\" of a determinant",
                                given.dimension(0)),
                    Place{"map"});
    }
    const NetBounds bounds = net_bounds(nets_of(given, limits), depth, limits);
    Json::Object result{{"decision", positivity_names[static_cast<std::size_t>(bounds.positivity)]}};
    if (bounds.lower) result.emplace_back("lower", *bounds.lower);
    if (bounds.upper) result.emplace_back("upper", *bounds.upper);
    if (bounds.witness) {
        result.emplace_back("at", parameter_json(*bounds.witness, given.are_curves));
        result.emplace_back("value", bounds.witness->value);
    }
    result.emplace_back("nets", bounds.nets);
    return result;
}

std::string render_bounds(const Answered& answered) {
    const Json& result = answered.result();
    const Json* of = answered.request.find("of");
    const std::string name = of && *of->text() == "jacobian" ? "The Jacobian" : "The map";
    const std::string& decision = *result.find("decision")->text();
    const std::string count = result.find("nets")->number()->text;
    const std::string nets = count == "1" ? "1 control net" : count + " control nets";
    std::string text = description(answered.given()) + "\n\n";
    if (decision == "positive") {
        text += fmt::format("{} is {} everywhere.\n", name, answered.style.good("positive"));
    } else if (decision == "undecided") {
        text += fmt::format("It is {} whether {} is positive everywhere.\n", answered.style.bold("undecided"),
                            name == "The map" ? "the map" : "the Jacobian");
    } else {
        const Json& at = *result.find("at");
        text += fmt::format("{} is {}: at {} it is {}.\n", name, answered.style.bad("not positive"),
                            at.array() ? parameter_text(at) : member_text(result, "at"),
                            answered.style.bold(member_text(result, "value")));
    }
    if (!result.find("lower")) return text + "It has no bounds: a weight is 0 or changes its sign.\n";
    return text + fmt::format("Its values lie between {} and {}, by {}.\n", member_text(result, "lower"),
                              member_text(result, "upper"), nets);
}

}  // namespace

Operation bounds_operation() {
    return {
        .summary =
            "Bound a scalar map, or the Jacobian of a map, and decide whether it is positive everywhere",
        .documentation = "A curved element is valid if its Jacobian is positive everywhere.",
        .request =
            {{map_field(),
              optional("of", Shape::words(bounded_names),
                       "what is bounded: the `values` of a scalar map, the default, or the determinant "
                       "of the `jacobian`"),
              optional("depth", ValueKind::count, "how often the domain is divided at most; by default 10")}},
        .result = {{required("decision", Shape::words(positivity_names),
                             "`positive` everywhere, `not positive` at `at`, or `undecided` after the last "
                             "division"),
                    optional("lower", ValueKind::number,
                             "a lower bound of all values; none where a weight is 0 or changes its sign"),
                    optional("upper", ValueKind::number, "an upper bound"),
                    optional("at", ValueKind::point, "a parameter at which the value is 0 or negative"),
                    optional("value", ValueKind::number, "the value there"),
                    required("nets", ValueKind::count, "how many control nets gave the bounds")}},
        .example =
            {"bounds", "--map",
             R"({"kind": "tensor", "degrees": [1, 1], "control_net": [[[0, 0], [0, 2]], [[2, 0], [3, 3]]]})",
             "--of", "jacobian"},
        .options = with_map_options({
            word_option("--of", "of"),
            field_option("--depth", "depth", "N", count),
        }),
        .answer = answer_bounds,
        .render = render_bounds,
    };
}

}  // namespace blossom::protocol
