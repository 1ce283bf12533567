#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <bit>

#include "grounder.hpp"

/// The functions of the language that give numbers, points or vectors.

namespace blossom::proofs {

Value Grounder::call(const Expression& e) {
    const auto& arguments = e.children;
    if (e.name == "sum") return sum_of(over_range(e), kinds_->of(e));
    if (e.name == "if") return chosen(e);
    if (e.name == "determinant") return determinant(e);
    if (e.name == "bernstein") return bernstein(e);
    if (e.name == "bspline") return bspline(e);
    if (e.name == "size") {
        const bool collection = kinds_->of(arguments[0]).name == KindName::sets;
        return constant(collection ? elements_of(arguments[0]).size() : set_of(arguments[0]).size());
    }
    if (e.name == "sign") {
        // A permutation is odd if its number of inversions is.
        const std::vector<long long>& images = permutation(arguments[0].name)->images;
        int sign = 1;
        for (std::size_t i = 0; i < images.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) sign = images[j] > images[i] ? -sign : sign;
        }
        return constant(sign);
    }
    if (e.name == "factorial") {
        const std::size_t n = count(arguments[0]);
        spend(n, e.offset);
        return constant(factorial(n));
    }
    if (e.name == "binomial") {
        const std::size_t n = count(arguments[0]);
        const long long k = integer(arguments[1]);
        spend(n, e.offset);
        return constant(k < 0 ? Integer(0) : binomial(n, static_cast<std::size_t>(k)));
    }
    std::vector<Value> values = over_range(e);
    if (e.name == "mean") {
        if (values.empty()) refuse("the mean of nothing is not defined", e.offset);
        const NodeId weight = constant(Rational(1, values.size()));
        return scaled(weight, sum_of(std::move(values), {}));
    }
    std::vector<NodeId> factors;
    factors.reserve(values.size());
    for (const Value& value : values) factors.push_back(std::get<NodeId>(value));
    return multiply(std::move(factors));
}

/// if(i == j, a, b): only the chosen branch is evaluated.
Value Grounder::chosen(const Expression& e) {
    Value result = value(e.children[holds(e.children[0]) ? 1 : 2]);
    if (kinds_->of(e).is_geometric()) return as_argument(result);
    return result;
}

/// C(n, i) t^i (1 - t)^(n - i), zero for i outside 0..n.
NodeId Grounder::bernstein(const Expression& e) {
    const long long i = integer(e.children[0]);
    const std::size_t n = count(e.children[1]);
    const NodeId t = scalar(e.children[2]);
    if (i < 0 || static_cast<std::size_t>(i) > n) return multiply({constant(0), t});
    const auto k = static_cast<std::size_t>(i);
    const NodeId rest = add({constant(1), multiply({constant(-1), t})});
    return multiply({constant(binomial(n, k)), raise(t, k, e.offset), raise(rest, n - k, e.offset)});
}

NodeId Grounder::determinant(const Expression& e) {
    const std::size_t n = count(e.children[2]);
    require_elements(Integer(n) * pow(Integer(2), n), limits_, e.offset);
    std::vector<std::vector<NodeId>> rows(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Binding row(*this, e.children[0].name, static_cast<long long>(i) + 1);
        for (std::size_t j = 0; j < n; ++j) {
            const Binding column(*this, e.children[1].name, static_cast<long long>(j) + 1);
            rows[i].push_back(scalar(e.children[3]));
        }
    }
    return determinant(rows);
}

/// Laplace expansion by rows: for every set of columns, the minor of the first rows is computed once. Cost: n
/// 2^(n-1) products for n rows.
NodeId Grounder::determinant(const std::vector<std::vector<NodeId>>& rows) {
    const std::size_t n = rows.size();
    std::vector<NodeId> minors(std::size_t{1} << n, constant(1));
    for (std::size_t columns = 1; columns < minors.size(); ++columns) {
        const auto row = static_cast<std::size_t>(std::popcount(columns)) - 1;
        std::vector<NodeId> summands;
        std::size_t to_the_right = row;
        for (std::size_t j = 0; j < n; ++j) {
            if ((columns >> j) % 2 == 0) continue;
            const NodeId sign = constant(to_the_right-- % 2 == 0 ? 1 : -1);
            summands.push_back(multiply({sign, rows[row][j], minors[columns ^ (std::size_t{1} << j)]}));
        }
        minors[columns] = add(std::move(summands));
    }
    return minors.back();
}

/// The polynomial that equals the B-spline basis function N_{j,d} over the knots x_i on the span [x_i,
/// x_{i+1}).
NodeId Grounder::bspline(const Expression& e) {
    const long long j = integer(e.children[0]);
    const std::size_t degree = count(e.children[1]);
    const long long span = integer(e.children[3]);
    const NodeId t = scalar(e.children[4]);
    require_elements(pow(Integer(2), degree), limits_, e.offset);
    return add({multiply({constant(0), t}),
                basis_function(e.children[2], j, static_cast<long long>(degree), span, t, e.offset)});
}

/// The recursion of Cox and de Boor. A function that vanishes on the span is omitted together with its
/// divisor.
NodeId Grounder::basis_function(const Expression& knots, long long j, long long degree, long long span,
                                NodeId t, std::size_t offset) {
    if (span < j || span > j + degree) return constant(0);
    if (degree == 0) return constant(1);
    const auto knot = [&](long long i) {
        Expression name = knots;
        const bool negative = i < 0;
        Expression index{ExpressionKind::number, knots.offset, std::to_string(negative ? -i : i), {}, {}};
        if (negative) index = {ExpressionKind::negative, knots.offset, "", {std::move(index)}, {}};
        name.children.push_back(std::move(index));
        return scalar(name);
    };
    const auto minus = [&](NodeId a, NodeId b) { return add({a, multiply({constant(-1), b})}); };
    std::vector<NodeId> summands;
    if (span < j + degree) {
        const NodeId ratio = divide(minus(t, knot(j)), minus(knot(j + degree), knot(j)), offset);
        summands.push_back(multiply({ratio, basis_function(knots, j, degree - 1, span, t, offset)}));
    }
    if (span > j) {
        const NodeId last = knot(j + degree + 1);
        const NodeId ratio = divide(minus(last, t), minus(last, knot(j + 1)), offset);
        summands.push_back(multiply({ratio, basis_function(knots, j + 1, degree - 1, span, t, offset)}));
    }
    return add(std::move(summands));
}

}  // namespace blossom::proofs
