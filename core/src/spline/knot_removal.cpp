#include <blossom/core/spline/knot_removal.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>
#include <variant>

namespace blossom {

namespace {

/// The knots strictly between the two that bound the domain.
std::span<const Rational> removable(const KnotVector& knots) {
    return std::span(knots.knots())
        .subspan(knots.begin_index() + 1, knots.end_index() - knots.begin_index() - 1);
}

KnotVector without(const KnotVector& knots, const Rational& knot) {
    const auto inside = removable(knots);
    const auto place = std::ranges::lower_bound(inside, knot) - inside.begin();
    std::vector<Rational> remaining = knots.knots();
    remaining.erase(remaining.begin() + static_cast<std::ptrdiff_t>(knots.begin_index() + 1) + place);
    return {knots.degree(), std::move(remaining), knots.points() - 1};
}

/// Solves combined = (1 - weight) known + weight x for x.
Coordinates solved(const Coordinates& combined, const Coordinates& known, const Rational& weight) {
    Coordinates x;
    x.reserve(combined.size());
    for (std::size_t i = 0; i < combined.size(); ++i)
        x.push_back(known[i] + (combined[i] - known[i]) / weight);
    return x;
}

std::variant<BSplineCurve, RemovalObstruction> removed_once(const BSplineCurve& curve, const Rational& knot) {
    const std::size_t n = curve.degree();
    KnotVector knots = without(curve.knots(), knot);
    const std::size_t span = knots.span_at(knot);
    const std::size_t first = knots.first_point(span);
    const auto around = knots.around(span);
    const auto& points = curve.control_points();

    std::vector<Coordinates> fresh{points[first]};
    for (std::size_t l = 0; l < n && around[l] != knot; ++l) {
        fresh.push_back(
            solved(points[first + 1 + l], fresh.back(), (knot - around[l]) / (around[l + n] - around[l])));
    }
    const std::size_t last = first + fresh.size() - 1;
    if (fresh.back() != points[last + 1]) {
        const auto window = knots.window(last);
        return RemovalObstruction{{window.begin(), window.end()}, fresh.back(), points[last + 1]};
    }
    std::vector<Coordinates> remaining(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(first));
    remaining.insert(remaining.end(), fresh.begin(), fresh.end());
    remaining.insert(remaining.end(), points.begin() + static_cast<std::ptrdiff_t>(last + 2), points.end());
    return BSplineCurve(std::move(knots), std::move(remaining));
}

}  // namespace

Coordinates RemovalObstruction::residual() const {
    Coordinates difference;
    difference.reserve(from_left.size());
    for (std::size_t i = 0; i < from_left.size(); ++i) difference.push_back(from_left[i] - from_right[i]);
    return difference;
}

namespace {

/// "; the nearest is 1/2", where there is a knot that can be removed.
std::string nearest_knot(std::span<const Rational> knots, const Rational& wanted) {
    if (knots.empty()) return "";
    const auto distance = [&](const Rational& knot) { return abs(knot - wanted); };
    return "; the nearest is " + to_string(*std::ranges::min_element(knots, {}, distance));
}

}  // namespace

KnotRemoval remove_knot(const BSplineCurve& curve, const Rational& knot, std::size_t times) {
    const auto available =
        static_cast<std::size_t>(std::ranges::equal_range(removable(curve.knots()), knot).size());
    if (available < times) {
        throw Error(ErrorCode::bad_knots,
                    "the knot " + to_string(knot) + " occurs " + std::to_string(available) +
                        " times between those that bound the domain; it cannot be removed " +
                        std::to_string(times) + " times" +
                        (available == 0 ? nearest_knot(removable(curve.knots()), knot) : ""),
                    available == 0 ? Part::knot : Part::times);
    }
    KnotRemoval removal{curve, 0, {}};
    while (removal.removed < times) {
        auto next = removed_once(removal.curve, knot);
        if (auto* obstruction = std::get_if<RemovalObstruction>(&next)) {
            removal.obstruction = std::move(*obstruction);
            break;
        }
        removal.curve = std::get<BSplineCurve>(std::move(next));
        ++removal.removed;
    }
    return removal;
}

}  // namespace blossom
