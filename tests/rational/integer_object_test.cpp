#include <type_traits>
#include "rational_test.hpp"

// Integer as a regular type: construction, copies, moves, aliasing, equality and hashes.

namespace {

std::vector<Integer> samples() {
    std::vector<Integer> values{0, 1, -1, INT64_MAX, INT64_MIN, UINT64_MAX};
    Random random(21);
    for (int i = 0; i < 300; ++i) values.push_back(integer(random));
    return values;
}

}  // namespace

static_assert(std::is_nothrow_move_constructible_v<Integer>);
static_assert(std::is_nothrow_move_assignable_v<Integer>);
static_assert(std::is_nothrow_default_constructible_v<Integer>);
static_assert(!std::is_constructible_v<Integer, double>);
static_assert(!std::is_constructible_v<Integer, float>);
static_assert(!std::is_constructible_v<Integer, bool>);
static_assert(!std::is_constructible_v<Integer, const char*>);
static_assert(!std::is_constructible_v<Integer, std::string>);

TEST_CASE("integers from every built-in type keep their value", "[integer]") {
    CHECK(to_string(Integer()) == "0");
    CHECK(to_string(Integer(INT8_MIN)) == "-128");
    CHECK(to_string(Integer(std::uint8_t{255})) == "255");
    CHECK(to_string(Integer(INT64_MIN)) == "-9223372036854775808");
    CHECK(to_string(Integer(INT64_MAX)) == "9223372036854775807");
    CHECK(to_string(Integer(std::uint64_t{1} << 63)) == "9223372036854775808");
    CHECK(to_string(Integer(UINT64_MAX)) == "18446744073709551615");
    CHECK(Integer(UINT64_MAX) == (Integer(1) << 64) - 1);
    CHECK_FALSE(Integer(UINT64_MAX).to_int64());
    CHECK(Integer(std::uint64_t{INT64_MAX}).to_int64() == INT64_MAX);
}

TEST_CASE("an integer may be its own operand", "[integer]") {
    for (const Integer& value : samples()) {
        CAPTURE(value);
        Integer self = value;
        self += self;
        CHECK(self == value * 2);
        self = value;
        self -= self;
        CHECK(self == 0);
        CHECK(self.to_int64() == 0);
        self = value;
        self *= self;
        CHECK(self == Integer(value) * Integer(value));
        self = value;
        self.add_product(self, self);
        CHECK(self == value * value + value);
        if (value.is_zero()) continue;
        self = value;
        self /= self;
        CHECK(self == 1);
        self = value;
        self %= self;
        CHECK(self == 0);
        CHECK(self.to_int64() == 0);
    }
}

TEST_CASE("assignment between every two representations, and to itself", "[integer]") {
    for (const Integer& from : samples()) {
        for (const Integer& to :
             {Integer(0), Integer(42), Integer(INT64_MIN), Integer(1) << 64, -(Integer(1) << 300)}) {
            CAPTURE(from, to);
            Integer target = to;
            target = from;
            CHECK(target.is_word() == target.to_int64().has_value());
            CHECK(target.word() == target.to_int64().value_or(0));
            CHECK(target.is_one() == (to_string(target) == "1"));
            CHECK(target == from);
            Integer moved = from;
            target = to;
            target = std::move(moved);
            CHECK(target == from);
            const Integer constructed(std::move(target));
            CHECK(constructed == from);
        }
        Integer self = from;
        const Integer& alias = self;
        self = alias;
        CHECK(self == from);
        Integer& reference = self;
        self = std::move(reference);
        CHECK(self == from);
    }
}

TEST_CASE("a moved integer can be assigned and used again", "[integer]") {
    for (const Integer& value : samples()) {
        Integer source = value;
        const Integer target = std::move(source);
        source = 7;
        source += 1;
        CHECK(source == 8);
        CHECK(target == value);
    }
}

TEST_CASE("a copy does not share", "[integer]") {
    const Integer original = Integer(1) << 100;
    Integer copy = original;
    copy += 1;
    CHECK(copy != original);
    CHECK(original == Integer(1) << 100);
}

TEST_CASE("a value that comes back into 64 bits is the same object as one that never left", "[integer]") {
    for (const std::int64_t word :
         {std::int64_t{0}, std::int64_t{1}, std::int64_t{-1}, INT64_MAX, INT64_MIN}) {
        const Integer never_left = word;
        const Integer far = Integer(1) << 200;
        std::vector<Integer> returned{(never_left + far) - far, (never_left - far) + far,
                                      (never_left << 77) >> 77, (never_left * far) / far,
                                      -(-never_left),           (far * 2 + never_left) % far};
        if (word < 0) returned.pop_back();
        for (const Integer& value : returned) {
            CAPTURE(value);
            CHECK(value == never_left);
            CHECK(value.to_int64() == word);
            CHECK((value <=> never_left) == std::strong_ordering::equal);
            CHECK(std::hash<Integer>{}(value) == std::hash<Integer>{}(never_left));
        }
    }
}

TEST_CASE("hashes tell different integers apart", "[integer]") {
    int collisions = 0;
    const auto values = samples();
    for (std::size_t i = 0; i < values.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (values[i] == values[j]) {
                CHECK(std::hash<Integer>{}(values[i]) == std::hash<Integer>{}(values[j]));
            } else {
                collisions += std::hash<Integer>{}(values[i]) == std::hash<Integer>{}(values[j]);
            }
        }
    }
    CHECK(collisions < 10);
}
