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

/// What a program adds to an error in a response, such as the option that raises a limit.
using ErrorMembers = void (*)(const Error& error, Json::Object& members);

/// The operation of that name. Errors: `unknown_op`.
const Operation& find_operation(std::string_view name);

/// The answer to a request, with rounded numbers if the request has the field "numbers". Errors: all that can
/// be wrong with it, each with the JSON Pointer of its place.
Answer find_answer(const Json& request, const Limits& limits);

/// {"ok": true, "result": ...}, with "id" in front when the request has one.
Json success_response(const Json& request, Json result);
/// {"ok": false, "error": {"code", "message", "at"}}, likewise, with "limit" if a limit is exceeded, and what
/// `add` adds.
Json error_response(const Json& request, const Error& error, ErrorMembers add = nullptr);

/// Any other exception as an error: `limit_exceeded` for memory, `internal` for the rest.
Error unexpected(const std::exception& problem);

/// The outcome of an answer with this result.
Outcome outcome_of(const Json& result);

/// As `answer`, with what `add` adds to an error.
Response answer(std::string_view request, const Limits& limits, ErrorMembers add);

/// The response to a line that is too long.
Response refuse_long_line(const Limits& limits, ErrorMembers add = nullptr);

}  // namespace blossom::protocol
