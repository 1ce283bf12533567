#include <stdexcept>
#include "core_test.hpp"

// A web article on de Casteljau's algorithm and blossoms: its statements that the identity language cannot
// express.

namespace {

/// The program of the article: level r has `entries(r)` entries, and reading beyond a level raises an error
/// as in Python.
Coordinates recursion(std::size_t r, const Coordinates& a, const Rational& t,
                      const std::function<std::size_t(std::size_t)>& entries) {
    if (r == 0) return a;
    const Coordinates below = recursion(r - 1, a, t, entries);
    Coordinates level;
    for (std::size_t i = 0; i < entries(r); ++i) level.push_back((1 - t) * below.at(i) + t * below.at(i + 1));
    return level;
}

}  // namespace

TEST_CASE("blog-dimension: the dimension is not the degree: any dimension will do, as for a planar cubic",
          "[statement]") {
    const BezierCurve planar_cubic(std::vector<Coordinates>{{0, 0}, {0, 1}, {1, 1}, {1, 0}});
    CHECK(planar_cubic.degree() == 3);
    CHECK(planar_cubic.dimension() == 2);
    CHECK(evaluate(planar_cubic, Rational(1, 2)) == Coordinates{Rational(1, 2), Rational(3, 4)});
    for (std::size_t k = 1; k <= 6; ++k) {
        const BezierCurve line(std::vector<Coordinates>(2, Coordinates(k, 1)));
        CHECK(evaluate(line, Rational(1, 3)) == Coordinates(k, 1));
    }
}

TEST_CASE("blog-py-decasteljau: range(n) reads past the end for n >= 2; range(n-r+1) gives C(t)",
          "[statement]") {
    // The printed base case `return a[i]` uses an undefined i; the loop is also wrong if the base case
    // returns the whole array.
    Random random(381);
    for (std::size_t n = 0; n <= 6; ++n) {
        Coordinates a;
        std::vector<Coordinates> control_points;
        for (std::size_t i = 0; i <= n; ++i) {
            a.push_back(number(random, Size::small));
            control_points.push_back({a.back()});
        }
        const Rational t = number(random, Size::small);
        const Coordinates expected = evaluate(BezierCurve(control_points), t);
        const auto printed = [&] { return recursion(n, a, t, [&](std::size_t) { return n; }); };
        if (n >= 2) {
            CHECK_THROWS_AS(printed(), std::out_of_range);
        } else {
            CHECK(printed().front() == expected[0]);
        }
        CHECK(recursion(n, a, t, [&](std::size_t r) { return n - r + 1; }) == expected);
    }
}
