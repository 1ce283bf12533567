#include "curve/rounded_polygon.hpp"

#include "support/catch.hpp"
#include "support/random.hpp"

using namespace blossom;
using blossom::testing::Random;

namespace {

using Polygon = std::vector<Integer>;

std::size_t exact_changes(const Polygon& polygon) {
    std::size_t changes = 0;
    int last = 0;
    for (const Integer& point : polygon) {
        if (point.sign() == 0) continue;
        if (last != 0 && point.sign() != last) ++changes;
        last = point.sign();
    }
    return changes;
}

/// Both halves of a polygon, multiplied by 2^n.
std::pair<Polygon, Polygon> exact_halves(Polygon points) {
    const std::size_t n = points.size() - 1;
    Polygon left;
    Polygon right(n + 1);
    for (std::size_t level = 0; level <= n; ++level) {
        left.push_back(points[0] << (n - level));
        right[n - level] = points[n - level] << (n - level);
        for (std::size_t i = 0; i + level < n; ++i) points[i] += points[i + 1];
    }
    return {left, right};
}

void check(const Polygon& exact, const RoundedPolygon& rounded) {
    const auto [least, most] = rounded.sign_changes();
    const std::size_t changes = exact_changes(exact);
    CHECK(least <= changes);
    CHECK(changes <= most);
}

}  // namespace

TEST_CASE("short polygons are exact") {
    const auto changes = RoundedPolygon(Polygon{-5, 3, 4, -2, 7}).sign_changes();
    CHECK(changes.least == 3);
    CHECK(changes.most == 3);
}

TEST_CASE("points whose sign is lost widen the bounds") {
    const Integer large = Integer(1) << 300;
    const auto changes = RoundedPolygon(Polygon{large, 1, -1, large}).sign_changes();
    CHECK(changes.least == 0);
    CHECK(changes.most == 2);
    const auto between = RoundedPolygon(Polygon{large, 1, -large}).sign_changes();
    CHECK(between.least == 1);
    CHECK(between.most == 1);
    const auto at_ends = RoundedPolygon(Polygon{1, large, large, -1}).sign_changes();
    CHECK(at_ends.least == 0);
    CHECK(at_ends.most == 2);
}

TEST_CASE("the bounds hold through many halvings") {
    Random random(4);
    for (int round = 0; round < 60; ++round) {
        const std::size_t n = 1 + random.below(24);
        const std::size_t shift = random.below(3) * 60;
        Polygon exact;
        for (std::size_t i = 0; i <= n; ++i)
            exact.push_back(Integer(random.between(-1000, 1000)) << random.below(shift + 1));
        RoundedPolygon rounded(exact);
        check(exact, rounded);
        for (int step = 0; step < 30; ++step) {
            auto [left, right] = std::move(rounded).halves();
            auto [exact_left, exact_right] = exact_halves(exact);
            check(exact_left, left);
            check(exact_right, right);
            const bool goes_left = random.one_in(2);
            rounded = goes_left ? std::move(left) : std::move(right);
            exact = goes_left ? std::move(exact_left) : std::move(exact_right);
        }
    }
}
