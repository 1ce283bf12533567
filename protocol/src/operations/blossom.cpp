#include <fmt/format.h>
#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/spline/de_boor.hpp>

#include <algorithm>

#include "blossom_arguments.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "patch_answers.hpp"
#include "segment.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

struct Value {
    std::span<const Argument> arguments;
    std::optional<Construction> construction;
    std::optional<std::size_t> span;
    const Limits& limits;

    Coordinates operator()(const OnePolynomial auto& curve) const {
        const PolynomialMap map = polynomial_map(curve, limits);
        return construction ? blossom_value(map, arguments, *construction, limits)
                            : Blossom(map, limits)(arguments);
    }
    Coordinates operator()(const ProgressiveCurve& curve) const {
        if (construction)
            return blossom_value(polynomial_map(curve, limits), arguments, *construction, limits);
        return blossom_value(curve, arguments, limits);
    }
    Coordinates operator()(const BSplineCurve& curve) const {
        return (*this)(segment(curve, chosen_span(curve, span)));
    }
};

Answer blossom_of_curve(Fields& request, const Map& map, const Limits& limits) {
    const std::vector<Argument> arguments = request.required(
        "arguments", [&](const Json& value) { return read_arguments(value, map.form, limits); });
    const auto construction = request.optional("construction", read_construction);
    const auto span = read_span(request, map, limits);
    request.finish();

    const auto value = dispatch_on_kind<Coordinates>(map, Value{arguments, construction, span, limits});
    return Json::Object{{"value", within("arguments", [&] { return to_json(value, map.form); })}};
}

Json blossom_of_tensor_bspline(Fields& request, const Map& map, const Limits& limits) {
    return blossom_of_patch(request, chosen_segment(request, map, limits), limits);
}

std::string render(const Answered& answered) {
    return fmt::format("{}\n\n  p({}) = {}\n", description(answered.given()),
                       arguments_text(*answered.request.find("arguments")),
                       answered.style.bold(member_text(answered.result(), "value")));
}

}  // namespace

Operation blossom_operation() {
    return {
        .name = "blossom",
        .summary = "Compute the value of the blossom at points, vectors, or pairs with any mass",
        .documentation = "A B-spline has one blossom per segment.",
        .request = {{map_field(),
                     arguments_field(Presence::required, "the arguments, as many as the formal degree"),
                     optional("construction", construction_shape(),
                              "the construction to use; by default the one that suits the map"),
                     segment_field()}},
        .result = {{required("value", ValueKind::point, "the value")}},
        .example = {"blossom", "1 + 2t + 4t^2 - t^3", "--at", "delta,2,pair:3:2"},
        .options = with_map_options({
            arguments_option("the arguments, as many as the formal degree: T, vector:V, delta, pair:U:MASS"),
            word_option("--construction", "construction"),
            segment_option(),
        }),
        .answer = answer_by_shape<blossom_of_curve, blossom_of_patch, blossom_of_tensor_bspline>,
        .render = render,
    };
}

}  // namespace blossom::protocol
