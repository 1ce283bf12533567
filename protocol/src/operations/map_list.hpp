#pragma once

#include <string_view>
#include <vector>

#include "operation.hpp"

/// Several maps in one request.

namespace blossom::protocol {

/// Field "maps".
inline Field maps_field(std::string documentation) {
    return required("maps", Shape::list(ValueKind::map), std::move(documentation));
}
/// What it holds. Errors: those of `read_map`, below the index of the map.
std::vector<Map> read_maps_field(Fields& request, const Limits& limits);

/// A list with one number per map; `what` are several of them. Errors: `wrong_arity`.
std::vector<Rational> read_each_map(const Json& value, std::size_t maps, std::string_view what,
                                    const Limits& limits);

/// The maps in one form of points: where some are rational and others are not, these get the weight 1.
/// Errors: `mismatched_dimensions` where points are numbers here and arrays there, of different lengths, or
/// homogeneous in some of the maps only; `wrong_kind` for a map that is no single curve.
void make_form_common(std::vector<Map>& maps, const Limits& limits);

/// For field "maps": each a polynomial as text, a map of the protocol, a list of maps, or a response that has
/// a map or several.
Option maps_option(std::string name, std::string help);

}  // namespace blossom::protocol
