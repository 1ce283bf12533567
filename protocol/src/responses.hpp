#pragma once

#include <blossom/protocol/answer.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/limits.hpp>

#include <exception>
#include <string>
#include <string_view>

#include "operations/operation.hpp"

namespace blossom::protocol {

/// The fields besides "op" that every request may have.
FieldList common_fields();

/// The operation of that name. Errors: `unknown_op`.
const Operation& find_operation(std::string_view name);

/// The answer to a request, with rounded numbers if the request has the field "numbers". Errors: all that can
/// be wrong with it, each with the JSON Pointer of its place.
Answer find_answer(const Json& request, const Limits& limits);

/// {"ok": true, "result": ...}, with "id" in front when the request has one.
Json success_response(const Json& request, Json result);
/// {"ok": false, "error": {"code", "message", "at"}}, likewise.
Json error_response(const Json& request, const Error& error);

/// Any other exception as an error: `limit_exceeded` for memory, `internal` for the rest.
Error unexpected(const std::exception& problem);

/// The outcome of an answer with this result.
Outcome outcome_of(const Json& result);

/// The response to a line that is too long.
Response refuse_long_line(const Limits& limits);

}  // namespace blossom::protocol
