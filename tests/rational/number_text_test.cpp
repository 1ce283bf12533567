#include "rational_test.hpp"
#include "support/memory.hpp"

// Conversion from text to numbers.

TEST_CASE("numbers are read in every form", "[number_text]") {
    struct Example {
        const char* text;
        Rational value;
    };
    const Example examples[] = {
        {"0", 0},
        {"-0", 0},
        {"7", 7},
        {"-7", -7},
        {"010", 10},
        {"-007", -7},
        {"08", 8},
        {"2/4", Rational(1, 2)},
        {"-6/4", Rational(-3, 2)},
        {"06/004", Rational(3, 2)},
        {"0/5", 0},
        {"-0.125", Rational(-1, 8)},
        {"0.50", Rational(1, 2)},
        {"12.0", 12},
        {"1.5e-3", Rational(3, 2000)},
        {"1.5E3", 1500},
        {"15e2", 1500},
        {"15e+2", 1500},
        {"15e-2", Rational(3, 20)},
        {"0.0e7", 0},
        {"1e0", 1},
        {"1e-0", 1},
        {"9223372036854775807", INT64_MAX},
        {"-9223372036854775808", INT64_MIN},
        {"9223372036854775808", Rational(-Integer(INT64_MIN))},
        {"999999999999999999", 999999999999999999},
        {"1000000000000000000", 1000000000000000000},
        {"18446744073709551616", Rational(Integer(1) << 64)},
        {"-340282366920938463463374607431768211456", Rational(-(Integer(1) << 128))},
        {"000000000000000000000000000000000000000000000001", 1},
        {".5", Rational(1, 2)},
        {"-.5", Rational(-1, 2)},
        {"0.", 0},
        {"12.", 12},
        {"1.e2", 100},
        {".5e1", 5},
        {"\u22121/2", Rational(-1, 2)},
        {"1\u20442", Rational(1, 2)},
        {"½", Rational(1, 2)},
        {"-¾", Rational(-3, 4)},
        {"2⅓", Rational(7, 3)},
        {"⅒", Rational(1, 10)},
        {"⅞", Rational(7, 8)},
        {"0x1.8p-3", Rational(3, 16)},
        {"0X1.8P-3", Rational(3, 16)},
        {"-0x1p+0", -1},
        {"0x0p+0", 0},
        {"0x.8p1", 1},
        {"0xA.p0", 10},
        {"0x1.999999999999ap-4", Rational(Integer(3602879701896397), Integer(1) << 55)},
        {"0x0.0000000000001p-1022", Rational(Integer(1), Integer(1) << 1074)},
        {"0x1.fffffffffffffp+1023", Rational((Integer(1) << 1024) - (Integer(1) << 971))},
        {"2^10", 1024},
        {"2**-3", Rational(1, 8)},
        {"10⁻³", Rational(1, 1000)},
        {"2¹⁰", 1024},
        {"1.5×10^-3", Rational(3, 2000)},
        {"1.5·10⁻³", Rational(3, 2000)},
        {"-½*2**3", -4},
        {"0^0", 1},
    };
    for (const Example& example : examples) {
        CAPTURE(example.text);
        const Rational value = parse_rational(example.text);
        CHECK(value == example.value);
        CHECK(std::hash<Rational>{}(value) == std::hash<Rational>{}(example.value));
    }
}

TEST_CASE("what is not an exact number is refused", "[number_text]") {
    for (const std::string text :
         {"",         "-",        "+1",   " 1",    "1 ",    "1\n",   "--1",   "1-",    "0x10",  ".",
          "-.",       "0x.p1",    "1..2", "1.2.3", "1e",    "1e+",   "1e-",   "e5",    "1e5/2", "1/2e5",
          "1.5/2",    "1/2.0",    "6/-4", "6/+4",  "1/",    "/2",    "/",     "1/2/3", "1/ 2",  "1 /2",
          "inf",      "nan",      "NaN",  "1,5",   "1'000", "1_000", "1e5.5", "1e1e1", "0b1",   "one",
          "\xC2\xB2", "\xD9\xA1", "-/2",  "-1/-2", ".e5",   "1 000", "1d5",   "1f",    "#5",    "0x1.8",
          "0x1p",     "½½",       "1.5½", "2^",    "2^^3",  "2^+3",  "^3",    "2^1.5", "1·2",   "1.5^2",
          "1·t^2",    "2^3^4",    "½/2",  "1⁄",    "⁄2",    "1·10^", "10⁻",   "×10^2", "1_000x"}) {
        CAPTURE(text);
        CHECK(failure_code([&] { parse_rational(text); }) == ErrorCode::not_a_number);
    }
    CHECK(failure_code([] { parse_rational(std::string_view("1\0", 2)); }) == ErrorCode::not_a_number);
    CHECK(failure_code([] { parse_rational(std::string_view("\0", 1)); }) == ErrorCode::not_a_number);
    CHECK(failure_code([] { parse_rational(std::string_view("1\0/2", 4)); }) == ErrorCode::not_a_number);
}

TEST_CASE("a zero denominator in text is an error of its own", "[number_text]") {
    for (const std::string text : {"1/0", "0/0", "-1/0", "5/000", "1\u20440", "0^-1", "1·0⁻²"}) {
        CAPTURE(text);
        CHECK(failure_code([&] { parse_rational(text); }) == ErrorCode::zero_denominator);
    }
}

TEST_CASE("only integers will do for an integer", "[number_text]") {
    CHECK(parse_integer("-010") == -10);
    CHECK(parse_integer("-0") == 0);
    CHECK(parse_integer("-9223372036854775808") == INT64_MIN);
    CHECK(parse_integer("9223372036854775808") == -Integer(INT64_MIN));
    for (const std::string text : {"", "-", "+1", "1.0", "1e2", "4/2", " 1", "1 ", "0x1", "--1", "1-"}) {
        CAPTURE(text);
        CHECK(failure_code([&] { parse_integer(text); }) == ErrorCode::not_a_number);
    }
}

TEST_CASE("numbers are written and read back", "[number_text]") {
    Random random(61);
    for (int i = 0; i < 3000; ++i) {
        const Integer whole = integer(random);
        CHECK(parse_integer(to_string(whole)) == whole);
        const Rational value = rational(random);
        const Rational back = parse_rational(to_string(value));
        CHECK(back == value);
        CHECK(to_string(back) == to_string(value));
    }
}

TEST_CASE("decimal text against the quotient it abbreviates", "[number_text]") {
    Random random(62);
    for (int i = 0; i < 2000; ++i) {
        std::string digits;
        for (std::uint64_t k = 1 + random.below(25); k > 0; --k)
            digits += static_cast<char>('0' + random.below(10));
        std::string fraction;
        for (std::uint64_t k = random.below(25); k > 0; --k)
            fraction += static_cast<char>('0' + random.below(10));
        const auto exponent = random.between(-20, 20);
        const std::string sign(random.below(2), '-');
        std::string text = sign + digits;
        if (!fraction.empty()) text.append(".").append(fraction);
        if (exponent != 0 || random.one_in(2)) text.append("e").append(std::to_string(exponent));
        CAPTURE(text);

        const std::string numerator = sign + digits + fraction +
                                      std::string(exponent > 0 ? static_cast<std::size_t>(exponent) : 0, '0');
        const std::size_t places = fraction.size() + (exponent < 0 ? static_cast<std::size_t>(-exponent) : 0);
        std::string denominator(1 + places, '0');
        denominator.front() = '1';
        CHECK(to_string(parse_rational(text)) ==
              textbook::lowest_terms(parse_integer(numerator), parse_integer(denominator)));
    }
}

TEST_CASE("the length of an unsigned number at the front of a text", "[number_text]") {
    CHECK(unsigned_number_length("12") == 2);
    CHECK(unsigned_number_length("0.5") == 3);
    CHECK(unsigned_number_length("1.5e-3") == 6);
    CHECK(unsigned_number_length("1.5e-3t") == 6);
    CHECK(unsigned_number_length("2t") == 1);
    CHECK(unsigned_number_length("2e") == 1);
    CHECK(unsigned_number_length("2e1") == 3);
    CHECK(unsigned_number_length("2e+x") == 1);
    CHECK(unsigned_number_length("2.") == 2);
    CHECK(unsigned_number_length("2.x") == 2);
    CHECK(unsigned_number_length("2..5") == 1);
    CHECK(unsigned_number_length("2.e5") == 4);
    CHECK(unsigned_number_length("½x") == 2);
    CHECK(unsigned_number_length("2½x") == 3);
    CHECK(unsigned_number_length("0x1.8p-3x") == 8);
    CHECK(unsigned_number_length("0x1.8") == 1);
    CHECK(unsigned_number_length(".") == 0);
    CHECK(unsigned_number_length("..5") == 0);
    CHECK(unsigned_number_length("") == 0);
    CHECK(unsigned_number_length("-1") == 0);
    CHECK(unsigned_number_length(".5") == 2);
    CHECK(unsigned_number_length("x") == 0);
}

TEST_CASE("text is quoted short and printable", "[number_text]") {
    CHECK(quoted("abc") == "\"abc\"");
    CHECK(quoted("a\nb\x7f") == "\"a\\x0ab\\x7f\"");
    CHECK(quoted(std::string(40, 'x')) == "\"" + std::string(40, 'x') + "\"");
    CHECK(quoted(std::string(39, 'x') + "\u03b4") == "\"" + std::string(39, 'x') + "...\"");
    CHECK(first_character("\u03b4 + 1") == "\u03b4");
    CHECK(first_character("t") == "t");
    CHECK(first_character("").empty());
    CHECK(quoted(std::string(41, 'x')) == "\"" + std::string(40, 'x') + "...\"");
}

TEST_CASE("the count of digits is limited exactly", "[number_text]") {
    Limits limits;
    limits.digits = 30;
    const std::string longest(30, '7');
    CHECK(to_string(parse_rational(longest, limits)) == longest);
    CHECK(to_string(parse_integer("-" + longest, limits)) == "-" + longest);
    CHECK(to_string(parse_integer("000000" + longest, limits)) == longest);
    for (const std::string& text :
         {longest + "7", "-" + longest + "7", "1/" + longest + "7", longest + "7/2"}) {
        CAPTURE(text);
        CHECK(failure_code([&] { parse_rational(text, limits); }) == ErrorCode::limit_exceeded);
    }
    CHECK(failure_code([&] { parse_integer(longest + "7", limits); }) == ErrorCode::limit_exceeded);
    CHECK(parse_rational("1e29", limits) == Rational(pow(Integer(10), 29)));
    CHECK(failure_code([&] { parse_rational("1e30", limits); }) == ErrorCode::limit_exceeded);
    CHECK(failure_code([&] { parse_rational("1e-30", limits); }) == ErrorCode::limit_exceeded);
    CHECK(failure_code([&] { parse_rational("0." + longest, limits); }) == ErrorCode::limit_exceeded);
}

TEST_CASE("enormous numbers are refused before their memory is taken", "[number_text]") {
    const std::string fifty_megabytes(50'000'000, '9');
    const std::string fraction = "1/" + fifty_megabytes;
    const std::string almost = fifty_megabytes + "x";
    const std::size_t before = peak_memory();
    for (const std::string_view text :
         {std::string_view("1e999999999999"), std::string_view("1e-999999999"),
          std::string_view("1e999999999"), std::string_view("0.5e1000000"),
          std::string_view("1e99999999999999999999999999999999999999"),
          std::string_view("1e18446744073709551615"), std::string_view("1e18446744073709551616"),
          std::string_view("0e999999999999"), std::string_view(fifty_megabytes),
          std::string_view(fraction)}) {
        CAPTURE(text.substr(0, 30));
        CHECK(failure_code([&] { parse_rational(text); }) == ErrorCode::limit_exceeded);
    }
    const auto refused = failure([&] { parse_integer(fifty_megabytes); });
    REQUIRE(refused);
    CHECK(refused->code() == ErrorCode::limit_exceeded);
    CHECK(refused->message().size() < 300);
    const auto malformed = failure([&] { parse_rational(almost); });
    REQUIRE(malformed);
    CHECK(malformed->code() == ErrorCode::not_a_number);
    CHECK(malformed->message().size() < 300);
    CHECK(peak_memory() < before + 16);
}
