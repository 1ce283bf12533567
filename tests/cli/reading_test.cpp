#include <filesystem>

#include "cli/run.hpp"
#include "json/json_text.hpp"
#include "maps/map.hpp"

// Counts how often texts are parsed: the linker replaces the functions of the library by these, which call
// the originals.

using namespace blossom;
using namespace blossom::cli;

namespace {

std::size_t maps_read = 0;
std::size_t texts_parsed = 0;

}  // namespace

#define BLOSSOM_READ_MAP "_ZN7blossom8protocol8read_mapERKNS_4JsonERKNS_6LimitsE"
#define BLOSSOM_READ_JSON \
    "_ZN7blossom8protocol9read_jsonESt17basic_string_viewIcSt11char_traitsIcEERKNS_6LimitsE"
#define BLOSSOM_PARSE_JSON \
    "_ZN7blossom8protocol10parse_jsonESt17basic_string_viewIcSt11char_traitsIcEERKNS_6LimitsE"

protocol::Map library_read_map(const Json& value, const Limits& limits) asm("__real_" BLOSSOM_READ_MAP);
protocol::Map counted_read_map(const Json& value, const Limits& limits) asm("__wrap_" BLOSSOM_READ_MAP);
protocol::Map counted_read_map(const Json& value, const Limits& limits) {
    ++maps_read;
    return library_read_map(value, limits);
}

Json library_parse_json(std::string_view text, const Limits& limits) asm("__real_" BLOSSOM_PARSE_JSON);
Json counted_parse_json(std::string_view text, const Limits& limits) asm("__wrap_" BLOSSOM_PARSE_JSON);
Json counted_parse_json(std::string_view text, const Limits& limits) {
    ++texts_parsed;
    return library_parse_json(text, limits);
}

protocol::JsonReading library_read_json(std::string_view text,
                                        const Limits& limits) asm("__real_" BLOSSOM_READ_JSON);
protocol::JsonReading counted_read_json(std::string_view text,
                                        const Limits& limits) asm("__wrap_" BLOSSOM_READ_JSON);
protocol::JsonReading counted_read_json(std::string_view text, const Limits& limits) {
    ++texts_parsed;
    return library_read_json(text, limits);
}

namespace {

struct Counts {
    std::size_t maps;
    std::size_t texts;
    friend bool operator==(const Counts&, const Counts&) = default;
};

std::ostream& operator<<(std::ostream& stream, const Counts& counts) {
    return stream << counts.maps << " maps, " << counts.texts << " texts";
}

template <class Action>
Counts counted(const Action& action) {
    maps_read = texts_parsed = 0;
    action();
    return {maps_read, texts_parsed};
}

Counts of_command(const std::vector<std::string>& arguments) {
    return counted([&] {
        const Run result = run(arguments);
        CAPTURE(arguments, result.errors);
        CHECK(result.status == 0);
    });
}

const std::vector<std::string> cubic{"--control-points", "0,0; 1,2; 3,3; 5,1"};
const std::vector<std::string> spline{"--control-points", "0,0; 1,2; 3,3; 5,1", "--knots",
                                      "0,0,0,1,2,2,2",    "--degree",           "2"};
const std::vector<std::string> patch{"x^2 - y^2", "--variables", "x,y"};

std::vector<std::string> joined(std::vector<std::string> words, const std::vector<std::string>& map,
                                const std::vector<std::string>& more = {}) {
    words.insert(words.end(), map.begin(), map.end());
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

}  // namespace

TEST_CASE("a command reads its map once, and no JSON that the program has written") {
    const std::string picture =
        (std::filesystem::temp_directory_path() / "blossom-reading-test.svg").string();
    const std::vector<std::string> shown{"--svg", picture};
    const Counts one{1, 0};
    for (const auto& arguments : {
             joined({"insert-knots"}, spline, {"--insert", "1/2"}),
             joined({"insert-knots", "--json"}, spline, {"--insert", "1/2", "--svg", picture}),
             joined({"segments", "--json"}, spline, shown),
             joined({"segments"}, spline),
             joined({"derivative"}, cubic, {"--at", "1/2"}),
             joined({"derivative"}, cubic, {"--at", "1/2", "--svg", picture}),
             joined({"derivative"}, cubic, shown),
             joined({"derivative"}, patch, {"--direction", "1,0", "--at", "1,2", "--svg", picture}),
             joined({"derivative"}, patch, {"--direction", "1,0", "--svg", picture}),
             joined({"evaluate", "--numbers", "double"}, cubic, {"--at", "1/2", "--svg", picture}),
             joined({"evaluate"}, patch, {"--at", "1,2", "--svg", picture}),
             joined({"subdivide"}, cubic, {"--at", "1/2", "--svg", picture}),
             joined({"control-points", "--numbers", "double"}, cubic, {"--over", "0,1/2", "--svg", picture}),
             joined({"elevate"}, cubic, {"--by", "1"}),
             joined({"agree"}, cubic, {"--at", "1,2,3"}),
             joined({"explain", "evaluate"}, cubic, {"--at", "1/2"}),
             joined({"explain", "insert-knots"}, spline, {"--insert", "1/2"}),
             joined({"explain", "segments"}, spline),
         }) {
        CAPTURE(arguments);
        CHECK(of_command(arguments) == one);
    }
    std::filesystem::remove(picture);
}

TEST_CASE("JSON that is typed is parsed once") {
    const std::string map = R"({"kind": "bezier", "control_points": [0, 1, 4]})";
    CHECK(of_command({"elevate", "--map", map, "--by", "1"}) == Counts{1, 1});
    CHECK(
        of_command({"join", map, R"({"kind": "bezier", "control_points": [4, 7, 9], "interval": [1, 2]})"}) ==
        Counts{2, 2});
    CHECK(of_command({"certify", R"({"op": "blossom", "map": {"kind": "polynomial", "text": "1 + 2t"},)"
                                 R"( "arguments": ["1/2"]})"}) == Counts{1, 1});
}

TEST_CASE("a line of a batch is parsed once, and its map read once") {
    const auto counts = counted([] {
        const std::string request =
            R"({"op": "blossom", "map": {"kind": "polynomial", "text": "t^2"}, "arguments": [1, 2]})";
        CHECK(run({"batch"}, request + "\n" + request + "\n").status == 0);
    });
    CHECK(counts == Counts{2, 2});
}
