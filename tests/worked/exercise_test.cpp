#include <blossom/worked/exercise.hpp>
#include <blossom/worked/render.hpp>

#include <set>

#include "support/catch.hpp"
#include "support/failure.hpp"

using namespace blossom;
using namespace blossom::testing;
using namespace blossom::worked;

namespace {

SheetRequest request(std::string_view topic, std::uint64_t seed, std::size_t level, std::size_t count) {
    return {std::string(topic), seed, count, level};
}

/// A sheet with one problem as its text, without the number of the sheet in the title.
std::string problem_text(Sheet sheet, std::size_t i) {
    Document one;
    one.steps.push_back(sheet.problems.steps[i]);
    std::string text = render_json(one);
    // Names have the number of the problem behind them.
    for (const std::string name : {"P", "p", "F", "f"}) {
        const std::string numbered = "\"" + name + std::to_string(i + 1) + "\"";
        for (std::size_t at = text.find(numbered); at != std::string::npos; at = text.find(numbered)) {
            text.replace(at, numbered.size(), "\"" + name + "\"");
        }
    }
    return text;
}

}  // namespace

TEST_CASE("the same seed gives the same sheet, another seed another one") {
    for (const std::string_view topic : exercise_topics()) {
        CAPTURE(topic);
        const auto sheet = [&](std::uint64_t seed) {
            return render_json(exercise_sheet(request(topic, seed, 2, 3)).solutions);
        };
        CHECK(sheet(5) == sheet(5));
        CHECK(sheet(5) != sheet(6));
    }
}

TEST_CASE("a sheet has as many problems as asked for, each with its solution and no two alike") {
    for (const std::string_view topic : exercise_topics()) {
        for (std::size_t level = 1; level <= 3; ++level) {
            CAPTURE(topic, level);
            const Sheet sheet = exercise_sheet(request(topic, 11, level, 12));
            REQUIRE(sheet.problems.steps.size() == 12);
            REQUIRE(sheet.solutions.steps.size() == 12);
            std::set<std::string> problems;
            for (std::size_t i = 0; i < 12; ++i) problems.insert(problem_text(sheet, i));
            CHECK(problems.size() == 12);
            CHECK_FALSE(sheet.problems.check.has_value());
        }
    }
}

TEST_CASE("sheets that cannot be made are refused") {
    CHECK(failure_code([] { exercise_sheet(request("algebra", 1, 1, 1)); }) == ErrorCode::unknown_op);
    CHECK(failure_code([] { exercise_sheet(request("blossom", 1, 4, 1)); }) == ErrorCode::wrong_arity);
    CHECK(failure_code([] { exercise_sheet(request("blossom", 1, 0, 1)); }) == ErrorCode::wrong_arity);
    CHECK(failure_code([] { exercise_sheet(request("blossom", 1, 1, 41)); }) == ErrorCode::limit_exceeded);
}
