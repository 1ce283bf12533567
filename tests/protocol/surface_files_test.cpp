#include <blossom/rational/double_conversion.hpp>
#include "answered.hpp"

#include <array>

#include "pictures/shading.hpp"
#include "responses.hpp"

// Pictures and meshes of patches, read without the code that wrote them.

using blossom::testing::failure;

namespace {

std::string shown(const std::string& text, std::string (*Operation::*show)(const Answered&)) {
    const Json request = parse_json(text, Limits{});
    const Answer answer = find_answer(request, Limits{});
    const auto function = find_operation(*request.find("op")->text()).*show;
    REQUIRE(function);
    return function({request, answer, Limits{}, Style()});
}

std::string picture(const std::string& request) { return shown(request, &Operation::plot); }

/// The contents of an OBJ file.
struct ReadMesh {
    std::vector<std::string> objects;
    std::vector<std::array<double, 3>> vertices;
    std::vector<std::vector<std::size_t>> faces;
    std::vector<std::vector<std::size_t>> lines;

    /// Vertices - edges + faces.
    std::ptrdiff_t euler_characteristic() const {
        return static_cast<std::ptrdiff_t>(vertices.size()) - static_cast<std::ptrdiff_t>(edges().size()) +
               static_cast<std::ptrdiff_t>(faces.size());
    }
    /// The number of faces to which each undirected edge belongs.
    std::map<std::set<std::size_t>, std::size_t> edges() const {
        std::map<std::set<std::size_t>, std::size_t> counts;
        for (const auto& face : faces) {
            for (std::size_t k = 0; k < face.size(); ++k) ++counts[{face[k], face[(k + 1) % face.size()]}];
        }
        return counts;
    }
    std::size_t edges_of_one_face() const {
        const auto all = edges();
        return static_cast<std::size_t>(
            std::ranges::count_if(all, [](const auto& entry) { return entry.second == 1; }));
    }
};

ReadMesh mesh(const std::string& request) {
    ReadMesh read;
    std::istringstream file(shown(request, &Operation::mesh));
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "#") continue;
        if (kind == "o") {
            words >> read.objects.emplace_back();
        } else if (kind == "v") {
            auto& vertex = read.vertices.emplace_back();
            for (double& coordinate : vertex) words >> coordinate;
            REQUIRE(words);
        } else {
            auto& element = (kind == "f" ? read.faces : read.lines).emplace_back();
            REQUIRE((kind == "f" || kind == "l"));
            for (std::size_t vertex = 0; words >> vertex;) {
                REQUIRE(vertex >= 1);
                REQUIRE(vertex <= read.vertices.size());
                element.push_back(vertex);
            }
        }
    }
    return read;
}

std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

const std::string saddle =
    R"("map": {"kind": "polynomial", "variables": ["x", "y"], "text": "x^2 - y^2/3", "degrees": [2, 2]})";
const std::string triangle = R"("map": {"kind": "simplex", "degree": 1, "vertices": [[1, 0], [3, 0], [0, 2]],
    "control_net": [[[1, 0, 0], [0, 0, 1]], [[0, 1, 0], [1, 0, 2]], [[0, 0, 1], [0, 1, 3]]]})";
const std::string cube = R"("map": {"kind": "tensor", "degrees": [1, 1, 1], "control_net":
    [[[[0, 0, 0], [0, 0, 1]], [[0, 1, 0], [0, 1, 1]]], [[[1, 0, 0], [1, 0, 1]], [[1, 1, 0], [1, 1, 1]]]]})";

}  // namespace

TEST_CASE("a mesh of a graph has the nearest doubles of its exact values, in quadrilaterals of one disc") {
    const ReadMesh read = mesh(R"({"op": "evaluate", "at": [], )" + saddle + "}");
    CHECK(read.objects == std::vector<std::string>{"surface"});
    CHECK(read.vertices.size() == 17 * 17);
    CHECK(read.faces.size() == 16 * 16);
    for (const auto& [x, y, z] : read.vertices) {
        const Rational u = exact_rational(x);
        const Rational v = exact_rational(y);
        CHECK(u * 16 == Rational((u * 16).numerator()));
        CHECK(z == nearest_double(u * u - v * v / 3));
    }
    CHECK(std::ranges::all_of(read.faces, [](const auto& face) { return face.size() == 4; }));
    CHECK(read.euler_characteristic() == 1);
    CHECK(read.edges_of_one_face() == 4 * 16);
}

TEST_CASE("a mesh of a triangle has triangles, that of a solid its surface") {
    const ReadMesh flat = mesh(R"({"op": "control-points", )" + triangle + "}");
    CHECK(flat.vertices.size() == 17 * 18 / 2);
    CHECK(flat.faces.size() == 16 * 16);
    CHECK(std::ranges::all_of(flat.faces, [](const auto& face) { return face.size() == 3; }));
    for (const auto& [x, y, z] : flat.vertices) CHECK(z == 1 + x + 2 * y);
    CHECK(flat.euler_characteristic() == 1);
    CHECK(flat.edges_of_one_face() == 3 * 16);
    const ReadMesh solid = mesh(R"({"op": "control-points", )" + cube + "}");
    CHECK(solid.faces.size() == 6 * 16 * 16);
    CHECK(solid.euler_characteristic() == 2);
    CHECK(solid.edges_of_one_face() == 0);
    const ReadMesh tetrahedron = mesh(
        R"({"op": "control-points", "map": {"kind": "polynomial", "variables": ["x", "y", "z"], "text": ["x", "y", "z"]}})");
    CHECK(tetrahedron.euler_characteristic() == 2);
    CHECK(tetrahedron.edges_of_one_face() == 0);
}

TEST_CASE("every patch of a result is an object of its own, and a curve a polyline") {
    const ReadMesh pieces = mesh(R"({"op": "subdivide", "at": "midpoints", )" + triangle + "}");
    CHECK(pieces.objects == std::vector<std::string>{"surface_1", "surface_2", "surface_3", "surface_4"});
    CHECK(pieces.vertices.size() == 4 * 153);
    CHECK(pieces.euler_characteristic() == 4);
    const ReadMesh curve = mesh(
        R"({"op": "elevate", "by": 1, "map": {"kind": "tensor", "degrees": [1], "control_net": [[0, 1], [4, 3]]}})");
    CHECK(curve.faces.empty());
    REQUIRE(curve.lines.size() == 1);
    CHECK(curve.lines.front().size() == 17);
    for (const auto& [x, y, z] : curve.vertices) CHECK((2 * y == 2 + x && z == 0));
    // The derived map is shown whether or not its values are requested.
    const std::string derivative = R"({"op": "derivative", "direction": [1, 0], )" + saddle;
    CHECK(mesh(derivative + "}").vertices == mesh(derivative + R"(, "at": [[0, 0]]})").vertices);
    for (const auto& [x, y, z] : mesh(derivative + "}").vertices) CHECK(z == 2 * x);
}

TEST_CASE("a rational patch is shown divided by its weights, with a hole where it has no point") {
    // x / (x + y) over the unit triangle has no value at the origin.
    const std::string pole =
        R"("map": {"kind": "polynomial", "variables": ["x", "y"], "text": "x", "denominator": "x + y")";
    for (const std::string& map : {pole + "}", pole + R"(, "homogeneous": true})"}) {
        const ReadMesh read = mesh(R"({"op": "evaluate", "at": [], )" + map + "}");
        CHECK(read.vertices.size() == 152);
        CHECK(read.faces.size() == 255);
        for (const auto& [x, y, z] : read.vertices)
            CHECK(z == nearest_double(exact_rational(x) / (exact_rational(x) + exact_rational(y))));
    }
}

TEST_CASE("what has no mesh is refused with the reason") {
    const auto refusal = [](const std::string& map) {
        return failure([&] { mesh(R"({"op": "evaluate", "at": [], "map": )" + map + "}"); });
    };
    CHECK(refusal(R"({"kind": "tensor", "degrees": [0, 0], "control_net": [[[1, 2, 3, 4]]]})")->code() ==
          ErrorCode::mismatched_dimensions);
    CHECK(refusal(R"({"kind": "polynomial", "variables": ["x", "y", "z"], "text": "x"})")->message() ==
          "the graph of a scalar map over a domain of dimension 3 cannot be shown in space; points have "
          "dimension 2 or 3 there, and a scalar map at most two parameters");
    CHECK(refusal(R"({"kind": "polynomial", "text": "t"})")->code() == ErrorCode::wrong_kind);
    CHECK(refusal(R"({"kind": "tensor", "degrees": [0, 0], "control_net": [["1e400"]]})")->code() ==
          ErrorCode::overflow);
    CHECK(refusal(R"({"kind": "polynomial", "variables": ["a", "b", "c", "d", "e"], "text": ["a", "b"]})")
              ->code() == ErrorCode::limit_exceeded);
}

TEST_CASE("a picture of a patch has its cells, lines, net and marked values, and says what it shows") {
    const std::string text = picture(R"({"op": "evaluate", "at": [["1/2", "1/4"]], )" + saddle + "}");
    CHECK(text.starts_with("<svg "));
    CHECK(text.ends_with("</svg>\n"));
    CHECK(occurrences(text, ">P(x, y) = x^2 - 1/3 y^2</title>") == 1);
    CHECK(occurrences(text, "<polygon") == 16 * 16);
    // The net, and the marked value with its label.
    CHECK(occurrences(text, "<circle") == 9 + 1);
    CHECK(occurrences(text, ">P(1/2, 1/4)<") == 1);
    CHECK(occurrences(text, ">x<") == 1);
    CHECK(occurrences(text, ">y<") == 1);
    const std::string pieces = picture(R"({"op": "subdivide", "at": ["5/3", "1/2"], )" + triangle + "}");
    CHECK(occurrences(pieces, "<polygon") == 3 * 256);
    // The nets of the pieces have the same points as that of the patch.
    CHECK(occurrences(pieces, "<circle") == 4);
    const std::string plane = picture(
        R"({"op": "control-points", "map": {"kind": "polynomial", "variables": ["x", "y"], "text": ["x", "y"]}})");
    CHECK(occurrences(plane, "<polygon") == 256);
    CHECK(occurrences(plane, ">1/5<") == 2);
}

TEST_CASE("what lies in front is painted last") {
    // The unit cube divided at y = 1/2; the first half is in front.
    const std::string text = picture(
        R"({"op": "subdivide", "at": ["1/2", null, null], "map": {"kind": "tensor", "degrees": [1, 1, 1],
            "control_net": [[[[0, 0, 0], [0, 0, 1]], [[1, 0, 0], [1, 0, 1]]],
                            [[[0, 1, 0], [0, 1, 1]], [[1, 1, 0], [1, 1, 1]]]]}})");
    CHECK(occurrences(text, "<polygon") == 2 * 6 * 256);
    const auto is_filled_as = [&](std::size_t polygon, std::size_t surface) {
        const std::string element = text.substr(polygon, text.find("/>", polygon) - polygon);
        for (std::size_t tilt = 0; tilt <= greatest_tilt; ++tilt) {
            if (element.find("fill=\"" + shade(surface, tilt)) != std::string::npos) return true;
        }
        return false;
    };
    CHECK(is_filled_as(text.find("<polygon"), 1));
    CHECK(is_filled_as(text.rfind("<polygon"), 0));
}
