#pragma once

#include <vector>

#include "maps/parameters.hpp"
#include "operation.hpp"

/// Every node of the triangle that evaluates a curve.

namespace blossom::protocol {

/// Member "pyramids": for each parameter the levels of the algorithm, level 0 the control points of the map
/// or segment, the last the value; of a tensor product one direction after the other, the last one first.
/// With separate weights also "pyramid_weights". Errors: `wrong_kind`; `limit_exceeded`; `zero_weight`.
void add_pyramids(Json& result, const Map& map, const Parameters& parameters, const Limits& limits);

/// The pyramids of a result for a person; "" if there are none.
std::string pyramids_text(const Answered& answered);

}  // namespace blossom::protocol
