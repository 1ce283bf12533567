#pragma once

// Two pieces of plane curves, and the equations of their common points.

#include <blossom/core/queries/curve_pieces.hpp>
#include <blossom/core/queries/intersections.hpp>

#include <optional>
#include <vector>

namespace blossom {

/// A polynomial in s and t by its coefficients in one of them.
using PolynomialRows = std::vector<Polynomial>;

/// Two equations in s and t, as polynomials in t with coefficients in s, and the other way round.
struct PairEquations {
    PolynomialRows in_t[2];
    PolynomialRows in_s[2];
};

/// x(s) z(t) - u(t) w(s) and y(s) z(t) - v(t) w(s).
PairEquations equations_of_common_points(const CurvePiece& first, const CurvePiece& second);

/// The same for one curve, (x(s) w(t) - x(t) w(s)) / (s - t) and likewise for y: they are symmetric.
PairEquations equations_of_double_points(const CurvePiece& curve);

/// The resultant of the two equations in t, a polynomial in s without the factors of the weight of `first`;
/// 0 exactly if they have a common factor that depends on t.
Polynomial equation_of_first(const PairEquations& equations, const CurvePiece& first, const Limits& limits);
Polynomial equation_of_second(const PairEquations& equations, const CurvePiece& second, const Limits& limits);

/// The roots of a polynomial, which is not zero, in the range of a piece, of which it may lack the upper end.
std::vector<Root> roots_in(const CurvePiece& piece, const Polynomial& polynomial, const Rational& width,
                           const Limits& limits);

/// Whether a piece is a single point.
bool is_point(const CurvePiece& piece);

/// Decides for parameters whether the points of two pieces are the same there, and how they touch.
class PointComparison {
public:
    PointComparison(const CurvePiece& first, const CurvePiece& second, const Limits& limits);

    bool meet(const Root& s, const Root& t);
    /// Of a common point; 0 if it is more than `most`, which the caller gives where the curves may be the
    /// same there, or where the velocity of one of them is 0.
    std::size_t multiplicity(const Root& s, const Root& t, std::optional<std::size_t> most = {});

private:
    struct Quotient {
        Polynomial numerator;
        Polynomial denominator;
    };

    bool is_excluded(Root s, Root t) const;
    bool have_same_value(const Quotient& of_first, const Quotient& of_second, AlgebraicValues& at_first,
                         AlgebraicValues& at_second, const Root& s, const Root& t) const;
    bool have_same_value(const Quotient& of_first, const Quotient& of_second, const Root& s,
                         const Root& t) const;

    const CurvePiece& first_;
    const CurvePiece& second_;
    const Limits& limits_;
    std::vector<AlgebraicValues> coordinates_[2];
    std::vector<Polynomial> velocity_[2] = {velocity(first_), velocity(second_)};
};

/// Adds the common parts of two pieces of the same irreducible curve, and the parameters of `first` and of
/// `second` besides them at which they may meet. `is_self` if they are one piece: then only parts with lower
/// parameters of `first` count.
struct CommonParts {
    std::vector<CurveOverlap> overlaps;
    std::vector<Root> first;
    std::vector<Root> second;
};
CommonParts common_parts(const CurvePiece& first, const CurvePiece& second, const PairEquations& equations,
                         bool is_self, const Rational& width, const Limits& limits);

}  // namespace blossom
