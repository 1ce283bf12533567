#include "limit_flags.hpp"
#include "operations/operation.hpp"
#include "run.hpp"

namespace {

using Arguments = std::vector<std::string>;

const std::string bezier = R"({"kind": "bezier", "control_points": ["0", "1", "4"]})";
const std::string triangle = R"({"kind": "simplex", "degree": 1, "control_net":
    [[[1, 0, 0], "1"], [[0, 1, 0], "2"], [[0, 0, 1], "4"]]})";
const std::string box = R"({"kind": "tensor", "degrees": [1, 1], "control_net": [["1", "2"], ["3", "5"]]})";
const std::string surface = R"({"kind": "bspline", "degrees": [1, 1],
    "knots": [["0", "0", "1", "2", "2"], ["0", "0", "1", "1"]], "control_net": [["1", "2"], ["3", "5"], ["4", "4"]]})";
const std::string two_maps =
    "[" + bezier + R"(, {"kind": "bezier", "control_points": [4, 7, 9], "interval": [1, 2]}])";
const std::string closed =
    R"({"kind": "bspline", "degrees": [1, 0], "knots": [[0, 0, 1, 2, 2], [0, 1]], "control_net": [[0], [2], [0]]})";
const std::string two_boxes = R"([{"kind": "tensor", "degrees": [1, 0], "control_net": [[0], [1]]},
    {"kind": "tensor", "degrees": [1, 0], "intervals": [[1, 2], [0, 1]], "control_net": [[1], [3]]}])";
const std::string two_planes =
    R"([{"kind": "tensor", "degrees": [1, 1], "control_net": [[[0, 0], [0, 1]], [[1, 0], [1, 1]]]},
        {"kind": "tensor", "degrees": [1, 1], "control_net": [[[1, 0], [1, 1]], [[3, 0], [2, 1]]]}])";
const std::string document =
    R"({"degree": 1, "dimension": 1, "control_points": [0, 2], "knots": [0, 0, 1, 1]})";

/// Command lines in addition to the examples of the operations, so that each option with a value is used.
const std::vector<Arguments> command_lines{
    {"evaluate", "t", "--degree", "2", "--denominator", "1 + t^2", "--at", "1", "--numbers", "double"},
    {"evaluate", "--control-points", "0,0; 1,2; 3,0", "--weights", "1,1,2", "--interval", "0,2", "--at", "1"},
    {"evaluate", "--control-points", "0; 1; 2", "--knots", "0,0,1,2,2", "--degree", "1", "--at", "1"},
    {"evaluate", "x*y", "--variables", "x,y", "--degrees", "1,2", "--at", "1,2"},
    {"evaluate", "--map", bezier, "--at", "1"},
    {"evaluate", "--map", triangle, "--at", "1/2,1/4,1/4"},
    {"evaluate", "--map", box, "--at", "1/2,1/4"},
    {"evaluate", "--map", surface, "--at", "1/2,1/4"},
    {"agree", "t^2", "--at", "1,2"},
    {"blossom", "t^2", "--at", "1,2", "--construction", "casteljau"},
    {"blossom", "--control-points", "0; 1; 2", "--knots", "0,0,1,2,2", "--degree", "1", "--at", "1",
     "--segment", "1"},
    {"blossom", "--map", triangle, "--at", "1/2,1/4,1/4"},
    {"blossom", "--map", box, "--at", "1/2; 1/4"},
    {"derivative", "--map", triangle, "--direction", "1,-1,0", "--at", "1/2,1/4,1/4"},
    {"derivative", "--map", triangle, "--directions", "1,-1,0", "--at", "1/2,1/4,1/4"},
    {"derivative", "t^2", "--order", "2", "--at", "1"},
    {"control-points", "t", "--over", "0,2", "--degree", "2"},
    {"control-points", "t", "--interval", "0,2", "--degree", "2"},
    {"control-points", "x*y", "--variables", "x,y", "--vertices", "0,0; 1,0; 0,1", "--degree", "2"},
    {"control-points", "x*y", "--variables", "x,y", "--degrees", "1,1", "--intervals", "0,1; 0,2"},
    {"convert", "t", "--to", "taylor", "--center", "2"},
    {"convert", "t^2", "--to", "hermite", "--counts", "2,1"},
    {"convert", "t", "--to", "bernstein", "--interval", "0,2"},
    {"elevate", "--map", box, "--by", "1,0"},
    {"subdivide", "--map", triangle, "--at", "1/2,1/4,1/4"},
    {"reduce", "t^3", "--to", "2", "--method", "uniform", "--interval", "0,2"},
    {"inverse-formula", "--degree", "2", "--interval", "0,2"},
    {"inverse-formula", "--degree", "2", "--vertices", "0,0; 2,0; 0,1"},
    {"insert-knots", "--control-points", "0; 1; 2", "--knots", "0,0,1,2,2", "--degree", "1", "--insert",
     "1/2", "--method", "oslo"},
    {"insert-knots", "--map", surface, "--insert", "1/2;"},
    {"remove-knot", "--control-points", "0; 1; 2", "--knots", "0,0,1,2,2", "--degree", "1", "--knot", "1",
     "--times", "1"},
    {"join", two_maps, "--knots", "0,0,0,1,1,2,2,2", "--degree", "2"},
    {"continuity", "--maps", two_maps, "--at", "1"},
    {"basis-functions", "--knots", "0,0,0,1,2,2,2", "--degree", "2", "--convention", "textbook", "--at",
     "1/2"},
    {"basis-functions", "--knots", "0,0,1,1", "--degree", "1", "--weights", "1,2", "--order", "1"},
    {"basis-matrix", "--from", "lagrange:0,1,2", "--to", "newton:0,1,2"},
    {"interpolate", "--values", "1; 2; 4", "--nodes", "0,1,2", "--interval", "0,2"},
    {"interpolate", "--values", "1; 2; 4", "--degree", "1", "--knots", "0,0,1,2,2"},
    {"interpolate", "--values", "1,2; 3,4", "--grid", "0,1; 0,1", "--intervals", "0,1; 0,2"},
    {"interpolate", "--values", "1,2; 3,4", "--degrees", "1,1"},
    {"interpolate", "--lattice", "[[[1, 0], 1], [[0, 1], 2]]", "--vertices", "0; 1"},
    {"insert-knots", "--control-points", "0; 1; 2", "--knots", "0,0,1,2,2", "--degree", "1", "--insert", "1",
     "--multiplicity", "2"},
    {"insert-knots", "--map", closed, "--direction", "0", "--insert", "1/2"},
    {"remove-knot", "--map", closed, "--direction", "0", "--knot", "1", "--times", "1"},
    {"join", two_boxes, "--direction", "0"},
    {"clamp", "--map", closed, "--direction", "0"},
    {"trim", "--map", closed, "--direction", "0", "--over", "0,1"},
    {"reverse", "--map", closed, "--direction", "0"},
    {"reparametrise", "--map", closed, "--direction", "0"},
    {"periodic", "--map", closed, "--direction", "0"},
    {"reduce", "--map", box, "--to", "1,0"},
    {"convert", "x*y", "--variables", "x,y", "--to", "taylor", "--center", "1,2"},
    {"continuity", "--maps", two_planes, "--faces", "1,0; 1,1 | 0,0; 0,1", "--geometric"},
    {"trim", "t^2", "--interval", "1,2"},
    {"trim", "t^2", "--over", "1,2"},
    {"sum", "t", bezier, "--factors", "1,2"},
    {"product", "t; 1", "1; t", "--as", "dot"},
    {"transform", "t^2; t", "--matrix", "1,0; 0,2", "--translation", "1,2"},
    {"polar", "--map", box, "--at", "1/2; "},
    {"polar", "--control-points", "0; 1; 2", "--knots", "0,0,1,2,2", "--degree", "1", "--at", "1",
     "--segment", "1"},
    {"restrict", "x*y", "--variables", "x,y", "--vertices", "0,0; 1,1", "--over", "0,2"},
    {"restrict", "t^2", "--vertices", "0; 1", "--interval", "0,2"},
    {"restrict", "--map", box, "--at", "1/2,-"},
    {"jacobian", "x*y; x", "--variables", "x,y", "--as", "matrix"},
    {"bounds", "t^2 + 1", "--of", "values", "--depth", "3"},
    {"resultant", R"({"kind": "polynomial", "variables": ["x", "y"], "text": "x + y"})",
     R"({"kind": "polynomial", "variables": ["x", "y"], "text": "x - y"})", "--variable", "y"},
    {"reparametrise", "t^2", "--interval", "1,2", "--from", "0,1"},
    {"reparametrise", "t^2", "--to", "1,2"},
    {"roots", "t^2 - 2", "--interval", "0,2", "--width", "1/10"},
    {"audit", "--control-points", "0; 1/3; 1/10", "--computed", R"({"values": [0]})", "--at", "0"},
    {"audit", "--map", R"({"kind": "bezier", "control_points": [["0"], ["2"]]})", "--format", "tinyspline",
     "--document", document},
    {"audit", "--maps", R"([{"kind": "bezier", "control_points": [["0"], ["2"]]}])", "--format", "tinyspline",
     "--document", document},
    {"evaluate", "--map-index", "1", "--map", two_maps, "--at", "1"},
    {"export", "--format", "geomdl", "--maps",
     R"([{"kind": "bezier", "control_points": [["0", "0"], ["1", "1"]]}])"},
    {"exercise", "subdivision", "--seed", "2", "--count", "1", "--level", "2", "--format", "text"},
    {"convert", "t", "--to", "bernstein", "--over", "0,2"},
    {"convert", "x*y", "--variables", "x,y", "--degree", "2", "--to", "simplex", "--vertices",
     "0,0; 2,0; 0,1"},
    {"convert", "x*y", "--variables", "x,y", "--degrees", "1,1", "--to", "tensor", "--intervals", "0,1; 0,3"},
    {"convert", "--control-points", "0; 1; 2", "--knots", "0,0,1,2,2", "--degree", "1", "--to", "monomial",
     "--segment", "1"},
    {"reduce", "t^3", "--to", "2", "--over", "0,2"},
    {"roots", "t^2 - 2", "--over", "0,2"},
    {"roots", "t^2 - 1", "--with", "t - 1"},
    {"extrema", "t; t^2", "--direction", "1,0", "--over", "0,2", "--width", "1/10"},
    {"extrema", "t^2", "--interval", "0,2"},
    {"inflections", "t; t^3", "--over", "-1,2", "--width", "1/10"},
    {"inflections", "t; t^3", "--interval", "-1,2"},
    {"nearest", "t; t^2", "--to", "0,1", "--over", "0,2", "--width", "1/10"},
    {"nearest", "t; t^2", "--to", "0,1", "--interval", "0,2"},
    {"intersections", "t; t^2", "--line", "1,-1,0", "--over", "0,2", "--width", "1/10"},
    {"intersections", "t; t^2", "--line", "1,-1,0", "--interval", "0,2"},
    {"intersections", "t; t^2", "--with", "t; 1", "--with-over", "0,2"},
    {"self-intersections", "t^2 - 1; t^3 - t", "--over", "-2,2", "--width", "1/10"},
    {"self-intersections", "t^2 - 1; t^3 - t", "--interval", "-2,2"},
    {"exercise", "subdivision", "--notation", "brackets", "--columns", "60"},
    {"explain", "evaluate", "t", "--at", "1", "--format", "text"},
};

/// Whether a message names an option, or shows its text with a caret below the wrong position.
bool names(const std::string& errors, const std::string& option, const std::string& text) {
    return errors.find(option) != std::string::npos ||
           (errors.find("\n  " + text + "\n") != std::string::npos &&
            errors.find("^\n") != std::string::npos);
}

/// The spellings of an option, "-e" and "--statement".
std::vector<std::string> spellings(const std::string& name) {
    const std::size_t comma = name.find(',');
    if (comma == std::string::npos) return {name};
    return {name.substr(0, comma), name.substr(comma + 1)};
}

}  // namespace

TEST_CASE("a wrong value of an option is refused with the name of the option, or a caret below it") {
    std::vector<Arguments> lines = command_lines;
    for (const Operation& operation : operations()) lines.push_back(operation.example);
    std::set<std::pair<std::string, std::string>> tried;
    for (const Arguments& line : lines) {
        const Run right = run(line);
        CAPTURE(line, right.errors);
        CHECK(right.status == 0);
        for (std::size_t i = 1; i < line.size(); ++i) {
            if (!line[i - 1].starts_with("-") || line[i].starts_with("--")) continue;
            if (line[i - 1] == "-e") continue;  // what is wrong in a statement is shown as in a file
            Arguments changed = line;
            changed[i] = "?!";
            const Run refused = run(changed);
            CAPTURE(line[i - 1], refused.errors);
            CHECK(refused.status != 0);
            CHECK(names(refused.errors, line[i - 1], "?!"));
            tried.emplace(line[0] == "explain" ? line[1] : line[0], line[i - 1]);
        }
    }
    // Each option of each command once; those of the map, which all commands share, only for `evaluate`.
    for (const Operation& operation : operations()) {
        for (const Option& option : operation.options) {
            if (option.value.empty() || !option.name.starts_with('-')) continue;
            CAPTURE(operation.name, option.name);
            const bool of_map = option.field.begins_with(Part::map);
            const bool found = std::ranges::any_of(spellings(option.name), [&](const std::string& name) {
                return tried.contains({std::string(operation.name), name}) ||
                       (of_map && tried.contains({"evaluate", name}));
            });
            CHECK(found);
        }
    }
}

TEST_CASE("a wrong positional argument is shown with its name, or with a caret") {
    for (const Arguments& line :
         {Arguments{"evaluate", "?!", "--at", "1"}, {"join", "?!"}, {"certify", "?!"}}) {
        CAPTURE(line, run(line).errors);
        CHECK(names(run(line).errors, "at ", "?!"));
    }
    CHECK(contains(run({"exercise", "?!"}).errors, "at TOPIC, /topic: \"?!\"\n"));
    CHECK(contains(run({"join", R"({"kind": "?!"})"}).errors, "at MAP, /maps/0/kind: \"?!\"\n"));
    CHECK(contains(run({"certify", R"({"op": "?!"})"}).errors, "at REQUEST, /requests/0/op: \"?!\"\n"));
}

TEST_CASE("a wrong limit is refused with its name") {
    for (const LimitEntry& entry : limit_table()) {
        CHECK(contains(run({"evaluate", "t", "--at", "1", flag_of(entry), "?!"}).errors, flag_of(entry)));
    }
    for (const std::string option : {"--jobs", "--timeout", "--degree"})
        CHECK(contains(run({"prove", "-e", "1 == 1", option, "?!"}).errors, option));
    CHECK(contains(run({"batch", "--jobs", "?!"}).errors, "--jobs"));
}
