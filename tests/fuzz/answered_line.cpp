#include "answered_line.hpp"

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>

#include "json/json_text.hpp"
#include "responses.hpp"

void check_answered(std::span<const std::uint8_t> line, const blossom::Limits& limits) {
    if (line.size() > limits.line_bytes) return;
    const std::string_view text(reinterpret_cast<const char*>(line.data()), line.size());
    const blossom::protocol::Response served = blossom::protocol::answer(text, limits);
    if (served.text.find('\n') != std::string::npos) std::abort();
    // The response without its `id`, which may hold valid numbers that are too large for this reader.
    blossom::Limits limits_of_responses;  // a result is nested some levels deeper than its request
    limits_of_responses.nesting = 1000;
    const auto [echoed, problem] = blossom::protocol::read_json(served.text, limits_of_responses);
    if (problem) std::abort();
    blossom::protocol::Json::Object members = *echoed.object();
    std::erase_if(members, [](const auto& member) { return member.first == "id"; });
    const auto response = nlohmann::json::parse(blossom::protocol::to_text(members));
    const bool success = response.at("ok").get<bool>();
    if (success != response.contains("result") || success == response.contains("error")) std::abort();
    if (served.outcome == blossom::protocol::Outcome::disagreement) std::abort();
    if (!success && response.at("error").at("code") == "internal") std::abort();
}
