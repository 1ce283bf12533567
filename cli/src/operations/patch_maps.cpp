// Patches made of patches: nets over other domains, subdivision, degree raising.

#include <fmt/format.h>
#include <blossom/core/patch_conversion.hpp>
#include <blossom/core/patch_elevation.hpp>
#include <blossom/core/patch_subdivision.hpp>

#include "maps/serve.hpp"
#include "operations/patch_answers.hpp"

namespace blossom::cli {

namespace {

Json map_json(Patch patch, const Map& original) {
    return to_json(Map{std::move(patch), original.form, original.variable});
}

/// What control points are wanted of.
struct WantedDomain {
    bool tensor;
    std::vector<BarycentricFrame> frames;  ///< none: those of the map
};

/// The degrees of the map as simplex or tensor form asks for: kept, or turned into each other.
std::vector<std::size_t> default_degrees(const NetShape& shape, bool tensor) {
    std::vector<std::size_t> degrees;
    std::size_t total = 0;
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        degrees.push_back(shape[f].degree);
        total += shape[f].degree;
    }
    if (!tensor) return {total};
    if (shape.factors() == 1) degrees.assign(shape.dimension(), total);
    return degrees;
}

/// The degrees asked for, or the default ones. Errors: `wrong_arity`.
std::vector<std::size_t> read_degrees(Fields& request, const NetShape& shape, bool tensor,
                                      const Limits& limits) {
    const std::vector<std::size_t> usual = default_degrees(shape, tensor);
    if (!tensor) {
        const auto degree =
            request.optional("degree", [&](const Json& value) { return read_count(value, limits); });
        return degree ? std::vector<std::size_t>{*degree} : usual;
    }
    const auto degrees = request.optional("degrees", [&](const Json& value) {
        return read_list(value, [&](const Json& degree) { return read_count(degree, limits); });
    });
    if (!degrees) return usual;
    if (degrees->size() == usual.size()) return *degrees;
    throw Error(ErrorCode::wrong_arity,
                fmt::format("{} degrees for {} directions", degrees->size(), usual.size()), "/degrees");
}

/// By monomial coefficients in a shape that may group the variables otherwise.
PolynomialPatch monomials_in(const Patch& patch, const NetShape& shape, const Limits& limits) {
    if (const auto* polynomial = std::get_if<PolynomialPatch>(&patch.map))
        return regrouped(*polynomial, shape, limits);
    return regrouped(monomial_form(std::get<BezierPatch>(patch.map), patch.frames, limits), shape, limits);
}

WantedDomain read_domain(Fields& request, const Patch& patch, const Limits& limits) {
    const auto vertices = [&](const Json& value) {
        BarycentricFrame frame = read_vertices(value, limits);
        const std::size_t dimension = patch.shape().dimension();
        if (frame.dimension() == dimension && frame.space_dimension() == patch.parameters()) return frame;
        throw Error(
            ErrorCode::mismatched_dimensions,
            fmt::format(
                "a simplex of dimension {} is needed, {} vertices with {} numbers each; given are {} with {}",
                dimension, dimension + 1, patch.parameters(), frame.dimension() + 1,
                frame.space_dimension()));
    };
    const auto over = request.optional("vertices", vertices);
    const auto boxes = request.optional("intervals", [&](const Json& value) {
        std::vector<BarycentricFrame> frames = read_intervals(value, limits);
        if (frames.size() == patch.shape().dimension()) return frames;
        throw Error(ErrorCode::wrong_arity,
                    fmt::format("{} intervals for {} directions", frames.size(), patch.shape().dimension()));
    });
    if (over && boxes) {
        throw Error(ErrorCode::wrong_kind,
                    R"(control points are over "vertices" or over "intervals", not over both)", "/intervals");
    }
    if (over) return {false, {*over}};
    if (boxes) return {true, *boxes};
    return {patch.tensor, {}};
}

/// Over vertices that are given by barycentric coordinates.
Patch over_sub_simplex(const Patch& patch, const WantedDomain& wanted,
                       const std::vector<std::size_t>& degrees, const Limits& limits) {
    const auto& net = std::get<BezierPatch>(patch.map);
    BezierPatch result = net;
    if (!wanted.frames.empty()) {
        const auto& vertices = wanted.frames.front().vertices();
        for (std::size_t k = 0; k < vertices.size(); ++k) {
            within("vertices", [&] { within(k, [&] { return engine_arguments(patch, vertices[k], 1); }); });
        }
        result = with_frame(net, 0, vertices, limits);
    }
    return {within("degree", [&] { return elevated_to(result, degrees, limits); }), false, {}, {}};
}

std::string degree_place(const Error& error, bool tensor) {
    return error.code() == ErrorCode::degree_too_low ? (tensor ? "/degrees" : "/degree") : error.field();
}

Patch over_domain(const Patch& patch, const WantedDomain& wanted, const std::vector<std::size_t>& degrees,
                  const Limits& limits) {
    const std::size_t dimension = patch.shape().dimension();
    const NetShape shape = wanted.tensor ? NetShape::tensor(degrees, limits)
                                         : NetShape::simplex(dimension, degrees.front(), limits);
    std::vector<BarycentricFrame> frames = wanted.frames;
    if (frames.empty()) frames = domain_or_standard(patch);
    require_numbers(shape.size(), patch.dimension(), limits);
    try {
        BezierPatch net = control_net(monomials_in(patch, shape, limits), frames, limits);
        return {std::move(net), wanted.tensor, std::move(frames), {}};
    } catch (const Error& error) {
        throw Error(error.code(), error.message(), degree_place(error, wanted.tensor));
    }
}

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
    std::vector<BezierPatch> nets;
    try {
        nets = subdivide(std::get<BezierPatch>(patch.map), factor, point, limits);
    } catch (const Error& error) {
        // The engine calls the field "/at", which the request is at already.
        throw Error(error.code(), error.message());
    }
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

Patch as_net(const Patch& patch, const Limits& limits) {
    if (!patch.is_polynomial()) return patch;
    const std::vector<std::size_t> degrees = default_degrees(patch.shape(), patch.tensor);
    return over_domain(patch, {patch.tensor, {}}, degrees, limits);
}

Json control_net_of_patch(Fields& request, const Map& map, const Limits& limits) {
    const Patch& patch = *patch_of(map);
    const WantedDomain wanted = read_domain(request, patch, limits);
    const std::vector<std::size_t> degrees = read_degrees(request, patch.shape(), wanted.tensor, limits);
    request.finish();
    if (patch.is_barycentric() && wanted.tensor) {
        throw Error(ErrorCode::wrong_kind, R"(a simplex without "vertices" has no box of parameters)",
                    "/intervals");
    }
    return Json::Object{
        {"map", map_json(patch.is_barycentric() ? over_sub_simplex(patch, wanted, degrees, limits)
                                                : over_domain(patch, wanted, degrees, limits),
                         map)}};
}

Json subdivide_patch(Fields& request, const Map& map, const Limits& limits) {
    const Patch patch = as_net(*patch_of(map), limits);
    const auto pieces = request.required("at", [&](const Json& value) {
        return patch.tensor ? split_box(patch, value, limits) : split_simplex(patch, value, limits);
    });
    request.finish();
    Json::Array maps;
    for (const Patch& piece : pieces) maps.push_back(within("at", [&] { return map_json(piece, map); }));
    return Json::Object{{"maps", std::move(maps)}};
}

Json elevate_patch(Fields& request, const Map& map, const Limits& limits) {
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
    return Json::Object{{"map", map_json(std::move(raised), map)}};
}

}  // namespace blossom::cli
