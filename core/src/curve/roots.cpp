#include <blossom/core/blossom/change_of_basis.hpp>
#include <blossom/core/curve/roots.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <optional>

#include "maps/integer_frame.hpp"

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

/// The polygons over both halves, scaled by 2^n: de Casteljau at the midpoint with additions alone.
std::pair<Polygon, Polygon> halves(Polygon polygon) {
    const std::size_t n = polygon.size() - 1;
    Polygon left(n + 1);
    Polygon right(n + 1);
    for (std::size_t r = 0; r <= n; ++r) {
        left[r] = polygon[0] << (n - r);
        right[n - r] = polygon[n - r] << (n - r);
        for (std::size_t i = 0; i + r < n; ++i) polygon[i] += polygon[i + 1];
    }
    return {std::move(left), std::move(right)};
}

/// The sign of the polynomial at p / q with q > 0.
int sign_at(const Polynomial& polynomial, const Rational& t) {
    return constructions::form_value(std::span<const Integer>(polynomial.coefficients().numerators()),
                                     t.numerator(), t.denominator())
        .sign();
}

/// Isolates and refines the roots of one squarefree factor.
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

    void run(const Rational& lower, const Rational& upper) {
        if (sign_at(factor_, lower) == 0) add(lower);
        search(polygon_over(cleared(Interval(lower, upper))), lower, upper);
        if (sign_at(factor_, upper) == 0) add(upper);
    }

private:
    struct Piece {
        Polygon polygon;
        Rational lower;
        Rational upper;
        std::size_t changes_before = 0;  ///< sign changes of what it was cut out of; 0 at the beginning
        std::size_t speed = 2;           ///< how many bits `around_cluster` tries to gain
    };

    void add(const Rational& root) { found_.push_back({root, root, multiplicity_}); }

    /// The roots strictly between `lower` and `upper`. The pending halves stand on a stack of their own:
    /// close roots would nest calls deeply.
    void search(Polygon polygon, const Rational& lower, const Rational& upper) {
        std::vector<Piece> pending;
        pending.push_back({std::move(polygon), lower, upper});
        while (!pending.empty()) {
            Piece piece = std::move(pending.back());
            pending.pop_back();
            const std::size_t changes = sign_changes(piece.polygon);
            if (changes == 0) continue;
            if (changes == 1) {
                refine(piece.lower, piece.upper);
                continue;
            }
            require_result_bits(greatest_bit_length(piece.polygon), limits_);
            if (changes == piece.changes_before) {
                if (auto cluster = around_cluster(piece, changes)) {
                    pending.push_back(std::move(*cluster));
                    continue;
                }
            }
            const Rational middle = (piece.lower + piece.upper) / 2;
            const std::size_t speed = std::max<std::size_t>(piece.speed / 2, 2);
            auto [left, right] = halves(std::move(piece.polygon));
            if (left.back().is_zero()) add(middle);
            pending.push_back({std::move(right), middle, piece.upper, changes, speed});
            pending.push_back({std::move(left), piece.lower, middle, changes, speed});
        }
    }

    /// A much smaller part of the piece, by 3 / 2^(speed + 2), that has all its sign changes and so all its
    /// roots: sign changes of disjoint parts, and simple roots where these meet, add up to at most the sign
    /// changes of the whole, so that there are none elsewhere and none at the new ends. Newton's step for a
    /// root of multiplicity `changes` from the middle says where to look; it comes near a cluster of roots,
    /// and the next step may be smaller by the square. None if it fails.
    std::optional<Piece> around_cluster(const Piece& piece, std::size_t changes) const {
        const Rational middle = (piece.lower + piece.upper) / 2;
        const Rational slope = slope_(middle);
        if (slope.is_zero()) return std::nullopt;
        const Rational target = middle - Rational(changes) * factor_(middle) / slope;
        if (target < piece.lower || piece.upper < target) return std::nullopt;
        const Rational cell = (piece.upper - piece.lower) / Rational(Integer(1) << (piece.speed + 2));
        const Rational cells = (target - piece.lower) / cell;
        const Rational begin = piece.lower + Rational(cells.numerator() / cells.denominator() - 1) * cell;
        const Rational lower = std::max(begin, piece.lower);
        const Rational upper = std::min(begin + 3 * cell, piece.upper);
        const auto interval = cleared(Interval(lower, upper));
        constexpr std::size_t bits_of_digits = 3;
        if (factor_.degree() * interval.bits() > bits_of_digits * limits_.digits) return std::nullopt;
        Polygon polygon = polygon_over(interval);
        if (sign_changes(polygon) != changes) return std::nullopt;
        return Piece{std::move(polygon), lower, upper, changes, 2 * piece.speed};
    }

    Polygon polygon_over(const ClearedInterval& interval) const {
        const std::span<const Integer> coefficients = factor_.coefficients().numerators();
        return constructions::bernstein_from_monomial(coefficients, interval.a, interval.b, interval.q)
            .numerators;
    }

    /// Exactly one root lies strictly between: bisects until a rational one would be recognised and the width
    /// is reached.
    void refine(Rational lower, Rational upper) {
        const Integer& leading = factor_.coefficients().numerators().back();
        const Rational enough = Rational(1, abs(leading));
        int sign_behind = sign_at(factor_, upper);
        if (sign_behind == 0) sign_behind = -sign_just_behind(lower);
        while (sign_at(factor_, lower) == 0 || sign_at(factor_, upper) == 0 || upper - lower >= enough ||
               (width_.sign() > 0 && upper - lower > width_)) {
            const Rational middle = (lower + upper) / 2;
            const int sign = sign_at(factor_, middle);
            if (sign == 0) return add(middle);
            (sign == sign_behind ? upper : lower) = middle;
        }
        // A rational root is k / leading, and at most one such number lies between.
        const Rational scaled = lower * Rational(abs(leading));
        Integer k = (scaled.numerator() - modulo(scaled)) / scaled.denominator() + 1;
        const Rational candidate(std::move(k), abs(leading));
        if (candidate < upper && sign_at(factor_, candidate) == 0) return add(candidate);
        found_.push_back({std::move(lower), std::move(upper), multiplicity_});
    }

    /// numerator mod denominator, in 0..denominator - 1.
    static Integer modulo(const Rational& value) {
        Integer rest = value.numerator() % value.denominator();
        return rest.sign() < 0 ? rest + value.denominator() : rest;
    }

    /// The sign immediately to the right of a root of odd order or of any other point.
    int sign_just_behind(const Rational& t) const {
        const int sign = sign_at(factor_, t);
        return sign != 0 ? sign : sign_at(slope_, t);
    }

    const Polynomial& factor_;
    Polynomial slope_;  ///< its derivative
    std::size_t multiplicity_;
    const Rational& width_;
    const Limits& limits_;
    std::vector<Root>& found_;
};

/// Whether two roots of coprime factors are still not told apart: their intervals overlap, or one root is an
/// end of the interval of the other.
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
    const auto factors = squarefree_factors(polynomial);
    Rational finest = width;
    while (true) {
        std::vector<Root> found;
        for (const auto& [factor, multiplicity] : factors) {
            Isolation(factor, multiplicity, finest, limits, found).run(lower, upper);
        }
        std::ranges::sort(found, {}, [](const Root& root) { return root.lower + root.upper; });
        if (std::ranges::adjacent_find(found, overlap) == found.end()) return found;
        finest = (finest.sign() > 0 ? finest : upper - lower) / 16;
    }
}

}  // namespace blossom
