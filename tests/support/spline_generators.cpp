#include "spline_generators.hpp"

#include <algorithm>

#include "number_generators.hpp"

namespace blossom::testing {

namespace {

Rational step(Random& random, Size size) {
    if (random.one_in(2)) return 1;
    Rational length = abs(number(random, size));
    return length.is_zero() ? Rational(1, 2) : length;
}

/// `outer` knots on one side of an end, in order away from it, with `direction` -1 or 1. No multiplicity
/// exceeds degree + 1.
std::vector<Rational> outer_knots(Random& random, Ends ends, const Rational& end, int direction,
                                  std::size_t outer, std::size_t degree, Size size) {
    std::size_t copies = 0;
    if (ends == Ends::clamped) copies = outer;
    if (ends == Ends::repeated) copies = random.below(outer + 1);
    std::vector<Rational> knots(copies, end);
    Rational knot = end;
    std::size_t repeated = degree + 1;
    while (knots.size() < outer) {
        if (repeated > degree || !random.one_in(3)) {
            knot += Rational(direction) * step(random, size);
            repeated = 0;
        }
        ++repeated;
        knots.push_back(knot);
    }
    return knots;
}

}  // namespace

textbook::Spline oracle(const BSplineCurve& curve) {
    return textbook::with_end_knots(curve.degree(), curve.knots().knots(), curve.control_points());
}

SplineRecipe spline(Random& random, std::size_t degree, std::span<const std::size_t> inner_multiplicities,
                    KnotConvention convention, Ends begin, Ends end, Size size) {
    const std::size_t outer = convention == KnotConvention::textbook ? degree : degree - 1;
    SplineRecipe recipe{degree, {}, {}};
    Rational knot = number(random, size);
    recipe.knots = outer_knots(random, begin, knot, -1, outer, degree, size);
    std::ranges::reverse(recipe.knots);
    recipe.knots.push_back(knot);
    for (const std::size_t multiplicity : inner_multiplicities) {
        knot += step(random, size);
        recipe.knots.insert(recipe.knots.end(), multiplicity, knot);
    }
    knot += step(random, size);
    recipe.knots.push_back(knot);
    const std::vector<Rational> behind = outer_knots(random, end, knot, 1, outer, degree, size);
    recipe.knots.insert(recipe.knots.end(), behind.begin(), behind.end());

    const std::size_t points = convention == KnotConvention::textbook ? recipe.knots.size() - degree - 1
                                                                      : recipe.knots.size() + 1 - degree;
    const std::size_t dimension = 1 + random.below(3);
    for (std::size_t i = 0; i < points; ++i) {
        Coordinates& point = recipe.points.emplace_back();
        for (std::size_t j = 0; j < dimension; ++j) {
            point.push_back(random.one_in(4) ? Rational() : number(random, size));
        }
    }
    return recipe;
}

SplineRecipe spline(Random& random, std::size_t degree, Size size) {
    std::vector<std::size_t> multiplicities(random.below(8));
    for (std::size_t& multiplicity : multiplicities) {
        multiplicity = random.one_in(2) ? 1 : 1 + random.below(degree + 1);
    }
    const bool polar = degree > 0 && random.one_in(2);
    const auto ends = [&] { return static_cast<Ends>(random.below(3)); };
    const Ends begin = ends();
    return spline(random, degree, multiplicities, polar ? KnotConvention::polar : KnotConvention::textbook,
                  begin, ends(), size);
}

void for_each_pattern(std::size_t most, std::size_t greatest,
                      const std::function<void(std::span<const std::size_t>)>& visit) {
    for (std::size_t length = 0; length <= most; ++length) {
        std::vector<std::size_t> pattern(length, 1);
        while (true) {
            visit(pattern);
            std::size_t i = 0;
            while (i < length && pattern[i] == greatest) pattern[i++] = 1;
            if (i == length) break;
            ++pattern[i];
        }
    }
}

Rational parameter(Random& random, const KnotVector& knots) {
    if (random.one_in(3)) {
        return knots[knots.begin_index() + random.below(knots.end_index() - knots.begin_index() + 1)];
    }
    const Interval domain = knots.domain();
    return domain.a() + (domain.b() - domain.a()) * Rational(random.between(0, 60), 60);
}

std::vector<Rational> insertable(Random& random, const KnotVector& knots, std::size_t most) {
    std::vector<Rational> chosen;
    for (std::uint64_t i = random.below(most + 1); i > 0; --i) {
        const bool repeat = !chosen.empty() && random.one_in(3);
        const Rational knot = repeat ? chosen[random.below(chosen.size())] : parameter(random, knots);
        const auto already = static_cast<std::size_t>(std::ranges::count(chosen, knot));
        if (knots.multiplicity(knot) + already <= knots.degree()) chosen.push_back(knot);
    }
    return chosen;
}

BSplineCurve example_spline() {
    return {3, {0, 1, 2, 3, 4, 5, 6, 7}, {{0, 0}, {1, 2}, {3, 3}, {5, 1}, {6, 0}, {8, 2}}};
}

}  // namespace blossom::testing
