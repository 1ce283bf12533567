// Patches made of patches: subdivision, degree raising.

#include <fmt/format.h>
#include <blossom/core/patch/patch_elevation.hpp>
#include <blossom/core/patch/patch_subdivision.hpp>

#include "maps/dispatch_on_kind.hpp"
#include "patch_answers.hpp"

namespace blossom::protocol {

namespace {

/// A piece of one factor whose vertices are the combinations of the old ones.
Patch piece_of(const Patch& patch, BezierPatch net, std::size_t factor,
               std::span<const Coordinates> elements) {
    Patch piece = patch;
    piece.map = std::move(net);
    if (piece.frames.empty()) return piece;
    std::vector<Coordinates> vertices;
    for (const Coordinates& element : elements) vertices.push_back(patch.frames[factor].combination(element));
    piece.frames[factor] = BarycentricFrame(std::move(vertices));
    return piece;
}

std::vector<Coordinates> corners(std::size_t dimension) {
    std::vector<Coordinates> vertices(dimension + 1, Coordinates(dimension + 1));
    for (std::size_t k = 0; k <= dimension; ++k) vertices[k][k] = 1;
    return vertices;
}

/// The pieces with vertex i of the factor replaced by the point, in the order of i.
std::vector<Patch> pieces_at(const Patch& patch, std::size_t factor, const Coordinates& point,
                             const Limits& limits) {
    std::vector<BezierPatch> nets = as_parameter(
        Part::at, [&] { return subdivide(std::get<BezierPatch>(patch.map), factor, point, limits); });
    std::vector<Patch> pieces;
    for (BezierPatch& net : nets) {
        std::vector<Coordinates> elements = corners(patch.shape()[factor].dimension);
        elements[pieces.size()] = point;
        pieces.push_back(piece_of(patch, std::move(net), factor, elements));
    }
    return pieces;
}

/// Two pieces, left and right, for each direction in which there is a parameter.
std::vector<Patch> split_box(const Patch& patch, const Json& at, const Limits& limits) {
    const Json::Array& parameters = read_array(at);
    const std::size_t factors = patch.shape().factors();
    if (parameters.size() != factors) {
        throw Error(ErrorCode::wrong_arity,
                    fmt::format("{} entries for {} directions; one a direction is needed, a number or null",
                                parameters.size(), factors));
    }
    std::vector<Patch> pieces{patch};
    for (std::size_t f = 0; f < factors; ++f) {
        if (parameters[f].is_null()) continue;
        within(f, [&] {
            const Rational t = read_number(parameters[f], limits);
            std::vector<Patch> finer;
            for (const Patch& piece : pieces) {
                auto halves = pieces_at(piece, f, piece.frames[f].of_point(std::span(&t, 1)), limits);
                finer.push_back(std::move(halves[1]));
                finer.push_back(std::move(halves[0]));
            }
            pieces = std::move(finer);
        });
    }
    return pieces;
}

std::vector<Patch> split_simplex(const Patch& patch, const Json& at, const Limits& limits) {
    if (const std::string* word = at.text(); word && *word == "midpoints") {
        std::vector<Patch> pieces;
        for (auto& [net, elements] : subdivide_at_midpoints(std::get<BezierPatch>(patch.map), 0, limits)) {
            pieces.push_back(piece_of(patch, std::move(net), 0, elements));
        }
        return pieces;
    }
    const PatchPoint point = engine_arguments(patch, read_tuple(at, patch.parameters(), limits), 1);
    return pieces_at(patch, 0, point.front(), limits);
}

}  // namespace

Answer subdivide_patch(Fields& request, const Map& map, const Limits& limits) {
    const Patch patch = as_net(*patch_of(map), limits);
    const auto pieces = request.required("at", [&](const Json& value) {
        return patch.tensor ? split_box(patch, value, limits) : split_simplex(patch, value, limits);
    });
    request.finish();
    std::vector<Map> maps;
    maps.reserve(pieces.size());
    for (const Patch& piece : pieces) maps.push_back(like(map, piece));
    return answer_of(std::move(maps), "at");
}

Answer elevate_patch(Fields& request, const Map& map, const Limits& limits) {
    const Patch& patch = *patch_of(map);
    const std::size_t factors = patch.shape().factors();
    const auto by = request.required("by", [&](const Json& value) {
        if (!value.array()) return std::vector<std::size_t>(factors, read_count(value, limits));
        auto list = read_list(value, [&](const Json& element) { return read_count(element, limits); });
        if (list.size() == factors) return list;
        throw Error(ErrorCode::wrong_arity,
                    fmt::format("{} numbers for {} directions", list.size(), factors));
    });
    request.finish();
    Patch raised = patch;
    for (std::size_t f = 0; f < factors; ++f) {
        const auto raise = [&](const auto& one) -> PatchMap { return elevate(one, f, by[f], limits); };
        raised.map = std::visit(raise, raised.map);
    }
    return answer_of(like(map, std::move(raised)));
}

}  // namespace blossom::protocol
