// Agreement of the constructions on patches, and their continuity.

#include <fmt/format.h>
#include <blossom/core/patch_contact.hpp>
#include <blossom/core/polynomial_text.hpp>

#include "maps/serve.hpp"
#include "operations/blossom_arguments.hpp"
#include "operations/construction_results.hpp"
#include "operations/patch_answers.hpp"

namespace blossom::cli {

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

void add_degrees(Json& result, const Patch& patch) {
    if (!patch.tensor) {
        result["degree"] = patch.shape()[0].degree;
        return;
    }
    Json::Array degrees;
    for (std::size_t f = 0; f < patch.shape().factors(); ++f) degrees.emplace_back(patch.shape()[f].degree);
    result["degrees"] = std::move(degrees);
}

Json agree_at(const Map& map, const PatchArguments& arguments, const Limits& limits) {
    const Patch& patch = *patch_of(map);
    const auto agreement =
        at_arguments(patch, [&] { return blossom::agreement(patch.map, arguments, limits); });
    Json result = Json::Object{{"agree", agreement.agree()}};
    add_degrees(result, patch);
    result["values"] = construction_values(agreement, [&](const Coordinates& value) {
        return within("arguments", [&] { return to_json(value, map.form); });
    });
    result["skipped"] = skipped_constructions(agreement);
    return result;
}

Json agree_for_all(const Map& map, const Limits& limits) {
    const Patch& patch = *patch_of(map);
    const auto agreement = within("map", [&] { return agreement_for_all_arguments(patch.map, limits); });
    Json result = Json::Object{{"agree", agreement.agree()}, {"for_all_arguments", agreement.agree()}};
    add_degrees(result, patch);
    const std::vector<std::string> names = symbol_names(patch);
    const Json expansions =
        construction_values(agreement, [&](const std::vector<SparsePolynomial>& coordinates) -> Json {
            if (map.form.scalar && !map.form.rational) return to_text(coordinates.front(), names);
            Json::Array list;
            for (const SparsePolynomial& coordinate : coordinates)
                list.emplace_back(to_text(coordinate, names));
            return list;
        });
    result["expansion"] = expansions.object()->front().second;
    if (!agreement.agree()) result["expansions"] = expansions;
    result["skipped"] = skipped_constructions(agreement);
    return result;
}

const PlacedPatch& required_net(const std::optional<PlacedPatch>& net, std::size_t i) {
    if (net) return *net;
    throw Error(
        ErrorCode::wrong_kind,
        R"(two tensor or two simplex maps are needed, these with "vertices": their domains say where they meet)",
        "/maps/" + std::to_string(i));
}

std::optional<PlacedPatch> placed(const Map& map) {
    const Patch* patch = patch_of(map);
    if (!patch || patch->is_polynomial() || patch->is_barycentric()) return {};
    return PlacedPatch{std::get<BezierPatch>(patch->map), patch->frames};
}

}  // namespace

Json agree_on_patch(Fields& request, const Map& map, const Limits& limits) {
    const auto arguments = request.optional("arguments", [&](const Json& value) {
        return read_patch_arguments(value, *patch_of(map), map.form, limits);
    });
    request.finish();
    return arguments ? agree_at(map, *arguments, limits) : agree_for_all(map, limits);
}

std::string patch_expansion_text(const Answered& answered) {
    const Map map = map_of(answered);
    const Patch& patch = *patch_of(map);
    const Json& expansion = *answered.result.find("expansion");
    std::string text =
        fmt::format("  p({}) = {}\n", fmt::join(symbol_names(patch), ", "), point_text(expansion));
    if (patch.is_polynomial()) return text;
    return text + (patch.tensor
                       ? "where each argument runs from 0 to 1 over its interval.\n"
                       : "where the first barycentric coordinate of each argument is 1 less the others.\n");
}

Json continuity_of_patches(Fields& request, const std::vector<Map>& maps, const Limits& limits) {
    request.finish();
    if (maps.size() != 2) {
        throw Error(ErrorCode::wrong_arity,
                    "there are two sides, left and right, not " + std::to_string(maps.size()), "/maps");
    }
    const std::optional<PlacedPatch> first = placed(maps[0]);
    const std::optional<PlacedPatch> second = placed(maps[1]);
    const PlacedPatch& left = required_net(first, 0);
    const PlacedPatch& right = required_net(second, 1);
    const PointForm& form = maps[0].form;
    if (form.separate_weights() || maps[1].form.separate_weights() ||
        maps[1].form.homogeneous != form.homogeneous) {
        throw Error(
            ErrorCode::wrong_kind,
            R"(the contact of rational patches is decided on their homogeneous coordinates: give both with )"
            R"("homogeneous": true)",
            "/maps");
    }
    return within("maps", [&] {
        const PatchContact found = contact(left, right, shared_face(left.frames, right.frames), limits);
        Json result = Json::Object{
            {"order", found.order ? Json(Json::Number{std::to_string(*found.order)}) : Json("infinite")}};
        if (const auto& difference = found.first_difference) {
            result["first_difference"] = Json::Object{
                {"arguments", patch_arguments_json(difference->arguments, patch_of(maps[0])->tensor)},
                {"left", to_json(difference->left, form)},
                {"right", to_json(difference->right, form)}};
        }
        result["reason"] = to_string(found);
        return result;
    });
}

}  // namespace blossom::cli
