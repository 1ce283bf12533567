#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/blossom/evaluation.hpp>
#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/curve/newton_form.hpp>
#include <blossom/core/maps/taylor_curve.hpp>
#include <blossom/core/spline/basis_matrix.hpp>
#include <blossom/core/spline/de_boor.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace blossom {

namespace {

using Matrix = std::vector<std::vector<Rational>>;

template <class... Functions>
struct Overloads : Functions... {
    using Functions::operator()...;
};

/// The points whose coordinates are the functions of a basis: 1 in one place, 0 in all others.
PointArray unit_points(std::size_t count) {
    std::vector<Integer> numbers(count * count);
    for (std::size_t i = 0; i < count; ++i) numbers[i * count + i] = 1;
    return {count, RationalVector(std::move(numbers), 1)};
}

/// Consecutive functions of a basis on one interval as the coordinates of a curve; all others are 0 there.
struct Functions {
    std::size_t first = 0;
    PolynomialMap curve;
};

Functions functions_on_span(const KnotVector& knots, std::size_t span, const Limits& limits) {
    const auto around = knots.around(span);
    const ProgressiveCurve curve(std::vector<Rational>(around.begin(), around.end()),
                                 unit_points(knots.degree() + 1).to_points());
    return {knots.first_point(span), control_points(curve, Interval(knots[span], knots[span + 1]), limits)};
}

/// The functions of a basis on the only non-empty span, if it has any.
Functions functions_of(const Basis& basis, const Limits& limits) {
    const PointArray units = unit_points(degree_of(basis) + 1);
    return std::visit(
        Overloads{
            [&](const PowerBasis& powers) -> Functions {
                return {0, monomial_form(TaylorCurve{powers.center, units}, limits)};
            },
            [&](const BernsteinBasis& bernstein) -> Functions {
                return {0, BezierCurve(units, bernstein.interval)};
            },
            [&](const LagrangeBasis& lagrange) -> Functions {
                return {0, lagrange_polynomials(lagrange.nodes, limits)};
            },
            [&](const NewtonBasis& newton) -> Functions {
                return {0, monomial_form_of_newton(units, newton.nodes, limits)};
            },
            [&](const KnotVector& knots) { return functions_on_span(knots, knots.spans().front(), limits); },
        },
        basis);
}

PolynomialMap elevated_to(const PolynomialMap& map, std::size_t degree, const Limits& limits) {
    const std::size_t r = degree - degree_of(map);
    if (r == 0) return map;
    return std::visit([&](const auto& curve) -> PolynomialMap { return elevate(curve, r, limits); }, map);
}

/// The coefficients of a curve in a basis of polynomials of its degree.
std::vector<Coordinates> coefficients(const PowerBasis& powers, const PolynomialMap& curve,
                                      const Limits& limits) {
    return taylor_form(monomial_form(curve, limits), powers.center, limits).coefficients.to_points();
}
std::vector<Coordinates> coefficients(const BernsteinBasis& bernstein, const PolynomialMap& curve,
                                      const Limits& limits) {
    return control_points(curve, bernstein.interval, limits).control_points().to_points();
}
std::vector<Coordinates> coefficients(const LagrangeBasis& lagrange, const PolynomialMap& curve,
                                      const Limits& limits) {
    std::vector<Coordinates> values;
    values.reserve(lagrange.nodes.size());
    for (const Rational& node : lagrange.nodes) {
        values.push_back(
            std::visit([&](const auto& map) { return evaluate(map, Parameter(node), limits); }, curve));
    }
    return values;
}
std::vector<Coordinates> coefficients(const NewtonBasis& newton, const PolynomialMap& curve,
                                      const Limits& limits) {
    return newton_form(monomial_form(curve, limits), newton.nodes, limits).to_points();
}

/// A row of the matrix: the values of the functions that may not be 0, among zeros.
std::vector<Rational> row_of(Coordinates values, std::size_t first, std::size_t count) {
    std::vector<Rational> row(count);
    std::ranges::move(values, row.begin() + static_cast<std::ptrdiff_t>(first));
    return row;
}

template <class Polynomials>
Matrix matrix_to(const Polynomials& to, const Basis& from, const Limits& limits) {
    const Functions functions = functions_of(from, limits);
    Matrix rows;
    for (Coordinates& values :
         coefficients(to, elevated_to(functions.curve, degree_of(Basis(to)), limits), limits)) {
        rows.push_back(row_of(std::move(values), functions.first, function_count(from)));
    }
    return rows;
}

/// The first of the non-empty spans on which a basis function is not 0; if it is 0 on all, the nearest.
std::size_t span_of(const KnotVector& knots, std::span<const std::size_t> spans, std::size_t point) {
    const std::size_t first = knots.begin_index() + point - std::min(point, knots.degree());
    const auto found = std::ranges::lower_bound(spans, first);
    return found == spans.end() ? spans.back() : *found;
}

Matrix matrix_to(const KnotVector& to, const Basis& from, const Limits& limits) {
    const auto* splines = std::get_if<KnotVector>(&from);
    const std::vector<std::size_t> spans = to.spans();
    std::optional<Blossom> blossom;
    std::size_t first = 0;
    std::optional<std::size_t> segment;
    Matrix rows;
    for (std::size_t i = 0; i < to.points(); ++i) {
        const std::size_t wanted = splines ? splines->span_at(to[span_of(to, spans, i)]) : 0;
        if (segment != wanted) {
            const Functions functions =
                splines ? functions_on_span(*splines, wanted, limits) : functions_of(from, limits);
            blossom.emplace(elevated_to(functions.curve, to.degree(), limits), limits);
            first = functions.first;
            segment = wanted;
        }
        std::vector<Argument> arguments;
        for (const Rational& knot : to.window(i)) arguments.emplace_back(Parameter(knot));
        rows.push_back(row_of((*blossom)(arguments), first, function_count(from)));
    }
    return rows;
}

std::string times(std::size_t count) { return count == 1 ? "once" : std::to_string(count) + " times"; }

/// Where a knot stands in the list.
std::size_t index_of(const KnotVector& knots, const Rational& knot) {
    return static_cast<std::size_t>(std::ranges::lower_bound(knots.knots(), knot) - knots.knots().begin());
}

/// The distinct knots in the interior of the domain.
std::vector<KnotMultiplicity> interior_knots(const KnotVector& knots, const Interval& domain) {
    std::vector<KnotMultiplicity> inner = knots.distinct();
    std::erase_if(
        inner, [&](const KnotMultiplicity& one) { return one.knot <= domain.a() || one.knot >= domain.b(); });
    return inner;
}

void require_polynomials(const KnotVector& from) {
    const auto inner = interior_knots(from, from.domain());
    if (inner.empty()) return;
    const auto& [knot, multiplicity] = inner.front();
    throw Error(ErrorCode::bad_knots,
                "B-splines with the knot " + to_string(knot) +
                    " inside their domain are not polynomials: their derivative of order " +
                    std::to_string(from.degree() + 1 - multiplicity) + " jumps there",
                Place{Part::from, Part::knots, index_of(from, knot)});
}

void require_splines(const KnotVector& from, const KnotVector& to) {
    const Interval own = from.domain();
    const Interval wanted = to.domain();
    if (wanted.a() < own.a() || wanted.b() > own.b()) {
        throw Error(ErrorCode::outside_domain,
                    "the B-splines over [" + to_string(own.a()) + ", " + to_string(own.b()) +
                        "] are not known on all of the domain [" + to_string(wanted.a()) + ", " +
                        to_string(wanted.b()) + "] of the other basis",
                    Place{Part::to, Part::knots});
    }
    for (const auto& [knot, multiplicity] : interior_knots(from, wanted)) {
        const std::size_t needed = multiplicity + to.degree() - from.degree();
        const std::size_t present = to.multiplicity(knot);
        if (present >= needed) continue;
        throw Error(ErrorCode::bad_knots,
                    "B-splines of degree " + std::to_string(from.degree()) + " that have the knot " +
                        to_string(knot) + " " + times(multiplicity) + " are splines of degree " +
                        std::to_string(to.degree()) + " only if these have it " + times(needed) +
                        "; they have it " + (present == 0 ? "not at all" : times(present)),
                    Place{Part::to, Part::knots});
    }
}

void require_contained(const Basis& from, const Basis& to) {
    if (degree_of(from) > degree_of(to)) {
        throw Error(ErrorCode::degree_too_low,
                    "functions of degree " + std::to_string(degree_of(from)) +
                        " are not in the span of a basis of degree " + std::to_string(degree_of(to)),
                    Part::to);
    }
    const auto* splines = std::get_if<KnotVector>(&from);
    if (!splines) return;
    if (const auto* knots = std::get_if<KnotVector>(&to)) {
        require_splines(*splines, *knots);
    } else {
        require_polynomials(*splines);
    }
}

}  // namespace

std::size_t degree_of(const Basis& basis) {
    return std::visit(Overloads{[](const PowerBasis& powers) { return powers.degree; },
                                [](const BernsteinBasis& bernstein) { return bernstein.degree; },
                                [](const LagrangeBasis& lagrange) { return lagrange.nodes.size() - 1; },
                                [](const NewtonBasis& newton) { return newton.nodes.size() - 1; },
                                [](const KnotVector& knots) { return knots.degree(); }},
                      basis);
}

std::size_t function_count(const Basis& basis) {
    const auto* knots = std::get_if<KnotVector>(&basis);
    return knots ? knots->points() : degree_of(basis) + 1;
}

Matrix basis_matrix(const Basis& from, const Basis& to, const Limits& limits) {
    for (const auto& [basis, part] : {std::pair(&from, Part::from), std::pair(&to, Part::to)}) {
        require_within(degree_of(*basis), limits.degree, "degree", "the degree", part);
        if (const auto* lagrange = std::get_if<LagrangeBasis>(basis))
            within(part, [&] { require_distinct(lagrange->nodes); });
    }
    require_contained(from, to);
    std::size_t numbers = 0;
    if (__builtin_mul_overflow(function_count(from), function_count(to), &numbers)) numbers = SIZE_MAX;
    require_within(numbers, limits.numbers, "numbers", "the number of entries of the matrix");
    return std::visit([&](const auto& target) { return matrix_to(target, from, limits); }, to);
}

}  // namespace blossom
