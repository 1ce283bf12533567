#include <fmt/format.h>
#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/spline/de_boor.hpp>

#include <optional>
#include <type_traits>

#include "blossom_arguments.hpp"
#include "map_options.hpp"
#include "segment.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

/// The value by the requested construction, or by the natural one for the map.
template <OnePolynomial Curve>
Coordinates value_of(const Curve& curve, std::span<const Argument> arguments,
                     std::optional<Construction> construction, const Limits& limits) {
    if (construction) return blossom_value(polynomial_map(curve, limits), arguments, *construction, limits);
    if constexpr (requires { blossom_value(curve, arguments, limits); }) {
        return blossom_value(curve, arguments, limits);
    } else {
        const auto natural = [&](const auto& one) { return blossom_value(one, arguments, limits); };
        return std::visit(natural, polynomial_map(curve, limits));
    }
}

Coordinates value_of(const Patch& patch, const PatchArguments& arguments,
                     std::optional<Construction> construction, const Limits& limits) {
    if (construction) return blossom_value(patch.map, arguments, *construction, limits);
    return std::visit([&](const auto& one) { return blossom_value(one, arguments, limits); }, patch.map);
}

/// Reads the arguments and computes the value.
struct Value {
    Fields& request;
    const PointForm& form;
    const Limits& limits;

    template <class Polynomial>
        requires OnePolynomial<Polynomial> || std::is_same_v<Polynomial, Patch>
    Coordinates operator()(const Polynomial& map) const {
        const auto arguments = request.required(
            "arguments", [&](const Json& value) { return read_arguments(value, map, form, limits); });
        const auto construction = request.optional("construction", read_construction);
        request.finish();
        return at_arguments(map, [&] { return value_of(map, arguments, construction, limits); });
    }
    Coordinates operator()(const BSplineCurve& curve) const {
        return (*this)(segment(curve, chosen_span(curve, read_span(request, limits))));
    }
    Coordinates operator()(const TensorBSpline& spline) const {
        return (*this)(read_segment(request, spline, limits));
    }
};

Answer answer_blossom(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const auto value = dispatch_on_kind<Coordinates>(map, Value{request, map.form, limits});
    return Json::Object{{"value", within("arguments", [&] { return to_json(value, map.form); })}};
}

std::string render_blossom(const Answered& answered) {
    return fmt::format("{}\n\n  p({}) = {}\n", description(answered.given()),
                       arguments_text(*answered.request.find("arguments")),
                       answered.style.bold(member_text(answered.result(), "value")));
}

}  // namespace

Operation blossom_operation() {
    return {
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
        .answer = answer_blossom,
        .render = render_blossom,
    };
}

}  // namespace blossom::protocol
