#include <blossom/rational/taylor_shift.hpp>
#include "rational_test.hpp"

// Run separately, with BLOSSOM_VECTOR_LEVEL=avx512 in the environment.
TEST_CASE("an unknown vector level is refused at every use", "[.][unknown_vector_level]") {
    const std::vector<Integer> too_many_for_words(100, 1);
    for (int use = 0; use < 2; ++use) {
        const std::optional<Error> error = failure([&] { shifted_by_one(too_many_for_words); });
        REQUIRE(error);
        CHECK(error->code() == ErrorCode::wrong_kind);
        CHECK(
            error->message() ==
            R"(the environment variable BLOSSOM_VECTOR_LEVEL is "avx512"; it must be "ifma", "avx2" or "portable")");
    }
}
