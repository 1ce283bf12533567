#include "integer_frame.hpp"

#include <algorithm>
#include <iterator>

namespace blossom {

namespace {

HomogeneousPair<Integer> scaled(const Argument& argument, const Integer& scale) {
    return {argument.u.numerator() * divide_exactly(scale, argument.u.denominator()),
            argument.mass.numerator() * divide_exactly(scale, argument.mass.denominator())};
}

std::size_t bits(const HomogeneousPair<Integer>& pair) {
    return std::max(pair.u.bit_length(), pair.mass.bit_length()) + 1;
}

}  // namespace

Integer ClearedArguments::denominator() const {
    Integer product = 1;
    for (const Integer& scale : scales) product *= scale;
    return product;
}

ClearedArguments cleared_one_by_one(std::span<const Argument> arguments) {
    ClearedArguments cleared;
    cleared.pairs.reserve(arguments.size());
    cleared.scales.reserve(arguments.size());
    for (const Argument& argument : arguments) {
        // Parameters have mass 1, vectors mass 0.
        if (argument.mass.is_integer()) {
            const Integer& scale = argument.u.denominator();
            cleared.pairs.push_back({argument.u.numerator(), argument.mass.numerator() * scale});
            cleared.scales.push_back(scale);
        } else {
            const Integer scale = lcm(argument.u.denominator(), argument.mass.denominator());
            cleared.pairs.push_back(scaled(argument, scale));
            cleared.scales.push_back(scale);
        }
        cleared.bits += bits(cleared.pairs.back());
    }
    return cleared;
}

ClearedInterval cleared(const Interval& interval) {
    const Integer q = lcm(interval.a().denominator(), interval.b().denominator());
    return {interval.a().numerator() * divide_exactly(q, interval.a().denominator()),
            interval.b().numerator() * divide_exactly(q, interval.b().denominator()), q};
}

Coordinates reduced(const Quotients<Integer>& value, const Integer& denominator) {
    const Integer common = value.denominator * denominator;
    Coordinates point;
    point.reserve(value.numerators.size());
    for (const Integer& numerator : value.numerators) point.emplace_back(numerator, common);
    return point;
}

PointArray point_array(std::vector<Quotients<Integer>> rows, const Integer& denominator) {
    Integer common = 1;
    for (const auto& row : rows) common = lcm(common, row.denominator);
    std::vector<Integer> numerators;
    numerators.reserve(rows.size() * rows.front().numerators.size());
    for (auto& row : rows) {
        const Integer scale = divide_exactly(common, row.denominator);
        for (Integer& numerator : row.numerators) {
            if (!scale.is_one()) numerator *= scale;
            numerators.push_back(std::move(numerator));
        }
    }
    PointArray points(rows.size(), RationalVector(std::move(numerators), common * denominator));
    points.make_canonical();
    return points;
}

}  // namespace blossom
