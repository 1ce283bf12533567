#include "answered.hpp"

namespace {

/// Whether `actual` contains everything in `expected`: additional members are allowed, all else must be
/// equal.
bool holds(const Json& actual, const Json& expected) {
    if (const Json::Object* members = expected.object()) {
        for (const auto& [name, value] : *members) {
            const Json* found = actual.find(name);
            if (!found || !holds(*found, value)) return false;
        }
        return actual.object() != nullptr;
    }
    const Json::Array* elements = expected.array();
    if (!elements) return actual == expected;
    const Json::Array* found = actual.array();
    if (!found || found->size() != elements->size()) return false;
    for (std::size_t i = 0; i < elements->size(); ++i) {
        if (!holds((*found)[i], (*elements)[i])) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("the comparison sees what is missing and what differs") {
    const auto json = [](const char* text) { return parse_json(text, Limits{}); };
    CHECK(holds(json(R"({"a": [1, {"b": "x"}], "more": 1})"), json(R"({"a": [1, {"b": "x"}]})")));
    CHECK_FALSE(holds(json(R"({"a": [1]})"), json(R"({"a": [1, 2]})")));
    CHECK_FALSE(holds(json(R"({"a": "1"})"), json(R"({"a": 1})")));
    CHECK_FALSE(holds(json(R"({})"), json(R"({"a": null})")));
}

TEST_CASE("the protocol's examples are answered as shown") {
    std::ifstream file(BLOSSOM_SOURCE "/tests/golden/protocol-examples.jsonl");
    std::size_t count = 0;
    for (std::string line; std::getline(file, line); ++count) {
        const Json example = parse_json(line, Limits{});
        const Json response = served(protocol::to_text(*example.find("request")));
        INFO(line);
        INFO(protocol::to_text(response));
        CHECK(holds(response, *example.find("response")));
    }
    CHECK(count >= 33);
}
