// Control nets of patches over simplices and boxes, and their conversion to other forms.

#include <fmt/format.h>
#include <blossom/core/patch/patch_conversion.hpp>
#include <blossom/core/patch/patch_elevation.hpp>
#include <blossom/core/patch/patch_subdivision.hpp>
#include <blossom/core/patch/tensor_bspline_change.hpp>

#include <algorithm>

#include "patch_answers.hpp"

namespace blossom::protocol {

namespace {

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
    std::vector<std::size_t> usual = default_degrees(shape, tensor);
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
                fmt::format("{} degrees for {} directions", degrees->size(), usual.size()), Place{"degrees"});
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

Place degree_place(const Error& error, bool tensor) {
    return error.code() == ErrorCode::degree_too_low ? (tensor ? Place{"degrees"} : Place{"degree"})
                                                     : error.place();
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

/// x, y, z for a simplex, u, v, w for a tensor product, x1, x2, ... where there are more.
std::vector<std::string> usual_variables(std::size_t count, bool tensor) {
    const std::string_view letters = tensor ? "uvw" : "xyz";
    std::vector<std::string> names;
    names.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        names.push_back(count <= letters.size() ? std::string(1, letters[i]) : fmt::format("x{}", i + 1));
    }
    return names;
}

Patch as_polynomial(const Patch& patch, const Limits& limits) {
    if (patch.is_polynomial()) return patch;
    if (patch.is_barycentric()) {
        throw Error(ErrorCode::wrong_kind,
                    R"(a simplex without "vertices" is no polynomial in coordinates of its points)",
                    Place{"map"});
    }
    return {monomial_form(std::get<BezierPatch>(patch.map), patch.frames, limits),
            patch.tensor,
            {},
            usual_variables(patch.shape().dimension(), patch.tensor)};
}

TensorBSpline as_bspline(const Patch& patch, const Limits& limits) {
    if (!patch.tensor) {
        throw Error(ErrorCode::wrong_kind,
                    "B-splines in several directions are over a box; convert the simplex map to tensor first",
                    Place{"map"});
    }
    Patch net = as_net(patch, limits);
    return bspline_of({std::get<BezierPatch>(net.map), std::move(net.frames)}, limits);
}

/// The control points of the map over what the request says; in simplex or tensor form where `form` says
/// which, by default that of the map.
Answer net_over(Fields& request, const Map& map, std::optional<bool> tensor, const Limits& limits) {
    const Patch& patch = *patch_of(map);
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
    if (patch.is_barycentric() && wanted.tensor) {
        throw Error(ErrorCode::wrong_kind, R"(a simplex without "vertices" has no box of parameters)",
                    wanted.frames.empty() ? Place{"map"} : Place{"intervals"});
    }
    return answer_of(like(map, patch.is_barycentric() ? over_sub_simplex(patch, wanted, degrees, limits)
                                                      : over_domain(patch, wanted, degrees, limits)));
}

}  // namespace

Patch as_net(const Patch& patch, const Limits& limits) {
    if (!patch.is_polynomial()) return patch;
    const std::vector<std::size_t> degrees = default_degrees(patch.shape(), patch.tensor);
    return over_domain(patch, {patch.tensor, {}}, degrees, limits);
}

Answer control_net_of_patch(Fields& request, const Map& map, const Limits& limits) {
    return net_over(request, map, {}, limits);
}

Answer convert_patch(Fields& request, const Map& map, const Limits& limits) {
    const auto to = static_cast<PatchForm>(request.required("to", [](const Json& value) {
        return read_alternative(value, patch_form_names, "a form of a patch");
    }));
    const Patch& patch = *patch_of(map);
    switch (to) {
        case PatchForm::monomial:
            request.finish();
            return answer_of(like(map, as_polynomial(patch, limits)));
        case PatchForm::bspline:
            request.finish();
            return answer_of(like(map, as_bspline(patch, limits)));
        case PatchForm::bernstein:
            return net_over(request, map, {}, limits);
        case PatchForm::tensor:
        case PatchForm::simplex:
            break;
    }
    return net_over(request, map, to == PatchForm::tensor, limits);
}

}  // namespace blossom::protocol
