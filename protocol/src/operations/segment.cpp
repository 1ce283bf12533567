#include "segment.hpp"

#include <blossom/core/patch/tensor_bspline_change.hpp>
#include <blossom/core/spline/de_boor.hpp>

#include "map_options.hpp"
#include "shared_fields.hpp"

namespace blossom::protocol {

std::optional<std::size_t> read_span(Fields& request, const Limits& limits) {
    return request.optional("segment", [&](const Json& value) { return read_index(value, limits); });
}

std::optional<std::size_t> read_span(Fields& request, const Map& map, const Limits& limits) {
    if (!std::holds_alternative<BSplineCurve>(map.value)) return std::nullopt;
    return read_span(request, limits);
}

std::size_t chosen_span(const BSplineCurve& curve, std::optional<std::size_t> span) {
    if (!span) return only_span(curve.knots());
    curve.knots().require_span(*span);
    return *span;
}

Patch segment(const TensorBSpline& spline, std::span<const std::size_t> spans, const Limits& limits) {
    PlacedPatch placed = placed_segment(spline, spans, limits);
    return {std::move(placed.patch), true, std::move(placed.frames), {}};
}

Patch read_segment(Fields& request, const TensorBSpline& spline, const Limits& limits) {
    auto spans = request.optional("segment", [&](const Json& value) {
        return read_each_direction(value, spline.directions(), "indices of knots",
                                   [&](const Json& element) { return read_index(element, limits); });
    });
    if (!spans) {
        spans.emplace();
        for (const KnotVector& knots : spline.knots()) spans->push_back(only_span(knots));
    }
    return segment(spline, *spans, limits);
}

Field segment_field() {
    return optional("segment", Shape::one_of({ValueKind::count, counts_shape()}),
                    "of a B-spline: the index of the knot at which the segment begins, needed if there are "
                    "several; in several directions one index each");
}

Option segment_option() {
    const auto indices_of = [](std::string_view text, const Json&) -> Json {
        Json::Array indices;
        for (const std::string& index : split(text, ',')) indices.push_back(count(index));
        return indices;
    };
    return field_option("--segment", "segment", "I", count, indices_of);
}

}  // namespace blossom::protocol
