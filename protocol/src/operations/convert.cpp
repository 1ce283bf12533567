#include <fmt/format.h>
#include <blossom/core/patch/patch_conversion.hpp>
#include <blossom/core/patch/tensor_bspline_change.hpp>
#include <blossom/core/spline/de_boor.hpp>
#include <blossom/rational/lists.hpp>

#include <algorithm>
#include <iterator>
#include <type_traits>

#include "control_nets.hpp"
#include "json/nearest_name.hpp"
#include "listing.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "segment.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

/// The kinds to which curves are converted.
std::vector<const Kind*> target_kinds() {
    std::vector<const Kind*> targets;
    std::ranges::copy_if(Kinds::all, std::back_inserter(targets),
                         [](const Kind* kind) { return !kind->target.word.empty(); });
    return targets;
}

std::vector<std::string_view> target_words() {
    return mapped(target_kinds(), [](const Kind* kind) { return kind->target.word; });
}

const Kind& read_target(const Json& value) {
    return *target_kinds()[read_alternative(value, target_words(), "a basis")];
}

struct CurveConversion {
    Target::Convert convert;
    std::optional<std::size_t> span;
    bool keeps_splines;
    const Limits& limits;

    AnyMap operator()(const OnePolynomial auto& curve) const {
        return convert(polynomial_map(curve, limits), interval_of(curve), limits);
    }
    AnyMap operator()(const Samples& samples) const { return (*this)(curve_of_samples(samples, limits)); }
    AnyMap operator()(const BSplineCurve& curve) const {
        if (keeps_splines) return curve;
        const std::size_t chosen = chosen_span(curve, span);
        // A segment of degree 0 has no knots of its own that determine its interval.
        const Interval own(curve.knots()[chosen], curve.knots()[chosen + 1]);
        return convert(polynomial_map(segment(curve, chosen), limits), own, limits);
    }
};

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
    if (patch.is_polynomial()) {
        Patch polynomial = patch;
        polynomial.center.clear();
        return polynomial;
    }
    if (patch.is_barycentric()) {
        throw Error(ErrorCode::wrong_kind,
                    R"(a simplex without "vertices" is not a polynomial in the coordinates of its points)",
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

enum class PatchForm { monomial, taylor, bspline, bernstein, tensor, simplex };
constexpr std::string_view patch_form_names[] = {"monomial",  "taylor", "bspline",
                                                 "bernstein", "tensor", "simplex"};
/// The targets that are control nets.
constexpr std::span net_form_names = std::span(patch_form_names).last<3>();

/// Reads the target and its own fields.
struct Conversion {
    Fields& request;
    const Map& map;
    const Limits& limits;

    /// Curves.
    template <class Curve>
        requires std::is_invocable_v<const CurveConversion&, const Curve&>
    AnyMap operator()(const Curve& curve) const {
        const Kind& to = request.required("to", read_target);
        Target::Convert convert = to.target.read(request, limits);
        const auto span = read_span(request, map, limits);
        request.finish();
        const bool keeps_splines = &to == &kind_of(map) && !span && !request.has("interval");
        return CurveConversion{std::move(convert), span, keeps_splines, limits}(curve);
    }
    AnyMap operator()(const Patch& patch) const {
        const auto to = static_cast<PatchForm>(request.required("to", [](const Json& value) {
            return read_alternative(value, patch_form_names, "a form of a patch");
        }));
        switch (to) {
            case PatchForm::monomial:
                request.finish();
                return as_polynomial(patch, limits);
            case PatchForm::taylor:
                return as_expansion(patch);
            case PatchForm::bspline:
                request.finish();
                return as_bspline(patch, limits);
            case PatchForm::bernstein:
                return net_over(request, patch, {}, limits);
            case PatchForm::tensor:
            case PatchForm::simplex:
                break;
        }
        return net_over(request, patch, to == PatchForm::tensor, limits);
    }
    /// Reads the field "center", by default the origin.
    Patch as_expansion(const Patch& patch) const {
        const auto center = request.optional("center", [&](const Json& value) {
            return read_tuple(value, patch.shape().dimension(), limits);
        });
        request.finish();
        Patch expansion = as_polynomial(patch, limits);
        expansion.center = center.value_or(Coordinates(patch.shape().dimension()));
        return expansion;
    }
    /// Converts the polynomial of the field "segment"; the target bspline leaves a B-spline unchanged.
    AnyMap operator()(const TensorBSpline& spline) const {
        const auto to = request.optional("to", [](const Json& value) { return value; });
        const std::string* word = to ? to->text() : nullptr;
        if (request.has("segment") || !word || *word != "bspline")
            return (*this)(read_segment(request, spline, limits));
        request.finish();
        return spline;
    }
};

Answer answer_convert(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    return answer_of(like(map, dispatch_on_kind<AnyMap>(map, Conversion{request, map, limits})));
}

/// The fields of each target.
Members convert_fields() {
    const std::string basis = "the new basis; tensor and simplex are forms of patches";
    Choice targets;
    for (const Kind* kind : target_kinds()) {
        const Target& target = kind->target;
        FieldList fields{required("to", Shape::words({target.word}), basis)};
        if (target.over_interval) {
            fields.push_back(optional("interval", ValueKind::interval,
                                      "for a curve: the interval; by default that of the map"));
        }
        if (!target.field.name.empty()) {
            fields.push_back(optional(target.field.name,
                                      target.field.is_list ? Shape::list(ValueKind::count, 2, 2)
                                      : target.field.has_points
                                          ? Shape::one_of({ValueKind::number, numbers_shape()})
                                          : Shape(ValueKind::number),
                                      std::string(target.field.help)));
        }
        targets.push_back(std::move(fields));
    }
    targets.push_back(
        {required("to", Shape::words(net_form_names), basis), vertices_field(), intervals_field(),
         optional("degree", ValueKind::count, "for a simplex: the new formal degree"), degrees_field()});
    return {{map_field(), segment_field()}, {std::move(targets)}};
}

Json numbers_of_patch(std::string_view text, const Json&) { return number_list(text); }

std::vector<Option> options() {
    std::vector<Option> all{
        word_option("--to", "to"),
        own_interval_option(
            "the interval of the given control points, or else of the new ones; by default 0,1"),
        field_option("--over", "interval", "A,B", number_list, "the interval of the new control points")};
    for (const Kind* kind : target_kinds()) {
        const TargetField& field = kind->target.field;
        if (field.name.empty()) continue;
        const std::string name(field.name);
        all.push_back(field_option("--" + name, name, std::string(field.value),
                                   field.is_list ? number_list : plain_text, numbers_of_patch));
    }
    std::ranges::move(std::vector{field_option("--vertices", "vertices", "P0;P1;...", tuple_list),
                                  field_option("--intervals", "intervals", "A,B;C,D;...", tuple_list),
                                  wanted_degrees_option(), segment_option()},
                      std::back_inserter(all));
    return with_map_options(std::move(all));
}

}  // namespace

Operation convert_operation() {
    return {
        .summary = "Convert a map to another basis or form",
        .documentation = "A spline is converted segment by segment.",
        .request = convert_fields(),
        .result = {{map_member("the same map in the new basis")}},
        .example = {"convert", "--control-points", "1; 5/3; 11/3; 6", "--to", "monomial"},
        .options = options(),
        .answer = answer_convert,
        .render = described_listing,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
