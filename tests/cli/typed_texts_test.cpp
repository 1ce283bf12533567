#include "run.hpp"

// What people type as options of commands.

namespace {

std::string output(const std::vector<std::string>& arguments) {
    const Run result = run(arguments);
    return result.status == 0 ? result.output : result.errors;
}

}  // namespace

TEST_CASE("polynomials are read as people write them, and a number without separators") {
    for (const char* text : {"x²+2x+1", "\u2212x", "x**2", "3·x", "½x", ".5x", "0.x"}) {
        CAPTURE(text);
        CHECK(run({"evaluate", text, "--at", "1"}).status == 0);
    }
    CHECK(contains(output({"evaluate", "1_000x", "--at", "1"}), "a number without '_' between its digits"));
    CHECK(contains(output({"evaluate", "é + 1", "--at", "1"}), "found \"é\"\n  é + 1\n  ^\n"));
    CHECK(contains(output({"evaluate", "δt + 1", "--at", "1"}), "found \"δ\""));
    CHECK(contains(output({"evaluate", "1 − é", "--at", "1"}), "column 5: "));
}

TEST_CASE("control points are read as people have them") {
    for (const char* text :
         {"0 0\n1 2\n3 0", "[[0,0],[1,2],[3,0]]", "[(0, 0), (1, 2), (3, 0)]", "[[0. 0.]\n [1. 2.]\n [3. 0.]]",
          "0,0;1,2;3,0;", "M0 0Q1 2 3 0", "m0,0q1,2 3,0"}) {
        CAPTURE(text);
        CHECK(contains(output({"evaluate", "--control-points", text, "--at", "1"}), "P(1) = (3, 0)"));
    }
    CHECK(contains(output({"evaluate", "--control-points", "M1 0A1 1 0 0 1 0 1", "--at", "1"}),
                   "weights 1, 1/2, 1/2"));
    CHECK(contains(output({"evaluate", "--control-points", "M0 0H1H2", "--at", "1"}), "import --format svg"));
    CHECK(contains(output({"evaluate", "--control-points", "0,0 1", "--at", "1"}),
                   "points are separated by ';', and their coordinates by ','"));
    CHECK(contains(output({"evaluate", "--control-points", "0 1 2", "--knots", "0*2, 1, 2*2", "--degree", "1",
                           "--at", "1"}),
                   "knots 0, 0, 1, 2, 2"));
}

TEST_CASE("the names of several variables are asked for, and a product sign where names are joined") {
    CHECK(contains(output({"agree", "x^2 + 3x*y - 2"}), "--variables x,y"));
    const std::string joined = output({"agree", "xy + x"});
    CHECK(contains(joined, "write a product with '*'"));
    CHECK(joined.find("--variables") == std::string::npos);
}

TEST_CASE("decimals of options are doubles where this is said") {
    const std::string map = R"({"kind": "bezier", "control_points": [0, 1.5]})";
    CHECK(contains(output({"evaluate", "--map", map, "--at", "1"}), "\"floats\""));
    CHECK(contains(output({"evaluate", "--map", map, "--at", "0.2", "--floats", "decimal"}), "= 3/10\n"));
    CHECK(contains(output({"evaluate", "--control-points", "0,1", "--at", "0.2", "--floats", "double"}),
                   "P(0.2) = 3602879701896397/18014398509481984\n"));
    CHECK(contains(output({"evaluate", "0.2", "--at", "1", "--floats", "double"}), "P(1) = 1/5\n"));
    CHECK(contains(output({"evaluate", "--map", R"({"kind": "bezier", "control_points": ["0.2", 1.5]})",
                           "--at", "0", "--floats", "double"}),
                   "P(0) = 1/5\n"));
    CHECK(contains(output({"explain", "evaluate", "--map", map, "--at", "1", "--floats", "decimal"}), "3/2"));
    CHECK(contains(output({"evaluate", "t", "--at", "1", "--floats", "x"}), "at --floats, /floats"));
}

TEST_CASE("documents of programs are read as they print them") {
    CHECK(contains(output({"import", "--format", "fitpack", "--document",
                           "(array([0., 0., 1., 1.]), array([0.5, 2., 0., 0.]), 1)"}),
                   "= 1/2\n"));
    CHECK(contains(output({"import", "--format", "svg", "--document", "M0 0L1 2"}), "(1, 2)"));
    CHECK(contains(output({"import", "--format", "svg", "--document", "M0 0X"}), "  M0 0X\n      ^\n"));
}

TEST_CASE("messages name kinds, options and places that there are") {
    const std::string tensor =
        R"({"kind": "tensor", "degrees": [1, 1], "control_net": [["1", "2"], ["3", "4"]]})";
    const std::string roots = output({"roots", "--map", tensor});
    CHECK(contains(roots, "a map of kind tensor is not accepted"));
    CHECK(contains(roots, "at --map, /map\n"));
    CHECK(contains(output({"roots", "x + y", "--variables", "x,y"}),
                   "a map of kind polynomial in several variables"));
    CHECK(contains(output({"convert", "t", "--to", "bernstien"}), "did you mean \"bernstein\"?"));
    CHECK(
        contains(output({"control-points", "--control-points", "0,1", "--interval", "0,1", "--over", "1,1"}),
                 "at --over, /interval"));
    CHECK(
        contains(output({"control-points", "--control-points", "0,1", "--interval", "1,1", "--over", "0,1"}),
                 "at --interval, /map/interval"));
    CHECK(contains(output({"basis-functions", "--degree", "3", "--knots", "0,1"}), "at --knots, /knots"));
    CHECK(contains(output({"evaluate", "--control-points", "0;1", "--knots", "0.1,0.1,0.5,0.5", "--degree",
                           "1", "--at", ".7"}),
                   "the parameter .7 lies outside the domain [0.1, 0.5]"));
}
