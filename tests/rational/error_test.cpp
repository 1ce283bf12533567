#include <blossom/rational/error.hpp>
#include <blossom/rational/limits.hpp>

#include <set>
#include <string>

#include "support/failure.hpp"
#include "support/number_printing.hpp"

using namespace blossom;
using namespace blossom::testing;

TEST_CASE("every error code has a name of its own", "[error]") {
    std::set<std::string_view> names;
    int codes = 0;
    for (; error_name(static_cast<ErrorCode>(codes)) != "error"; ++codes)
        names.insert(error_name(static_cast<ErrorCode>(codes)));
    CHECK(codes > static_cast<int>(ErrorCode::limit_exceeded));
    CHECK(static_cast<int>(names.size()) == codes);
    CHECK(error_name(ErrorCode::zero_denominator) == "zero_denominator");
    CHECK(error_name(ErrorCode::limit_exceeded) == "limit_exceeded");
}

TEST_CASE("an error seen from outside lies below a prefix", "[error]") {
    const Error inner(ErrorCode::syntax, "column 3: expected a number", "/1/u", 2);
    const Error outer = inner.below("/arguments");
    CHECK(outer.field() == "/arguments/1/u");
    CHECK(outer.code() == ErrorCode::syntax);
    CHECK(outer.message() == inner.message());
    CHECK(outer.offset() == 2U);
    CHECK(std::string(outer.what()) == inner.message());
}

TEST_CASE("a limit is kept up to its value and refused beyond, with its name", "[error]") {
    CHECK_FALSE(failure([] { require_within(10, 10, "degree", "the degree"); }));
    const auto refused = failure([] { require_within(11, 10, "degree", "the degree", "/map"); });
    REQUIRE(refused);
    CHECK(refused->code() == ErrorCode::limit_exceeded);
    CHECK(refused->message() == "the degree 11 exceeds the limit degree = 10");
    CHECK(refused->field() == "/map");
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
    CHECK_FALSE(failure([&] { require_result_bits(300, limits, 10); }));
    CHECK_FALSE(failure([&] { require_result_bits(2, limits, SIZE_MAX); }));
    const auto refused = failure([&] { require_result_bits(300, limits, 11); });
    REQUIRE(refused);
    CHECK(refused->code() == ErrorCode::limit_exceeded);
    CHECK(refused->message() ==
          "a result of 11 numbers of up to 100 decimal digits exceeds the limit output_digits = 1000");
    CHECK(failure_code([&] { require_result_bits(300, limits, SIZE_MAX); }) == ErrorCode::limit_exceeded);
}
