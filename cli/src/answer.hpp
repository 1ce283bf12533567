#pragma once

#include <blossom/rational/error.hpp>
#include <blossom/rational/limits.hpp>

#include <exception>
#include <string>
#include <string_view>

#include "json.hpp"
#include "operations/operation.hpp"

namespace blossom::cli {

/// Exit statuses of the program. Of several responses the greatest counts.
enum class Outcome { success = 0, refused = 1, wrong_usage = 2, disagreement = 3 };

/// The operation of that name. Errors: `unknown_op`.
const Operation& find_operation(std::string_view name);

/// The result of a request. Errors: all that can be wrong with it, each with the JSON Pointer of its place.
Json result_of(const Json& request, const Limits& limits);

/// {"ok": true, "result": ...}, with "id" in front when the request has one.
Json success_response(const Json& request, Json result);
/// {"ok": false, "error": {"code", "message", "at"}}, likewise.
Json error_response(const Json& request, const Error& error);

/// What else was thrown, as an error: `limit_exceeded` for memory, `internal` for the rest.
Error unexpected(const std::exception& problem);

Outcome outcome_of(const Json& response);

/// One line of a batch and its response, without line end. Nothing is thrown: whatever goes wrong is the
/// response.
struct ServedLine {
    std::string response;
    Outcome outcome;
};
ServedLine serve_line(std::string_view line, const Limits& limits);

/// The response to a line that was too long to be read.
ServedLine refuse_long_line(const Limits& limits);

}  // namespace blossom::cli
