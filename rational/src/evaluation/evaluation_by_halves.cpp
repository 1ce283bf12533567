#include "evaluation_by_halves.hpp"

#include <bit>

#include "number/rational_access.hpp"

namespace blossom {

namespace {

/// The greatest divisor of `number` that is coprime to `other`.
Integer coprime_part(Integer number, const Integer& other) {
    Integer common = gcd(number, other);
    while (!common.is_one()) {
        number = divide_exactly(number, common);
        common = gcd(number, common);
    }
    return number;
}

}  // namespace

/// The powers u^(2^i), and the powers of v by which the sums of the lower halves are multiplied.
struct EvaluationByHalves::Powers {
    Powers(const Integer& u, const Integer& v, std::size_t count) {
        std::size_t size = 1;
        of_u.push_back(u);
        of_v.push_back(v);
        for (; 2 * size < count; size *= 2) {
            of_u.push_back(of_u.back() * of_u.back());
            of_v.push_back(of_v.back() * of_v.back());
        }
    }
    const Integer& u_to(std::size_t power_of_two) const {
        return of_u[static_cast<std::size_t>(std::countr_zero(power_of_two))];
    }
    Integer v_to(std::size_t exponent) const {
        Integer power = 1;
        for (std::size_t i = 0; exponent >> i != 0; ++i) {
            if ((exponent >> i & 1) != 0) power *= of_v[i];
        }
        return power;
    }

    std::vector<Integer> of_u;
    std::vector<Integer> of_v;
};

EvaluationByHalves::EvaluationByHalves(std::span<const Integer> coefficients, const Integer& denominator,
                                       bool prepared) {
    std::vector<Rational> reduced;
    reduced.reserve(coefficients.size());
    // Without preparation every node keeps the common denominator.
    for (const Integer& coefficient : coefficients)
        reduced.push_back(prepared ? Rational(coefficient, denominator) : Rational(coefficient));
    leaves_.reserve(reduced.size());
    for (const Rational& coefficient : reduced) leaves_.push_back(coefficient.numerator());
    denominator_ = 1;
    if (reduced.size() > 1) {
        add_node(reduced, 0, reduced.size(), denominator_);
    } else {
        denominator_ = reduced[0].denominator();
    }
    if (!prepared) denominator_ = denominator;
    greatest_ = prepared ? leaves_.back() * divide_exactly(denominator_, reduced.back().denominator())
                         : leaves_.back();
    unknown_ = denominator_;
    if (!prepared) return;
    std::vector<Integer> over_one;
    over_one.reserve(reduced.size());
    for (const Rational& coefficient : reduced)
        over_one.push_back(coefficient.numerator() * divide_exactly(denominator_, coefficient.denominator()));
    separate_denominator(over_one);
}

std::size_t EvaluationByHalves::add_node(std::span<const Rational> coefficients, std::size_t begin,
                                         std::size_t end, Integer& denominator) {
    if (end - begin == 1) {
        denominator = coefficients[begin].denominator();
        return begin;  // a leaf, which is not a node
    }
    const std::size_t index = nodes_.size();
    nodes_.emplace_back();
    Node node;
    node.begin = begin;
    node.end = end;
    const std::size_t middle = begin + std::bit_floor(end - begin - 1);
    Integer lower = 1;
    Integer upper = 1;
    node.lower = add_node(coefficients, begin, middle, lower);
    node.upper = add_node(coefficients, middle, end, upper);
    denominator = lcm(lower, upper);
    node.lower_factor = divide_exactly(denominator, lower);
    node.upper_factor = divide_exactly(denominator, upper);
    nodes_[index] = std::move(node);
    return index;
}

/// Each prime of D fails to divide at least one coefficient. `known_` collects the primes for which there is
/// exactly one such coefficient.
void EvaluationByHalves::separate_denominator(std::span<const Integer> coefficients) {
    Integer once = 1;
    Integer often = 1;
    for (const Integer& coefficient : coefficients) {
        const Integer whole = coprime_part(denominator_, coefficient);
        const Integer again = gcd(once, whole);
        const Integer fresh = divide_exactly(whole, gcd(whole, once * often));
        once = divide_exactly(once, again) * fresh;
        often *= again;
    }
    known_ = std::move(once);
    unknown_ = divide_exactly(denominator_, known_);
}

Integer EvaluationByHalves::sum(const Node& node, const Powers& powers) const {
    const std::size_t middle = node.begin + std::bit_floor(node.end - node.begin - 1);
    const auto half = [&](std::size_t begin, std::size_t end, std::size_t index, const Integer& factor,
                          const Integer& power) {
        const Integer& scale = factor.is_one() ? power : factor * power;
        return end - begin == 1 ? leaves_[begin] * scale : sum(nodes_[index], powers) * scale;
    };
    Integer result = half(node.begin, middle, node.lower, node.lower_factor, powers.v_to(node.end - middle));
    result += half(middle, node.end, node.upper, node.upper_factor, powers.u_to(middle - node.begin));
    return result;
}

Rational EvaluationByHalves::value(const Integer& u, const Integer& v) const {
    const std::size_t count = leaves_.size();
    const Powers powers(u, v, count);
    Integer numerator = nodes_.empty() ? leaves_[0] : sum(nodes_[0], powers);
    if (numerator.is_zero()) return 0;
    Integer denominator = denominator_;
    const auto divide = [&](const Integer& common) {
        if (common.is_one()) return;
        numerator = divide_exactly(numerator, common);
        denominator = divide_exactly(denominator, common);
    };
    divide(gcd(numerator, unknown_));
    if (!known_.is_one()) {
        const Integer parameters = u * v;
        // The part of `known_` whose primes divide u or v.
        const Integer suspected = divide_exactly(known_, coprime_part(known_, gcd(known_, parameters)));
        if (!suspected.is_one()) divide(gcd(numerator, suspected));
    }
    if (!v.is_one()) {
        const Integer suspected = divide_exactly(v, coprime_part(v, gcd(v, greatest_)));
        const Integer rest = divide_exactly(v, suspected);
        denominator *= rest.is_one() ? Integer(1) : pow(rest, count - 1);
        if (!suspected.is_one()) {
            const Integer power = pow(suspected, count - 1);
            const Integer common = gcd(numerator, power);
            numerator = divide_exactly(numerator, common);
            denominator *= divide_exactly(power, common);
        }
    }
    return RationalAccess::from_lowest_terms(std::move(numerator), std::move(denominator));
}

}  // namespace blossom
