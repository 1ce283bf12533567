#include <blossom/rational/error.hpp>
#include <blossom/rational/limits.hpp>
#include "rational_test.hpp"

TEST_CASE("error codes have distinct names", "[error]") {
    std::set<std::string_view> names;
    int codes = 0;
    for (; error_name(static_cast<ErrorCode>(codes)) != "error"; ++codes)
        names.insert(error_name(static_cast<ErrorCode>(codes)));
    CHECK(codes > static_cast<int>(ErrorCode::limit_exceeded));
    CHECK(static_cast<int>(names.size()) == codes);
    CHECK(error_name(ErrorCode::zero_denominator) == "zero_denominator");
    CHECK(error_name(ErrorCode::limit_exceeded) == "limit_exceeded");
}

TEST_CASE("parts have distinct names", "[error]") {
    std::set<std::string_view> names;
    for (int part = 0; part <= static_cast<int>(Part::vertices); ++part)
        names.insert(part_name(static_cast<Part>(part)));
    CHECK(names.size() == static_cast<std::size_t>(Part::vertices) + 1);
    CHECK(names.count("") == 0);
    CHECK(part_name(Part::arguments) == "arguments");
    CHECK(part_name(Part::control_points) == "control_points");
    CHECK(part_name(Part::knots) == "knots");
    CHECK(part_name(Part::vertices) == "vertices");
}

TEST_CASE("a place leads through parameters, indices and members", "[error]") {
    const Place place = Part::maps / 1 / Part::control_points;
    CHECK(place.steps().size() == 3);
    CHECK(place == Place{Part::maps, std::size_t{1}, Part::control_points});
    CHECK(place == Place{"maps"} / 1 / "control_points");
    CHECK_FALSE(place == Part::maps / 2 / Part::control_points);
    CHECK_FALSE(place == Part::maps / 1);
    CHECK_FALSE(Place{"1"} == Place{std::size_t{1}});
    CHECK(place.begins_with({}));
    CHECK(place.begins_with(place));
    CHECK(place.begins_with(Part::maps / 1));
    CHECK_FALSE(Place(Part::maps).begins_with(Part::maps / 1));
    CHECK(place.inside(Part::maps / 1) == Part::control_points);
    CHECK(place.inside(Part::knots).empty());
    CHECK(Place(Part::maps).around(Part::at / 0) == Place(Part::maps) / Part::at / 0);
    CHECK(Place().empty());
}

TEST_CASE("an error seen from outside lies below a prefix", "[error]") {
    const Error inner(ErrorCode::syntax, "column 3: expected a number", Place{std::size_t{1}}, 2);
    const Error outer = inner.below(Part::arguments);
    CHECK(outer.place() == Part::arguments / 1);
    CHECK(outer.at(Part::at).place() == Part::at);
    CHECK(failure([&] { within(Part::arguments, [&] { throw Error(inner); }); })->place() == outer.place());
    CHECK(within(std::size_t{3}, [] { return 5; }) == 5);
    CHECK(outer.code() == ErrorCode::syntax);
    CHECK(outer.message() == inner.message());
    CHECK(outer.offset() == 2U);
    CHECK(std::string(outer.what()) == inner.message());
}

TEST_CASE("a limit is kept up to its value and refused beyond, with its name", "[error]") {
    CHECK_FALSE(failure([] { require_within(10, 10, "degree", "the degree"); }));
    const auto refused = failure([] { require_within(11, 10, "degree", "the degree", Part::map); });
    REQUIRE(refused);
    CHECK(refused->code() == ErrorCode::limit_exceeded);
    CHECK(refused->message() == "the degree 11 exceeds the limit degree = 10");
    CHECK(refused->place() == Part::map);
}

TEST_CASE("the size of a result is refused when its decimal digits exceed the limit", "[error]") {
    Limits limits;
    limits.digits = 100;
    CHECK_FALSE(failure([&] { require_result_bits(300, limits); }));
    CHECK(failure_code([&] { require_result_bits(340, limits); }) == ErrorCode::limit_exceeded);
    CHECK(failure_code([&] { require_result_bits(SIZE_MAX, limits); }) == ErrorCode::limit_exceeded);
}

TEST_CASE("the size of all numbers of a result together is refused beyond its own limit", "[error]") {
    Limits limits;
    limits.output_digits = 1000;
    CHECK_FALSE(failure([&] { require_result_bits(333, limits, 10); }));
    CHECK_FALSE(failure([&] { require_result_bits(2, limits, SIZE_MAX); }));
    const auto refused = failure([&] { require_result_bits(333, limits, 11); });
    REQUIRE(refused);
    CHECK(refused->code() == ErrorCode::limit_exceeded);
    CHECK(refused->message() ==
          "a result of 11 numbers of up to 100 decimal digits exceeds the limit output_digits = 1000");
    CHECK(failure_code([&] { require_result_bits(333, limits, SIZE_MAX); }) == ErrorCode::limit_exceeded);
}
