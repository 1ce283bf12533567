#include <blossom/worked/exercise.hpp>
#include <blossom/worked/render.hpp>

#include <set>

#include "support/catch.hpp"
#include "support/failure.hpp"

using namespace blossom;
using namespace blossom::testing;
using namespace blossom::worked;

namespace {

SheetRequest request(std::string_view topic, std::uint64_t seed, std::size_t level, std::size_t count) {
    return {{std::string(topic)}, seed, count, level};
}

/// The text of a sheet with a single problem, without the number of the sheet in the title.
std::string problem_text(Sheet sheet, std::size_t i) {
    Document one;
    one.steps.push_back(sheet.problems.steps[i]);
    std::string text = render_json(one);
    // The number of the problem is appended to names.
    for (const std::string name : {"P", "p", "F", "f"}) {
        const std::string numbered = "\"" + name + std::to_string(i + 1) + "\"";
        for (std::size_t at = text.find(numbered); at != std::string::npos; at = text.find(numbered)) {
            text.replace(at, numbered.size(), "\"" + name + "\"");
        }
    }
    return text;
}

}  // namespace

TEST_CASE("the same seed gives the same sheet, another seed another one") {
    for (const std::string_view topic : exercise_topics()) {
        CAPTURE(topic);
        const auto sheet = [&](std::uint64_t seed) {
            return render_json(exercise_sheet(request(topic, seed, 2, 3)).solutions);
        };
        CHECK(sheet(5) == sheet(5));
        CHECK(sheet(5) != sheet(6));
    }
}

TEST_CASE("a sheet has the requested number of different problems, each with its solution") {
    for (const std::string_view topic : exercise_topics()) {
        for (std::size_t level = 1; level <= 3; ++level) {
            CAPTURE(topic, level);
            const Sheet sheet = exercise_sheet(request(topic, 11, level, 12));
            REQUIRE(sheet.problems.steps.size() == 12);
            REQUIRE(sheet.solutions.steps.size() == 12);
            std::set<std::string> problems;
            for (std::size_t i = 0; i < 12; ++i) problems.insert(problem_text(sheet, i));
            CHECK(problems.size() == 12);
            CHECK_FALSE(sheet.problems.check.has_value());
        }
    }
}

namespace {

/// Twice the area of a triangle in the plane.
Rational area(const Coordinates& p, const Coordinates& q, const Coordinates& r) {
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

/// The point in the plane, after a division by the weight if there is one.
Coordinates in_plane(const Coordinates& point) {
    if (point.size() == 2) return point;
    return {point[0] / point[2], point[1] / point[2]};
}

bool is_bent(const std::vector<Coordinates>& points) {
    for (std::size_t i = 0; i + 2 < points.size(); ++i) {
        if (area(in_plane(points[i]), in_plane(points[i + 1]), in_plane(points[i + 2])).is_zero())
            return false;
    }
    return true;
}

/// Checks that a problem is not trivial: no leading coefficient is zero, and no polygon lies on a line.
struct HasWork {
    bool operator()(const PolynomialCurve& curve) const {
        return !curve.coordinate(0)[curve.degree()].is_zero();
    }
    bool operator()(const BezierCurve& curve) const { return is_bent(curve.control_points().to_points()); }
    bool operator()(const PolynomialMap& map) const { return std::visit(*this, map); }
    bool operator()(const BSplineCurve& curve) const { return is_bent(curve.control_points()); }
    bool operator()(const TriangleMap& map) const {
        const auto net = map.net.control_net().to_points();
        const std::size_t n = map.net.shape()[0].degree;
        return !area(net.front(), net[net.size() - n - 1], net.back()).is_zero();
    }
    bool operator()(const SymbolicMap&) const { return true; }
};

}  // namespace

TEST_CASE("no problem of many sheets is degenerate") {
    for (const std::string_view topic : exercise_topics()) {
        for (std::uint64_t seed = 0; seed < 40; ++seed) {
            CAPTURE(topic, seed);
            const Sheet sheet = exercise_sheet(request(topic, seed, 1 + seed % 3, 3));
            REQUIRE(sheet.problems.maps.size() == 3);
            for (const NamedMap& map : sheet.problems.maps) CHECK(std::visit(HasWork(), map.definition));
        }
    }
}

TEST_CASE("sheets that cannot be made are refused") {
    CHECK(failure_code([] { exercise_sheet(request("algebra", 1, 1, 1)); }) == ErrorCode::unknown_op);
    CHECK(failure_code([] { exercise_sheet(request("blossom", 1, 4, 1)); }) == ErrorCode::wrong_arity);
    CHECK(failure_code([] { exercise_sheet(request("blossom", 1, 0, 1)); }) == ErrorCode::wrong_arity);
    CHECK(failure_code([] { exercise_sheet(request("blossom", 1, 1, 41)); }) == ErrorCode::limit_exceeded);
}

TEST_CASE("a sheet has problems on all its topics in turn, and topics have their own numbers") {
    const std::vector<std::string> topics{"evaluation", "subdivision", "degree-raising"};
    const Sheet sheet = exercise_sheet({topics, 3, 7, 1});
    REQUIRE(sheet.problems.steps.size() == 7);
    CHECK(sheet.problems.title == "De Casteljau's algorithm, Subdivision, Degree raising, level 1, sheet 3");
    // Each topic has its own problems, whatever stands between them.
    const Sheet single = exercise_sheet({{"subdivision"}, 3, 2, 1});
    for (std::size_t i = 0; i < 2; ++i) {
        const auto points = [](const Document& document, std::size_t map) {
            return std::get<BezierCurve>(std::get<PolynomialMap>(document.maps.at(map).definition))
                .control_points();
        };
        CHECK(points(sheet.problems, 3 * i + 1) == points(single.problems, i));
        CHECK(points(sheet.problems, 3 * i) != points(sheet.problems, 3 * i + 1));
        CHECK(points(sheet.problems, 3 * i + 1) != points(sheet.problems, 3 * i + 2));
    }
    CHECK(failure_code([] { exercise_sheet({{"evaluation", "nonsense"}, 1, 5, 1}); }) ==
          ErrorCode::unknown_op);
    CHECK(failure_code([] { exercise_sheet({{}, 1, 5, 1}); }) == ErrorCode::wrong_arity);
    CHECK(failure_code([&] { exercise_sheet({topics, 1, 2, 1}); }) == ErrorCode::wrong_arity);
}
