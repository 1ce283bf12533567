#include <blossom/core/maps/knot_vector.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>

namespace blossom {

namespace {

[[noreturn]] void bad_knots(std::string message, Place place = Part::knots) {
    throw Error(ErrorCode::bad_knots, std::move(message), std::move(place));
}

KnotConvention convention_of(std::size_t degree, std::size_t knots, std::size_t points) {
    if (points <= degree) {
        throw Error(ErrorCode::wrong_arity,
                    "a B-spline of degree " + std::to_string(degree) + " needs more than " +
                        std::to_string(degree) + " control points, not " + std::to_string(points),
                    Part::control_points);
    }
    if (knots == points + degree + 1) return KnotConvention::textbook;
    if (degree > 0 && knots == points + degree - 1) return KnotConvention::polar;
    std::string expected = std::to_string(points + degree + 1);
    if (degree > 0) expected += " or " + std::to_string(points + degree - 1);
    bad_knots(std::to_string(points) + " control points of degree " + std::to_string(degree) + " need " +
              expected + " knots, not " + std::to_string(knots));
}

std::string named(std::size_t i, const Rational& knot) {
    return "knot " + std::to_string(i) + " (" + to_string(knot) + ")";
}

void require_inside(const Interval& domain, const Rational& t) {
    if (domain.a() <= t && t <= domain.b()) return;
    throw Error(ErrorCode::outside_domain, "the parameter " + to_string(t) + " lies outside the domain [" +
                                               to_string(domain.a()) + ", " + to_string(domain.b()) + "]");
}

}  // namespace

void require_knots(std::span<const Rational> knots, std::size_t degree) {
    std::size_t run = 0;
    for (std::size_t i = 1; i <= knots.size(); ++i) {
        if (i < knots.size() && knots[i] < knots[i - 1]) {
            bad_knots(named(i, knots[i]) + " is less than " + named(i - 1, knots[i - 1]) +
                          "; knots must not decrease",
                      Part::knots / i);
        }
        if (i < knots.size() && knots[i] == knots[run]) continue;
        if (i - run > degree + 1) {
            const std::size_t surplus = run + degree + 1;
            bad_knots(named(surplus, knots[run]) + " has multiplicity " + std::to_string(i - run) +
                          ", more than degree + 1 = " + std::to_string(degree + 1),
                      Part::knots / surplus);
        }
        run = i;
    }
}

KnotVector::KnotVector(Count degree, std::vector<Rational> knots, Count points)
    : degree_(degree),
      points_(points),
      convention_(convention_of(degree, knots.size(), points)),
      knots_(std::move(knots)) {
    require_knots(knots_, degree_);
    if (knots_[begin_index()] == knots_[end_index()]) {
        bad_knots("the domain from " + named(begin_index(), knots_[begin_index()]) + " to " +
                  named(end_index(), knots_[end_index()]) + " is a single point");
    }
}

std::size_t KnotVector::span_at(const Rational& t) const {
    const Interval ends = domain();
    require_inside(ends, t);
    if (t == ends.b()) return span_before(t);
    const auto inside = std::span(knots_).subspan(begin_index(), end_index() - begin_index() + 1);
    const auto above = std::ranges::upper_bound(inside, t);
    return begin_index() + static_cast<std::size_t>(above - inside.begin()) - 1;
}

std::size_t KnotVector::span_before(const Rational& t) const {
    const Interval ends = domain();
    require_inside(ends, t);
    if (t == ends.a()) return span_at(t);
    const auto inside = std::span(knots_).subspan(begin_index(), end_index() - begin_index() + 1);
    const auto not_below = std::ranges::lower_bound(inside, t);
    return begin_index() + static_cast<std::size_t>(not_below - inside.begin()) - 1;
}

std::vector<std::size_t> KnotVector::spans() const {
    std::vector<std::size_t> spans;
    for (std::size_t i = begin_index(); i < end_index(); ++i) {
        if (knots_[i] != knots_[i + 1]) spans.push_back(i);
    }
    return spans;
}

void KnotVector::require_span(std::size_t span) const {
    if (begin_index() <= span && span < end_index()) {
        if (knots_[span] != knots_[span + 1]) return;
        throw Error(ErrorCode::outside_domain,
                    "span " + std::to_string(span) + " is empty: " + named(span, knots_[span]) +
                        " equals knot " + std::to_string(span + 1),
                    Part::segment);
    }
    throw Error(ErrorCode::outside_domain,
                "span " + std::to_string(span) + " is outside the domain, whose spans are " +
                    std::to_string(begin_index()) + " to " + std::to_string(end_index() - 1),
                Part::segment);
}

std::size_t KnotVector::multiplicity(const Rational& t) const {
    return static_cast<std::size_t>(std::ranges::equal_range(knots_, t).size());
}

std::vector<KnotMultiplicity> KnotVector::distinct() const {
    std::vector<KnotMultiplicity> distinct;
    for (const Rational& knot : knots_) {
        if (distinct.empty() || distinct.back().knot != knot) distinct.push_back({knot, 0});
        ++distinct.back().multiplicity;
    }
    return distinct;
}

}  // namespace blossom
