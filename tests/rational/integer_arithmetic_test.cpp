#include <iterator>
#include "rational_test.hpp"

// Every operation of Integer compared with numbers of another library, across the boundary of 64 bits.

namespace {

/// 0, +-1 and both sides of every power of two at which the representation or a kernel changes.
std::vector<Integer> boundary_values() {
    std::set<Integer> values;
    for (int offset = -2; offset <= 2; ++offset) {
        values.insert(offset);
        for (const std::size_t exponent : {31U, 32U, 62U, 63U, 64U, 127U, 128U}) {
            values.insert((Integer(1) << exponent) + Integer(offset));
            values.insert(-(Integer(1) << exponent) + Integer(offset));
        }
    }
    return {values.begin(), values.end()};
}

/// The representation must not depend on how a value was computed: a 64-bit value is stored as one, and
/// double negation gives the value back.
void check_canonical(const Integer& value) {
    const bool word = textbook::bit_length(value) < 64 || to_string(value) == "-9223372036854775808";
    CHECK(value.to_int64().has_value() == word);
    CHECK(-(-value) == value);
    CHECK(std::hash<Integer>{}(-(-value)) == std::hash<Integer>{}(value));
}

void check_operations(const Integer& a, const Integer& b) {
    CAPTURE(a, b);
    CHECK(to_string(a + b) == textbook::sum(a, b));
    CHECK(to_string(a - b) == textbook::difference(a, b));
    CHECK(to_string(a * b) == textbook::product(a, b));
    CHECK((a <=> b) == (textbook::comparison(a, b) <=> 0));
    CHECK((a == b) == (textbook::comparison(a, b) == 0));

    Integer assigned = a;
    CHECK((assigned += b) == a + b);
    assigned = a;
    CHECK((assigned -= b) == a - b);
    assigned = a;
    CHECK((assigned *= b) == a * b);
    assigned = b;
    CHECK(assigned.add_product(a, b) == a * b + b);
    check_canonical(a + b);
    check_canonical(a - b);
    check_canonical(a * b);

    if (b.is_zero()) return;
    CHECK(to_string(a / b) == textbook::quotient(a, b));
    CHECK(to_string(a % b) == textbook::remainder(a, b));
    check_canonical(a / b);
    check_canonical(a % b);
    CHECK(divide_exactly(a * b, b) == a);
}

}  // namespace

TEST_CASE("integer operations on all pairs of boundary values", "[integer]") {
    const std::vector<Integer> values = boundary_values();
    CHECK(values.size() == 75);
    for (const Integer& a : values) {
        for (const Integer& b : values) check_operations(a, b);
    }
}

TEST_CASE("integer operations on random values", "[integer]") {
    Random random(11);
    for (int i = 0; i < 4000; ++i) {
        const Integer a = integer(random);
        const Integer b = integer(random);
        check_operations(a, b);
    }
}

TEST_CASE("a sum of products with operands of every size", "[integer]") {
    Random random(12);
    for (int i = 0; i < 4000; ++i) {
        const Integer start = integer(random);
        const Integer a = integer(random);
        const Integer b = integer(random);
        CAPTURE(start, a, b);
        Integer sum = start;
        sum.add_product(a, b);
        CHECK(sum == start + a * b);
        check_canonical(sum);
        sum.add_product(-a, b);
        CHECK(sum == start);
        check_canonical(sum);
    }
}

TEST_CASE("sign, parity, negation and size of integers", "[integer]") {
    std::vector<Integer> values = boundary_values();
    Random random(13);
    for (int i = 0; i < 500; ++i) values.push_back(integer(random));
    for (const Integer& value : values) {
        CAPTURE(value);
        CHECK(value.sign() == textbook::comparison(value, 0));
        CHECK(value.is_zero() == (to_string(value) == "0"));
        CHECK(value.is_one() == (to_string(value) == "1"));
        CHECK(value.bit_length() == textbook::bit_length(value));
        CHECK(value.is_odd() == (textbook::remainder(value, 2) != "0"));
        CHECK(to_string(-value) == textbook::difference(0, value));
        CHECK(to_string(abs(value)) == textbook::difference(value.sign() < 0 ? Integer(0) : value,
                                                            value.sign() < 0 ? value : Integer(0)));
        check_canonical(-value);
    }
}

TEST_CASE("shifts go by powers of two, to the right towards minus infinity", "[integer]") {
    std::vector<Integer> values = boundary_values();
    Random random(14);
    for (int i = 0; i < 200; ++i) values.push_back(integer(random));
    for (const Integer& value : values) {
        for (const unsigned bits : {0U, 1U, 2U, 31U, 62U, 63U, 64U, 65U, 127U, 128U, 200U}) {
            CAPTURE(value, bits);
            CHECK(to_string(value << bits) == textbook::left_shifted(value, bits));
            CHECK(to_string(value >> bits) == textbook::right_shifted(value, bits));
            CHECK(((value << bits) >> bits) == value);
            check_canonical((value << bits) >> bits);
        }
    }
    CHECK((Integer(-1) >> 1'000'000) == -1);
    CHECK((Integer(5) >> 1'000'000) == 0);
    CHECK((Integer(0) << 1'000'000'000) == 0);
}

TEST_CASE("division by zero is an error, and leaves the dividend alone", "[integer]") {
    for (Integer value : {Integer(0), Integer(7), Integer(INT64_MIN), Integer(1) << 100}) {
        const Integer before = value;
        CHECK(failure_code([&] { value /= 0; }) == ErrorCode::division_by_zero);
        CHECK(failure_code([&] { value %= 0; }) == ErrorCode::division_by_zero);
        CHECK(failure_code([&] { divide_exactly(value, 0); }) == ErrorCode::division_by_zero);
        CHECK(value == before);
    }
}

TEST_CASE("the least value of 64 bits", "[integer]") {
    const Integer least = INT64_MIN;
    CHECK(to_string(-least) == "9223372036854775808");
    CHECK(to_string(abs(least)) == "9223372036854775808");
    CHECK(to_string(least / -1) == "9223372036854775808");
    CHECK(least % -1 == 0);
    CHECK(to_string(least * -1) == "9223372036854775808");
    CHECK(to_string(least * least) == "85070591730234615865843651857942052864");
    CHECK(to_string(least - 1) == "-9223372036854775809");
    CHECK((least - 1) + 1 == least);
    CHECK(-(-least) == least);
    CHECK((-(-least)).to_int64() == INT64_MIN);
    CHECK(gcd(least, least) == -least);
    CHECK(gcd(least, 0) == -least);
    CHECK(lcm(least, -1) == -least);
    CHECK(least.bit_length() == 64);
    CHECK(divide_exactly(least, -least) == -1);
}
