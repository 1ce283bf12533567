#include "answered.hpp"

// An error in a document of another library has its place in this document.

namespace {

struct Document {
    std::string format;
    std::string text;
};

/// Each format with and without its optional members.
const std::vector<Document> documents{
    {"tinyspline", R"({"degree": 1, "dimension": 2, "control_points": [0, 1, 2, 3], "knots": [0, 0, 1, 1]})"},
    {"tinyspline",
     R"({"degree": 2, "dimension": 1, "control_points": [0, 1, 2, 3], "knots": [0, 0, 0.5, 1, 1]})"},
    {"geomdl", R"({"shape": {"type": "curve", "count": 1, "data": [{"type": "spline", "rational": false,
        "dimension": 1, "degree": 1, "knotvector": [0, 0, 1, 1], "control_points": {"points": [[0], [1]]}}]}})"},
    {"geomdl", R"({"shape": {"type": "curve", "data": [
        {"degree": 1, "knotvector": [0, 0, 1, 1], "control_points": {"points": [[0, 1], [2, 3]], "weights": [1, 2]}},
        {"degree": 2, "knotvector": [0, 1, 2, 3], "control_points": {"points": [[0], [1], [2]]}}]}})"},
    {"splinepy", R"({"Base64Encoding": false, "SplineList": [{"degrees": [1], "knot_vectors": [[0, 0, 1, 1]],
        "control_points": [[0, 1], [2, 3]]}]})"},
    {"splinepy", R"({"SplineList": [{"degrees": [1], "control_points": [[0], [1]], "weights": [[1], [2]]},
        {"degrees": [1], "knot_vectors": [[0, 0, 1, 1]], "control_points": [[0, 1], [2, 3]], "weights": [1, 2]},
        {"degrees": [0], "control_points": [[7]], "dim": 1}]})"},
    {"geomdl",
     R"({"shape": {"type": "surface", "count": 1, "data": [{"dimension": 1, "rational": true, "degree_u": 1,
        "degree_v": 1, "knotvector_u": [0, 0, 1, 1], "knotvector_v": [0, 0, 1, 2, 2], "size_u": 2, "size_v": 3,
        "control_points": {"points": [[0], [1], [2], [3], [4], [5]], "weights": [1, 1, 2, 2, 3, 3]}}]}})"},
    {"geomdl",
     R"({"shape": {"type": "volume", "data": [{"degree_u": 0, "degree_v": 0, "degree_w": 1, "knotvector_u": [0, 1],
        "knotvector_v": [0, 1, 2], "knotvector_w": [0, 0, 1, 1], "size_u": 1, "size_v": 2, "size_w": 2,
        "control_points": {"points": [[0, 1], [1, 2], [2, 3], [3, 4]]}}]}})"},
    {"splinepy",
     R"({"NumberOfSplines": 2, "SplineList": [{"SplineType": "NURBS", "degrees": [1, 1], "para_dim": 2,
        "knot_vectors": [[0, 0, 1, 1], [0, 0, 1, 2, 2]], "control_points": [[0], [1], [2], [3], [4], [5]],
        "weights": [[1], [2], [3], [4], [5], [6]]}, {"SplineType": "Bezier", "degrees": [1, 0, 1],
        "control_points": [[0, 1], [1, 2], [2, 3], [3, 4]]}]})"},
};

/// The places of all parts of a value, including itself.
std::vector<Place> places_in(const Json& value) {
    std::vector<Place> places{Place{}};
    const auto append = [&](const Place& step, const Json& inner) {
        for (const Place& place : places_in(inner)) places.push_back(step.around(place));
    };
    if (const Json::Object* members = value.object()) {
        for (const auto& [name, member] : *members) append(Place{name}, member);
    }
    if (const Json::Array* elements = value.array()) {
        for (std::size_t i = 0; i < elements->size(); ++i) append(Place{i}, (*elements)[i]);
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

std::string pointer_of_error(const Json& request, const Json& response) {
    const Json* error = response.find("error");
    if (!error) return "none";
    INFO(to_text(request) << " -> " << to_text(response));
    std::string pointer = *error->find("at")->text();
    if (*error->find("code") == Json("missing_field")) pointer.erase(pointer.rfind('/'));
    CHECK(at_pointer(request, pointer));
    return pointer;
}

Json request_with(const Document& document) {
    const Limits limits;
    return Json::Object{
        {"op", "import"}, {"format", document.format}, {"document", parse_json(document.text, limits)}};
}

/// The value that contains the one at the place.
Json& around(Json& value, const Place& place) {
    Json* outer = &value;
    Json* inner = &value;
    for (const Place::Step& step : place.steps()) {
        outer = inner;
        inner = &at(*inner, std::holds_alternative<std::size_t>(step) ? Place{std::get<std::size_t>(step)}
                                                                      : Place{std::get<std::string>(step)});
    }
    return *outer;
}

bool lies_in(const std::string& pointer, const std::string& outer) {
    return pointer == outer || pointer.starts_with(outer + "/");
}

}  // namespace

TEST_CASE("the documents are right") {
    for (const Document& document : documents) {
        INFO(document.text);
        CHECK(answer_to(request_with(document), Limits{}).find("result"));
    }
}

TEST_CASE("a leaf of a document that has the wrong type is refused at its place or the one around it") {
    for (const Document& document : documents) {
        const Json request = request_with(document);
        for (const Place& place : places_in(*request.find("document"))) {
            const Json& right = *at_place(*request.find("document"), place);
            if (right.array() || right.object()) continue;
            const Place whole = Place{"document"}.around(place);
            for (const Json& wrong :
                 {Json(), Json("?"), Json(Json::Object{{"x", "0"}}), Json(Json::Array{"0", "1"})}) {
                Json broken = request;
                at(broken, whole) = wrong;
                const std::string pointer = pointer_of_error(broken, answer_to(broken, Limits{}));
                const std::string own = pointer_of(whole);
                const std::string parent = own.substr(0, own.rfind('/'));
                CAPTURE(to_text(broken), pointer);
                CHECK((pointer == "none" || pointer == parent || lies_in(pointer, own)));
                const bool is_read = !own.ends_with("0/type");
                CHECK((pointer != "none") == is_read);
            }
        }
    }
}

TEST_CASE("an error in a document that has other values, fewer or more is at a place that it has") {
    for (const Document& document : documents) {
        const Json request = request_with(document);
        for (const Place& place : places_in(*request.find("document"))) {
            const Place whole = Place{"document"}.around(place);
            std::vector<Json> others;
            const Json& right = *at_place(request, whole);
            if (right.number()) {
                for (const char* number : {"0", "1", "2", "3", "9", "-1", "0.5", "1e400", "1e-400"})
                    others.emplace_back(Json::Number{number});
            }
            if (const Json::Array* list = right.array()) {
                Json::Array shorter = *list, longer = *list;
                shorter.pop_back();
                longer.push_back(list->back());
                others.insert(others.end(), {Json(shorter), Json(longer), Json(Json::Array{})});
            }
            for (const Json& other : others) {
                Json changed = request;
                at(changed, whole) = other;
                pointer_of_error(changed, answer_to(changed, Limits{}));
            }
            if (place.steps().empty()) continue;
            const auto* name = std::get_if<std::string>(&place.steps().back());
            if (!name) continue;
            Json without = request;
            Json& owner = around(without, whole);
            std::erase_if(*owner.object(), [&](const auto& member) { return member.first == *name; });
            pointer_of_error(without, answer_to(without, Limits{}));
        }
    }
}
