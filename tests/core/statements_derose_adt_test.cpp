#include <blossom/core/geometry/coordinate_free_blossom.hpp>
#include "core_test.hpp"

// DeRose, Goldman, Lounsbery: A Tutorial Introduction to Blossoming (1991), section 6: the algorithms of the
// field are evaluations of one abstract data type. Each algorithm of the engine is compared with the blossom
// of its curve at the right arguments.

namespace {

/// A cubic spline with unrelated knots, and the blossoms of its segments.
struct Spline {
    geometry::Space line{1, "line"};
    geometry::Space plane{2, "plane"};
    KnotVector knots{3, {0, 0, 0, 1, Rational(3, 2), 4, 4, 5, 7, 7}, 6};
    std::vector<geometry::Point> points;
    std::vector<Coordinates> coordinates;

    Spline() {
        Random random(921);
        for (int j = 0; j < 6; ++j) {
            coordinates.push_back({small_rational(random), small_rational(random)});
            points.push_back(plane.point(coordinates.back()));
        }
    }

    BSplineCurve curve() const { return {knots, coordinates}; }
    geometry::Blossom blossom(std::size_t span) const {
        return geometry::Blossom::from_bspline(line, knots, points, span);
    }
    Coordinates value(std::size_t span, const std::vector<Rational>& parameters) const {
        std::vector<geometry::Point> arguments;
        for (const Rational& parameter : parameters) arguments.push_back(line.point({parameter}));
        return blossom(span)(arguments).coordinates();
    }
};

}  // namespace

TEST_CASE("derose-adt-list", "[statement]") {
    const Spline spline;
    const BSplineCurve curve = spline.curve();
    for (const std::size_t span : spline.knots.spans()) {
        const Rational a = spline.knots[span], b = spline.knots[span + 1];
        const Rational t = (Rational(2) * a + b) / 3;
        // De Boor: all arguments t.
        CHECK(de_boor(curve, t) == spline.value(span, {t, t, t}));
        // Sablonniere: the Bezier points of the segment.
        const BezierCurve bezier = sablonniere(curve, span);
        CHECK(bezier.control_points().to_points() ==
              std::vector<Coordinates>{spline.value(span, {a, a, a}), spline.value(span, {a, a, b}),
                                       spline.value(span, {a, b, b}), spline.value(span, {b, b, b})});
        // De Casteljau, and Bezier subdivision.
        CHECK(casteljau_pyramid(bezier, with_copies({}, 3, Parameter(t))).apex() ==
              spline.value(span, {t, t, t}));
        const auto [left, right] = subdivide(bezier, t);
        CHECK(left.control_points()[2] == spline.value(span, {a, t, t}));
        CHECK(right.control_points()[1] == spline.value(span, {t, t, b}));
        // Boehm and Oslo: the values at the windows of the new knots that contain t.
        const std::vector<Rational> inserted{t, t};
        for (const BSplineCurve& finer :
             {insert_knots_boehm(curve, inserted), insert_knots_oslo(curve, inserted)}) {
            for (std::size_t j = 0; j < finer.knots().points(); ++j) {
                const auto window = finer.knots().window(j);
                if (std::ranges::find(window, t) == window.end()) continue;
                CHECK(finer.control_points()[j] == spline.value(span, {window.begin(), window.end()}));
            }
        }
    }
}
