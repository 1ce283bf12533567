#include "control_nets.hpp"

#include <fmt/format.h>
#include <blossom/core/blossom/patch_subdivision.hpp>
#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/patch/patch_conversion.hpp>

#include <algorithm>
#include <numeric>

namespace blossom::protocol {

namespace {

/// The degrees and the domain of the requested control net.
struct WantedDomain {
    bool tensor;
    std::vector<BarycentricFrame> frames;  ///< empty for those of the map
};

/// The degrees of the map, converted between simplex and tensor form if necessary.
std::vector<std::size_t> default_degrees(const NetShape& shape, bool tensor) {
    std::vector<std::size_t> degrees = degrees_of(shape);
    const std::size_t total = std::accumulate(degrees.begin(), degrees.end(), std::size_t{0});
    if (!tensor) return {total};
    if (shape.factors() == 1) degrees.assign(shape.dimension(), total);
    return degrees;
}

/// The requested degrees, or the default ones. Errors: `wrong_arity`.
std::vector<std::size_t> read_degrees(Fields& request, const NetShape& shape, bool tensor,
                                      const Limits& limits) {
    std::vector<std::size_t> usual = default_degrees(shape, tensor);
    if (!tensor) {
        const auto degree =
            request.optional("degree", [&](const Json& value) { return read_count(value, limits); });
        return degree ? std::vector<std::size_t>{*degree} : usual;
    }
    const auto degrees = request.optional("degrees", [&](const Json& value) {
        return read_each_direction(value, usual.size(), "degrees",
                                   [&](const Json& degree) { return read_count(degree, limits); });
    });
    return degrees.value_or(usual);
}

/// Converts by monomial coefficients to a shape that may group the variables differently.
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
        return read_intervals(value, patch.shape().dimension(), limits);
    });
    if (over && boxes) {
        throw Error(ErrorCode::wrong_kind,
                    R"(control points are over "vertices" or over "intervals", not over both)",
                    Place{"intervals"});
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
        if (error.code() != ErrorCode::degree_too_low) throw;
        throw error.at(Place{wanted.tensor ? "degrees" : "degree"});
    }
}

/// Where a simplex map is given as a tensor product and the other way round: the least box around the
/// simplex, the simplex at the first corner of the box.
std::vector<BarycentricFrame> other_domain(const Patch& patch) {
    const std::vector<BarycentricFrame> own = domain_or_standard(patch);
    if (!patch.tensor) {
        std::vector<BarycentricFrame> box;
        for (std::size_t d = 0; d < own.front().space_dimension(); ++d) {
            const auto [least, greatest] = std::ranges::minmax(
                own.front().vertices(), {}, [&](const Coordinates& vertex) { return vertex[d]; });
            box.push_back(BarycentricFrame({{least[d]}, {greatest[d]}}));
        }
        return box;
    }
    Coordinates corner;
    for (const BarycentricFrame& interval : own) corner.push_back(interval.vertices()[0][0]);
    std::vector<Coordinates> vertices(own.size() + 1, corner);
    for (std::size_t d = 0; d < own.size(); ++d) vertices[d + 1][d] = own[d].vertices()[1][0];
    return {BarycentricFrame(std::move(vertices))};
}

}  // namespace

Patch as_net(const Patch& patch, const Limits& limits) {
    if (!patch.is_polynomial()) return patch;
    const std::vector<std::size_t> degrees = default_degrees(patch.shape(), patch.tensor);
    return over_domain(patch, {patch.tensor, {}}, degrees, limits);
}

Patch net_over(Fields& request, const Patch& patch, std::optional<bool> tensor, const Limits& limits) {
    WantedDomain wanted = read_domain(request, patch, limits);
    if (tensor && *tensor != wanted.tensor) {
        if (!wanted.frames.empty()) {
            throw Error(ErrorCode::wrong_kind,
                        R"(a tensor product is over "intervals", a simplex over "vertices")",
                        wanted.tensor ? Place{"intervals"} : Place{"vertices"});
        }
        wanted = {*tensor, patch.is_barycentric() ? std::vector<BarycentricFrame>() : other_domain(patch)};
    }
    const std::vector<std::size_t> degrees = read_degrees(request, patch.shape(), wanted.tensor, limits);
    request.finish();
    if (!patch.is_barycentric()) return over_domain(patch, wanted, degrees, limits);
    if (!wanted.tensor) return over_sub_simplex(patch, wanted, degrees, limits);
    throw Error(ErrorCode::wrong_kind, R"(a simplex without "vertices" has no box of parameters)",
                wanted.frames.empty() ? Place{"map"} : Place{"intervals"});
}

}  // namespace blossom::protocol
