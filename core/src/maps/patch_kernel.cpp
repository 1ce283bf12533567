#include "patch_kernel.hpp"

#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <numeric>
#include <string>

#include "integer_frame.hpp"

namespace blossom {

namespace {

/// prod n_f! / (n_f - k_f)!
Integer derivative_factor(const NetShape& shape, const PatchArguments& directions) {
    Integer factor = 1;
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        factor *= falling_factorial(shape[f].degree, directions[f].size());
    }
    return factor;
}

void require_length(std::size_t given, std::size_t needed, ErrorCode code, const std::string& what) {
    if (given == needed) return;
    throw Error(code,
                what + " must have length " + std::to_string(needed) + ", not " + std::to_string(given));
}

}  // namespace

NetSums net_sums(const NetShape& shape, const PointArray& net, const Integer& greatest) {
    return {net.numbers(), net.dimension(), shape.list(), greatest};
}

bool words_are_within(const NetSums& sums, const Limits& limits) {
    // The sum of the entries of a tuple has a few bits more than a word. A decimal digit has more than three
    // bits.
    constexpr std::size_t tuple_bits = 72;
    return sums.sum_bits(tuple_bits) / 3 < limits.digits;
}

Coordinates polar_value(const NetShape& shape, const PointArray& polar, const PatchArguments& arguments,
                        const Limits& limits) {
    require_arguments(shape, arguments);
    const NetSums sums = net_sums(shape, polar, greatest_magnitude(polar));
    Coordinates value(polar.dimension());
    WordTuples words;
    const auto are_words = [&] {
        return std::ranges::all_of(arguments, [&](const auto& list) {
            return std::ranges::all_of(list, [&](const Coordinates& tuple) { return words.add(tuple); });
        });
    };
    if (words_are_within(sums, limits) && are_words()) {
        sums.multilinear_values(words.arguments(), value);
        return value;
    }
    IntegerTuples tuples;
    for (const auto& list : arguments) {
        for (const Coordinates& tuple : list) {
            tuples.add(tuple, 1);
            require_result_bits(sums.sum_bits(0) + tuples.bits(), limits);
        }
    }
    sums.multilinear_values(tuples.arguments(), value);
    return value;
}

PointArray form_of(const NetShape& shape, const PointArray& polar) {
    PointArray form(polar.dimension(), polar.numbers().weighted(multinomials(shape), 1));
    form.make_canonical();
    return form;
}

PointArray polar_of(const NetShape& shape, const PointArray& form) {
    std::vector<Integer> weights = multinomials(shape);
    Integer common = 1;
    for (const Integer& factor : weights) common = lcm(common, factor);
    for (Integer& factor : weights) factor = divide_exactly(common, factor);
    PointArray polar(form.dimension(), form.numbers().weighted(weights, common));
    polar.make_canonical();
    return polar;
}

Coordinates polar_derivative_at(const NetShape& shape, const PointArray& polar,
                                const PatchArguments& directions, const PatchPoint& at,
                                const Limits& limits) {
    const Integer factor = derivative_factor(shape, directions);
    if (factor.is_zero()) return Coordinates(polar.dimension());
    PatchArguments arguments = directions;
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        arguments[f].insert(arguments[f].begin(), shape[f].degree - directions[f].size(), at[f]);
    }
    Coordinates value = polar_value(shape, polar, arguments, limits);
    for (Rational& coordinate : value) coordinate *= factor;
    return value;
}

std::pair<NetShape, PointArray> polar_derivative(NetShape shape, const PointArray& polar,
                                                 const PatchArguments& directions, const Limits& limits) {
    const Integer factor = derivative_factor(shape, directions);
    if (factor.is_zero()) {
        for (std::size_t f = 0; f < shape.factors(); ++f) {
            const std::size_t degree = shape[f].degree;
            shape = shape.with_degree(f, degree - std::min(degree, directions[f].size()));
        }
        std::vector<Integer> zeros(shape.size() * polar.dimension());
        return {std::move(shape), PointArray(polar.dimension(), RationalVector(std::move(zeros), 1))};
    }
    return partial_polar(std::move(shape), polar, directions, factor, limits);
}

std::pair<NetShape, PointArray> partial_polar(NetShape shape, const PointArray& polar,
                                              const PatchArguments& arguments, const Integer& factor,
                                              const Limits& limits) {
    const IntegerArguments integers = cleared_one_by_one(arguments, bits_of(polar), limits);
    auto rows = each_row(polar, [&](std::span<const Integer> row) {
        std::vector<Integer> scaled(row.begin(), row.end());
        for (Integer& entry : scaled) entry *= factor;
        return scaled;
    });
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        for (const Tuple<Integer>& argument : integers.tuples[f]) {
            for (auto& row : rows) row = constructions::fold<Integer>(shape, f, row, argument);
            shape = shape.with_degree(f, shape[f].degree - 1);
        }
    }
    return {std::move(shape), canonical_points(rows, integers.denominator * polar.denominator())};
}

void require_mass(const Coordinates& tuple, int mass, const std::string& what) {
    const Rational sum = std::accumulate(tuple.begin(), tuple.end(), Rational());
    if (sum == mass) return;
    throw Error(ErrorCode::not_affine, what + " must have barycentric coordinates of sum " +
                                           std::to_string(mass) + ", not " + to_string(sum));
}

void require_first(const Coordinates& tuple, int mass, const std::string& what) {
    if (tuple.front() == mass) return;
    throw Error(ErrorCode::not_affine,
                what + " must have the mass " + std::to_string(mass) + ", not " + to_string(tuple.front()));
}

void require_point(std::span<const SimplexFactor> shape, const PatchPoint& point) {
    require_length(point.size(), shape.size(), ErrorCode::wrong_arity, "a point with one argument a factor");
    for (std::size_t f = 0; f < shape.size(); ++f) {
        within(f, [&] {
            require_length(point[f].size(), shape[f].dimension + 1, ErrorCode::mismatched_dimensions,
                           "the argument of factor " + std::to_string(f));
        });
    }
}

namespace {

/// Requires one list per factor, of tuples with the right length; `what` names an element of a list.
void require_lists(const NetShape& shape, const PatchArguments& lists, Part part, const std::string& what) {
    within(part, [&] {
        require_length(lists.size(), shape.factors(), ErrorCode::wrong_arity,
                       "the list of " + what + " lists, one a factor,");
        for (std::size_t f = 0; f < lists.size(); ++f) {
            for (std::size_t i = 0; i < lists[f].size(); ++i) {
                within(f, [&] {
                    within(i, [&] {
                        require_length(lists[f][i].size(), shape[f].dimension + 1,
                                       ErrorCode::mismatched_dimensions,
                                       what + " " + std::to_string(i) + " of factor " + std::to_string(f));
                    });
                });
            }
        }
    });
}

}  // namespace

void require_directions(const NetShape& shape, const PatchArguments& directions) {
    require_lists(shape, directions, Part::directions, "direction");
}

void require_some_arguments(const NetShape& shape, const PatchArguments& arguments) {
    require_lists(shape, arguments, Part::arguments, "argument");
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        if (arguments[f].size() <= shape[f].degree) continue;
        throw Error(ErrorCode::wrong_arity,
                    std::to_string(arguments[f].size()) + " arguments for the degree " +
                        std::to_string(shape[f].degree) + "; there are at most as many as the degree",
                    Part::arguments / f);
    }
}

void require_arguments(const NetShape& shape, const PatchArguments& arguments) {
    within(Part::arguments, [&] {
        for (std::size_t f = 0; f < std::min(arguments.size(), shape.factors()); ++f) {
            within(f, [&] {
                require_length(arguments[f].size(), shape[f].degree, ErrorCode::wrong_arity,
                               "the argument list of factor " + std::to_string(f));
            });
        }
    });
    require_lists(shape, arguments, Part::arguments, "argument");
}

}  // namespace blossom
