// Whatever a line holds, its response is one line of valid JSON, and says whether it succeeded.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>

#include "json/json_text.hpp"
#include "responses.hpp"

namespace {

/// Small enough for every input to be answered in a moment.
blossom::Limits small_limits() {
    blossom::Limits limits;
    limits.degree = 12;
    limits.digits = 300;
    limits.nesting = 20;
    limits.polarization_terms = 1 << 8;
    limits.expansion_terms = 1 << 8;
    limits.expansion_work = 20'000;
    limits.numbers = 1 << 10;
    limits.line_bytes = 1 << 14;
    return limits;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const blossom::Limits limits = small_limits();
    if (size > limits.line_bytes) return 0;
    const std::string_view line(reinterpret_cast<const char*>(data), size);
    const blossom::protocol::Response served = blossom::protocol::answer(line, limits);
    if (served.text.find('\n') != std::string::npos) std::abort();
    // Without the `id`, which may hold numbers that are valid and too large for this reader.
    const auto [echoed, problem] = blossom::protocol::read_json(served.text, blossom::Limits{});
    if (problem) std::abort();
    blossom::protocol::Json::Object members = *echoed.object();
    std::erase_if(members, [](const auto& member) { return member.first == "id"; });
    const auto response = nlohmann::json::parse(blossom::protocol::to_text(members));
    const bool success = response.at("ok").get<bool>();
    if (success != response.contains("result") || success == response.contains("error")) std::abort();
    if (served.outcome == blossom::protocol::Outcome::disagreement) std::abort();
    if (!success && response.at("error").at("code") == "internal") std::abort();
    return 0;
}
