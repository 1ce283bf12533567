#include "drawing/label_placement.hpp"
#include "drawing/drawing.hpp"

#include "support/catch.hpp"
#include "support/random.hpp"

using namespace blossom::worked;
using blossom::Rational;
using blossom::testing::Random;

TEST_CASE("a segment crosses a box exactly when it enters its inside") {
    const Box box{10, 10, 20, 20};
    CHECK(crosses({{0, 0}, {30, 30}}, box));
    CHECK(crosses({{15, 15}, {16, 16}}, box));
    CHECK(crosses({{0, 15}, {30, 15}}, box));
    CHECK_FALSE(crosses({{0, 10}, {30, 10}}, box));
    CHECK_FALSE(crosses({{0, 0}, {9, 30}}, box));
    CHECK_FALSE(crosses({{0, 11}, {11, 0}}, box));
    CHECK_FALSE(crosses({{15, 22}, {30, 18}}, box));
}

TEST_CASE("labels of separate points cover neither each other nor a point, and stay on the paper") {
    Random random(601);
    const Box paper{0, 0, 5000, 4000};
    for (int round = 0; round < 60; ++round) {
        std::vector<LabelSize> labels;
        for (std::size_t i = 0; i < 10; ++i) {
            labels.push_back({{static_cast<Length>(700 + random.below(3600)),
                               static_cast<Length>(500 + random.below(3000))},
                              800,
                              180});
        }
        std::vector<Segment> segments;
        for (std::size_t i = 0; i + 1 < labels.size(); ++i)
            segments.push_back({labels[i].anchor, labels[i + 1].anchor});
        const auto placed = place_labels(labels, segments, paper);
        REQUIRE(placed.size() == labels.size());
        CAPTURE(round);
        for (std::size_t i = 0; i < placed.size(); ++i) {
            const Box& box = placed[i].box;
            CHECK((box.left >= 0 && box.top >= 0 && box.right <= 5000 && box.bottom <= 4000));
            CHECK(box.right - box.left == 800);
            for (std::size_t j = 0; j < placed.size(); ++j) {
                if (j != i) CHECK_FALSE(overlap(box, placed[j].box));
                const Spot& spot = labels[j].anchor;
                CHECK_FALSE(overlap(box, {spot.x - 40, spot.y - 40, spot.x + 40, spot.y + 40}));
            }
        }
    }
}

TEST_CASE("a label beside a lone line is off the line") {
    const std::vector<Segment> segments{{{0, 2000}, {5000, 2000}}};
    const auto placed = place_labels({{{2500, 2000}, 800, 180}}, segments, {0, 0, 5000, 4000});
    CHECK_FALSE(crosses(segments.front(), placed.front().box));
    CHECK_FALSE(placed.front().away);
}

TEST_CASE("only points at one place are equal in a label") {
    const auto label = [](const Picture& picture) {
        const Drawing drawing = drawn(picture, {});
        return to_text(label_formula(drawing.labels.front()));
    };
    Picture picture;
    picture.lines.push_back({{{0, 0}, {1'000'000, 0}}, Role::control});
    const auto point = [](const Rational& x, const char* name) { return PicturePoint{{x, 0}, symbol(name)}; };
    picture.points = {point(0, "A"), point(0, "B"), point(1, "C"),
                      point(0, "A"), point(1, "D"), point(2, "E")};
    CHECK(label(picture) == "A = B, C = D, E");
    picture.points.erase(picture.points.begin() + 1, picture.points.end());
    CHECK(label(picture) == "A");

    // Points in space that are projected to one place are not equal, nor are values with one mean of
    // arguments.
    picture.points.push_back(point(0, "B"));
    CHECK(label(picture) == "A = B");
    Picture projected = picture;
    projected.projection = {{1, 0, 0}, {0, 1, 0}};
    CHECK(label(projected) == "A, B");
    picture.corners = {{0, 0}, {1, 0}, {0, 1}};
    CHECK(label(picture) == "A, B");
}

TEST_CASE("the numbers on an axis are exact") {
    Picture picture;
    picture.graph = true;
    picture.lines.push_back({{{1'000'000'000, 0}, {1'000'000'001, 7}}, Role::control});
    std::vector<std::string> horizontal;
    for (const Drawing::Tick& tick : drawn(picture, {}).ticks) {
        if (tick.horizontal) horizontal.push_back(tick.text);
    }
    CHECK(horizontal == std::vector<std::string>{"1000000000", "1000000000.5", "1000000001"});
}
