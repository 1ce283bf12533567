#include "textbook_blossom.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include <bit>

namespace blossom::textbook {

namespace {

using Number = boost::multiprecision::cpp_int;
using Fraction = boost::multiprecision::cpp_rational;

Fraction fraction(const Rational& value) {
    return {Number(to_string(value.numerator())), Number(to_string(value.denominator()))};
}

std::string text(const Fraction& value) {
    const Number denominator = boost::multiprecision::denominator(value);
    std::string result = boost::multiprecision::numerator(value).str();
    if (denominator != 1) result.append("/").append(denominator.str());
    return result;
}

/// sum_k points[k] * weights[k].
std::vector<std::string> combination(std::span<const Coordinates> points, std::span<const Fraction> weights) {
    std::vector<std::string> result;
    for (std::size_t j = 0; j < points.front().size(); ++j) {
        Fraction sum = 0;
        for (std::size_t k = 0; k < points.size(); ++k) sum += fraction(points[k][j]) * weights[k];
        result.push_back(text(sum));
    }
    return result;
}

/// For k = 0..n the sum over all subsets S of k indices of prod_{i in S} inside_i prod_{i not in S}
/// outside_i, and the number of these subsets.
struct SubsetSums {
    std::vector<Fraction> sums;
    std::vector<Number> counts;

    SubsetSums(std::span<const Fraction> inside, std::span<const Fraction> outside)
        : sums(inside.size() + 1), counts(inside.size() + 1) {
        for (std::size_t subset = 0; subset < std::size_t{1} << inside.size(); ++subset) {
            Fraction product = 1;
            for (std::size_t i = 0; i < inside.size(); ++i)
                product *= (subset >> i & 1) != 0 ? inside[i] : outside[i];
            const auto k = static_cast<std::size_t>(std::popcount(subset));
            sums[k] += product;
            counts[k] += 1;
        }
    }
};

Fraction power(const Fraction& base, std::size_t exponent) {
    Fraction result = 1;
    for (std::size_t i = 0; i < exponent; ++i) result *= base;
    return result;
}

}  // namespace

std::vector<std::string> blossom_of_coefficients(std::span<const Coordinates> coefficients,
                                                 std::span<const Argument> arguments) {
    std::vector<Fraction> parameters;
    std::vector<Fraction> masses;
    for (const Argument& argument : arguments) {
        parameters.push_back(fraction(argument.u));
        masses.push_back(fraction(argument.mass));
    }
    SubsetSums subsets(parameters, masses);
    // Without /=: in Boost 1.81, a cpp_rational of value 1 divided in place by an integer stays 1.
    for (std::size_t k = 0; k < subsets.sums.size(); ++k) subsets.sums[k] *= Fraction(1, subsets.counts[k]);
    return combination(coefficients, subsets.sums);
}

std::vector<std::string> blossom_of_control_points(std::span<const Coordinates> control_points,
                                                   const Interval& interval,
                                                   std::span<const Argument> arguments) {
    const Fraction a = fraction(interval.a());
    const Fraction b = fraction(interval.b());
    std::vector<Fraction> right;
    std::vector<Fraction> left;
    for (const Argument& argument : arguments) {
        const Fraction u = fraction(argument.u);
        const Fraction v = fraction(argument.mass);
        right.push_back((u - a * v) / (b - a));
        left.push_back((b * v - u) / (b - a));
    }
    return combination(control_points, SubsetSums(right, left).sums);
}

std::vector<std::string> polynomial_value(std::span<const Coordinates> coefficients, const Rational& t,
                                          std::size_t order) {
    std::vector<Fraction> weights;
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
        Fraction weight = k < order ? Fraction(0) : power(fraction(t), k - order);
        for (std::size_t i = 0; i < order && i < k; ++i) weight *= k - i;
        weights.push_back(weight);
    }
    return combination(coefficients, weights);
}

std::vector<std::string> bernstein_value(std::span<const Coordinates> control_points,
                                         const Interval& interval, const Rational& t) {
    const Fraction a = fraction(interval.a());
    const Fraction s = (fraction(t) - a) / (fraction(interval.b()) - a);
    const std::size_t n = control_points.size() - 1;
    std::vector<Fraction> weights;
    Number binomial = 1;
    for (std::size_t k = 0; k <= n; ++k) {
        weights.push_back(binomial * power(s, k) * power(1 - s, n - k));
        binomial = binomial * (n - k) / (k + 1);
    }
    return combination(control_points, weights);
}

std::vector<std::string> text(const Coordinates& value) {
    std::vector<std::string> result;
    for (const Rational& coordinate : value) result.push_back(to_string(coordinate));
    return result;
}

}  // namespace blossom::textbook
