#include "segment.hpp"

#include <blossom/core/spline/de_boor.hpp>

#include "map_options.hpp"
#include "shared_fields.hpp"

namespace blossom::protocol {

std::optional<std::size_t> read_span(Fields& request, const Map& map, const Limits& limits) {
    if (!std::holds_alternative<BSplineCurve>(map.value)) return std::nullopt;
    return request.optional("segment", [&](const Json& value) { return read_index(value, limits); });
}

std::size_t chosen_span(const BSplineCurve& curve, std::optional<std::size_t> span) {
    if (!span) return only_span(curve.knots());
    curve.knots().require_span(*span);
    return *span;
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
