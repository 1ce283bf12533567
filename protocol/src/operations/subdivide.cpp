#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/blossom/patch_subdivision.hpp>
#include <blossom/core/curve/subdivision.hpp>
#include <blossom/core/patch/curve_along.hpp>
#include <blossom/core/spline/spline_split.hpp>

#include "control_nets.hpp"
#include "listing.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "maps/parameters.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

using Pieces = std::vector<AnyMap>;

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

/// The pieces with a vertex of the factor replaced by the point, in the order of the vertices.
std::vector<Patch> pieces_at(const Patch& patch, std::size_t factor, const Coordinates& point,
                             const Limits& limits) {
    std::vector<Patch> pieces;
    const std::vector<std::size_t> replaced = replaced_vertices(point);
    for (BezierPatch& net : subdivide(std::get<BezierPatch>(patch.map), factor, point, limits)) {
        std::vector<Coordinates> elements(point.size(), Coordinates(point.size()));
        for (std::size_t k = 0; k < point.size(); ++k) elements[k][k] = 1;
        elements[replaced[pieces.size()]] = point;
        pieces.push_back(piece_of(patch, std::move(net), factor, elements));
    }
    return pieces;
}

std::vector<Patch> parts_of_simplex(const Patch& patch, const Json& at, const Limits& limits) {
    if (const std::string* word = at.text(); word && *word == "midpoints") {
        std::vector<Patch> pieces;
        for (auto& [net, elements] : subdivide_at_midpoints(std::get<BezierPatch>(patch.map), 0, limits)) {
            pieces.push_back(piece_of(patch, std::move(net), 0, elements));
        }
        return pieces;
    }
    const PatchPoint point = engine_arguments(patch, read_tuple(at, patch.parameters(), limits), 1);
    return as_parameter(Part::at, [&] { return pieces_at(patch, 0, point.front(), limits); });
}

/// Splits a map in two in each direction that has a parameter: split(part, d, t).
template <class Value, class Split>
std::vector<Value> parts_of_box(const Value& whole, std::size_t directions, const Json& at,
                                const Limits& limits, const Split& split) {
    const auto parameters = read_some_directions(at, directions, limits);
    std::vector<Value> parts{whole};
    for (std::size_t d = 0; d < directions; ++d) {
        if (!parameters[d]) continue;
        within(d, [&] {
            std::vector<Value> finer;
            for (const Value& part : parts) {
                auto [before, behind] =
                    as_parameter(Part::at, [&] { return split(part, d, *parameters[d]); });
                finer.push_back(std::move(before));
                finer.push_back(std::move(behind));
            }
            parts = std::move(finer);
        });
    }
    return parts;
}

/// The parts of a map that is divided at the field "at".
struct Subdivide {
    Fields& request;
    const Limits& limits;

    Pieces operator()(const BezierCurve& curve) const {
        return divided([&](const Json& at) {
            const auto [left, right] = subdivide(curve, read_number(at, limits), limits);
            return std::vector{left, right};
        });
    }
    Pieces operator()(const OnePolynomial auto& curve) const {
        return (*this)(control_points(polynomial_map(curve, limits), interval_of(curve), limits));
    }
    Pieces operator()(const BSplineCurve& curve) const {
        const bool clamp = is_clamped();
        return divided([&](const Json& at) {
            const Rational t = read_number(at, limits);
            const auto [left, right] = as_parameter(Part::at, [&] { return halves(curve, t, clamp); });
            return std::vector{left, right};
        });
    }
    Pieces operator()(const Patch& patch) const {
        const Patch net = as_net(patch, limits);
        return divided([&](const Json& at) {
            if (!patch.tensor) return parts_of_simplex(net, at, limits);
            return parts_of_box(net, net.shape().factors(), at, limits,
                                [&](const Patch& part, std::size_t f, const Rational& t) {
                                    auto halves =
                                        pieces_at(part, f, part.frames[f].of_point(std::span(&t, 1)), limits);
                                    return std::pair(std::move(halves[1]), std::move(halves[0]));
                                });
        });
    }
    Pieces operator()(const TensorBSpline& spline) const {
        const bool clamp = is_clamped();
        return divided([&](const Json& at) {
            return parts_of_box(spline, spline.directions(), at, limits,
                                [&](const TensorBSpline& part, std::size_t d, const Rational& t) {
                                    const auto [left, right] = halves(curve_along(part, d), t, clamp);
                                    return std::pair(with_curve_along(part, d, left),
                                                     with_curve_along(part, d, right));
                                });
        });
    }

private:
    bool is_clamped() const { return request.optional("clamped", read_boolean).value_or(false); }
    std::pair<BSplineCurve, BSplineCurve> halves(const BSplineCurve& curve, const Rational& t,
                                                 bool clamp) const {
        auto [left, right] = split(curve, t, limits);
        if (!clamp) return {std::move(left), std::move(right)};
        return {clamped(left, limits), clamped(right, limits)};
    }
    template <class Divide>
    Pieces divided(const Divide& divide) const {
        auto parts = request.required("at", divide);
        request.finish();
        return {std::make_move_iterator(parts.begin()), std::make_move_iterator(parts.end())};
    }
};

Answer answer_subdivide(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    return answer_of(like(map, dispatch_on_kind<Pieces>(map, Subdivide{request, limits})), "at");
}

}  // namespace

Operation subdivide_operation() {
    return {
        .summary = "Split a curve or patch at a parameter",
        .documentation =
            "The parameter may lie outside the interval of a Bezier curve, but in the domain of a B-spline.",
        .request = {{map_field(),
                     required("at",
                              Shape::one_of({ValueKind::number, Shape::words({"midpoints"}), cut_shape()}),
                              "the parameter; for a simplex a point, inside or on a face, or midpoints, for "
                              "a tensor product a number "
                              "or null per direction"),
                     optional("clamped", ValueKind::boolean,
                              "of a bspline: whether the parts are clamped at their other ends too")}},
        .result = {{maps_member("the parts")}},
        .example = {"subdivide", "--control-points", "0,0; 1,2; 3,0", "--at", "1/3"},
        .options = with_map_options({
            field_option(
                "--at", "at", "T", plain_text, place_of_division,
                "the parameter, which may lie outside the interval of a Bezier curve; for a simplex a "
                "point or \"midpoints\", for a tensor product a number or - per direction"),
            flag_option("--clamped", "clamped"),
        }),
        .answer = answer_subdivide,
        .render = described_listing,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
