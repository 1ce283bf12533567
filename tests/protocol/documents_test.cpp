#include <iterator>
#include "answered.hpp"

#include "operations/operation.hpp"

namespace {

std::string document(const std::string& name) {
    std::ifstream file(BLOSSOM_SOURCE "/docs/" + name);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("the documents name every operation and every error code") {
    const std::string protocol = document("protocol.md");
    const std::string commands = document("commands.md");
    for (const Operation& operation : operations()) {
        CHECK(commands.find("\n## " + std::string(operation.name) + "\n") != std::string::npos);
        CHECK(protocol.find("\n### " + std::string(operation.name) + "\n") != std::string::npos);
    }
    const Json schema = parse_json(document("protocol.schema.json"), Limits{});
    const Json* codes = at_pointer(schema, "/$defs/error/properties/code/enum");
    REQUIRE(codes);
    for (const Json& code : *codes->array()) {
        CAPTURE(*code.text());
        CHECK(protocol.find("| `" + *code.text() + "` |") != std::string::npos);
    }
}

TEST_CASE("docs/protocol.md shows requests with their real responses") {
    std::istringstream lines(document("protocol.md"));
    std::string request;
    std::size_t count = 0;
    bool in_block = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```")) {
            in_block = line == "```jsonl";
        } else if (in_block && request.empty()) {
            request = line;
        } else if (in_block) {
            CHECK(answer(request).text == line);
            request.clear();
            ++count;
        }
    }
    CHECK(request.empty());
    CHECK(count >= 12);
}
