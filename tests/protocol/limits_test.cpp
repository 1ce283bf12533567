#include "answered.hpp"
#include "limit_table.hpp"

namespace {

/// The message of a request that a limit refuses.
std::string excess(const std::string& request, const Limits& limits = {}) {
    const Json response = served(request, limits);
    INFO(protocol::to_text(response).substr(0, 300));
    REQUIRE(response.find("error"));
    REQUIRE(*response.find("error")->find("code") == Json("limit_exceeded"));
    return *response.find("error")->find("message")->text();
}

bool names(const std::string& message, const std::string& limit) {
    CAPTURE(message);
    return message.find(limit + " = ") != std::string::npos && message.size() < 300;
}

std::string evaluate(const std::string& text, const std::string& at = "1") {
    return R"({"op": "evaluate", "map": {"kind": "polynomial", "text": ")" + text + R"("}, "at": [")" + at +
           "\"]}";
}

/// Digits beyond the limit. With AddressSanitizer, a character costs forty times as much.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define BLOSSOM_ADDRESS_SANITIZER
#endif
#endif
#if defined(BLOSSOM_ADDRESS_SANITIZER) || defined(__SANITIZE_ADDRESS__)
constexpr std::size_t enormous = 5'000'000;
#else
constexpr std::size_t enormous = 50'000'000;
#endif

}  // namespace

TEST_CASE("huge exponents, numbers and nesting are refused, naming the limit") {
    CHECK(names(excess(evaluate("t^999999999999")), "degree"));
    CHECK(names(excess(evaluate("(((t^1000)^1000)^1000)^1000")), "degree"));
    CHECK(names(excess(evaluate("1e999999999999")), "digits"));
    CHECK(names(excess(evaluate("t", "1e-999999999999")), "digits"));
    CHECK(names(excess(evaluate(std::string(1'000'000, '(') + "t")), "nesting"));
    CHECK(names(excess(evaluate("t^10000", "1e900")), "digits"));
    CHECK(names(excess(R"({"op": "evaluate", "map": )" + std::string(1'000'000, '[')), "nesting"));
}

TEST_CASE("a number of tens of millions of digits is refused") {
    CHECK(names(excess(evaluate("t", std::string(enormous, '7'))), "digits"));
    CHECK(names(excess(R"({"op": "evaluate", "map": {"kind": "polynomial", "text": "t"}, "at": [)" +
                       std::string(enormous, '7') + "]}"),
                "digits"));
}

TEST_CASE("a result that is long in all is refused before it is written") {
    Limits limits;
    limits.output_digits = 40;
    const auto parameters = [](std::size_t count) {
        std::string line =
            R"({"op": "evaluate", "map": {"kind": "polynomial", "text": "t"}, "at": ["1000000000")";
        for (std::size_t i = 1; i < count; ++i) line += R"(, "1000000000")";
        return line + "]}";
    };
    CHECK(served_at("/ok", parameters(3), limits) == "true");
    CHECK(names(excess(parameters(4), limits), "output_digits"));
}

TEST_CASE("a formal degree and a dimension may not multiply beyond what fits") {
    std::string texts = "\"1\"";
    for (int i = 0; i < 1000; ++i) texts += ", \"1\"";
    CHECK(names(excess(R"({"op": "evaluate", "map": {"kind": "polynomial", "degree": 10000, "text": [)" +
                       texts + R"(]}, "at": [1]})"),
                "numbers"));
    std::string at = "1";
    for (int i = 0; i < 9999; ++i) at += ", 1";
    CHECK(names(excess(R"({"op": "evaluate", "map": {"kind": "polynomial", "text": [)" + texts +
                       R"(]}, "at": [)" + at + "]}"),
                "numbers"));
}

TEST_CASE("every list of coefficients obeys the degree") {
    Limits limits;
    limits.degree = 3;
    const auto with = [](const std::string& map) {
        return R"({"op": "evaluate", "at": [1], "map": {)" + map + "}}";
    };
    CHECK(names(excess(with(R"("kind": "polynomial", "coefficients": [0, 0, 0, 0, 0])"), limits), "degree"));
    CHECK(names(excess(with(R"("kind": "polynomial", "text": "1", "denominator": [1, 0, 0, 0, 1])"), limits),
                "degree"));
    CHECK(names(excess(with(R"("kind": "bezier", "control_points": [0, 0, 0, 0, 0])"), limits), "degree"));
    CHECK(served(with(R"("kind": "bezier", "control_points": [0, 0, 0, 0])"), limits).find("result"));
}

TEST_CASE("what is expanded for all arguments is limited") {
    CHECK(names(excess(R"({"op": "agree", "map": {"kind": "polynomial", "text": "t^64"}})"),
                "expansion_terms"));
}

TEST_CASE("every limit of the table can be set") {
    Limits limits;
    for (const LimitEntry& entry : limit_table()) {
        limits.*entry.member = 7;
        CHECK(entry.greatest >= Limits{}.*entry.member);
    }
    CHECK(limits.degree == 7);
    CHECK(limits.line_bytes == 7);
}

TEST_CASE("the limit of numbers counts those of the result, not those of an algorithm") {
    const std::string request =
        R"({"op": "control-points", "map": {"kind": "polynomial", "variables": ["x", "y"], "text": "x + y",
            "degrees": [2900, 1]}})";
    const Json net = parse_json(served_at("/result/map/control_net", request), Limits{});
    const auto& rows = *net.array();
    REQUIRE(rows.size() == 2901);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Rational x(Integer(i), Integer(2900));
        const Json::Array expected{Json(to_string(x)), Json(to_string(x + 1))};
        CHECK(rows[i] == Json(expected));
    }
    Limits limits;
    limits.numbers = 11;
    const std::string split = R"({"op": "subdivide", "at": ["1/3", "1/2"], "map": {"kind": "tensor",
        "degrees": [2, 1], "control_net": [[0, 1], [2, 5], [1, 1]]}})";
    CHECK(names(excess(split, limits), "numbers"));
    limits.numbers = 12;
    CHECK(served_at("/ok", split, limits) == "true");
}
