#include <blossom/core/curve/interpolation.hpp>
#include <blossom/core/spline/basis_functions.hpp>
#include <blossom/core/spline/spline_interpolation.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace blossom {

namespace {

/// One equation, over the integers: sum_i entries[i] P_(first + i) = right, a number per coordinate.
struct Equation {
    std::size_t first = 0;
    std::vector<Integer> entries;
    std::vector<Integer> right;
};

/// The part of the domain on which a basis function is not 0.
std::pair<Rational, Rational> support(const KnotVector& knots, std::size_t point) {
    const std::size_t window = knots.window_index(point);
    const std::size_t end = window + knots.degree();
    const Interval domain = knots.domain();
    return {window > 0 ? std::max(knots[window - 1], domain.a()) : domain.a(),
            end < knots.size() ? std::min(knots[end], domain.b()) : domain.b()};
}

bool is_zero_at(const KnotVector& knots, std::size_t point, const Rational& node) {
    const BasisValues row = basis_values(knots, node);
    return point < row.first_point || point > row.first_point + knots.degree() ||
           row.values[point - row.first_point].is_zero();
}

[[noreturn]] void refuse_nodes(const KnotVector& knots, std::span<const Rational> ordered, std::size_t i,
                               std::size_t order) {
    const auto [begin, end] = support(knots, i);
    const std::string function = "B-spline " + std::to_string(i);
    const std::string interval = "[" + to_string(begin) + ", " + to_string(end) + "]";
    const bool none =
        std::ranges::all_of(ordered, [&](const Rational& node) { return is_zero_at(knots, i, node); });
    const std::string datum =
        order > 0 ? "the derivative of order " + std::to_string(order) : std::string("the value");
    throw Error(
        ErrorCode::missing_sample,
        "the nodes do not determine the spline: " +
            (none ? function + " is 0 at all of them, none lies inside its support " + interval
                  : "in increasing order, datum " + std::to_string(i) + " is " + datum + " at " +
                        to_string(ordered[i]) + ", which does not involve " + function + " on " + interval),
        Part::nodes);
}

/// Whether datum i determines control point i, given those before.
bool is_determined(const KnotVector& knots, const BasisValues& row, const Rational& node, std::size_t i) {
    const std::size_t n = knots.degree();
    if (i < row.first_point || i > row.first_point + n) return false;
    const auto [begin, end] = support(knots, i);
    return (begin < node && node < end) || !row.values[i - row.first_point].is_zero();
}

Equation equation(const BasisValues& row, const Coordinates& value) {
    std::vector<Rational> numbers = row.values;
    numbers.insert(numbers.end(), value.begin(), value.end());
    const RationalVector cleared(numbers);
    const auto behind = cleared.numerators().begin() + static_cast<std::ptrdiff_t>(row.values.size());
    return {row.first_point, {cleared.numerators().begin(), behind}, {behind, cleared.numerators().end()}};
}

std::vector<Equation> equations(const KnotVector& knots, std::span<const Rational> nodes,
                                std::span<const Coordinates> values, const Limits& limits) {
    std::vector<NodeDatum> data = data_in_order(nodes, values);
    // At the end of the domain the derivatives are those from the left, and it is the last B-spline that has
    // a value there, the one before a derivative of order 1, and so on.
    const auto at_end = std::ranges::find(data, knots.domain().b(),
                                          [&](const NodeDatum& datum) { return nodes[datum.index]; });
    std::reverse(at_end, data.end());
    std::vector<Rational> ordered;
    std::vector<BasisValues> rows;
    ordered.reserve(data.size());
    rows.reserve(data.size());
    for (const NodeDatum& datum : data) {
        ordered.push_back(nodes[datum.index]);
        rows.push_back(within(Part::nodes, [&] {
            return within(datum.index,
                          [&] { return basis_derivatives(knots, datum.order, nodes[datum.index], limits); });
        }));
    }
    std::vector<Equation> system;
    for (std::size_t i = 0; i < data.size(); ++i) {
        if (!is_determined(knots, rows[i], ordered[i], i)) refuse_nodes(knots, ordered, i, data[i].order);
        system.push_back(equation(rows[i], values[data[i].index]));
    }
    return system;
}

/// Removes the entries below the diagonal without fractions: afterwards row i begins at column i, and its
/// entry for column j is the minor of the rows 0, ..., i and the columns 0, ..., i - 1, j. Returns the
/// determinant. Cost: O(n^2) products of minors per row at degree n. Source: Bareiss, "Sylvester's identity
/// and multistep integer-preserving Gaussian elimination", 1968.
Integer eliminate(std::vector<Equation>& system, const Limits& limits) {
    std::vector<Integer> pivots{1};  // pivots[k + 1] is the minor of the first k + 1 rows and columns
    for (std::size_t i = 0; i < system.size(); ++i) {
        Equation& row = system[i];
        for (auto* part : {&row.entries, &row.right}) {
            for (Integer& entry : *part) entry *= pivots[row.first];
        }
        for (std::size_t k = row.first; k < i; ++k) {
            const Equation& above = system[k];
            const Integer factor = row.entries[k - row.first];
            const auto combine = [&](Integer& entry, const Integer* other) {
                entry *= pivots[k + 1];
                if (other) entry -= factor * *other;
                entry = divide_exactly(entry, pivots[k]);
            };
            for (std::size_t j = k + 1; j - row.first < row.entries.size(); ++j) {
                const bool inside = j - k < above.entries.size();
                combine(row.entries[j - row.first], inside ? &above.entries[j - k] : nullptr);
            }
            for (std::size_t j = 0; j < row.right.size(); ++j) combine(row.right[j], &above.right[j]);
        }
        row.entries.erase(row.entries.begin(),
                          row.entries.begin() + static_cast<std::ptrdiff_t>(i - row.first));
        row.first = i;
        if (row.entries.front().is_zero()) {
            throw Error(ErrorCode::missing_sample, "the nodes do not determine the spline", Part::nodes);
        }
        pivots.push_back(row.entries.front());
        require_result_bits(std::max(greatest_bit_length(row.entries), greatest_bit_length(row.right)),
                            limits, row.right.size() * system.size());
    }
    return pivots.back();
}

}  // namespace

BSplineCurve interpolate(const KnotVector& knots, std::span<const Rational> nodes,
                         std::span<const Coordinates> values, const Limits& limits) {
    if (nodes.size() != knots.points()) {
        throw Error(ErrorCode::wrong_arity,
                    "the " + std::to_string(knots.points()) + " control points of the spline need as many " +
                        "nodes, not " + std::to_string(nodes.size()),
                    Part::nodes);
    }
    std::vector<Equation> system = equations(knots, nodes, values, limits);
    const Integer determinant = eliminate(system, limits);
    // Cramer: the numerators of the control points over the determinant, from the last one up.
    const std::size_t dimension = values.front().size();
    std::vector<Coordinates> points(system.size());
    for (std::size_t i = system.size(); i-- > 0;) {
        Equation& row = system[i];
        for (std::size_t j = 0; j < dimension; ++j) {
            Integer numerator = row.right[j] * determinant;
            for (std::size_t k = 1; k < row.entries.size(); ++k)
                numerator -= row.entries[k] * system[i + k].right[j];
            row.right[j] = divide_exactly(numerator, row.entries.front());
            points[i].emplace_back(row.right[j], determinant);
        }
    }
    return {knots, std::move(points)};
}

}  // namespace blossom
