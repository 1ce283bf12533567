#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/roots.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/integer_polynomials.hpp>

#include <algorithm>
#include <optional>
#include <string>

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
    Isolation(std::shared_ptr<const Polynomial> factor, std::size_t multiplicity, const Rational& width,
              const Limits& limits, std::vector<Root>& found)
        : shared_(std::move(factor)),
          factor_(*shared_),
          slope_(derivative(factor_)),
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

    /// Exactly one root lies between: finds its cell in the grid of halves by quadratic interval refinement.
    /// A straight line between the values at the ends of a cell says in which of 2^s parts the root is; where
    /// the signs confirm this, s is doubled. Source: Abbott, "Quadratic interval refinement for real roots",
    /// 2014.
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
        found_.push_back({grid.point(level, cell), grid.point(level, cell + 1), multiplicity_, shared_});
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

    /// In which of 2^gain parts of a cell a line through the values at its ends has its zero.
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

    std::shared_ptr<const Polynomial> shared_;
    const Polynomial& factor_;
    Polynomial slope_;  ///< the derivative
    std::size_t multiplicity_;
    const Rational& width_;
    const Limits& limits_;
    std::vector<Root>& found_;
};

[[noreturn]] void throw_zero_polynomial() {
    throw Error(ErrorCode::division_by_zero,
                "the zero polynomial has no squarefree factors: every number is a root");
}

/// The part of the range in which roots may lie; where there can be none, a part without roots.
Interval bounded(const ParameterRange& range, const Polynomial& polynomial) {
    if (range.lower && range.upper) return {*range.lower, *range.upper};
    const Rational bound = root_bound(polynomial);
    if (range.lower) return {*range.lower, std::max(bound, *range.lower + 1)};
    if (range.upper) return {std::min(-bound, *range.upper - 1), *range.upper};
    return {-bound, bound};
}

/// A squarefree factor without its rational roots.
struct IrrationalFactor {
    std::shared_ptr<const Polynomial> polynomial;
    std::size_t multiplicity;
};

/// Divides by the linear factors of rational roots, and adds those roots that lie in the interval to `found`.
IrrationalFactor without_rational_roots(const Polynomial& factor, std::size_t multiplicity,
                                        const ParameterRange& range, std::vector<Root>& found) {
    IntegerPolynomial rest = factor.coefficients().numerators();
    for (const Rational& root : rational_roots(rest)) {
        const bool inside = (!range.lower || *range.lower <= root) && (!range.upper || root <= *range.upper);
        if (inside) found.push_back({root, root, multiplicity});
        const Integer linear[] = {-root.numerator(), root.denominator()};
        rest = *exact_quotient(rest, linear);
    }
    return {std::make_shared<const Polynomial>(RationalVector(std::move(rest), 1)), multiplicity};
}

/// Whether two roots of coprime factors are not yet separated: their intervals overlap, or one root is an end
/// of the other's interval.
bool overlap(const Root& a, const Root& b) {
    if (a.is_rational() != b.is_rational()) return a.lower <= b.upper && b.lower <= a.upper;
    return a.lower < b.upper && b.lower < a.upper;
}

}  // namespace

std::vector<std::pair<Polynomial, std::size_t>> squarefree_factors(const Polynomial& polynomial) {
    if (polynomial.is_zero()) throw_zero_polynomial();
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

Rational root_bound(const Polynomial& polynomial) {
    const std::vector<Integer>& coefficients = polynomial.coefficients().numerators();
    if (coefficients.empty()) throw_zero_polynomial();
    const std::size_t n = coefficients.size() - 1;
    // |a_(n-k) / a_n| < 2^(bits + 1) with the difference of the bits of the two.
    const auto leading = static_cast<std::ptrdiff_t>(coefficients.back().bit_length());
    std::optional<std::ptrdiff_t> exponent;
    for (std::size_t k = 1; k <= n; ++k) {
        const Integer& coefficient = coefficients[n - k];
        if (coefficient.is_zero()) continue;
        const std::ptrdiff_t bits = static_cast<std::ptrdiff_t>(coefficient.bit_length()) - leading + 1;
        const auto order = static_cast<std::ptrdiff_t>(k);
        const std::ptrdiff_t rounded_up = bits > 0 ? (bits + order - 1) / order : -(-bits / order);
        exponent = std::max(exponent.value_or(rounded_up), rounded_up);
    }
    if (!exponent) return 1;
    const std::ptrdiff_t power = *exponent + 1;
    return power >= 0 ? Rational(Integer(1) << static_cast<std::size_t>(power))
                      : Rational(1, Integer(1) << static_cast<std::size_t>(-power));
}

Root narrowed(const Root& root, const Rational& width, const Limits& limits) {
    if (root.upper - root.lower <= width) return root;
    std::vector<Root> found;
    Isolation(root.factor, root.multiplicity, width, limits, found).refine(root.lower, root.upper);
    return found.front();
}

std::vector<Root> roots(const Polynomial& polynomial, const ParameterRange& range, const Rational& width,
                        const Limits& limits) {
    std::vector<Root> rational;
    std::vector<IrrationalFactor> factors;
    for (const auto& [factor, multiplicity] : squarefree_factors(polynomial)) {
        auto rest = without_rational_roots(factor, multiplicity, range, rational);
        if (rest.polynomial->degree() > 0) factors.push_back(std::move(rest));
    }
    const Interval where = bounded(range, polynomial);
    Rational finest = width;
    while (true) {
        std::vector<Root> found = rational;
        for (const IrrationalFactor& factor : factors) {
            Isolation(factor.polynomial, factor.multiplicity, finest, limits, found)
                .run(where.a(), where.b());
        }
        std::ranges::sort(found, {}, [](const Root& root) { return root.lower + root.upper; });
        if (std::ranges::adjacent_find(found, overlap) == found.end()) return found;
        finest = (finest.sign() > 0 ? finest : where.b() - where.a()) / 16;
    }
}

Polynomial numerator(const PolynomialMap& map, const Limits& limits) {
    const std::size_t dimension = dimension_of(map);
    if (dimension != 1 && dimension != 2) {
        throw Error(ErrorCode::mismatched_dimensions,
                    "a map into " + std::to_string(dimension) + " dimensions is not scalar", Part::map);
    }
    const PolynomialCurve curve = monomial_form(map, limits);
    if (dimension == 1) return curve.coordinate(0);
    return divide_exactly(curve.coordinate(0), gcd(curve.coordinate(0), curve.coordinate(1)));
}

}  // namespace blossom
