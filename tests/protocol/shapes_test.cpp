#include "answered.hpp"

#include "text/shapes.hpp"

// Numbers and points as people write them and programs print them.

namespace {

std::string numbers(std::string_view text) { return to_text(number_list(text)); }
std::string tuples(std::string_view text) { return to_text(tuple_list(text)); }

}  // namespace

TEST_CASE("numbers are separated by commas, blanks or lines") {
    for (const char* text :
         {"0, 3, 0", "0,3,0", " 0 3  0 ", "0\n3\n0\n", "0; 3; 0", "0;3;0;", "[0, 3, 0]", "(0, 3, 0)",
          "[0 3 0]", "array([0, 3, 0])", "np.array([0, 3, 0], dtype=int)", "['0', \"3\", '0']",
          "[np.int64(0), np.int64(3), np.int64(0)]", "t\n0\n3\n0", "0\t3\t0"}) {
        CAPTURE(text);
        CHECK(numbers(text) == R"(["0", "3", "0"])");
    }
    CHECK(numbers("") == "[]");
    CHECK(numbers(" \n") == "[]");
    CHECK(numbers("7") == R"(["7"])");
    CHECK(numbers("[]") == "[]");
    CHECK(numbers("-1/2, .5 ,1e-3") == R"(["-1/2", ".5", "1e-3"])");
    CHECK(numbers("[0.   0.25 1.  ]") == R"(["0.", "0.25", "1."])");
    CHECK(numbers("0,,1") == R"(["0", "", "1"])");
    CHECK(numbers("0;;1") == R"(["0", "", "1"])");
    CHECK(numbers("[Fraction(1, 2), Fraction(3, 1), Decimal('0.5')]") == R"(["1/2", "3/1", "0.5"])");
}

TEST_CASE("points stand in lines, between semicolons, or in brackets of their own") {
    for (const char* text :
         {"0,0; 1,2; 3,0", "0,0;1,2;3,0;", "0 0\n1 2\n3 0", "0,0\n1,2\n3,0\n", "0 0; 1 2; 3 0",
          "0,0;\n1,2;\n3,0;\n", "0,0 1,2 3,0", "0, 0  1, 2  3, 0", "x,y\n0,0\n1,2\n3,0",
          "x\ty\n0\t0\n1\t2\n3\t0", "[[0,0],[1,2],[3,0]]", "[(0, 0), (1, 2), (3, 0)]",
          "((0, 0), (1, 2), (3, 0))", "(0,0), (1,2), (3,0)", "(0,0) (1,2) (3,0)", "(0,0); (1,2); (3,0);",
          "[[0 0]\n [1 2]\n [3 0]]", "array([[0, 0],\n       [1, 2],\n       [3, 0]])",
          "[array([0, 0]), array([1, 2]), array([3, 0])]"}) {
        CAPTURE(text);
        CHECK(numbers(text) == R"([["0", "0"], ["1", "2"], ["3", "0"]])");
        CHECK(tuples(text) == R"([["0", "0"], ["1", "2"], ["3", "0"]])");
    }
    CHECK(numbers("[[0. 0.]\n [1. 2.]]") == R"([["0.", "0."], ["1.", "2."]])");
    CHECK(numbers("[[[0, 1], [2, 3]], [[4, 5], [6, 7]]]") ==
          R"([[["0", "1"], ["2", "3"]], [["4", "5"], ["6", "7"]]])");
    CHECK(tuples("0,0") == R"([["0", "0"]])");
    CHECK(tuples("(0, 0)") == R"([["0", "0"]])");
    CHECK(tuples("[[0, 0]]") == R"([["0", "0"]])");
    CHECK(tuples("") == "[]");
    CHECK(numbers("0,1;2") == R"([["0", "1"], "2"])");  // refused where points are read
}

TEST_CASE("a number with a multiplicity is repeated") {
    CHECK(numbers("0*3, 1, 2*2") == R"(["0", "0", "0", "1", "2", "2"])");
    CHECK(numbers("0×3 1/2 ×1") == R"(["0", "0", "0", "1/2", "×1"])");
    CHECK(numbers("[0]*3 + [1] + [2] * 2") == R"(["0", "0", "0", "1", "2", "2"])");
    CHECK(numbers("2**3, 1.5*10^3") == R"(["2**3", "1.5*10^3"])");
    CHECK(numbers("0*20000") == R"(["0*20000"])");
    CHECK(numbers("0*0, 1") == R"(["1"])");
}

TEST_CASE("what is no list is refused with its place in the text") {
    struct Example {
        const char* text;
        std::size_t offset;
        const char* message;
    };
    for (const Example& example :
         {Example{"0,0 1", 4, "points are separated by ';'"},
          Example{"0,0 1,2,3", 4, "points are separated by ';'"}, Example{"[0, 1, ..., 3]", 7, "shortened"},
          Example{"[[0,1]", 0, "not closed by ']'"}, Example{"(0,1]", 4, "a number or a bracket"},
          Example{"(0,1", 0, "not closed by ')'"}, Example{"[0)", 2, "a number or a bracket"},
          Example{"[0]*x", 4, "a count"}, Example{"[0]*3 + 1", 8, "a list is expected"},
          Example{"[{1}]", 1, "a number"}, Example{"['1]", 1, "quotation mark"},
          Example{"[f()]", 1, "no value"}}) {
        CAPTURE(example.text);
        const auto error = failure([&] { number_list(example.text); });
        REQUIRE(error);
        CAPTURE(error->message());
        CHECK(error->code() == ErrorCode::syntax);
        CHECK(error->offset() == example.offset);
        CHECK(error->message().find(example.message) != std::string::npos);
    }
    CHECK(failure_code([] { number_list(std::string(1000, '[')); }) == ErrorCode::limit_exceeded);
}

TEST_CASE("a map of a request may have its points and knots as texts") {
    const auto value = [](const std::string& points) {
        return result_text(
            R"("op": "evaluate", "at": ["1/2"], "map": {"kind": "bezier", "control_points": ")" + points +
            "\"}");
    };
    CHECK(value("0,0; 1,2; 2,0;") == R"({"values": [["1", "1"]]})");
    CHECK(value("[[0. 0.]\\n [1. 2.]\\n [2. 0.]]") == R"({"values": [["1", "1"]]})");
    CHECK(value("0 2 0") == R"({"values": ["1"]})");
    CHECK(result_text(
              R"("op": "evaluate", "at": ["1/2"], "map": {"kind": "bspline", "degree": 2, "knots": "0*3, 1*3",
                      "control_points": "0, 2, 0"})") == R"({"values": ["1"]})");
    const auto refused = [](const std::string& points) {
        return refusal_text(
            R"("op": "evaluate", "at": ["1/2"], "map": {"kind": "bezier", "control_points": ")" + points +
            "\"}");
    };
    CHECK(refused("0,0 1") == "syntax /map/control_points");
    CHECK(refused("0,x") == "not_a_number /map/control_points");
    CHECK(refused("0,1;2") == "mismatched_dimensions /map/control_points");
    CHECK(refused("") == "wrong_arity /map/control_points");
}
