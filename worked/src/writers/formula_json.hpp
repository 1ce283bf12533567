#pragma once

#include <blossom/worked/formula.hpp>

#include <nlohmann/json.hpp>

namespace blossom::worked {

/// A formula as data: {"kind": "sum", "parts": [...]}; numbers as strings, {"kind": "number", "value":
/// "41/3"}.
nlohmann::ordered_json to_json(const Formula& formula);

}  // namespace blossom::worked
