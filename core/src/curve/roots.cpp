#include <blossom/core/curve/roots.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/integer_polynomials.hpp>

#include <algorithm>
#include <optional>

#include "maps/change_of_interval.hpp"
#include "maps/integer_frame.hpp"
#include "rounded_polygon.hpp"

namespace blossom {

namespace {

using Polygon = std::vector<Integer>;

std::size_t sign_changes(const Polygon& polygon) {
    std::size_t changes = 0;
    int last = 0;
    for (const Integer& point : polygon) {
        const int sign = point.sign();
        if (sign == 0) continue;
        if (last != 0 && sign != last) ++changes;
        last = sign;
    }
    return changes;
}

/// The sign of the polynomial at t = p / q, q > 0.
int sign_at(const Polynomial& polynomial, const Rational& t) {
    return constructions::form_value(std::span<const Integer>(polynomial.coefficients().numerators()),
                                     t.numerator(), t.denominator())
        .sign();
}

/// A grid on an interval with repeatedly halved cells: cell i of level m is the i-th of 2^m equal parts of
/// the interval.
class Grid {
public:
    Grid(const Rational& lower, const Rational& upper) : lower_(lower), length_(upper - lower) {}

    Rational point(std::size_t level, const Integer& index) const {
        return lower_ + length_ * Rational(index, Integer(1) << level);
    }
    /// The first level whose cells are shorter than `bound`, or equally long if `or_equal`.
    std::size_t level_below(const Rational& bound, bool or_equal) const {
        const Rational ratio = length_ / bound;
        const std::size_t above = ratio.numerator().bit_length();
        const std::size_t below = ratio.denominator().bit_length();
        std::size_t level = above > below + 1 ? above - below - 1 : 0;
        const auto is_enough = [&] {
            const auto order = ratio <=> Rational(Integer(1) << level);
            return order < 0 || (or_equal && order == 0);
        };
        while (!is_enough()) ++level;
        return level;
    }

private:
    Rational lower_;
    Rational length_;
};

/// Isolates and refines the roots of a squarefree polynomial without rational roots.
class Isolation {
public:
    Isolation(const Polynomial& factor, std::size_t multiplicity, const Rational& width, const Limits& limits,
              std::vector<Root>& found)
        : factor_(factor),
          slope_(derivative(factor)),
          multiplicity_(multiplicity),
          width_(width),
          limits_(limits),
          found_(found) {}

    /// Isolates the roots between `lower` and `upper`. Pending halves are kept on an explicit stack, because
    /// close roots would nest calls deeply.
    void run(const Rational& lower, const Rational& upper) {
        std::vector<Piece> pending;
        pending.push_back({RoundedPolygon(polygon_over(lower, upper)), lower, upper});
        while (!pending.empty()) {
            Piece piece = std::move(pending.back());
            pending.pop_back();
            SignChanges changes = piece.polygon.sign_changes();
            if (changes.least < 2 && changes.least != changes.most) {
                const Polygon polygon = polygon_over(piece.lower, piece.upper);
                changes.least = changes.most = sign_changes(polygon);
                piece.polygon = RoundedPolygon(polygon);
            }
            if (changes.most == 0) continue;
            if (changes.most == 1) {
                refine(piece.lower, piece.upper);
                continue;
            }
            piece.stalls = changes.least == piece.changes_before ? piece.stalls + 1 : 0;
            if (piece.stalls > 1) {
                if (auto cluster = around_cluster(piece)) {
                    pending.push_back(*std::move(cluster));
                    continue;
                }
            }
            const Rational middle = (piece.lower + piece.upper) / 2;
            const std::size_t speed = std::max<std::size_t>(piece.speed / 2, 2);
            auto [left, right] = std::move(piece.polygon).halves();
            pending.push_back({std::move(right), middle, piece.upper, changes.least, piece.stalls, speed});
            pending.push_back({std::move(left), piece.lower, middle, changes.least, piece.stalls, speed});
        }
    }

private:
    struct Piece {
        RoundedPolygon polygon;
        Rational lower;
        Rational upper;
        /// a lower bound for the piece from which this one was cut; 0 at the beginning
        std::size_t changes_before = 0;
        std::size_t stalls = 0;  ///< the number of consecutive halvings that did not lower them
        std::size_t speed = 2;   ///< the number of bits that `around_cluster` tries to gain
    };

    /// A part of the piece, smaller by the factor 3 / 2^(speed + 2), that has all of its sign changes and
    /// therefore all of its roots. (The sign changes of disjoint parts add up to at most those of the whole,
    /// so that no others exist.) A Newton step from the middle, for a root of this multiplicity, gives the
    /// position. It comes close to a cluster of roots, and the next part can be smaller by the square.
    /// Returns nullopt if it fails.
    std::optional<Piece> around_cluster(const Piece& piece) const {
        const std::size_t changes = sign_changes(polygon_over(piece.lower, piece.upper));
        const Rational middle = (piece.lower + piece.upper) / 2;
        const Rational slope = slope_(middle);
        if (slope.is_zero()) return std::nullopt;
        const Rational target =
            std::clamp(middle - Rational(changes) * factor_(middle) / slope, piece.lower, piece.upper);
        const Rational cell = (piece.upper - piece.lower) / Rational(Integer(1) << (piece.speed + 2));
        const Rational cells = (target - piece.lower) / cell;
        const Rational begin = piece.lower + Rational(cells.numerator() / cells.denominator() - 1) * cell;
        const Rational lower = std::max(begin, piece.lower);
        const Rational upper = std::min(begin + 3 * cell, piece.upper);
        constexpr std::size_t bits_of_digits = 3;
        if (factor_.degree() * cleared(Interval(lower, upper)).bits() > bits_of_digits * limits_.digits)
            return std::nullopt;
        const Polygon polygon = polygon_over(lower, upper);
        if (sign_changes(polygon) != changes) return std::nullopt;
        return Piece{RoundedPolygon(polygon), lower, upper, changes, piece.stalls, 2 * piece.speed};
    }

    Polygon polygon_over(const Rational& lower, const Rational& upper) const {
        const Interval interval(lower, upper);
        require_result_bits(greatest_bit_length(coefficients()) + factor_.degree() * cleared(interval).bits(),
                            limits_);
        return bernstein_from_monomial(coefficients(), interval).numerators;
    }

    std::span<const Integer> coefficients() const { return factor_.coefficients().numerators(); }

    /// The value at a grid point p / q, times a positive number that is the same for all points of a level.
    Integer value_at(const Rational& t, const Integer& denominator) const {
        return constructions::form_value(
            coefficients(), t.numerator() * divide_exactly(denominator, t.denominator()), denominator);
    }

    /// Finds the cell of the only root between the two numbers in the grid of halves, by quadratic interval
    /// refinement. A straight line between the values at the ends of a cell predicts which of its 2^s parts
    /// contains the root; if the signs confirm this, s is doubled. Source: Abbott, "Quadratic interval
    /// refinement for real roots", 2014.
    void refine(const Rational& lower, const Rational& upper) {
        const Grid grid(lower, upper);
        const std::size_t level = last_level(grid);
        const int sign_behind = sign_at(factor_, upper);
        Integer cell = 0;
        std::size_t reached = 0;
        std::size_t gain = 1;
        while (reached < level) {
            gain = std::min(gain, level - reached);
            Integer part = (cell << gain) + guess(grid, reached, cell, gain);
            const bool lies_behind = sign_at(factor_, grid.point(reached + gain, part)) != sign_behind;
            const bool lies_before = sign_at(factor_, grid.point(reached + gain, part + 1)) == sign_behind;
            if (lies_behind && lies_before) {
                cell = std::move(part);
                reached += gain;
                gain *= 2;
            } else if (gain == 1) {
                cell = lies_behind ? part + 1 : part - 1;
                reached += 1;
            } else {
                gain /= 2;
            }
        }
        found_.push_back({grid.point(level, cell), grid.point(level, cell + 1), multiplicity_});
    }

    /// Which of 2^gain parts of a cell contains the zero of the line through the values at its ends.
    Integer guess(const Grid& grid, std::size_t level, const Integer& cell, std::size_t gain) const {
        const Rational begin = grid.point(level, cell);
        const Rational end = grid.point(level, cell + 1);
        const Integer denominator = lcm(begin.denominator(), end.denominator());
        const Integer before = abs(value_at(begin, denominator));
        const Integer behind = abs(value_at(end, denominator));
        Integer part = (before << gain) / (before + behind);
        return part >> gain == Integer(1) ? part - 1 : part;
    }

    /// Intervals become shorter than 1 / |leading coefficient| or 2^-32, short enough to distinguish roots
    /// with short numerators and denominators, and not longer than the requested width.
    std::size_t last_level(const Grid& grid) const {
        constexpr std::size_t usual_bits = 32;
        const Rational usual(1, std::min(abs(coefficients().back()), Integer(1) << usual_bits));
        const std::size_t level = grid.level_below(usual, false);
        return width_.sign() > 0 ? std::max(level, grid.level_below(width_, true)) : level;
    }

    const Polynomial& factor_;
    Polynomial slope_;  ///< the derivative
    std::size_t multiplicity_;
    const Rational& width_;
    const Limits& limits_;
    std::vector<Root>& found_;
};

/// A squarefree factor without its rational roots.
struct IrrationalFactor {
    Polynomial polynomial;
    std::size_t multiplicity;
};

/// Divides by the linear factors of rational roots, and adds those roots that lie in the interval to `found`.
IrrationalFactor without_rational_roots(const Polynomial& factor, std::size_t multiplicity,
                                        const Rational& lower, const Rational& upper,
                                        std::vector<Root>& found) {
    IntegerPolynomial rest = factor.coefficients().numerators();
    for (const Rational& root : rational_roots(rest)) {
        if (lower <= root && root <= upper) found.push_back({root, root, multiplicity});
        const Integer linear[] = {-root.numerator(), root.denominator()};
        rest = *exact_quotient(rest, linear);
    }
    return {Polynomial(RationalVector(std::move(rest), 1)), multiplicity};
}

/// Whether two roots of coprime factors are not yet separated: their intervals overlap, or one root is an end
/// of the other's interval.
bool overlap(const Root& a, const Root& b) {
    if (a.is_rational() != b.is_rational()) return a.lower <= b.upper && b.lower <= a.upper;
    return a.lower < b.upper && b.lower < a.upper;
}

}  // namespace

std::vector<std::pair<Polynomial, std::size_t>> squarefree_factors(const Polynomial& polynomial) {
    if (polynomial.is_zero()) {
        throw Error(ErrorCode::division_by_zero,
                    "the zero polynomial has no squarefree factors: every number is a root");
    }
    std::vector<std::pair<Polynomial, std::size_t>> factors;
    const Polynomial slope = derivative(polynomial);
    const Polynomial common = gcd(polynomial, slope);
    Polynomial rest = divide_exactly(polynomial, common);
    Polynomial excess = divide_exactly(slope, common) - derivative(rest);
    for (std::size_t multiplicity = 1; rest.degree() > 0; ++multiplicity) {
        const Polynomial factor = gcd(rest, excess);
        if (factor.degree() > 0) factors.emplace_back(factor, multiplicity);
        rest = divide_exactly(rest, factor);
        excess = divide_exactly(excess, factor) - derivative(rest);
    }
    return factors;
}

std::vector<Root> roots(const Polynomial& polynomial, const Interval& interval, const Rational& width,
                        const Limits& limits) {
    const Rational& lower = std::min(interval.a(), interval.b());
    const Rational& upper = std::max(interval.a(), interval.b());
    std::vector<Root> rational;
    std::vector<IrrationalFactor> factors;
    for (const auto& [factor, multiplicity] : squarefree_factors(polynomial)) {
        auto rest = without_rational_roots(factor, multiplicity, lower, upper, rational);
        if (rest.polynomial.degree() > 0) factors.push_back(std::move(rest));
    }
    Rational finest = width;
    while (true) {
        std::vector<Root> found = rational;
        for (const IrrationalFactor& factor : factors)
            Isolation(factor.polynomial, factor.multiplicity, finest, limits, found).run(lower, upper);
        std::ranges::sort(found, {}, [](const Root& root) { return root.lower + root.upper; });
        if (std::ranges::adjacent_find(found, overlap) == found.end()) return found;
        finest = (finest.sign() > 0 ? finest : upper - lower) / 16;
    }
}

}  // namespace blossom
