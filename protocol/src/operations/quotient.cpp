#include "common_domain.hpp"
#include "listing.hpp"
#include "map_list.hpp"
#include "map_options.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

/// (A / w) / (b / v) = A v / (w b), where a weight may be 1.
CoordinateSums quotient_sums(const CommonMaps& given) {
    const auto weight_of = [&](std::size_t map) {
        std::vector<CoordinateOf> weight;
        if (given.forms[map].rational) weight.push_back({map, given.dimension(map)});
        return weight;
    };
    CoordinateSums sums;
    for (std::size_t j = 0; j < given.dimension(0); ++j) {
        sums.push_back({{weight_of(1)}});
        sums.back().front().coordinates.push_back({0, j});
    }
    sums.push_back({{weight_of(0)}});
    sums.back().front().coordinates.push_back({1, 0});
    return sums;
}

/// Errors: `zero_weight` if the divisor is 0 everywhere.
void require_divisor(const CommonMaps& given, const Limits& limits) {
    const CoordinateSums divisor{{{{{1, 0}}}}};
    const auto is_zero = [&](const auto& maps) {
        const auto scalar = combined(std::span(maps), std::span(divisor), limits);
        if constexpr (requires { points_of(scalar); }) {
            return std::ranges::all_of(points_of(scalar).numbers().numerators(), &Integer::is_zero);
        } else {
            return std::ranges::all_of(scalar.control_points(),
                                       [](const Coordinates& point) { return point.front().is_zero(); });
        }
    };
    if (!std::visit(is_zero, given.maps)) return;
    throw Error(ErrorCode::zero_weight, "the divisor is 0 everywhere", Place{"maps"} / 1);
}

Answer answer_quotient(Request& request, const Limits& limits) {
    const std::vector<Map> maps = read_maps_field(request, limits);
    request.finish();
    if (maps.size() != 2) {
        throw Error(ErrorCode::wrong_arity,
                    "a quotient is one of two maps, not of " + std::to_string(maps.size()), Place{"maps"});
    }
    const CommonMaps given = on_common_domain(maps, limits);
    if (given.dimension(1) != 1) {
        throw Error(ErrorCode::mismatched_dimensions,
                    "the divisor has " + std::to_string(given.dimension(1)) +
                        " coordinates; a map is divided by a scalar one",
                    Place{"maps"} / 1);
    }
    require_divisor(given, limits);
    return answer_of(combined_rational_map(given, quotient_sums(given), given.forms.front().scalar, limits),
                     "maps");
}

}  // namespace

Operation quotient_operation() {
    return {
        .summary = "Divide a map by a scalar map on its domain: a rational map",
        .documentation =
            "Nothing is cancelled. Where a control point lies at infinity, the points are homogeneous.",
        .request = {{maps_field("the map that is divided, and the divisor")}},
        .result = {{map_member("the quotient, a rational map")}},
        .example = {"quotient", "1 - t^2; 2t", "1 + t^2"},
        .options = {maps_option("MAP",
                                "the two maps: polynomials, maps of the protocol, a list of them, or the "
                                "output of other commands")},
        .answer = answer_quotient,
        .render = described_listing,
        .plot = plot_of_result,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
