#include <blossom/core/blossom/patch_subdivision.hpp>
#include <blossom/core/patch/patch_conversion.hpp>
#include <blossom/rational/error.hpp>

#include <string>

#include "maps/patch_kernel.hpp"

namespace blossom {

namespace {

void require_frames(const NetShape& shape, std::span<const BarycentricFrame> frames) {
    if (frames.size() != shape.factors()) {
        throw Error(ErrorCode::wrong_arity, "a domain of " + std::to_string(shape.factors()) +
                                                " factors needs as many simplices, not " +
                                                std::to_string(frames.size()));
    }
    for (std::size_t f = 0; f < frames.size(); ++f) {
        if (frames[f].dimension() == shape[f].dimension && frames[f].space_dimension() == shape[f].dimension)
            continue;
        throw Error(
            ErrorCode::mismatched_dimensions,
            "factor " + std::to_string(f) + " of the domain has dimension " +
                std::to_string(shape[f].dimension) +
                "; it needs a simplex of this dimension in a space of this dimension, not of dimension " +
                std::to_string(frames[f].dimension()) + " in dimension " +
                std::to_string(frames[f].space_dimension()));
    }
}

/// The vertices with respect to the origin and the unit vectors.
std::vector<Coordinates> vertices_of(const BarycentricFrame& frame) {
    std::vector<Coordinates> elements;
    for (const Coordinates& vertex : frame.vertices()) elements.push_back(point_argument(vertex));
    return elements;
}

/// The origin and the unit vectors with respect to the vertices.
std::vector<Coordinates> axes_of(const BarycentricFrame& frame) {
    Coordinates unit(frame.dimension());
    std::vector<Coordinates> elements{frame.of_point(unit)};
    for (Rational& coordinate : unit) {
        coordinate = 1;
        elements.push_back(frame.of_vector(unit));
        coordinate = 0;
    }
    return elements;
}

}  // namespace

BezierPatch control_net(const PolynomialPatch& patch, std::span<const BarycentricFrame> frames,
                        const Limits& limits) {
    require_frames(patch.shape(), frames);
    BezierPatch net(patch.shape(), polar_of(patch.shape(), patch.coefficients()));
    for (std::size_t f = 0; f < frames.size(); ++f) net = with_frame(net, f, vertices_of(frames[f]), limits);
    return net;
}

PolynomialPatch shifted(const PolynomialPatch& patch, std::span<const Rational> center,
                        const Limits& limits) {
    const NetShape& shape = patch.shape();
    if (center.size() != shape.dimension()) {
        throw Error(ErrorCode::mismatched_dimensions, "a centre of " + std::to_string(center.size()) +
                                                          " coordinates for " +
                                                          std::to_string(shape.dimension()) + " variables");
    }
    BezierPatch net(shape, polar_of(shape, patch.coefficients()));
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        const std::size_t s = shape[f].dimension;
        std::vector<Coordinates> elements{point_argument(center.first(s))};
        center = center.subspan(s);
        for (std::size_t k = 0; k < s; ++k) {
            elements.emplace_back(s + 1);
            elements.back()[k + 1] = 1;
        }
        net = with_frame(net, f, elements, limits);
    }
    return {shape, form_of(shape, net.control_net())};
}

PolynomialPatch monomial_form(const BezierPatch& patch, std::span<const BarycentricFrame> frames,
                              const Limits& limits) {
    require_frames(patch.shape(), frames);
    BezierPatch net = patch;
    for (std::size_t f = 0; f < frames.size(); ++f) net = with_frame(net, f, axes_of(frames[f]), limits);
    return {net.shape(), form_of(net.shape(), net.control_net())};
}

}  // namespace blossom
