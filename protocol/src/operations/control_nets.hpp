#pragma once

#include <optional>

#include "operation.hpp"

/// Control nets of patches over simplices and boxes.

namespace blossom::protocol {

/// The patch as a control net with its domain, a polynomial over the unit box or simplex.
Patch as_net(const Patch& patch, const Limits& limits);

/// The control net over what the request says with "vertices" or "intervals", "degree" or "degrees", which
/// finishes it; in simplex or tensor form where `tensor` says which, by default that of the map.
Patch net_over(Fields& request, const Patch& patch, std::optional<bool> tensor, const Limits& limits);

}  // namespace blossom::protocol
