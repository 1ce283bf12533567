#include <blossom/core/curve/newton_form.hpp>
#include <blossom/core/spline/basis_functions.hpp>
#include <blossom/core/spline/basis_matrix.hpp>
#include <blossom/core/spline/spline_elevation.hpp>
#include "core_test.hpp"

namespace {

/// matrix * points.
std::vector<Coordinates> transformed(const std::vector<std::vector<Rational>>& matrix,
                                     const std::vector<Coordinates>& points) {
    std::vector<Coordinates> result;
    for (const auto& row : matrix) {
        REQUIRE(row.size() == points.size());
        Coordinates sum(points.front().size());
        for (std::size_t j = 0; j < row.size(); ++j) sum = combined(1, sum, row[j], points[j]);
        result.push_back(std::move(sum));
    }
    return result;
}

/// The sum of the blossom values p(x_0^(i_0), ..., x_k^(i_k), delta^k) over all i with the sum n - k.
Coordinates divided_difference(const PolynomialCurve& curve, std::span<const Rational> nodes, std::size_t k) {
    const std::size_t n = curve.degree();
    Coordinates sum(curve.dimension());
    for (const MultiIndex& index : multi_indices(k, n - k)) {
        std::vector<Argument> arguments(k, delta);
        for (std::size_t i = 0; i <= k; ++i)
            arguments = with_copies(arguments, index[i], Parameter(nodes[i]));
        sum = combined(1, sum, 1, blossom_value(curve, arguments, Construction::symmetric));
    }
    return sum;
}

}  // namespace

TEST_CASE("the weights of control points in a blossom value are those of de Boor's triangle", "[basis]") {
    Random random(411);
    for (int round = 0; round < 200; ++round) {
        const BSplineCurve curve = spline(random, random.below(6)).curve();
        const std::vector<std::size_t> spans = curve.knots().spans();
        const std::size_t span = spans[random.below(spans.size())];
        const std::vector<Argument> at = arguments(random, curve.degree(), Size::small);
        const auto [first, weights] = blossom_weights(curve.knots(), span, at);
        Coordinates sum(curve.dimension());
        for (std::size_t i = 0; i < weights.size(); ++i)
            sum = combined(1, sum, weights[i], curve.control_points()[first + i]);
        CHECK(sum == segment_blossom(curve, span, at));
    }
    const KnotVector knots(1, {0, 0, 1, 1}, 2);
    CHECK(failure_code([&] { blossom_weights(knots, 1, {}); }) == ErrorCode::wrong_arity);
    CHECK(failure_code([&] { blossom_weights(knots, 0, std::vector<Argument>{delta}); }) ==
          ErrorCode::outside_domain);
}

TEST_CASE("coefficients of Newton's form are sums of blossom values", "[newton]") {
    Random random(412);
    for (std::size_t round = 0; round < 120; ++round) {
        const std::size_t n = round % 6;
        const PolynomialCurve curve = polynomial_map(random, n, Size::small).curve();
        std::vector<Rational> nodes;
        for (std::size_t i = 0; i <= n; ++i)
            nodes.push_back(i > 0 && random.one_in(3) ? nodes[random.below(i)] : small_rational(random));
        const PointArray coefficients = newton_form(curve, nodes);
        REQUIRE(coefficients.size() == n + 1);
        for (std::size_t k = 0; k <= n; ++k) CHECK(coefficients[k] == divided_difference(curve, nodes, k));
        CHECK(monomial_form_of_newton(coefficients, nodes) == curve);
    }
    CHECK(failure_code([] {
              newton_form(PolynomialCurve(Polynomial::monomial(2)), std::vector<Rational>{1});
          }) == ErrorCode::wrong_arity);
    CHECK(failure_code([] { lagrange_polynomials(std::vector<Rational>{1, 2, 1}); }) ==
          ErrorCode::wrong_arity);
}

TEST_CASE("the matrix between knot vectors inserts knots and raises degrees", "[basis]") {
    Random random(413);
    for (int round = 0; round < 150; ++round) {
        const BSplineCurve curve = spline(random, random.below(5)).curve();
        const BSplineCurve finer = insert_knots_boehm(curve, insertable(random, curve.knots(), 4));
        CHECK(transformed(basis_matrix(curve.knots(), finer.knots()), curve.control_points()) ==
              finer.control_points());
        const BSplineCurve raised = elevate(curve, 1 + random.below(3));
        CHECK(transformed(basis_matrix(curve.knots(), raised.knots()), curve.control_points()) ==
              raised.control_points());
    }
}

TEST_CASE("a basis that is not in the span of another one is refused at the reason", "[basis]") {
    const KnotVector bent(2, {0, 0, 0, 1, 2, 2, 2}, 4);
    const KnotVector smooth(2, {0, 0, 0, 2, 2, 2}, 3);
    const auto refused = [](const Basis& from, const Basis& to) {
        const auto error = failure([&] { basis_matrix(from, to); });
        REQUIRE(error);
        return std::pair(error->code(), error->place());
    };
    CHECK(refused(bent, smooth) == std::pair(ErrorCode::bad_knots, Place{Part::to, Part::knots}));
    CHECK(refused(bent, PowerBasis{2, 0}) ==
          std::pair(ErrorCode::bad_knots, Place{Part::from, Part::knots, std::size_t{3}}));
    CHECK(refused(PowerBasis{3, 0}, bent) == std::pair(ErrorCode::degree_too_low, Place(Part::to)));
    CHECK(refused(smooth, KnotVector(2, {0, 0, 0, 3, 3, 3}, 3)) ==
          std::pair(ErrorCode::outside_domain, Place{Part::to, Part::knots}));
    CHECK(refused(LagrangeBasis{{1, 1}}, PowerBasis{1, 0}) ==
          std::pair(ErrorCode::wrong_arity, Place{Part::from, Part::nodes, std::size_t{1}}));
    CHECK(failure_code([] { basis_matrix(PowerBasis{20, 0}, PowerBasis{20, 1}, {.numbers = 440}); }) ==
          ErrorCode::limit_exceeded);
    CHECK(basis_matrix(PowerBasis{20, 0}, PowerBasis{20, 1}, {.numbers = 441}).size() == 21);
}
