#pragma once

#include <blossom/core/curve/roots.hpp>
#include <blossom/rational/limits.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <blossom/protocol/json.hpp>
#include "description/members.hpp"
#include "text/readable.hpp"

/// Real algebraic numbers in results: a rational number as "value", any other by an "interval" that has no
/// other number with the same equation; with the "double" nearest to it.

namespace blossom::protocol {

/// The members of such a number.
Json::Object real_members(const Root& number, const Limits& limits);
Json real_json(const Root& number, const Limits& limits);
Json real_json(std::span<const Root> numbers, const Limits& limits);

/// Members of an object that is such a number, `what`, with others.
Members real_number_members(FieldList others, std::string_view what);
Shape real_shape();
/// The field of a point, whose coordinates are such numbers.
Field real_point_member();

/// "1/2", or "≈ 1.414" with the interval where there is no double.
std::string real_text(const Json& number);
/// "t = 1/2", or "1 < t < 3/2, t ≈ 1.414".
std::string real_equation(const Json& number, std::string_view name, const Style& style);
/// "(1/2, ≈ 1.414)".
std::string real_point_text(const Json& point);

}  // namespace blossom::protocol
