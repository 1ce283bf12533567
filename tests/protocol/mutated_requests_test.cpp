#include "answered.hpp"
#include "operations/operation.hpp"
#include "support/random.hpp"

// Requests that are almost valid: every error has a place that exists in the request.

using blossom::testing::Random;

namespace {

/// Limits so small that every request is answered quickly.
Limits small_limits() {
    Limits limits;
    limits.degree = 12;
    limits.digits = 300;
    limits.nesting = 20;
    limits.polarization_terms = 1 << 8;
    limits.expansion_terms = 1 << 8;
    limits.expansion_work = 20'000;
    limits.numbers = 1 << 10;
    return limits;
}

/// The requests of the golden file and of the page of the protocol, and some others.
std::vector<Json> right_requests() {
    std::vector<Json> requests;
    std::ifstream golden(BLOSSOM_SOURCE "/tests/golden/protocol-examples.jsonl");
    for (std::string line; std::getline(golden, line);)
        requests.push_back(*parse_json(line, Limits{}).find("request"));
    std::ifstream page(BLOSSOM_SOURCE "/docs/protocol.md");
    for (std::string line; std::getline(page, line);) {
        const bool is_request = line.starts_with('{') && line.find("\"op\"") != std::string::npos;
        if (is_request) requests.push_back(parse_json(line, Limits{}));
    }
    for (
        const char* request : {
            R"({"op": "export", "format": "geomdl", "maps": [{"kind": "bezier", "control_points": [["0"], ["1"]]},
                 {"kind": "bspline", "degree": 1, "knots": [0, 0, 1, 1], "control_points": [["0"], ["1"], ["2"], ["3"]]}]})",
            R"({"op": "import", "format": "splinepy", "document": {"SplineList": [{"degrees": [1],
                 "control_points": [[0, 1], [2, 3]], "weights": [[1], [2]]}]}})",
            R"({"op": "audit", "format": "geomdl", "map": {"kind": "bezier", "control_points": [["0"], ["1"]]},
                 "document": {"shape": {"type": "curve", "data": [{"degree": 1, "knotvector": [0, 0, 1, 1],
                 "control_points": {"points": [[0], [1]], "weights": [1, 2]}}]}}})",
            R"({"op": "audit", "map": {"kind": "simplex", "degree": 1, "control_net": [[[1, 0], "1"], [[0, 1], "2"]]},
                 "at": [["0", "1"]], "computed": {"control_net": [[[1, 0], 1], [[0, 1], 2]], "values": [2.5]}})",
            R"({"op": "audit", "map": {"kind": "hermite", "left": ["1"], "right": ["2"],
                 "denominator": {"left": ["1"], "right": ["2"]}},
                 "computed": {"left": [1], "denominator": {"left": [1], "right": [2]}}})",
            R"({"op": "certify", "requests": [{"op": "agree", "map": {"kind": "bspline", "degree": 1,
                 "knots": [0, 0, 1, 1], "control_points": ["0", "1"]}}]})",
            R"({"op": "explain", "request": {"op": "evaluate", "map": {"kind": "polynomial", "text": "t^2"}, "at": ["1"]}})",
            R"({"op": "exercise", "topic": "subdivision", "seed": 2, "count": 1})",
        }) {
        requests.push_back(parse_json(request, Limits{}));
    }
    return requests;
}

/// The values in the requests, which are used to replace others.
struct Pool {
    std::vector<Json> values;
    std::vector<std::string> names;

    void collect(const Json& value) {
        values.push_back(value);
        if (const Json::Array* elements = value.array()) {
            for (const Json& element : *elements) collect(element);
        }
        if (const Json::Object* members = value.object()) {
            for (const auto& [name, member] : *members) {
                names.push_back(name);
                collect(member);
            }
        }
    }
};

Pool pool_of(const std::vector<Json>& requests) {
    Pool pool;
    for (const Json& request : requests) pool.collect(request);
    for (const char* text :
         {"", "0", "-1", "1/0", "1/3", "1e-400", "1e400", "t", "(1/t)^0", "x*y", "midpoints",
          "-9223372036854775808", "0x1p-1080", "infinite", "claim 1/x == 1/x"}) {
        pool.values.emplace_back(text);
    }
    for (const char* number : {"0", "1", "-1", "2", "0.5", "-0.0", "1e400", "1e-400", "9223372036854775808"})
        pool.values.emplace_back(Json::Number{number});
    pool.values.insert(pool.values.end(),
                       {Json(), Json(true), Json(false), Json(Json::Array{}), Json(Json::Object{})});
    return pool;
}

/// A random place in the value: each level deeper is equally likely.
Json& some_place(Json& value, Random& random) {
    Json* place = &value;
    while (!random.one_in(4)) {
        if (Json::Array* elements = place->array(); elements && !elements->empty()) {
            place = &(*elements)[random.below(elements->size())];
        } else if (Json::Object* members = place->object(); members && !members->empty()) {
            place = &(*members)[random.below(members->size())].second;
        } else {
            break;
        }
    }
    return *place;
}

void mutate(Json& request, const Pool& pool, Random& random) {
    Json& place = some_place(request, random);
    const Json& other = pool.values[random.below(pool.values.size())];
    Json::Array* elements = place.array();
    Json::Object* members = place.object();
    if (elements && !elements->empty() && !random.one_in(3)) {
        const auto chosen = elements->begin() + static_cast<std::ptrdiff_t>(random.below(elements->size()));
        if (random.one_in(3)) {
            elements->erase(chosen);
        } else {
            elements->insert(chosen, random.one_in(2) ? Json(*chosen) : other);
        }
    } else if (members && !members->empty() && !random.one_in(3)) {
        if (random.one_in(2)) {
            members->erase(members->begin() + static_cast<std::ptrdiff_t>(random.below(members->size())));
        } else {
            place[pool.names[random.below(pool.names.size())]] = other;
        }
    } else if (&place != &request) {
        place = other;
    }
}

/// Renders the answer to the request for people, if there is one.
void show(const Json& request, const Limits& limits) {
    try {
        const Answer answer = find_answer(request, limits);
        const Operation& operation = find_operation(*request.find("op")->text());
        const Answered answered{request, answer, limits, Style(false)};
        if (operation.render) operation.render(answered);
        if (operation.plot) operation.plot(answered);
        if (operation.mesh) operation.mesh(answered);
    } catch (const Error& error) {
        CHECK(error.code() != ErrorCode::internal);
    }
}

void check_answer(const Json& request, const Limits& limits) {
    const Response response = answer(to_text(request), limits);
    const Json read = parse_json(response.text, Limits{});
    CAPTURE(to_text(request), response.text);
    CHECK(response.outcome != Outcome::disagreement);
    const Json* error = read.find("error");
    if (!error) return show(request, limits);
    const std::string& code = *error->find("code")->text();
    CHECK(code != "internal");
    std::string pointer = *error->find("at")->text();
    // A missing choice among several segments is also a missing field.
    if (code == "missing_field" || (pointer.ends_with("/segment") && code == "outside_domain"))
        pointer.erase(pointer.rfind('/'));
    CHECK(at_pointer(request, pointer));
}

void check_mutants(std::size_t count, std::uint64_t seed) {
    const Limits limits = small_limits();
    const std::vector<Json> requests = right_requests();
    REQUIRE(requests.size() > 100);
    const Pool pool = pool_of(requests);
    Random random(seed);
    for (std::size_t i = 0; i < count; ++i) {
        Json request = requests[random.below(requests.size())];
        for (std::uint64_t changes = 1 + random.below(3); changes > 0; --changes)
            mutate(request, pool, random);
        check_answer(request, limits);
    }
}

}  // namespace

TEST_CASE("requests with a few changes are answered, or refused at a place that they have") {
    check_mutants(1500, 1);
}

// Run as: protocol_tests [mutants]
TEST_CASE("the same of many requests", "[.][mutants]") {
    for (std::uint64_t seed = 2; seed < 22; ++seed) check_mutants(1000, seed);
}
