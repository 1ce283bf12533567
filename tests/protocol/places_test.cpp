#include "answered.hpp"
#include "operations/operation.hpp"

namespace {

const std::string cubic =
    R"("map": {"kind": "polynomial", "coefficients": ["1", "2", "4", "-1"], "degree": 3})";
const std::string arc =
    R"("map": {"kind": "bezier", "control_points": [["1", "0"], ["1", "1"], ["0", "1"]],
               "weights": ["1", "1", "2"], "interval": ["0", "1"]})";
const std::string plane =
    R"("map": {"kind": "bezier", "control_points": [["1", "0"], ["1", "1"], ["0", "1"]]})";
const std::string spline =
    R"("map": {"kind": "bspline", "degree": 2, "knots": ["0", "0", "0", "1", "2", "3", "3", "3"],
               "control_points": ["0", "1", "4", "5", "9"]})";
const std::string triangle =
    R"("map": {"kind": "simplex", "degree": 1, "vertices": [["0", "0"], ["1", "0"], ["0", "1"]],
               "control_net": [[[1, 0, 0], "1"], [[0, 1, 0], "2"], [[0, 0, 1], "4"]]})";
const std::string box =
    R"("map": {"kind": "tensor", "degrees": [1, 1], "intervals": [["0", "1"], ["0", "2"]],
               "control_net": [["1", "2"], ["3", "5"]]})";
const std::string surface =
    R"("map": {"kind": "bspline", "degrees": [1, 1], "knots": [["0", "0", "1", "2", "2"], ["0", "0", "1", "1"]],
               "control_net": [["1", "2"], ["3", "5"], ["4", "4"]]})";
const std::string monomials =
    R"("map": {"kind": "polynomial", "variables": ["x", "y"], "terms": [[[1, 0], "1"], [[1, 1], "3"]],
               "degree": 2})";
const std::string ratio =
    R"("map": {"kind": "polynomial", "text": ["1 - t^2", "2t"], "denominator": "1 + t^2",
                                     "degree": 2, "homogeneous": true})";

/// For every operation, requests with each of its fields, and for every kind of map, each of its fields.
const std::vector<std::string> requests{
    R"({"op": "agree", "arguments": ["1", {"vector": "2"}, {"homogeneous": ["1", "2"]}], )" + cubic + "}",
    R"({"op": "blossom", "numbers": "double", "construction": "casteljau", "arguments": ["1", "2", "3"], )" +
        cubic + "}",
    R"({"op": "blossom", "segment": 3, "arguments": ["1", "2"], )" + spline + "}",
    R"({"op": "blossom", "arguments": [["1/2", "1/4"]], )" + triangle + "}",
    R"({"op": "blossom", "arguments": [["1/2"], [{"vector": "1"}]], )" + box + "}",
    R"({"op": "evaluate", "at": ["1", "2"], "pyramid": true, )" + plane + "}",
    R"({"op": "evaluate", "at": ["1/2"], )" + arc + "}",
    R"({"op": "evaluate", "at": ["1/2"], )" + ratio + "}",
    R"({"op": "evaluate", "at": ["1/2"], "map": {"kind": "polynomial", "text": "t"}})",
    R"({"op": "evaluate", "at": ["1/2"], "map": {"kind": "hermite", "left": [["1", "2"], ["0", "1"]], "right": [["3", "4"]]}})",
    R"({"op": "evaluate", "at": ["1/2"], "map": {"kind": "taylor", "center": "1", "coefficients": ["1", "2"]}})",
    R"({"op": "evaluate", "at": ["1/2"],
        "map": {"kind": "progressive", "knots": ["0", "1", "2", "3"], "control_points": ["0", "2", "6"]}})",
    R"({"op": "evaluate", "at": ["1", "2"], "map": {"kind": "bspline", "degree": 1, "knots": ["0", "0", "1", "2", "2"],
        "control_points": [["0", "1"], ["1", "1"], ["2", "2"]], "homogeneous": true}})",
    R"({"op": "evaluate", "at": [["1/2", "1/4"]], )" + triangle + "}",
    R"({"op": "evaluate", "at": [["1/2", "1/4"]], )" + box + "}",
    R"({"op": "evaluate", "at": [["1/2", "1/4"]], )" + surface + "}",
    R"({"op": "evaluate", "at": [["1/2", "1/4"]], )" + monomials + "}",
    R"({"op": "evaluate", "at": [["1/2", "1/4"]],
        "map": {"kind": "polynomial", "variables": ["x", "y"], "text": "x*y", "degrees": [1, 2], "denominator": "1 + x"}})",
    R"({"op": "derivative", "order": 2, "at": ["1/2"], )" + cubic + "}",
    R"({"op": "derivative", "directions": [["1", "0"]], "at": [["1/2", "1/4"]], )" + triangle + "}",
    R"({"op": "derivative", "direction": ["1", "0"], "order": 1, "at": [["1/2", "1/4"]], )" + surface + "}",
    R"({"op": "control-points", "interval": ["0", "2"], "degree": 4, )" + cubic + "}",
    R"({"op": "control-points", "vertices": [["0", "0"], ["2", "0"], ["0", "1"]], "degree": 2, )" +
        monomials + "}",
    R"({"op": "control-points", "intervals": [["0", "1"], ["0", "3"]], "degrees": [1, 2],
        "map": {"kind": "polynomial", "variables": ["x", "y"], "text": "x*y", "degrees": [1, 1]}})",
    R"({"op": "convert", "to": "taylor", "center": "2", )" + cubic + "}",
    R"({"op": "convert", "to": "hermite", "counts": [3, 1], "interval": ["0", "2"], )" + cubic + "}",
    R"({"op": "convert", "to": "bernstein", "interval": ["0", "2"], )" + cubic + "}",
    R"({"op": "convert", "to": "monomial", "segment": 3, )" + spline + "}",
    R"({"op": "convert", "to": "simplex", )" + box + "}",
    R"({"op": "convert", "to": "bernstein", "vertices": [["0", "0"], ["2", "0"], ["0", "1"]], "degree": 2, )" +
        monomials + "}",
    R"({"op": "convert", "to": "tensor", "intervals": [["0", "1"], ["0", "3"]], "degrees": [1, 1],
        "map": {"kind": "polynomial", "variables": ["x", "y"], "text": "x*y", "degrees": [1, 1]}})",
    R"({"op": "graph", )" + cubic + "}",
    R"({"op": "subdivide", "at": "1/3", )" + plane + "}",
    R"({"op": "subdivide", "at": ["1/2", "1/4"], )" + triangle + "}",
    R"({"op": "subdivide", "at": ["1/2", "1/4"], )" + box + "}",
    R"({"op": "elevate", "by": 2, )" + plane + "}",
    R"({"op": "elevate", "by": [1, 0], )" + box + "}",
    R"({"op": "reduce", "to": 2, "method": "uniform", "interval": ["0", "2"], )" + cubic + "}",
    R"({"op": "inverse-formula", "degree": 3, "interval": ["0", "2"]})",
    R"({"op": "inverse-formula", "degree": 2, "vertices": [["0", "0"], ["2", "0"], ["0", "1"]]})",
    R"({"op": "insert-knots", "knots": ["1/2", "5/2"], "method": "oslo", )" + spline + "}",
    R"({"op": "insert-knots", "knots": [["1/2"], []], )" + surface + "}",
    R"({"op": "remove-knot", "knot": "1", "times": 1, )" + spline + "}",
    R"({"op": "segments", )" + spline + "}",
    R"({"op": "join", "degree": 2, "chain": true, "knots": ["0", "0", "0", "1", "1", "2", "2", "2"],
        "maps": [{"kind": "bezier", "control_points": ["0", "1", "4"]},
                 {"kind": "bezier", "control_points": ["4", "7", "9"], "interval": ["1", "2"]}]})",
    R"({"op": "continuity", "at": "1", )" + spline + "}",
    R"({"op": "continuity", "at": "1",
        "maps": [{"kind": "bezier", "control_points": ["0", "1", "4"]},
                 {"kind": "bezier", "control_points": ["4", "7", "9"], "interval": ["1", "2"]}]})",
    R"({"op": "basis-functions", "degree": 2, "knots": ["0", "0", "0", "1", "2", "2", "2"],
        "convention": "textbook", "at": ["1/2"]})",
    R"({"op": "basis-functions", "degree": 1, "knots": ["0", "0", "1", "1"], "weights": ["1", "2"], "order": 1})",
    R"({"op": "basis-matrix", "from": {"basis": "bernstein", "degree": 1, "interval": ["0", "2"]},
        "to": {"basis": "taylor", "degree": 1, "center": "1"}, "inverse": true})",
    R"({"op": "basis-matrix", "from": {"basis": "lagrange", "nodes": ["0", "2"]}, "to": {"basis": "newton", "nodes": ["3", "2"]}})",
    R"({"op": "basis-matrix", "from": {"basis": "monomial", "degree": 1},
        "to": {"basis": "bspline", "degree": 1, "knots": ["0", "1", "2"], "convention": "polar"}})",
    R"({"op": "interpolate", "values": ["1", "2", "4"], "nodes": ["0", "1", "1"], "interval": ["0", "2"]})",
    R"({"op": "interpolate", "values": ["1", "2", "4"], "nodes": ["0", "1", "2"], "degree": 1, "knots": ["0", "0", "1", "2", "2"]})",
    R"({"op": "interpolate", "values": [["1", "2"], ["4", "7"]], "grid": [["0", "1"], ["0", "2"]], "intervals": [["0", "1"], ["0", "1"]]})",
    R"({"op": "interpolate", "values": [["1", "2"], ["4", "7"]], "grid": [["0", "1"], ["0", "2"]], "degrees": [1, 1],
        "knots": [["0", "0", "1", "1"], ["0", "0", "2", "2"]]})",
    R"({"op": "interpolate", "lattice": [[[1, 0, 0], "1"], [[0, 1, 0], "2"], [[0, 0, 1], "4"]],
        "vertices": [["0", "0"], ["1", "0"], ["0", "1"]]})",
    R"({"op": "insert-knots", "knots": ["1/2"], "multiplicity": 2, )" + spline + "}",
    R"({"op": "subdivide", "at": "1/2", "clamped": true, )" + spline + "}",
    R"({"op": "continuity", "at": "seam", )" + spline + "}",
    R"({"op": "clamp", )" + spline + "}",
    R"({"op": "trim", "interval": ["1/2", "1"], )" + spline + "}",
    R"({"op": "reverse", )" + spline + "}",
    R"({"op": "reparametrise", "from": ["0", "1"], "interval": ["3", "1"], )" + spline + "}",
    R"({"op": "sum", "factors": ["1", "-1/2"], "maps": [{"kind": "polynomial", "text": "t^2"},
        {"kind": "bezier", "control_points": ["0", "1", "4"]}]})",
    R"({"op": "product", "as": "dot", "maps": [{"kind": "polynomial", "text": ["t^2", "1"]},
        {"kind": "bezier", "control_points": [["0", "1"], ["4", "2"]]}]})",
    R"({"op": "quotient", "maps": [{"kind": "polynomial", "text": ["t^2", "1"]},
        {"kind": "bezier", "control_points": ["1", "4"]}]})",
    R"({"op": "transform", "matrix": [["1", "2"], ["3", "4"]], "translation": ["5", "6"], )" + plane + "}",
    R"({"op": "transform", "matrix": ["1", "2"], "translation": "6", )" + plane + "}",
    R"({"op": "polar", "arguments": ["1", {"vector": "2"}], )" + cubic + "}",
    R"({"op": "polar", "arguments": [["1/2"], [{"homogeneous": ["1", "2"]}]], )" + box + "}",
    R"({"op": "polar", "arguments": [["1/2", "1/4"]], )" + monomials + "}",
    R"({"op": "polar", "arguments": ["1"], "segment": 3, )" + spline + "}",
    R"({"op": "restrict", "vertices": [["0", "1"], ["1/2", "0"]], "interval": ["0", "2"], )" + monomials +
        "}",
    R"({"op": "restrict", "at": ["1/2", null], )" + box + "}",
    R"({"op": "restrict", "at": ["1/2", null], )" + surface + "}",
    R"({"op": "compose", "maps": [{"kind": "bezier", "control_points": ["0", "1", "4"]},
        {"kind": "polynomial", "text": "t^2"}]})",
    R"({"op": "jacobian", "as": "matrix", )" + plane + "}",
    R"({"op": "normal", )" + plane + "}",
    R"({"op": "bounds", "of": "jacobian", "depth": 3, )" + cubic + "}",
    R"({"op": "gcd", "maps": [{"kind": "polynomial", "text": "t^2"}, {"kind": "polynomial", "text": "t"}]})",
    R"({"op": "resultant", "variable": "x",
        "maps": [{"kind": "polynomial", "variables": ["x", "y"], "text": "x*y"},
                 {"kind": "polynomial", "variables": ["x", "y"], "text": "x+y"}]})",
    R"({"op": "periodic", "map": {"kind": "bspline", "degree": 1, "knots": ["0", "0", "1", "2", "3", "3"],
        "control_points": ["0", "2", "1", "0"]}})",
    R"({"op": "insert-knots", "direction": 1, "knots": ["1/2"], )" + surface + "}",
    R"({"op": "remove-knot", "direction": 0, "knot": "1/2",
        "map": {"kind": "bspline", "degrees": [1, 0], "knots": [["0", "0", "1/2", "1", "1"], ["0", "1"]],
        "control_net": [["0"], ["1"], ["3"]]}})",
    R"({"op": "join", "direction": 0, "maps": [{"kind": "tensor", "degrees": [1, 0], "control_net": [["0"], ["1"]]},
        {"kind": "tensor", "degrees": [1, 0], "intervals": [["1", "2"], ["0", "1"]], "control_net": [["1"], ["3"]]}]})",
    R"({"op": "clamp", "direction": 0, )" + surface + "}",
    R"({"op": "trim", "direction": 0, "interval": ["1/2", "1"], )" + surface + "}",
    R"({"op": "reverse", "direction": 1, )" + surface + "}",
    R"({"op": "reparametrise", "direction": 1, "interval": ["3", "1"], )" + box + "}",
    R"({"op": "periodic", "direction": 0, "map": {"kind": "bspline", "degrees": [1, 0],
        "knots": [["0", "0", "1", "2", "2"], ["0", "1"]], "control_net": [["0"], ["2"], ["0"]]}})",
    R"({"op": "reduce", "to": [1, 0], )" + box + "}",
    R"({"op": "graph", )" + triangle + "}",
    R"({"op": "convert", "to": "taylor", "center": ["1", "2"], )" + monomials + "}",
    R"({"op": "evaluate", "at": [["1", "2"]], "map": {"kind": "taylor", "variables": ["x", "y"], "center": ["1", "0"],
        "terms": [[[1, 0], "1"], [[1, 1], "3"]], "degree": 2}})",
    R"({"op": "evaluate", "at": [["1/2", "1/4"]], "pyramid": true, )" + box + "}",
    R"({"op": "continuity", "faces": [[["1", "0"], ["1", "1"]], [["0", "0"], ["0", "1"]]], "geometric": true,
        "maps": [{"kind": "tensor", "degrees": [1, 1], "control_net": [[["0", "0"], ["0", "1"]], [["1", "0"], ["1", "1"]]]},
                 {"kind": "tensor", "degrees": [1, 1], "control_net": [[["1", "0"], ["1", "1"]], [["3", "0"], ["2", "1"]]]}]})",
    R"({"op": "roots", "interval": ["-4", "4"], "width": "1/10", )" + cubic + "}",
    R"({"op": "roots", "with": [{"kind": "polynomial", "text": "t"}], )" + cubic + "}",
    R"({"op": "extrema", "interval": ["-4", "4"], "width": "1/10", "direction": ["1", "2"], )" + plane + "}",
    R"({"op": "nearest", "interval": ["-4", "4"], "width": "1/10", "point": ["1", "2"], )" + plane + "}",
    R"({"op": "inflections", "interval": ["-4", "4"], "width": "1/10", )" + plane + "}",
    R"({"op": "intersections", "with": {"kind": "polynomial", "text": ["t", "t"]}, "with_interval": ["-1", "2"], )" +
        plane + "}",
    R"({"op": "self-intersections", "interval": ["-4", "4"], "width": "1/10", )" + plane + "}",
    R"({"op": "intersections", "interval": ["-4", "4"], "width": "1/10", "line": ["1", "2", "3"], )" + plane +
        "}",
    R"({"op": "prove", "statement": "claim 1 == 1"})",
    R"({"op": "prove", "statement": ["claim 1 == 1", "claim 2 == 2"]})",
    R"({"op": "audit", "computed": {"control_points": [0, 0.333, 0.1]},
        "map": {"kind": "bezier", "control_points": ["0", "1/3", "1/10"]}})",
    R"({"op": "audit", "at": ["0", "1"], "computed": {"values": [0, 0.1]},
        "map": {"kind": "bezier", "control_points": ["0", "1/3", "1/10"]}})",
    R"({"op": "audit", "format": "tinyspline", "document": {"degree": 1, "dimension": 1, "control_points": [0, 1],
        "knots": [0, 0, 1, 1]}, "map": {"kind": "bezier", "control_points": [["0"], ["1"]]}})",
    R"({"op": "audit", "format": "geomdl", "document": {"shape": {"type": "curve", "data": [{"degree": 1,
        "knotvector": [0, 0, 1, 1], "control_points": {"points": [[0, 1], [2, 3]]}}]}},
        "map": {"kind": "bezier", "control_points": [["0", "1"], ["2", "3"]]}})",
    R"({"op": "audit", "format": "splinepy", "document": {"SplineList": [{"degrees": [1],
        "knot_vectors": [[0, 0, 1, 1]], "control_points": [[0, 1], [2, 3]], "weights": [1, 2]}]},
        "map": {"kind": "bezier", "control_points": [["0", "1"], ["2", "3"]], "weights": ["1", "2"]}})",
    R"({"op": "audit", "format": "geomdl", "maps": [{"kind": "bezier", "control_points": [["0"], ["1"]]}],
        "document": {"shape": {"type": "curve", "data": [{"degree": 1, "knotvector": [0, 0, 1, 1],
        "control_points": {"points": [[0], [1]]}}]}}})",
    R"({"op": "import", "format": "tinyspline", "document": {"degree": 1, "dimension": 1,
        "control_points": [0.1, 2], "knots": [0, 0, 1, 1]}})",
    R"({"op": "import", "format": "geomdl", "document": {"shape": {"type": "curve", "data": [{"degree": 1,
        "knotvector": [0, 0, 1, 1], "control_points": {"points": [[0, 1], [2, 3]], "weights": [1, 2]}}]}}})",
    R"({"op": "import", "format": "splinepy", "document": {"Base64Encoding": false, "SplineList": [{"degrees": [1],
        "knot_vectors": [[0, 0, 1, 1]], "control_points": [[0, 1], [2, 3]], "weights": [[1], [2]]}]}})",
    R"({"op": "export", "format": "geomdl", )" + plane + "}",
    R"({"op": "export", "format": "splinepy", "maps": [{"kind": "bezier", "control_points": [["0", "0"], ["1", "1"]]}]})",
    R"({"op": "certify", "requests": [{"op": "blossom", "arguments": ["1", "2", "3"], )" + cubic + "}]}",
    R"({"op": "explain", "format": "text", "request": {"op": "evaluate", "at": ["1/2"], )" + plane + "}}",
    R"({"op": "exercise", "topic": "subdivision", "seed": 2, "count": 1, "level": 2, "solutions": true, "format": "text",
        "notation": "brackets", "multiplicities": true, "columns": 60})",
    R"({"op": "barycentric", "vertices": [["0", "0"], ["1", "0"], ["0", "1"]], "at": [["1/4", "1/2"]]})",
};

/// Every place in a request except the whole.
std::vector<Place> places_in(const Json& value) {
    std::vector<Place> places;
    const auto append = [&](const Place& step, const Json& inner) {
        places.push_back(step);
        for (const Place& place : places_in(inner)) places.push_back(step.around(place));
    };
    if (const Json::Object* members = value.object()) {
        for (const auto& [name, member] : *members) append({name}, member);
    }
    if (const Json::Array* elements = value.array()) {
        for (std::size_t i = 0; i < elements->size(); ++i) append({i}, (*elements)[i]);
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

/// Values that are wrong at every place, by their type or as a text.
std::vector<Json> wrong_values(const Json& right) {
    std::vector<Json> wrong{Json(), Json::Object{{"wrong", "0"}}, Json("?!")};
    if (!right.boolean()) wrong.emplace_back(true);
    if (right.number()) {
        wrong.emplace_back("1/0");
        wrong.emplace_back("-1/2");
    }
    return wrong;
}

/// Values of the right type that may contradict the rest of the request.
std::vector<Json> doubtful_values(const Json& right) {
    std::vector<Json> doubtful;
    if (right.number()) {
        for (const char* number : {"0", "-1", "7", "100000000000000000000000"})
            doubtful.emplace_back(Json::Number{number});
    }
    if (right.text()) {
        for (const char* text : {"0", "-1", "7", "100000000000000000000000"}) doubtful.emplace_back(text);
    }
    if (const Json::Array* list = right.array(); list && !list->empty()) {
        Json::Array shorter = *list, longer = *list;
        shorter.pop_back();
        longer.push_back(list->back());
        doubtful.insert(doubtful.end(), {Json(shorter), Json(longer), Json(Json::Array{})});
    }
    return doubtful;
}

/// A request with one changed value, and its answer.
struct Changed {
    Json request;
    Place place;
    Json response;
};

template <class Values, class Check>
void for_each_change(const Values& values, const Check& check) {
    for (const std::string& text : requests) {
        const Json request = parse_json(text, Limits{});
        for (const Place& place : places_in(request)) {
            for (const Json& value : values(*at_place(request, place))) {
                Json changed = request;
                at(changed, place) = value;
                const Json response = answer_to(changed, Limits{});
                INFO(pointer_of(place) << " of " << to_text(changed) << " -> " << to_text(response));
                check(Changed{changed, place, response});
            }
        }
    }
}

std::string pointer_in(const Json& response) { return *at_pointer(response, "/error/at")->text(); }

bool lies_in(const std::string& pointer, const std::string& outer) {
    return pointer == outer || pointer.starts_with(outer + "/");
}

}  // namespace

TEST_CASE("the requests are right, and have every field that an option writes") {
    std::map<std::string, std::vector<Json>> by_operation;
    for (const std::string& text : requests) {
        INFO(text);
        const Json request = parse_json(text, Limits{});
        by_operation[*request.find("op")->text()].push_back(request);
        CHECK(to_text(answer_to(request, Limits{})).starts_with(R"({"ok": true)"));
    }
    for (const Operation& operation : operations()) {
        const std::vector<Json>& own = by_operation[std::string(operation.name)];
        CAPTURE(operation.name);
        CHECK_FALSE(own.empty());
        for (const Option& option : operation.options) {
            CAPTURE(option.name, pointer_of(option.field));
            const auto has_field = [&](const Json& request) { return at_place(request, option.field); };
            const bool of_map = option.field.begins_with(Part::map);
            CHECK((std::ranges::any_of(own, has_field) ||
                   (of_map && std::ranges::any_of(by_operation["evaluate"], has_field))));
        }
    }
}

TEST_CASE("a wrong value anywhere in a request is refused, at its place or below") {
    for_each_change(wrong_values, [](const Changed& changed) {
        // A direction in which a tensor product is not subdivided or restricted.
        const Json& operation = *changed.request.find("op");
        const bool undivided = (operation == Json("subdivide") || operation == Json("restrict")) &&
                               changed.place.begins_with(Part::at) && changed.place.steps().size() == 2 &&
                               at_place(changed.request, changed.place)->is_null();
        if (undivided) return;
        REQUIRE(changed.response.find("error"));
        CHECK(lies_in(pointer_in(changed.response), pointer_of(changed.place)));
    });
}

TEST_CASE("the place of an error is in the request, and not all of it") {
    for_each_change(doubtful_values, [](const Changed& changed) {
        const Json* code = at_pointer(changed.response, "/error/code");
        if (!code || *code == Json("missing_field")) return;
        CHECK_FALSE(pointer_in(changed.response).empty());
        CHECK(at_pointer(changed.request, pointer_in(changed.response)));
    });
}

TEST_CASE("a wrong entry of another library's file is refused where the file has it") {
    struct Entry {
        std::string format;
        std::string document;
        std::string refused;
    };
    const auto tinyspline = [](const std::string& points, const std::string& knots) {
        return R"({"degree": 1, "dimension": 2, "control_points": )" + points + R"(, "knots": )" + knots +
               "}";
    };
    const auto geomdl = [](const std::string& knots, const std::string& points, const std::string& weights) {
        return R"({"shape": {"type": "curve", "data": [{"degree": 1, "knotvector": )" + knots +
               R"(, "control_points": {"points": )" + points + R"(, "weights": )" + weights + "}}]}}";
    };
    const auto splinepy = [](const std::string& knots, const std::string& points,
                             const std::string& weights) {
        return R"({"SplineList": [{"degrees": [1], "knot_vectors": [)" + knots + R"(], "control_points": )" +
               points + R"(, "weights": )" + weights + "}]}";
    };
    const std::string knots = "[0, 0, 1, 1]";
    const std::string points = "[[0, 1], [2, 3]]";
    const std::string curve = "/document/shape/data/0/";
    const std::string own = "/document/SplineList/0/";
    for (const auto& [format, document, refused] : {
             Entry{"tinyspline", tinyspline("[0, 1, 2, 3]", "[0, 2, 1, 1]"), "bad_knots /document/knots/2"},
             {"tinyspline", tinyspline("[0, 1, 2, 3]", "[0, 0, 1]"), "bad_knots /document/knots"},
             {"tinyspline", tinyspline("[0, 1]", knots), "wrong_arity /document/control_points"},
             {"tinyspline", tinyspline("[0, 1, 2]", knots), "mismatched_dimensions /document/control_points"},
             {"geomdl", geomdl("[0, 2, 1, 1]", points, "[1, 1]"), "bad_knots " + curve + "knotvector/2"},
             {"geomdl", geomdl("[0, 0, 1]", points, "[1, 1]"), "bad_knots " + curve + "knotvector"},
             {"geomdl", geomdl(knots, "[[0, 1], [2]]", "[1, 1]"),
              "mismatched_dimensions " + curve + "control_points/points/1"},
             {"geomdl", geomdl(knots, points, "[1]"), "wrong_arity " + curve + "control_points/weights"},
             {"geomdl", geomdl(knots, points, "[1, 0]"), "zero_weight " + curve + "control_points/weights/1"},
             {"geomdl", geomdl(knots, "[[0, 1]]", "[1]"), "wrong_arity " + curve + "control_points/points"},
             {"splinepy", splinepy("[0, 2, 1, 1]", points, "[1, 1]"),
              "bad_knots " + own + "knot_vectors/0/2"},
             {"splinepy", splinepy("[0, 0, 1]", points, "[1, 1]"), "bad_knots " + own + "knot_vectors/0"},
             {"splinepy", splinepy(knots, "[[0, 1], [2]]", "[1, 1]"),
              "mismatched_dimensions " + own + "control_points/1"},
             {"splinepy", splinepy(knots, points, "[[1]]"), "wrong_arity " + own + "weights"},
             {"splinepy", splinepy(knots, points, "[[1], [0]]"), "zero_weight " + own + "weights/1"},
             {"splinepy", splinepy(knots, points, "[[1], [\"x\"]]"), "not_a_number " + own + "weights/1/0"},
         }) {
        CAPTURE(format, document);
        CHECK(refusal_text(R"("op": "import", "format": ")" + format + R"(", "document": )" + document) ==
              refused);
    }
}
