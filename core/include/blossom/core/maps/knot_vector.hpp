#pragma once

#include <blossom/core/maps/interval.hpp>
#include <blossom/rational/rational.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace blossom {

/// Which knots a knot vector lists. The number of knots distinguishes the conventions.
enum class KnotConvention {
    textbook,  ///< points + degree + 1 knots
    /// the knots that occur in blossoms, points + degree - 1: one fewer at each end; not for degree 0
    polar,
};

/// A knot and its multiplicity.
struct KnotMultiplicity {
    Rational knot;
    std::size_t multiplicity = 0;

    friend bool operator==(const KnotMultiplicity&, const KnotMultiplicity&) = default;
};

/// Errors: `bad_knots` if the knots decrease or one has a multiplicity above degree + 1, at `Part::knots /
/// i`.
void require_knots(std::span<const Rational> knots, std::size_t degree);

/// The knots t_0 <= t_1 <= ... of a B-spline of degree n with a number of control points.
///
/// All indices are those of the given knots. With `first = 1` in the textbook convention and 0 in the polar
/// one, control point j is the blossom value at its window t_(j+first), ..., t_(j+first+n-1), and the domain
/// is [t_(first+n-1), t_(first+points-1)]. Span i is [t_i, t_(i+1)] within the domain. Source: DeRose,
/// section 4.6; Hart, "B-splines". Statements: derose-46-cubic-scheme, hart-bspline-segments,
/// hart-extra-knots.
class KnotVector {
public:
    /// Errors: `wrong_arity` for fewer than degree + 1 points; `bad_knots` if the number of knots fits
    /// neither convention, if the knots decrease, if one has a multiplicity above degree + 1, or if the
    /// domain is a single point.
    KnotVector(Count degree, std::vector<Rational> knots, Count points);

    std::size_t degree() const { return degree_; }
    std::size_t points() const { return points_; }
    KnotConvention convention() const { return convention_; }
    const std::vector<Rational>& knots() const { return knots_; }
    /// Errors: `outside_domain` unless i < size().
    const Rational& operator[](std::size_t i) const {
        require_index(i, knots_.size());
        return knots_[i];
    }
    std::size_t size() const { return knots_.size(); }

    /// The domain is [knot begin_index(), knot end_index()]; further knots may be equal to these.
    std::size_t begin_index() const { return degree_ + first() - 1; }
    std::size_t end_index() const { return points_ + first() - 1; }
    Interval domain() const { return {knots_[begin_index()], knots_[end_index()]}; }

    /// The non-empty span with t_i <= t < t_(i+1); at the end of the domain, the last non-empty span.
    /// Cost: one bisection. Errors: `outside_domain`.
    std::size_t span_at(const Rational& t) const;
    /// The non-empty span with t_i < t <= t_(i+1); at the beginning of the domain, the first non-empty span.
    std::size_t span_before(const Rational& t) const;
    /// All non-empty spans of the domain, in order.
    std::vector<std::size_t> spans() const;
    /// Errors: `outside_domain` unless `span` is a non-empty span of the domain.
    void require_span(std::size_t span) const;

    /// The 2n knots t_(i-n+1), ..., t_(i+n) on which the blossom of span i depends. Errors: `outside_domain`
    /// unless it is a span of the domain, possibly an empty one.
    std::span<const Rational> around(std::size_t span) const {
        require_index(first_point(span), points_ - degree_);
        return std::span(knots_).subspan(span + 1 - degree_, 2 * degree_);
    }
    /// The first of the n + 1 control points that determine span i, a span of the domain.
    std::size_t first_point(std::size_t span) const { return span - begin_index(); }
    /// The index of the first knot of the window of control point j.
    std::size_t window_index(std::size_t point) const { return point + first(); }
    /// The n knots at which control point j is a blossom value. Errors: `outside_domain` unless j < points().
    std::span<const Rational> window(std::size_t point) const {
        require_index(point, points_);
        return std::span(knots_).subspan(window_index(point), degree_);
    }

    /// The multiplicity of t among the knots; 0 if t is not a knot.
    std::size_t multiplicity(const Rational& t) const;
    /// The distinct knots in order.
    std::vector<KnotMultiplicity> distinct() const;

    friend bool operator==(const KnotVector&, const KnotVector&) = default;
    /// "degree 2, knots 0, 0, 1, 2, 2".
    friend std::string to_string(const KnotVector& knots);
    friend std::size_t hash_value(const KnotVector& knots) {
        return hash_of(knots.degree_, knots.points_, knots.knots_);
    }

private:
    std::size_t first() const { return convention_ == KnotConvention::textbook ? 1 : 0; }

    std::size_t degree_;
    std::size_t points_;
    KnotConvention convention_;
    std::vector<Rational> knots_;
};

}  // namespace blossom
