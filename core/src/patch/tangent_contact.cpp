#include <blossom/core/patch/tangent_contact.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>

#include "edge_rows.hpp"

namespace blossom {

namespace {

using Columns = std::vector<std::vector<Polynomial>>;

/// The determinant of the columns other than `left_out`, in some rows, by expansion along the first row.
Polynomial minor_of(const Columns& columns, std::vector<std::size_t> rows, std::vector<std::size_t> chosen) {
    if (rows.empty()) return 1;
    const std::size_t row = rows.front();
    rows.erase(rows.begin());
    Polynomial sum;
    for (std::size_t k = 0; k < chosen.size(); ++k) {
        const Polynomial& entry = columns[chosen[k]][row];
        if (entry.is_zero()) continue;
        std::vector<std::size_t> others = chosen;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
        const Polynomial term = entry * minor_of(columns, rows, std::move(others));
        sum += k % 2 == 0 ? term : -term;
    }
    return sum;
}

/// The minors, with signs, that make a relation of the columns in these rows.
std::vector<Polynomial> relation_in(const Columns& columns, const std::vector<std::size_t>& rows) {
    std::vector<Polynomial> functions;
    for (std::size_t j = 0; j < columns.size(); ++j) {
        std::vector<std::size_t> chosen;
        for (std::size_t k = 0; k < columns.size(); ++k) {
            if (k != j) chosen.push_back(k);
        }
        const Polynomial minor = minor_of(columns, rows, std::move(chosen));
        functions.push_back(j % 2 == 0 ? minor : -minor);
    }
    return functions;
}

Polynomial combination_in(const Columns& columns, const std::vector<Polynomial>& functions, std::size_t row) {
    Polynomial sum;
    for (std::size_t j = 0; j < columns.size(); ++j) sum += functions[j] * columns[j][row];
    return sum;
}

bool all_zero(const std::vector<Polynomial>& polynomials) {
    return std::ranges::all_of(polynomials, &Polynomial::is_zero);
}

/// Divides by the greatest common divisor; the first coefficient that is not 0 becomes positive, and all
/// together have no common factor.
std::vector<Polynomial> primitive(std::vector<Polynomial> functions) {
    Polynomial common;
    for (const Polynomial& function : functions) common = gcd(common, function);
    for (Polynomial& function : functions) function = divide_exactly(function, common);
    std::vector<Rational> numbers;
    for (const Polynomial& function : functions) {
        for (std::size_t k = 0; k <= function.degree(); ++k) numbers.push_back(function[k]);
    }
    const RationalVector cleared(numbers);
    Integer content;
    for (const Integer& numerator : cleared.numerators()) content = gcd(content, numerator);
    Rational factor(cleared.denominator(), content);
    if (std::ranges::find_if(numbers, [](const Rational& x) { return !x.is_zero(); })->sign() < 0)
        factor = -factor;
    for (Polynomial& function : functions) function *= Polynomial(factor);
    return functions;
}

/// All choices of `count` of the numbers below `size`, until action(choice) is true.
template <class Action>
bool any_choice(std::size_t size, std::size_t count, const Action& action) {
    if (count > size) return false;
    std::vector<std::size_t> choice(count);
    for (std::size_t i = 0; i < count; ++i) choice[i] = i;
    while (true) {
        if (action(choice)) return true;
        std::size_t i = count;
        while (i > 0 && choice[i - 1] == size - count + i - 1) --i;
        if (i == 0) return false;
        ++choice[i - 1];
        for (std::size_t k = i; k < count; ++k) choice[k] = choice[k - 1] + 1;
    }
}

/// A parameter of [0, 1] at which the polynomial, which is not 0, does not vanish.
Rational parameter_off_roots(const Polynomial& polynomial) {
    for (std::size_t n = 1;; ++n) {
        for (std::size_t k = 0; k <= n; ++k) {
            Rational t(k, n);
            if (!polynomial(t).is_zero()) return t;
        }
    }
}

Coordinates vector_at(const std::vector<Polynomial>& vector, const Rational& t) {
    Coordinates values;
    values.reserve(vector.size());
    for (const Polynomial& coordinate : vector) values.push_back(coordinate(t));
    return values;
}

/// Twice the area of begin, end and begin + vector.
Rational side_of(const PlaneSegment& segment, const Coordinates& vector) {
    return (segment.end[0] - segment.begin[0]) * vector[1] - (segment.end[1] - segment.begin[1]) * vector[0];
}

/// The vector off the edge of a triangle, or its opposite where it leads out of the domain.
Coordinates into_domain(const PlacedPatch& patch, const std::vector<Coordinates>& triangle) {
    const PlaneSegment segment{triangle[0], triangle[1]};
    Coordinates vector{triangle[2][0] - triangle[0][0], triangle[2][1] - triangle[0][1]};
    for (const PlaneSegment& edge : edges_of(patch)) {
        const int own =
            side_of(segment, {edge.begin[0] - segment.begin[0], edge.begin[1] - segment.begin[1]}).sign();
        if (own == 0) continue;
        if (own != side_of(segment, vector).sign())
            for (Rational& coordinate : vector) coordinate = -coordinate;
        break;
    }
    return vector;
}

EdgeRows rows_into(const PlacedPatch& patch, const std::vector<Coordinates>& triangle, const Limits& limits) {
    const Coordinates vector = into_domain(patch, triangle);
    const Coordinates off{triangle[0][0] + vector[0], triangle[0][1] + vector[1]};
    return EdgeRows(over_triangle(patch, {triangle[0], triangle[1], off}, limits));
}

}  // namespace

std::array<Coordinates, 2> across(std::span<const PlacedPatch> left, std::span<const PlacedPatch> right,
                                  const Joint& joint) {
    return {into_domain(left[joint.left_piece], joint.left),
            into_domain(right[joint.right_piece], joint.right)};
}

TangentContact tangent_contact(std::span<const PlacedPatch> left, std::span<const PlacedPatch> right,
                               const Joint& joint, bool projected, const Limits& limits) {
    using Kind = TangentContact::Kind;
    const PlacedPatch& one = left[joint.left_piece];
    const PlacedPatch& two = right[joint.right_piece];
    const std::size_t dimension = one.patch.dimension();
    if (dimension < (projected ? 3 : 2)) {
        throw Error(
            ErrorCode::mismatched_dimensions,
            "tangent planes are those of points with at least 2 coordinates; graph gives one with the "
            "parameters in front");
    }
    const PatchContact met = joint_contact(left, right, joint, projected, limits);
    TangentContact result{Kind::apart, {}, {}, {}, {}};
    if (met.order && *met.order < 0) return result;

    const EdgeRows from_left = rows_into(one, joint.left, limits);
    const EdgeRows from_right = rows_into(two, joint.right, limits);
    Columns columns{from_left.across(), from_right.across(), from_left.along()};
    if (projected) columns.push_back(from_left.points());

    const std::size_t size = columns.size();
    const bool has_relation = any_choice(dimension, size - 1, [&](const std::vector<std::size_t>& rows) {
        result.functions = relation_in(columns, rows);
        return !all_zero(result.functions);
    });
    if (!has_relation) {
        result.kind = Kind::singular;
        result.functions.clear();
        return result;
    }
    for (std::size_t row = 0; row < dimension; ++row) {
        const Polynomial independent = combination_in(columns, result.functions, row);
        if (independent.is_zero()) continue;
        const Rational t = parameter_off_roots(independent);
        result = {Kind::bent, {}, t, {}, {}};
        for (std::size_t j = 0; j < 3; ++j) result.vectors[j] = vector_at(columns[j], t);
        return result;
    }
    result.functions = primitive(std::move(result.functions));
    Polynomial sides = result.functions[0] * result.functions[1];
    if (projected) sides *= from_left.points().back() * from_right.points().back();
    if (sides.is_zero()) {
        result.kind = Kind::singular;
        return result;
    }
    result.singular = roots(sides, Interval(), 0, limits);
    if (!result.singular.empty()) {
        result.kind = Kind::singular;
    } else {
        result.kind = sides(0).sign() > 0 ? Kind::smooth : Kind::folded;
    }
    return result;
}

}  // namespace blossom
