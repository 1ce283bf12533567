#include "answered.hpp"
#include "maps/map.hpp"
#include "operations/operation.hpp"
#include "rounding.hpp"

// What `audit` compares: every number of every kind of map; and it requires the complete map.

namespace {

/// A map of every kind; rational ones have weights or a denominator.
const std::vector<std::string> maps{
    R"({"kind": "polynomial", "coefficients": [["1", "2/3"], ["-5", "1/10"]], "denominator": ["1", "1/7"]})",
    R"({"kind": "polynomial", "text": "1/3 + t"})",
    R"({"kind": "bezier", "control_points": ["1/3", "2"], "weights": ["1", "2/7"], "interval": ["-1/3", "2"]})",
    R"({"kind": "bezier", "control_points": [["1/3", "2", "1"], ["0", "1", "0"]], "homogeneous": true})",
    R"({"kind": "taylor", "center": "1/3", "coefficients": ["1", "2/3"], "denominator": ["1", "1/7"]})",
    R"({"kind": "bspline", "degree": 1, "knots": ["0", "1/3", "2/3", "1"], "control_points": [["1/3"], ["2"]],
        "weights": ["3", "1/9"]})",
    R"({"kind": "progressive", "knots": ["1/3", "2/3"], "control_points": ["1/7", "2"], "weights": ["3", "1/9"]})",
    R"({"kind": "hermite", "left": [["1/3", "1"]], "right": [["1/9", "2"], ["0", "1"]], "interval": ["0", "1/3"],
        "denominator": {"left": ["1"], "right": ["2/3", "1"]}})",
    R"({"kind": "samples", "degree": 1, "values": [["0", "1/3"], ["1", "2/3"]]})",
    R"({"kind": "polynomial", "variables": ["x", "y"], "terms": [[[0, 0], "1/3"], [[1, 1], "2"]],
        "denominator": [[[0, 0], "1"], [[1, 0], "1/9"]]})",
    R"({"kind": "tensor", "degrees": [1, 1], "control_net": [["0", "1/3"], ["2", "3"]],
        "weights": [["1", "2/3"], ["1", "5"]], "intervals": [["0", "1/3"], ["1", "2"]]})",
    R"({"kind": "simplex", "degree": 1, "control_net": [[[1, 0, 0], "1/3"], [[0, 1, 0], "2"], [[0, 0, 1], "4"]],
        "weights": [[[1, 0, 0], "1/3"], [[0, 1, 0], "2"], [[0, 0, 1], "4"]],
        "vertices": [["0", "1/3"], ["1", "0"], ["1", "1"]]})",
    R"({"kind": "bspline", "degrees": [1, 1], "knots": [["0", "0", "1/3", "1/3"], ["0", "0", "1", "1"]],
        "control_net": [[["1/3"], ["2"]], [["1"], ["0"]]], "weights": [["1", "2/3"], ["1", "5"]]})",
};

std::size_t numbers_in(const Json& value) {
    if (value.text()) return 1;
    std::size_t count = 0;
    if (const Json::Array* elements = value.array()) {
        for (const Json& element : *elements) count += numbers_in(element);
    }
    if (const Json::Object* members = value.object()) {
        for (const auto& [name, member] : *members) count += numbers_in(member);
    }
    return count;
}

/// The map as `convert` or any other answer writes it, and the nearest doubles of its numbers by the names of
/// its members.
struct Written {
    Json exact;
    Json doubles;
};

void keep_rounded(const Json::Object& members, Json& exact, Json& doubles) {
    for (const auto& [name, member] : members) {
        if (name.ends_with("_double")) {
            doubles[name.substr(0, name.size() - std::string_view("_double").size())] = member;
        } else if (const Json::Object* inner = member.object()) {
            keep_rounded(*inner, exact[name], doubles[name]);
        } else if (numbers_in(member) > 0 && name != "kind" && name != "variables") {
            exact[name] = member;
        }
    }
}

Written written(const std::string& map) {
    const Limits limits;
    const Json of_map = to_json(read_map(parse_json(map, limits), limits));
    Json result = Json::Object{{"map", of_map}};
    add_rounded_numbers(result, Rounding::binary64);
    Written both;
    keep_rounded(*parse_json(to_text(*result.find("map")), limits).object(), both.exact, both.doubles);
    return both;
}

std::string audit(const std::string& map, const Json& computed) {
    return R"("op": "audit", "map": )" + map + R"(, "computed": )" + to_text(computed);
}

std::string answered_at(const std::string& pointer, const std::string& request) {
    return served_at("/result" + pointer, "{" + request + "}");
}

/// The places of all numbers in a value.
std::vector<Place> numbers_below(const Json& value) {
    if (value.number()) return {Place{}};
    std::vector<Place> places;
    const auto append = [&](const Place& step, const Json& inner) {
        for (const Place& place : numbers_below(inner)) places.push_back(step.around(place));
    };
    if (const Json::Array* elements = value.array()) {
        const bool indexed = elements->size() == 2 && elements->front().array() &&
                             elements->front().array()->size() > 1 && !elements->back().array();
        for (std::size_t i = indexed ? 1 : 0; i < elements->size(); ++i) append(Place{i}, (*elements)[i]);
    }
    if (const Json::Object* members = value.object()) {
        for (const auto& [name, member] : *members) append(Place{name}, member);
    }
    return places;
}

Json& at(Json& value, const Place& place) {
    Json* found = &value;
    for (const Place::Step& step : place.steps()) {
        const auto* index = std::get_if<std::size_t>(&step);
        found = index ? &(*found->array())[*index] : &(*found)[std::get<std::string>(step)];
    }
    return *found;
}

}  // namespace

TEST_CASE("an audit takes every number of every kind of map") {
    for (const std::string& map : maps) {
        CAPTURE(map);
        const Written both = written(map);
        const std::string request = audit(map, both.doubles);
        CAPTURE(result_text(request));
        CHECK(answered_at("/not_nearest", request) == "0");
        CHECK(answered_at("/numbers", request) == std::to_string(numbers_in(both.exact)));
        const Json errors = parse_json(answered_at("/errors", request), Limits{});
        CHECK(numbers_in(errors) == numbers_in(both.exact));
    }
}

TEST_CASE("an audit finds a wrong number at every place of a map") {
    for (const std::string& map : maps) {
        const Written both = written(map);
        for (const auto& [name, member] : *both.doubles.object()) {
            for (const Place& place : numbers_below(member)) {
                Json doubles = both.doubles;
                at(doubles, Place{name}.around(place)) = Json::Number{"1234.5"};
                CAPTURE(map, pointer_of(Place{name}.around(place)));
                CHECK(answered_at("/not_nearest", audit(map, doubles)) == "1");
            }
        }
    }
}

TEST_CASE(
    "points of a rational map are not compared without their weights, nor numerators without denominator") {
    for (const std::string& map : maps) {
        const Written both = written(map);
        for (const std::string rest : {"weights", "denominator"}) {
            if (!both.doubles.find(rest)) continue;
            Json::Object kept = *both.doubles.object();
            std::erase_if(kept, [&](const auto& member) { return member.first == rest; });
            CAPTURE(map);
            CHECK(refusal_text(audit(map, kept)) == "missing_field /computed/" + rest);
            const Json alone = Json::Object{{rest, *both.doubles.find(rest)}};
            CHECK(answered_at("/not_nearest", audit(map, alone)) == "0");
        }
    }
}

TEST_CASE("any single member of a map may be computed") {
    for (const std::string& map : maps) {
        const Written both = written(map);
        if (both.doubles.find("weights") || both.doubles.find("denominator")) continue;
        for (const auto& [name, member] : *both.doubles.object()) {
            CAPTURE(map, name);
            CHECK(answered_at("/not_nearest", audit(map, Json::Object{{name, member}})) == "0");
        }
    }
    const std::string hermite = R"({"kind": "hermite", "left": ["1/3"], "right": ["1"]})";
    CHECK(answered_at("/errors", audit(hermite, parse_json(R"({"right": [1.5]})", Limits{}))) ==
          R"({"right": ["1/2"]})");
}

TEST_CASE("an end of a denominator that is left out is named") {
    const std::string map = R"({"kind": "hermite", "left": ["1/3"], "right": ["1"],
        "denominator": {"left": ["1"], "right": ["2"]}})";
    const auto refusal = [&](const char* computed) {
        return refusal_text(audit(map, parse_json(computed, Limits{})));
    };
    CHECK(refusal(R"({"denominator": {"left": [1]}})") == "missing_field /computed/denominator/right");
    CHECK(refusal(R"({"denominator": {"left": [1], "right": [2], "middle": [1]}})") ==
          "unknown_field /computed/denominator/middle");
    CHECK(refusal(R"({"denominator": [1, 2]})") == "wrong_kind /computed/denominator");
    CHECK(refusal(R"({"denominator": {"left": [1], "right": [2, 3]}})") ==
          "mismatched_dimensions /computed/denominator/right");
}

TEST_CASE("the points of a net over a simplex are compared by their indices, in any order") {
    const std::string map = R"({"kind": "simplex", "degree": 1,
        "control_net": [[[1, 0], "1/3"], [[0, 1], "2"]]})";
    const auto of = [&](const char* net) {
        return audit(map, parse_json(std::string(R"({"control_net": )") + net + "}", Limits{}));
    };
    CHECK(answered_at("/errors", of("[[[0, 1], 2.5], [[1, 0], 0.5]]")) ==
          R"({"control_net": [[[1, 0], "1/6"], [[0, 1], "1/2"]]})");
    CHECK(refusal_text(of("[[[0, 1], 2.5]]")) == "incomplete_net /computed/control_net");
    CHECK(refusal_text(of("[[[0, 1], 2.5], [[0, 1], 2.5]]")) == "incomplete_net /computed/control_net/1/0");
    CHECK(refusal_text(of("[[[1, 0], 1], [[0, 1], 2], [[2, 0], 2]]")) ==
          "incomplete_net /computed/control_net/2/0");
    CHECK(refusal_text(of("[[[1, 0], 1], [[0, 1]]]")) == "incomplete_net /computed/control_net/1");
    CHECK(refusal_text(of("[[[1, 0], 1], [[0, 1], [2]]]")) ==
          "mismatched_dimensions /computed/control_net/1/1");
    CHECK(refusal_text(of("[[[1, 0], 1], [[0, 0.5], 2]]")) == "inexact_number /computed/control_net/1/0/1");
}

TEST_CASE("a term that only one of two polynomials has counts as 0 in the other") {
    const std::string map = R"({"kind": "polynomial", "variables": ["x", "y"], "text": ["x + 1/3 y", "2x"]})";
    const auto of = [&](const char* terms) {
        return audit(map, parse_json(std::string(R"({"terms": )") + terms + "}", Limits{}));
    };
    const std::string with_more = of("[[[1, 0], [1, 2]], [[2, 0], [0.5, 0]]]");
    CHECK(answered_at("/errors", with_more) ==
          R"({"terms": [[[0, 1], ["-1/3", "0"]], [[1, 0], ["0", "0"]], [[2, 0], ["1/2", "0"]]]})");
    CHECK(answered_at("/not_nearest", with_more) == "2");
    CHECK(refusal_text(of("[[[1, 0, 0], [1, 2]]]")) == "incomplete_net /computed/terms/0/0");
    CHECK(refusal_text(of("[[[1, 0], [1, 2, 3]]]")) == "mismatched_dimensions /computed/terms/0/1");
    CHECK(refusal_text(of("[[[3, 0], [1]]]")) == "mismatched_dimensions /computed/terms/0/1");
}

TEST_CASE("values are those at the parameters, of curves and of patches") {
    const std::string box =
        R"({"kind": "tensor", "degrees": [1, 1], "control_net": [["0", "1/3"], ["2", "3"]]})";
    const std::string splines =
        R"({"kind": "bspline", "degrees": [1, 1], "knots": [[0, 0, 1, 1], [0, 0, 1, 1]],
        "control_net": [["0", "1/3"], ["2", "3"]]})";
    for (const std::string& map : {box, splines}) {
        const std::string request = R"("op": "audit", "at": [["0", "1"], ["1", "1"]], "map": )" + map;
        CHECK(answered_at("/errors", request + R"(, "computed": {"values": [0.5, 3]})") ==
              R"({"values": ["1/6", "0"]})");
        CHECK(refusal_text(request + R"(, "computed": {"values": [0.5]})") ==
              "mismatched_dimensions /computed/values");
    }
    const std::string curve = R"("op": "audit", "map": {"kind": "bezier", "control_points": ["0", "1"]}, )";
    CHECK(refusal_text(curve + R"("computed": {"values": [0]})") == "missing_field /at");
    CHECK(refusal_text(curve + R"("at": ["0"], "computed": {"control_points": [0, 1]})") ==
          "missing_field /computed/values");
    CHECK(
        refusal_text(curve + R"("at": ["0"], "format": "tinyspline", "document": {"degree": 1, "dimension": 1,
        "control_points": [0, 1], "knots": [0, 0, 1, 1]})") == "unknown_field /at");
    CHECK(refusal_text(R"("op": "audit", "at": [["1"]], "map": )" + box + R"(, "computed": {"values": [0]})")
              .ends_with(" /at/0"));
}

TEST_CASE("of a document and a map, the one without weights has the weights 1") {
    const auto curve = [](const std::string& weights) {
        return R"("map": {"kind": "bezier", "control_points": [["0"], ["1"]])" + weights + "}";
    };
    const auto document = [](const std::string& weights) {
        return R"("op": "audit", "format": "geomdl", "document": {"shape": {"type": "curve", "data": [{"degree": 1,
            "knotvector": [0, 0, 1, 1], "control_points": {"points": [[0], [1]])" +
               weights + "}}]}}, ";
    };
    const std::string lost = document("") + curve(R"(, "weights": ["1", "2"])");
    CHECK(answered_at("/errors/weights", lost) == R"(["0", "-1"])");
    CHECK(answered_at("/not_nearest", lost) == "1");
    CHECK(answered_at("/without_weights", lost) == R"("document")");
    const std::string found = document(R"(, "weights": [1, 2])") + curve("");
    CHECK(answered_at("/errors/weights", found) == R"(["0", "1"])");
    CHECK(answered_at("/without_weights", found) == R"("map")");
    CHECK(answered_at("/not_nearest", document(R"(, "weights": [1, 1])") + curve("")) == "0");
    const std::string neither = document("") + curve("");
    CHECK(answered_at("/errors/weights", neither).empty());
    CHECK(answered_at("/without_weights", neither).empty());
    CHECK(answered_at("/without_weights",
                      document(R"(, "weights": [1, 2])") + curve(R"(, "weights": ["1", "2"])"))
              .empty());
}

TEST_CASE("weights of a document are not those of points that carry their weight") {
    const std::string map =
        R"("map": {"kind": "bezier", "control_points": [["0", "1"], ["1", "1"]], "homogeneous": true})";
    CHECK(answered_at("/not_nearest", R"("op": "audit", "format": "tinyspline", "document": {"degree": 1,
        "dimension": 2, "control_points": [0, 1, 1, 1], "knots": [0, 0, 1, 1]}, )" +
                                          map) == "0");
    CHECK(refusal_text(R"("op": "audit", "format": "splinepy", "document": {"SplineList": [{"degrees": [1],
        "knot_vectors": [[0, 0, 1, 1]], "control_points": [[0, 1], [1, 1]], "weights": [1, 1]}]}, )" +
                       map) == "mismatched_dimensions /document/SplineList/0/control_points/0");
    CHECK(answered_at("/not_nearest", R"("op": "audit", "format": "splinepy", "document": {"SplineList": [{
        "degrees": [1], "knot_vectors": [[0, 0, 1, 1]], "control_points": [[0], [1]], "weights": [1, 1]}]}, )" +
                                          map) == "0");
}

TEST_CASE("a document of another degree is refused, even with as many numbers") {
    // 6 knots and 4 control points make degree 1 in the textbook convention, and degree 3 in the polar one.
    const std::string map = R"("map": {"kind": "bspline", "degree": 1, "knots": [0, 1, 2, 3, 4, 5],
        "control_points": [[0], [1], [4], [9]]})";
    CHECK(refusal_text(R"("op": "audit", "format": "tinyspline", "document": {"degree": 3, "dimension": 1,
        "control_points": [0, 1, 4, 9], "knots": [0, 1, 2, 3, 4, 5]}, )" +
                       map) == "mismatched_dimensions /document/degree");
    CHECK(refusal_text(R"("op": "audit", "format": "splinepy", "document": {"SplineList": [{"degrees": [3],
        "control_points": [[0], [1], [4], [9]], "knot_vectors": [[0, 1, 2, 3, 4, 5]]}]}, )" +
                       map) == "mismatched_dimensions /document/SplineList/0/degrees/0");
}

TEST_CASE("a document without knots is compared with others at its place") {
    CHECK(refusal_text(R"("op": "audit", "format": "splinepy", "document": {"SplineList": [{"degrees": [1],
        "control_points": [[0], [1]]}]}, "map": {"kind": "bspline", "degree": 1, "knots": [0, 0, 1, 2, 2],
        "control_points": [["0"], ["1"], ["2"]]})") == "mismatched_dimensions /document/SplineList/0");
}

TEST_CASE("a number in the text of an audit has its place") {
    const auto text = [](const char* map, const char* computed) {
        const Limits limits;
        const Json request = Json::Object{
            {"op", "audit"}, {"map", parse_json(map, limits)}, {"computed", parse_json(computed, limits)}};
        const Answer answer = find_answer(request, limits);
        return find_operation("audit").render({request, answer, limits, Style(false)});
    };
    const std::string taylor = text(R"({"kind": "taylor", "center": "1/2", "coefficients": ["1"]})",
                                    R"({"center": 1, "coefficients": [1]})");
    CHECK(taylor.find("\n  center: error 1/2, 4.5e+15 ulp\n") != std::string::npos);
    const std::string hermite = text(R"({"kind": "hermite", "left": ["1"], "right": ["2"],
        "denominator": {"left": ["1"], "right": ["2"]}})",
                                     R"({"denominator": {"left": [1], "right": [2.5]}})");
    CHECK(hermite.find("\n  denominator right 0: error 1/2, 1.13e+15 ulp\n") != std::string::npos);
    const std::string simplex =
        text(R"({"kind": "simplex", "degree": 1, "control_net": [[[1, 0], ["1"]], [[0, 1], ["2"]]]})",
             R"({"control_net": [[[1, 0], [1]], [[0, 1], [2.5]]]})");
    CHECK(simplex.find("\n  control_net (0, 1): error (1/2), (1.13e+15) ulp\n") != std::string::npos);
}

TEST_CASE("a computed decimal below the least double is its nearest double, 0") {
    const std::string map = R"("op": "audit", "map": {"kind": "bezier", "control_points": ["1e-400"]}, )";
    for (const char* number : {"1e-400", "-1e-400", "-0.0", R"("0x1p-1080")", R"("1e-999999")"}) {
        CAPTURE(number);
        CHECK(answered_at("/not_nearest", map + R"("computed": {"control_points": [)" + number + "]}") ==
              "0");
    }
    CHECK(answered_at("/errors", map + R"("computed": {"control_points": ["3e-324"]})")
              .starts_with(R"({"control_points": [)"));
    CHECK(refusal_text(map + R"("computed": {"control_points": ["1e400"]})") ==
          "overflow /computed/control_points/0");
    CHECK(refusal_text(map + R"("computed": {"control_points": ["0x1p1024"]})") ==
          "overflow /computed/control_points/0");
}

TEST_CASE("an exact number beyond the doubles cannot be compared") {
    CHECK(refusal_text(R"("op": "audit", "map": {"kind": "bezier", "control_points": ["1e309"]},
        "computed": {"control_points": [1e308]})") == "overflow /computed/control_points/0");
}
