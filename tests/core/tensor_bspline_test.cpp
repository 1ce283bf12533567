#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/nurbs/rational_curve.hpp>
#include <blossom/core/patch/tensor_bspline.hpp>
#include <blossom/core/patch/tensor_bspline_change.hpp>
#include "core_test.hpp"

// B-spline surfaces and volumes, compared with the definition by basis functions.

namespace {

/// The B-spline basis function j of degree n over textbook knots, by the recursion of Cox and de Boor.
Rational basis(const std::vector<Rational>& t, std::size_t j, std::size_t n, const Rational& x,
               std::size_t span) {
    if (n == 0) return j == span ? 1 : 0;
    Rational sum;
    if (t[j + n] != t[j]) sum += (x - t[j]) / (t[j + n] - t[j]) * basis(t, j, n - 1, x, span);
    if (t[j + n + 1] != t[j + 1])
        sum += (t[j + n + 1] - x) / (t[j + n + 1] - t[j + 1]) * basis(t, j + 1, n - 1, x, span);
    return sum;
}

/// Points of two coordinates.
TensorBSpline random_surface(Random& random, const std::vector<KnotVector>& knots) {
    std::size_t count = 1;
    for (const KnotVector& own : knots) count *= own.points();
    std::vector<Coordinates> points;
    for (std::size_t i = 0; i < count; ++i)
        points.push_back({small_rational(random), small_rational(random)});
    return {knots, points};
}

Coordinates definition(const TensorBSpline& surface, const std::vector<Rational>& at) {
    Coordinates sum(surface.dimension());
    for (std::size_t i = 0; i < surface.control_points().size(); ++i) {
        Rational weight = 1;
        std::size_t rest = i;
        for (std::size_t d = surface.directions(); d-- > 0;) {
            const KnotVector& knots = surface.knots(d);
            weight *=
                basis(knots.knots(), rest % knots.points(), knots.degree(), at[d], knots.span_at(at[d]));
            rest /= knots.points();
        }
        for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += weight * surface.control_points()[i][j];
    }
    return sum;
}

const KnotVector cubic(3, {0, 0, 0, 0, 1, Rational(3, 2), Rational(3, 2), 4, 4, 4, 4}, 7);
const KnotVector quadratic(2, {-1, 0, Rational(1, 3), 1, 2, 3, 5}, 4);
const KnotVector linear(1, {0, 0, 1, 2, 2}, 3);

const std::vector<std::vector<KnotVector>> shapes{
    {cubic}, {cubic, quadratic}, {quadratic, cubic}, {linear, quadratic, linear}};

Rational in_domain(Random& random, const KnotVector& knots) {
    const Interval domain = knots.domain();
    const Rational share(random.between(0, 8), 8);
    return domain.a() + share * (domain.b() - domain.a());
}

}  // namespace

TEST_CASE("tensor B-splines: values are those of the basis functions, at knots and ends too") {
    Random random(851);
    for (const auto& knots : shapes) {
        const TensorBSpline surface = random_surface(random, knots);
        for (int round = 0; round < 12; ++round) {
            std::vector<Rational> at;
            for (const KnotVector& own : knots) at.push_back(in_domain(random, own));
            CHECK(evaluate(surface, at) == definition(surface, at));
        }
    }
}

TEST_CASE("tensor B-splines: control points are blossom values at consecutive knots in every direction") {
    Random random(852);
    const TensorBSpline surface = random_surface(random, {cubic, quadratic});
    for (const std::size_t s : cubic.spans()) {
        for (const std::size_t t : quadratic.spans()) {
            for (std::size_t i = cubic.first_point(s); i <= cubic.first_point(s) + 3; ++i) {
                for (std::size_t j = quadratic.first_point(t); j <= quadratic.first_point(t) + 2; ++j) {
                    const auto u = cubic.window(i), v = quadratic.window(j);
                    const std::vector<std::vector<Argument>> arguments{{u.begin(), u.end()},
                                                                       {v.begin(), v.end()}};
                    CHECK(segment_blossom(surface, std::vector{s, t}, arguments) ==
                          surface.control_points()[i * 4 + j]);
                }
            }
        }
    }
    const std::vector<std::vector<Argument>> few{{}, {}};
    CHECK(failure_code([&] { segment_blossom(surface, std::vector<std::size_t>{3, 2}, few); }) ==
          ErrorCode::wrong_arity);
    CHECK(failure_code([&] { segment_blossom(surface, std::vector<std::size_t>{0, 2}, few); }) ==
          ErrorCode::outside_domain);
}

TEST_CASE(
    "tensor B-splines: knots in a direction leave the map as it is, and in both orders the same points") {
    Random random(853);
    const TensorBSpline surface = random_surface(random, {cubic, quadratic});
    const std::vector<Rational> in_u{Rational(1, 2), 1, 3}, in_v{1, Rational(1, 2), Rational(1, 2)};
    const TensorBSpline finer = insert_knots(insert_knots(surface, 0, in_u), 1, in_v);
    CHECK(finer == insert_knots(insert_knots(surface, 1, in_v), 0, in_u));
    CHECK(finer.knots(0).points() == 10);
    CHECK(finer.knots(1).points() == 7);
    for (int round = 0; round < 12; ++round) {
        const std::vector<Rational> at{in_domain(random, cubic), in_domain(random, quadratic)};
        CHECK(evaluate(finer, at) == definition(surface, at));
    }
    const std::vector<Rational> outside{5};
    CHECK(failure_code([&] { insert_knots(surface, 0, outside); }) == ErrorCode::outside_domain);
    Limits limits;
    limits.numbers = 60;
    CHECK(failure_code([&] { insert_knots(surface, 0, in_u, limits); }) == ErrorCode::limit_exceeded);
}

TEST_CASE("tensor B-splines: a segment as a Bezier patch, and its derivatives") {
    Random random(854);
    for (const auto& knots : shapes) {
        const TensorBSpline surface = random_surface(random, knots);
        for (int round = 0; round < 6; ++round) {
            std::vector<Rational> at;
            std::vector<std::size_t> spans, orders;
            for (const KnotVector& own : knots) {
                at.push_back(in_domain(random, own));
                spans.push_back(own.span_at(at.back()));
                orders.push_back(random.below(3));
            }
            const BezierPatch patch = bezier_segment(surface, spans);
            const std::vector<Interval> box = box_of(surface, spans);
            PatchPoint point;
            PatchArguments directions;
            for (std::size_t d = 0; d < at.size(); ++d) {
                const Rational length = box[d].b() - box[d].a();
                const Rational s = (at[d] - box[d].a()) / length;
                point.push_back({1 - s, s});
                directions.emplace_back(orders[d], Coordinates{-1 / length, 1 / length});
            }
            CHECK(evaluate(patch, point) == definition(surface, at));
            CHECK(derivative(surface, orders, at) == derivative(patch, directions, point));
        }
    }
}

TEST_CASE("tensor B-splines: a quarter of a cylinder, rational and exact") {
    const KnotVector arc(2, {0, 0, 0, 1, 1, 1}, 3), height(1, {0, 0, 1, 1}, 2);
    std::vector<Coordinates> points;
    for (const Coordinates& xyw : {Coordinates{1, 0, 1}, {1, 1, 1}, {0, 2, 2}}) {
        for (const int z : {0, 3}) points.push_back({xyw[0], xyw[1], Rational(z) * xyw[2], xyw[2]});
    }
    const TensorBSpline cylinder({arc, height}, points);
    for (int i = 0; i <= 5; ++i) {
        const Coordinates value = projected(evaluate(cylinder, std::vector{Rational(i, 5), Rational(1, 3)}));
        CHECK(value[0] * value[0] + value[1] * value[1] == 1);
        CHECK(value[2] == 1);
    }
}

TEST_CASE("tensor B-splines: raised, split, restricted and extracted, they are the same map") {
    Random random(855);
    for (const auto& knots : shapes) {
        const TensorBSpline surface = random_surface(random, knots);
        const std::size_t d = random.below(knots.size());
        const Interval domain = knots[d].domain();
        const Rational u = domain.a() + Rational(1, 3) * (domain.b() - domain.a());
        const TensorBSpline raised = elevate(surface, d, 2);
        CHECK(raised.knots(d).degree() == knots[d].degree() + 2);
        CHECK(elevate(surface, d, 0) == surface);
        const auto [left, right] = split(surface, d, u);
        CHECK(left.knots(d).domain() == Interval(domain.a(), u));
        const TensorBSpline part = restricted(surface, d, {u, domain.b()});
        CHECK(part == right);
        for (int round = 0; round < 12; ++round) {
            std::vector<Rational> at;
            for (const KnotVector& own : knots) at.push_back(in_domain(random, own));
            const Coordinates expected = definition(surface, at);
            CHECK(evaluate(raised, at) == expected);
            CHECK(evaluate(at[d] < u ? left : right, at) == expected);
            std::vector<std::size_t> spans = spans_at(surface, at);
            const PlacedPatch piece = placed_segment(surface, spans);
            PatchPoint point;
            for (std::size_t k = 0; k < at.size(); ++k)
                point.push_back(piece.frames[k].of_point(std::span(&at[k], 1)));
            CHECK(evaluate(piece.patch, point) == expected);
            // A Bezier patch is a spline of one box.
            CHECK(evaluate(bspline_of(piece), at) == expected);
        }
    }
}

TEST_CASE("tensor B-splines: the boxes are all combinations of spans") {
    Random random(856);
    const TensorBSpline surface = random_surface(random, {quadratic, linear});
    CHECK(boxes_of(surface) == std::vector<std::vector<std::size_t>>{{2, 1}, {2, 2}, {3, 1}, {3, 2}});
    Limits limits;
    limits.numbers = 4 * 6 * 2 - 1;
    CHECK(failure_code([&] { boxes_of(surface, limits); }) == ErrorCode::limit_exceeded);
    ++limits.numbers;
    CHECK(boxes_of(surface, limits).size() == 4);
}

TEST_CASE("tensor B-splines: the spline of a partial derivative has its values") {
    Random random(857);
    for (const auto& knots : shapes) {
        const TensorBSpline surface = random_surface(random, knots);
        for (int round = 0; round < 6; ++round) {
            std::vector<Rational> at;
            std::vector<std::size_t> orders;
            for (const KnotVector& own : knots) {
                at.push_back(in_domain(random, own));
                orders.push_back(random.below(3));
            }
            CHECK(evaluate(derivative_spline(surface, orders), at) == derivative(surface, orders, at));
        }
    }
}

TEST_CASE("tensor B-splines: a patch over a reversed box becomes one over increasing knots") {
    const PlacedPatch reversed{BezierPatch(NetShape::tensor(std::vector<std::size_t>{2, 0}),
                                           std::vector<Coordinates>{{1}, {2}, {5}}),
                               {BarycentricFrame({{3}, {1}}), BarycentricFrame({{0}, {1}})}};
    const TensorBSpline spline = bspline_of(reversed);
    CHECK(spline.control_points() == std::vector<Coordinates>{{5}, {2}, {1}});
    CHECK(spline.knots(0).knots() == std::vector<Rational>{1, 1, 1, 3, 3, 3});
    const PlacedPatch triangle{BezierPatch(NetShape::simplex(2, 0), std::vector<Coordinates>{{1}}),
                               {BarycentricFrame::standard(2)}};
    CHECK(failure_code([&] { bspline_of(triangle); }) == ErrorCode::mismatched_dimensions);
}

TEST_CASE("tensor B-splines: what does not fit is refused") {
    CHECK(failure_code([] { TensorBSpline({}, {{1}}); }) == ErrorCode::wrong_arity);
    CHECK(failure_code([] { TensorBSpline({linear}, {{1}, {2}}); }) == ErrorCode::wrong_arity);
    CHECK(failure_code([] { TensorBSpline({linear}, {{1}, {2}, {3, 4}}); }) ==
          ErrorCode::mismatched_dimensions);
    const TensorBSpline line({linear}, {{1}, {2}, {3}});
    CHECK(failure([&] { evaluate(line, std::vector<Rational>{7}); })->place() == Part::at / 0);
    CHECK(failure_code([&] { evaluate(line, std::vector<Rational>{1, 1}); }) == ErrorCode::wrong_arity);
}
