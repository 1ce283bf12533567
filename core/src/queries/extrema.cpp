#include <blossom/core/queries/extrema.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>

namespace blossom {

namespace {

/// Where an extremum may be: an end of a piece, or a stationary point.
struct ExtremumCandidate {
    Root at;
    Root value;
    /// The sign of the slope on either side; nullopt where the function ends.
    std::optional<int> before;
    std::optional<int> behind;

    bool is_alone() const { return !before && !behind; }
    bool is_minimum() const { return !is_alone() && before.value_or(-1) < 0 && behind.value_or(1) > 0; }
    bool is_maximum() const { return !is_alone() && before.value_or(1) > 0 && behind.value_or(-1) < 0; }
};

/// What a function does towards an infinite end of its range: its limit, or nullopt if it has no finite one,
/// and the sign of the slope there.
struct Tendency {
    std::optional<Rational> limit;
    bool falls = false;  ///< towards the end
};

class ExtremaSearch {
public:
    ExtremaSearch(const Rational& width, const Limits& limits) : width_(width), limits_(limits) {}

    void add(const QuotientPiece& piece) {
        const auto& [lower, upper] = piece.range;
        require_finite(piece);
        const Polynomial slope = without_factors_of(
            derivative(piece.numerator) * piece.denominator - piece.numerator * derivative(piece.denominator),
            piece.denominator);
        if (slope.is_zero()) {
            add_constant(piece);
            return;
        }
        AlgebraicValues values(piece.numerator, piece.denominator, limits_);
        if (lower && lower == upper) {
            meet({rational_root(*lower), values.at(rational_root(*lower)), {}, {}}, false);
            return;
        }
        std::vector<Root> stationary = roots(slope, piece.range, width_, limits_);
        std::erase_if(stationary, [&](const Root& root) {
            return root.is_rational() && (root.lower == lower || root.lower == upper);
        });
        int sign = lower ? sign_beside(slope, *lower, 1) : sign_at_infinity(slope, -1);
        if (lower) {
            meet({rational_root(*lower), values.at(rational_root(*lower)), {}, sign}, true);
        } else {
            tendencies_.push_back({limit(piece), sign > 0});
        }
        for (Root& root : stationary) {
            const int behind = root.multiplicity % 2 == 1 ? -sign : sign;
            const Root value = values.at(root);
            candidates_.push_back({std::move(root), value, sign, behind});
            sign = behind;
        }
        if (upper) {
            candidates_.push_back({rational_root(*upper), values.at(rational_root(*upper)), sign, {}});
        } else {
            tendencies_.push_back({limit(piece), sign < 0});
        }
    }

    Extrema finish() && {
        Extrema found;
        for (const ExtremumCandidate& candidate : candidates_) {
            if (candidate.is_minimum() || candidate.is_maximum())
                found.local.push_back({candidate.at, candidate.value, candidate.is_maximum()});
        }
        found.least = global(-1);
        found.greatest = global(1);
        for (const auto& [range, value] : constant_) found.constant.push_back(range);
        return found;
    }

private:
    void require_finite(const QuotientPiece& piece) const {
        if (piece.denominator.degree() == 0) return;
        const auto& [lower, upper] = piece.range;
        const bool is_point = lower && lower == upper;
        const bool vanishes = is_point ? piece.denominator(*lower).is_zero()
                                       : !roots(piece.denominator, piece.range, width_, limits_).empty();
        if (vanishes)
            throw Error(ErrorCode::zero_weight, "the weight is 0 in this range, where the curve has no point",
                        Part::map);
    }

    /// A candidate at the beginning of a piece, which the function may pass on its way from the one before.
    void meet(ExtremumCandidate candidate, bool has_extent) {
        if (!candidates_.empty()) {
            ExtremumCandidate& last = candidates_.back();
            if (last.at == candidate.at && !last.behind && is_same(last.value, candidate.value, limits_)) {
                if (has_extent) last.behind = candidate.behind;
                return;
            }
        }
        candidates_.push_back(std::move(candidate));
    }

    void add_constant(const QuotientPiece& piece) {
        const auto& [lower, upper] = piece.range;
        const Rational inside = lower ? *lower : (upper ? *upper : Rational());
        const Root value = rational_root(piece.numerator(inside) / piece.denominator(inside));
        if (lower) meet({rational_root(*lower), value, {}, 0}, true);
        if (upper && lower != upper) candidates_.push_back({rational_root(*upper), value, 0, {}});
        if (lower && lower == upper) return;
        if (!constant_.empty() && constant_.back().first.upper == lower && constant_.back().second == value) {
            constant_.back().first.upper = upper;
        } else {
            constant_.emplace_back(piece.range, value);
        }
    }

    static int sign_at_infinity(const Polynomial& polynomial, int side) {
        const int sign = polynomial.leading_coefficient().sign();
        return side < 0 && polynomial.degree() % 2 == 1 ? -sign : sign;
    }
    static std::optional<Rational> limit(const QuotientPiece& piece) {
        const std::size_t n = piece.numerator.degree();
        const std::size_t m = piece.denominator.degree();
        if (n > m) return std::nullopt;
        return n < m ? Rational()
                     : piece.numerator.leading_coefficient() / piece.denominator.leading_coefficient();
    }

    /// The least (side < 0) or the greatest value.
    std::optional<GlobalExtremum> global(int side) const {
        const auto is_better = [&](const Root& one, const Root& other) {
            const auto order = compare(one, other, limits_);
            return side < 0 ? order < 0 : order > 0;
        };
        const Root* best = nullptr;
        const auto consider = [&](const Root& value) {
            if (!best || is_better(value, *best)) best = &value;
        };
        for (const ExtremumCandidate& candidate : candidates_) consider(candidate.value);
        for (const auto& [range, value] : constant_) consider(value);
        if (!best) return std::nullopt;
        for (const auto& [bound, falls] : tendencies_) {
            if (falls != (side < 0)) continue;
            if (!bound || is_better(rational_root(*bound), *best)) return std::nullopt;
        }
        GlobalExtremum found{*best, {}, {}};
        for (const auto& [range, value] : constant_) {
            if (is_same(value, *best, limits_)) found.ranges.push_back(range);
        }
        const auto in_range = [&](const Root& at) {
            return std::ranges::any_of(found.ranges, [&](const ParameterRange& range) {
                return at.is_rational() && (!range.lower || *range.lower <= at.lower) &&
                       (!range.upper || at.lower <= *range.upper);
            });
        };
        for (const ExtremumCandidate& candidate : candidates_) {
            const bool known = !found.parameters.empty() && found.parameters.back() == candidate.at;
            if (!known && is_same(candidate.value, *best, limits_) && !in_range(candidate.at))
                found.parameters.push_back(candidate.at);
        }
        return found;
    }

    const Rational& width_;
    const Limits& limits_;
    std::vector<ExtremumCandidate> candidates_;
    std::vector<std::pair<ParameterRange, Root>> constant_;
    std::vector<Tendency> tendencies_;
};

void require_coordinates(std::size_t given, const CurvePiece& piece, std::string_view what) {
    if (given == piece.dimension()) return;
    throw Error(ErrorCode::mismatched_dimensions, "the " + std::string(what) + " has " +
                                                      std::to_string(given) + " coordinates; the map has " +
                                                      std::to_string(piece.dimension()));
}

}  // namespace

Extrema extrema(std::span<const QuotientPiece> pieces, const Rational& width, const Limits& limits) {
    ExtremaSearch search(width, limits);
    for (const QuotientPiece& piece : pieces) search.add(piece);
    return std::move(search).finish();
}

std::vector<QuotientPiece> component(std::span<const CurvePiece> pieces,
                                     std::span<const Rational> direction) {
    std::vector<QuotientPiece> functions;
    for (const CurvePiece& piece : pieces) {
        require_coordinates(direction.size(), piece, "direction");
        Polynomial numerator;
        for (std::size_t j = 0; j < direction.size(); ++j)
            numerator += piece.coordinates[j] * Polynomial(direction[j]);
        functions.push_back({std::move(numerator), piece.weight(), piece.range});
    }
    return functions;
}

std::vector<QuotientPiece> squared_distance(std::span<const CurvePiece> pieces,
                                            std::span<const Rational> point) {
    std::vector<QuotientPiece> functions;
    for (const CurvePiece& piece : pieces) {
        require_coordinates(point.size(), piece, "point");
        Polynomial sum;
        for (std::size_t j = 0; j < point.size(); ++j) {
            const Polynomial difference = piece.coordinates[j] - piece.weight() * Polynomial(point[j]);
            sum += difference * difference;
        }
        functions.push_back({std::move(sum), piece.weight() * piece.weight(), piece.range});
    }
    return functions;
}

}  // namespace blossom
