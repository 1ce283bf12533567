#include <blossom/core/curve/roots.hpp>
#include "core_test.hpp"

// Goldman, Lecture 26, exercise 11: the roots of a polynomial in [a, b] from its Bezier graph (t, P(t)), by
// subdivision, for random products of known factors. The graph is subdivided by blossom values, and the
// result is compared with the engine's kernel.

namespace {

const Polynomial t = Polynomial::monomial(1);

BezierCurve graph(const Polynomial& polynomial, const Interval& over) {
    return control_points(PolynomialCurve(std::vector<Polynomial>{t, polynomial}), over);
}

/// The number of crossings of the control polygon of a graph and the axis.
std::size_t crossings(const BezierCurve& curve) {
    std::vector<int> signs;
    for (const Coordinates& point : curve.control_points().to_points()) {
        if (!point[1].is_zero()) signs.push_back(point[1].sign());
    }
    std::size_t changes = 0;
    for (std::size_t i = 0; i + 1 < signs.size(); ++i) changes += signs[i] != signs[i + 1] ? 1U : 0U;
    return changes;
}

/// Subdivides at the midpoint until every polygon crosses the axis at most once. Returns the intervals with
/// one crossing, and in `met` the roots at which the polygon was subdivided.
std::vector<Interval> isolated(const BezierCurve& curve, std::vector<Rational>& met) {
    const std::size_t changes = crossings(curve);
    if (changes == 0) return {};
    if (changes == 1) return {curve.interval()};
    const Rational middle = (curve.interval().a() + curve.interval().b()) / 2;
    const auto [left, right] = subdivide(curve, middle);
    std::vector<Interval> intervals = isolated(left, met);
    if (right.control_points()[0][1].is_zero()) met.push_back(middle);
    const std::vector<Interval> behind = isolated(right, met);
    intervals.insert(intervals.end(), behind.begin(), behind.end());
    return intervals;
}

/// A polynomial with its rational roots; its quadratic factors have no real roots.
struct Known {
    Polynomial polynomial = 1;
    std::vector<Rational> roots;

    Known(Random& random, bool simple) {
        for (std::uint64_t factors = 1 + random.below(6); factors > 0; --factors) {
            const Rational root = number(random, Size::small);
            if (random.one_in(4)) {
                polynomial *= (t - Polynomial(root)) * (t - Polynomial(root)) + Polynomial(Rational(1, 7));
            } else if (!simple || std::ranges::find(roots, root) == roots.end()) {
                polynomial *= t - Polynomial(root);
                roots.push_back(root);
            }
        }
    }

    /// The roots strictly between the ends, with multiplicities.
    std::size_t inside(const Interval& over) const {
        const auto& [low, high] = std::minmax(over.a(), over.b());
        return static_cast<std::size_t>(
            std::ranges::count_if(roots, [&](const Rational& root) { return low < root && root < high; }));
    }
};

}  // namespace

TEST_CASE(
    "goldman-ex-11: the polygon crosses the axis as often as the graph, or an even number of times more",
    "[statement]") {
    Random random(421);
    std::size_t more = 0;
    for (int i = 0; i < 400; ++i) {
        const Known known(random, false);
        const Interval over = interval(random, Size::small);
        CAPTURE(known.polynomial, over.a(), over.b());
        const std::size_t changes = crossings(graph(known.polynomial, over));
        const std::size_t count = known.inside(over);
        CHECK(changes >= count);
        CHECK((changes - count) % 2 == 0);
        if (changes > count) ++more;
    }
    CHECK(more > 20);
}

TEST_CASE(
    "goldman-ex-11 by subdivision: the pieces that cross once hold one root each, as many as the engine "
    "finds",
    "[statement]") {
    Random random(422);
    for (int i = 0; i < 120; ++i) {
        const Known known(random, true);
        const Rational a = number(random, Size::small);
        const Interval over(a, a + 1 + abs(number(random, Size::small)));
        CAPTURE(known.polynomial, over.a(), over.b());
        std::vector<Rational> met;
        const std::vector<Interval> intervals = isolated(graph(known.polynomial, over), met);
        CHECK(intervals.size() + met.size() == known.inside(over));
        for (const Interval& piece : intervals) CHECK(known.inside(piece) == 1);
        for (const Rational& root : met) CHECK(known.polynomial(root).is_zero());
        std::size_t found = 0;
        for (const Root& root : roots(known.polynomial, over)) {
            if (over.a() < root.lower && root.upper < over.b()) ++found;
        }
        CHECK(found == known.inside(over));
    }
}
