#include <blossom/core/queries/cuts.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>

namespace blossom {

namespace {

std::optional<Rational> later_begin(const std::optional<Rational>& a, const std::optional<Rational>& b) {
    return a && b ? std::max(*a, *b) : (a ? a : b);
}
std::optional<Rational> earlier_end(const std::optional<Rational>& a, const std::optional<Rational>& b) {
    return a && b ? std::min(*a, *b) : (a ? a : b);
}

/// The part that two pieces share, or nullopt.
std::optional<RangedPolynomial> common_piece(const RangedPolynomial& one, const RangedPolynomial& other) {
    const auto lower = later_begin(one.range.lower, other.range.lower);
    const auto upper = earlier_end(one.range.upper, other.range.upper);
    const auto ends_there = [&](const RangedPolynomial& piece) {
        return piece.range.upper == upper && !piece.closed;
    };
    const bool closed = !ends_there(one) && !ends_there(other);
    if (lower && upper && (*upper < *lower || (*upper == *lower && !closed))) return std::nullopt;
    return RangedPolynomial{gcd(one.polynomial, other.polynomial), {lower, upper}, closed};
}

}  // namespace

SplineRoots cuts(std::span<const CurvePiece> pieces, std::span<const Rational> hyperplane,
                 const Rational& width, const Limits& limits) {
    std::vector<RangedPolynomial> functionals;
    for (const CurvePiece& piece : pieces) {
        if (hyperplane.size() != piece.coordinates.size()) {
            throw Error(ErrorCode::mismatched_dimensions,
                        std::to_string(hyperplane.size()) + " numbers for " +
                            std::to_string(piece.dimension()) +
                            " coordinates; a line a x + b y + c = 0 is given by a, b, c");
        }
        Polynomial functional;
        for (std::size_t j = 0; j < hyperplane.size(); ++j)
            functional += piece.coordinates[j] * Polynomial(hyperplane[j]);
        functionals.push_back(
            {without_factors_of(std::move(functional), piece.weight()), piece.range, piece.closed});
    }
    return roots(functionals, width, limits);
}

SplineRoots common_roots(std::span<const std::vector<CurvePiece>> curves, const Rational& width,
                         const Limits& limits) {
    std::vector<RangedPolynomial> common{{Polynomial(), {}, true}};
    for (const std::vector<CurvePiece>& curve : curves) {
        std::vector<RangedPolynomial> next;
        for (const RangedPolynomial& known : common) {
            for (const CurvePiece& piece : curve) {
                if (auto part =
                        common_piece(known, {without_factors_of(piece.coordinates.front(), piece.weight()),
                                             piece.range, piece.closed}))
                    next.push_back(*std::move(part));
            }
        }
        common = std::move(next);
    }
    return roots(common, width, limits);
}

}  // namespace blossom
