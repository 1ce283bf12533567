#include <blossom/protocol/json.hpp>
#include "answered.hpp"

#include <blossom/rational/error.hpp>

#include <nlohmann/json.hpp>

#include "json/json_text.hpp"
#include "support/random.hpp"

namespace {

std::string echoed(std::string_view text) { return protocol::to_text(parse_json(text, Limits{})); }

/// Another JSON reader, whose numbers do not overflow here.
using OtherJson =
    nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t, std::uint64_t, long double>;

Error refusal(std::string_view text, const Limits& limits = {}) {
    const JsonReading reading = read_json(text, limits);
    REQUIRE(reading.error);
    return *reading.error;
}

}  // namespace

TEST_CASE("JSON values are written as they were read") {
    for (const std::string text :
         {"null", "true", "-0", "-0.0", "1e400", "1.50", "[]", "{}", R"({"b": [1, "a/b~", {}], "a": null})",
          R"("é \" \\ \n")", "18446744073709551616", "-9223372036854775808"}) {
        CHECK(echoed(text) == text);
    }
    const std::string digits(5000, '9');
    CHECK(echoed(digits) == digits);
    CHECK(echoed("-" + digits) == "-" + digits);
    CHECK(echoed("\xEF\xBB\xBF [1]\r\n") == "[1]");
    CHECK(echoed(R"("\u00e9\ud83d\ude00")") == "\"é😀\"");
    CHECK(echoed(R"({"\u0061" : "\u0062", "\u0063\u0064": ["\u0065f"]})") == R"({"a": "b", "cd": ["ef"]})");
}

TEST_CASE("text that is not JSON is refused with the place") {
    for (const std::string_view text :
         {std::string_view(""), std::string_view("{"), std::string_view("[1,]"), std::string_view("01"),
          std::string_view("+1"), std::string_view("NaN"), std::string_view("1 2"),
          std::string_view("{\"a\" 1}"), std::string_view("'a'"), std::string_view("\"\xff\""),
          std::string_view("\"\xc0\x80\""), std::string_view("\"\xed\xa0\x80\""),
          std::string_view("\"\\ud800\""), std::string_view("\"a\nb\""), std::string_view("[1]\0", 4),
          std::string_view("1.e5"), std::string_view(".5"), std::string_view("// 1")}) {
        CAPTURE(text);
        CHECK(refusal(text).code() == ErrorCode::syntax);
        CHECK(refusal(text).offset());
    }
    CHECK(refusal("[1, x]").offset() == 4);
}

TEST_CASE("texts are accepted and understood as by another reader of JSON") {
    std::vector<std::string> texts = {
        R"({"a": [1, -0.5e+7, 0, -0, 10], "é😀": "\u00e9\ud83d\ude00\n\/", "": {"x": null}})",
        R"([true, false, null, "", [[]], {}, "\"\\\b\f\n\r\t"])",
        "\"\xC2\x80\xDF\xBF\xE0\xA0\x80\xED\x9F\xBF\xEE\x80\x80\xF0\x90\x80\x80\xF4\x8F\xBF\xBF\""};
    std::ifstream golden(BLOSSOM_SOURCE "/tests/golden/protocol-examples.jsonl");
    for (std::string line; std::getline(golden, line) && texts.size() < 40;)
        texts.push_back(line.substr(0, 400));
    REQUIRE(texts.size() == 40);
    Random random(7);
    constexpr std::string_view pieces = "{}[]\":,\\ue+-.019tfn \t\x01\x80\xBF\xC0\xC2\xED\xA0\xF4\x90";
    std::size_t accepted = 0;
    for (int round = 0; round < 20'000; ++round) {
        std::string text = texts[random.below(texts.size())];
        for (std::uint64_t changes = random.below(3); changes > 0; --changes) {
            const auto place = random.below(text.size());
            switch (random.below(3)) {
                case 0:
                    text[place] = pieces[random.below(pieces.size())];
                    break;
                case 1:
                    text.insert(place, 1, pieces[random.below(pieces.size())]);
                    break;
                default:
                    text.erase(place, 1 + random.below(2));
            }
        }
        CAPTURE(text);
        const JsonReading reading = read_json(text, Limits{});
        if (reading.error && reading.error->message().ends_with("occurs twice in one object")) continue;
        const auto expected = OtherJson::parse(text, nullptr, false);
        REQUIRE(expected.is_discarded() == reading.error.has_value());
        if (reading.error) continue;
        ++accepted;
        CHECK(OtherJson::parse(protocol::to_text(reading.value)) == expected);
    }
    CHECK(accepted > 5'000);
}

TEST_CASE("a syntax error tells no more of the text than its place") {
    CHECK(refusal("[\"" + std::string(1 << 20, 'a')).message().size() < 200);
}

TEST_CASE("a name may occur once in an object") {
    const Error error = refusal(R"({"a": [0, {"x": 1, "y": 2, "x": 3}]})");
    CHECK(error.code() == ErrorCode::syntax);
    CHECK(error.place() == (Place{"a", std::size_t{1}}));
    CHECK(error.message() == "the name \"x\" occurs twice in one object");
    CHECK(refusal(R"({"a": 1, "\u0061": 2})").code() == ErrorCode::syntax);
    CHECK(echoed(R"([{"a": 1}, {"a": 2}])") == R"([{"a": 1}, {"a": 2}])");
}

TEST_CASE("many names cost no more than sorting them") {
    std::string text = "{";
    for (int i = 0; i < 200'000; ++i) text += "\"" + std::to_string(i) + "\": 0, ";
    CHECK(refusal(text + "\"7\": 0}").message() == "the name \"7\" occurs twice in one object");
}

TEST_CASE("nesting is limited before it is stored") {
    Limits limits;
    limits.nesting = 3;
    CHECK(protocol::to_text(parse_json("[{\"a\": []}]", limits)) == "[{\"a\": []}]");
    CHECK(refusal("[[[[]]]]", limits).message() == "brackets nested deeper than the limit nesting = 3");
    CHECK(refusal(std::string(1'000'000, '[')).code() == ErrorCode::limit_exceeded);
}

TEST_CASE("what was read before an error is handed out") {
    const JsonReading reading = read_json(R"({"id": [1, 2], "op": "evaluate", "at": [1, )", Limits{});
    REQUIRE(reading.error);
    REQUIRE(reading.value.find("id"));
    CHECK(protocol::to_text(*reading.value.find("id")) == "[1, 2]");
}

TEST_CASE("JSON Pointers lead to places and back") {
    const Json value = parse_json(R"({"a/b": {"~": ["x", "y"]}, "": 5})", Limits{});
    const Place place = Place{"a/b", "~"} / 1;
    const std::string pointer = pointer_of(place);
    CHECK(pointer == "/a~1b/~0/1");
    REQUIRE(at_pointer(value, pointer));
    CHECK(*at_pointer(value, pointer) == Json("y"));
    CHECK(*at_pointer(value, "/") == Json(Json::Number{"5"}));
    CHECK(at_pointer(value, "") == &value);
    CHECK(at_pointer(value, "/a~1b/~0/2") == nullptr);
    CHECK(at_pointer(value, "/a~1b/~0/x") == nullptr);
    CHECK(at_pointer(value, "/none/0") == nullptr);
}

TEST_CASE("text is always written as valid UTF-8") {
    CHECK(protocol::to_text(Json("a\xff"
                                 "b")) ==
          "\"a\xEF\xBF\xBD"
          "b\"");
    CHECK(protocol::to_text(Json(std::string("\0\x1f", 2))) == "\"\\u0000\\u001f\"");
}
