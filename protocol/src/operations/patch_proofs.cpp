// Agreement of the constructions on patches, and their continuity.

#include <fmt/format.h>
#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/core/patch/patch_contact.hpp>
#include <blossom/core/patch/tensor_bspline_contact.hpp>

#include <algorithm>

#include "blossom_arguments.hpp"
#include "construction_results.hpp"
#include "map_list.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "patch_answers.hpp"

namespace blossom::protocol {

namespace {

/// The names of the symbolic arguments, argument by argument in each factor: x1, y1, x2, y2 for variables x
/// and y; u1, u2, v1 for the directions of a tensor product; v1, w1, ... for barycentric coordinates behind
/// the first.
std::vector<std::string> symbol_names(const Patch& patch) {
    const NetShape& shape = patch.shape();
    const std::string_view letters = patch.tensor ? "uvwxyz" : "vwxyz";
    const auto letter = [&](std::size_t variable) {
        if (patch.is_polynomial()) return patch.variables[variable];
        return variable < letters.size() ? std::string(1, letters[variable]) : fmt::format("c{}_", variable);
    };
    std::vector<std::string> names;
    std::size_t first = 0;
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        for (std::size_t i = 1; i <= shape[f].degree; ++i) {
            for (std::size_t k = 0; k < shape[f].dimension; ++k)
                names.push_back(letter(first + k) + std::to_string(i));
        }
        first += shape[f].dimension;
    }
    return names;
}

/// The member "degree" or "degrees".
Json::Object degree_member(const Patch& patch) {
    if (!patch.tensor) return {{"degree", patch.shape()[0].degree}};
    Json::Array degrees;
    for (std::size_t f = 0; f < patch.shape().factors(); ++f) degrees.emplace_back(patch.shape()[f].degree);
    return {{"degrees", std::move(degrees)}};
}

PlacedPatch required_net(std::optional<PlacedPatch> net, std::size_t i) {
    if (net) return std::move(*net);
    throw Error(
        ErrorCode::wrong_kind,
        R"(two tensor or two simplex maps are needed, these with "vertices": their domains say where they meet)",
        Place{"maps"} / i);
}

std::optional<PlacedPatch> placed(const Map& map) {
    const Patch* patch = patch_of(map);
    if (!patch || patch->is_polynomial() || patch->is_barycentric()) return {};
    return PlacedPatch{std::get<BezierPatch>(patch->map), patch->frames};
}

/// A contact, of maps that are divided by their weights where the form says so: then the values of the first
/// difference are points multiplied by weights.
Json contact_json(const PatchContact& contact, const PointForm& form, bool tensor) {
    const bool divided = form.separate_weights();
    const PointForm of_values = divided ? PointForm{.scalar = form.scalar} : form;
    Json result = Json::Object{
        {"order", contact.order ? Json(Json::Number{std::to_string(*contact.order)}) : Json("infinite")}};
    if (const auto& difference = contact.first_difference) {
        result["first_difference"] =
            Json::Object{{"arguments", patch_arguments_json(difference->arguments, tensor)},
                         {"left", to_json(difference->left, of_values)},
                         {"right", to_json(difference->right, of_values)}};
    }
    result["reason"] = divided ? projected_contact_text(contact) : to_string(contact);
    return result;
}

}  // namespace

Json agree_on_patch(Fields& request, const Map& map, const Limits& limits) {
    const Patch& patch = *patch_of(map);
    const auto arguments = request.optional(
        "arguments", [&](const Json& value) { return read_patch_arguments(value, patch, map.form, limits); });
    request.finish();
    if (!arguments) {
        const auto found = within("map", [&] { return agreement_for_all_arguments(patch.map, limits); });
        return agreement_for_all(found, degree_member(patch), map.form, symbol_names(patch));
    }
    const auto found = at_arguments(patch, [&] { return agreement(patch.map, *arguments, limits); });
    return agreement_at_arguments(found, degree_member(patch), map.form);
}

std::string patch_expansion_text(const Answered& answered) {
    const Map map = answered.given();
    const Patch& patch = *patch_of(map);
    const Json& expansion = *answered.result().find("expansion");
    std::string text =
        fmt::format("  p({}) = {}\n", fmt::join(symbol_names(patch), ", "), point_text(expansion));
    if (patch.is_polynomial()) return text;
    return text + (patch.tensor
                       ? "where each argument runs from 0 to 1 over its interval.\n"
                       : "where the first barycentric coordinate of each argument is 1 less the others.\n");
}

Json continuity_of_patches(Fields& request, std::vector<Map> maps, const Limits& limits) {
    request.finish();
    if (maps.size() != 2) {
        throw Error(ErrorCode::wrong_arity,
                    "there are two sides, left and right, not " + std::to_string(maps.size()), Place{"maps"});
    }
    for (std::size_t i = 0; i < maps.size(); ++i) required_net(placed(maps[i]), i);
    make_form_common(maps, limits);
    const PlacedPatch left = required_net(placed(maps[0]), 0);
    const PlacedPatch right = required_net(placed(maps[1]), 1);
    const PointForm& form = maps[0].form;
    return within("maps", [&] {
        const Face face = shared_face(left.frames, right.frames);
        const PatchContact found = form.separate_weights() ? projected_contact(left, right, face, limits)
                                                           : contact(left, right, face, limits);
        return contact_json(found, form, patch_of(maps[0])->tensor);
    });
}

Json continuity_of_tensor_bspline(Fields& request, const Map& map, const Limits& limits) {
    const TensorBSpline& spline = *tensor_bspline_of(map);
    const auto at = request.required("at", [&](const Json& value) {
        return read_list(value, [&](const Json& element) {
            return element.is_null() ? std::nullopt : std::optional(read_number(element, limits));
        });
    });
    request.finish();
    const auto is_given = [](const std::optional<Rational>& entry) { return entry.has_value(); };
    if (at.size() != spline.directions() || std::ranges::count_if(at, is_given) != 1) {
        throw Error(
            ErrorCode::wrong_arity,
            fmt::format("one entry a direction is needed, {} of them: a number in one and null in the "
                        "others",
                        spline.directions()),
            Place{"at"});
    }
    const auto direction = static_cast<std::size_t>(std::ranges::find_if(at, is_given) - at.begin());
    const bool divided = map.form.separate_weights();
    const PatchContact found = within("at", [&] {
        return within(direction, [&] {
            return as_parameter(Part::at, [&] {
                return divided ? projected_contact(spline, direction, *at[direction], limits)
                               : contact(spline, direction, *at[direction], limits);
            });
        });
    });
    return contact_json(found, map.form, true);
}

}  // namespace blossom::protocol
