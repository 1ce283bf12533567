#pragma once

#include <blossom/protocol/json.hpp>
#include <blossom/rational/limits.hpp>

#include <concepts>
#include <string>
#include <string_view>

/// Requests and their answers: the whole program as one function, without streams, threads and files.

namespace blossom::protocol {

/// How a request ended, as the exit status of the program. For several requests it is the greatest.
enum class Outcome { success = 0, refused = 1, wrong_usage = 2, disagreement = 3 };

/// One line of JSON, without a line end.
struct Response {
    std::string text;
    Outcome outcome;
};

/// The response to one request: {"ok": true, "result": ...} or {"ok": false, "error": {"code", "message",
/// "at"}}, where "at" is the JSON Pointer of what is wrong in the request. docs/protocol.md describes every
/// operation. Nothing is thrown: whatever goes wrong is in the response.
///
///     protocol::answer(R"({"op": "evaluate", "map": {"kind": "polynomial", "text": "t^2"}, "at":
///     ["1/2"]})").text
///
/// Cost: that of the operation, within `limits`.
Response answer(std::string_view request, const Limits& limits = {});

/// The same for a request and a response as values.
Json answer_to(const Json& request, const Limits& limits);
template <std::same_as<Json> Value>  // no text is taken for a JSON string
Json answer(const Value& request, const Limits& limits = {}) {
    return answer_to(request, limits);
}

}  // namespace blossom::protocol
