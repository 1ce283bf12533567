#include <blossom/core/constructions/constructions.hpp>
#include <blossom/proofs/expansion.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>

#include "polar_form.hpp"

namespace blossom::proofs {

namespace {

using Ring = SparsePolynomial;
using Argument = RingArgument<Ring>;
constexpr std::size_t unbounded = std::size_t(-1);

std::size_t saturating_product(std::size_t a, std::size_t b) {
    std::size_t product = 0;
    return __builtin_mul_overflow(a, b, &product) ? unbounded : product;
}

/// An upper bound on the terms of a product of linear forms with the arguments as coefficients: m equal
/// arguments of s terms give C(m + s - 1, s - 1) monomials.
std::size_t greatest_size(std::span<const Argument> arguments, const Limits& limits) {
    std::vector<std::pair<const Argument*, std::size_t>> groups;
    for (const Argument& argument : arguments) {
        const auto same = std::ranges::find_if(groups, [&](const auto& group) {
            return group.first->coordinates == argument.coordinates && group.first->mass == argument.mass;
        });
        if (same == groups.end()) {
            groups.emplace_back(&argument, 1);
        } else {
            ++same->second;
        }
    }
    std::size_t size = 1;
    for (const auto& [argument, copies] : groups) {
        std::size_t terms = argument->mass.size();
        for (const Ring& coordinate : argument->coordinates) terms += coordinate.size();
        if (terms == 0) continue;
        const Integer monomials = binomial(copies + terms - 1, terms - 1);
        if (monomials > Integer(limits.expansion_work)) return unbounded;
        size = saturating_product(size, static_cast<std::size_t>(*monomials.to_int64()));
    }
    return size;
}

/// n! times the engine's construction on symbolic arguments, for a direction of dimension 1.
Ring engine_blossom(std::span<const Ring> coefficients, std::span<const Argument> arguments) {
    std::vector<HomogeneousPair<Ring>> pairs;
    for (const Argument& argument : arguments) pairs.push_back({argument.coordinates.front(), argument.mass});
    const std::span<const Ring> rows[] = {coefficients};
    const auto [numerators, denominator] =
        constructions::by_symmetric_functions<Ring>(rows, std::span<const HomogeneousPair<Ring>>(pairs));
    return numerators.front() * Ring(Rational(factorial(arguments.size()), denominator));
}

/// The value of the homogeneous form, sum of coefficient * coordinates^alpha * mass^(n - |alpha|), from
/// powers.
Ring value_of_form(const Direction& direction, std::span<const Ring> coefficients, const Argument& argument) {
    std::vector<std::vector<Ring>> powers_of;
    powers_of.reserve(argument.coordinates.size());
    for (const Ring& coordinate : argument.coordinates)
        powers_of.push_back(powers(coordinate, direction.degree));
    const std::vector<Ring> powers_of_mass = powers(argument.mass, direction.degree);
    std::vector<Ring> products;
    for (const auto& exponents : monomials(direction)) {
        std::size_t left = direction.degree;
        for (const std::size_t exponent : exponents) left -= exponent;
        Ring product = powers_of_mass[left];
        for (std::size_t j = 0; j < exponents.size(); ++j) product *= powers_of[j][exponents[j]];
        products.push_back(std::move(product));
    }
    return dot(coefficients, products);
}

/// p(t), or the homogeneous form at coordinates and mass.
Ring value_in(const Direction& direction, std::span<const Ring> coefficients, const Argument& argument) {
    if (direction.dimension == 1 && argument.mass == Ring(1))
        return polynomial_value(coefficients, argument.coordinates.front());
    return value_of_form(direction, coefficients, argument);
}

}  // namespace

Fraction Expander::operator()(NodeId id) {
    if (known_.size() < block_.nodes.size()) count_uses();
    if (known_[id]) return *known_[id];
    // Operands are expanded before the node, and only if they are needed.
    std::vector<Frame> open;
    open.push_back(opened(id));
    while (!open.empty()) {
        Frame& frame = open.back();
        if (frame.next < frame.operands.size()) {
            const NodeId operand = frame.operands[frame.next];
            if (!known_[operand]) {
                open.push_back(opened(operand));
                continue;
            }
            if (frame.sum) frame.sum->add(use(operand));
            ++frame.next;
            continue;
        }
        known_[frame.node] = frame.sum ? std::move(*frame.sum).result() : expanded(block_.nodes[frame.node]);
        was_known_[frame.node] = true;
        if (!frame.sum) {
            for (const NodeId operand : frame.operands) give_up_use(operand);
        }
        open.pop_back();
    }
    return *known_[id];
}

void Expander::count_uses() {
    const std::size_t before = known_.size();
    known_.resize(block_.nodes.size());
    uses_.resize(block_.nodes.size());
    was_known_.resize(block_.nodes.size());
    for (NodeId id = before; id < block_.nodes.size(); ++id) {
        for (const NodeId operand : operands_of(block_, id)) ++uses_[operand];
        // Divisors are used once more, as conditions.
        if (block_.nodes[id].kind == NodeKind::quotient) ++uses_[block_.nodes[id].operands[1]];
    }
}

Expander::Frame Expander::opened(NodeId id) {
    Frame frame{id, operands_of(block_, id), 0, std::nullopt};
    if (block_.nodes[id].kind == NodeKind::sum) frame.sum.emplace(field_);
    // If a node was dropped and is needed again, so are its operands.
    if (was_known_[id]) {
        for (const NodeId operand : frame.operands) ++uses_[operand];
    }
    return frame;
}

Fraction Expander::use(NodeId id) {
    Fraction result = uses_[id] > 1 ? *known_[id] : std::move(*known_[id]);
    give_up_use(id);
    return result;
}

void Expander::give_up_use(NodeId id) {
    if (--uses_[id] == 0) known_[id].reset();
}

Fraction Expander::expanded(const Node& node) {
    const auto operand = [&](std::size_t i) -> const Fraction& { return *known_[node.operands[i]]; };
    switch (node.kind) {
        case NodeKind::constant:
            return {node.value, {}};
        case NodeKind::symbol:
            if (const auto found = replaced_.find(node.index); found != replaced_.end())
                return {found->second, {}};
            return {SparsePolynomial::variable(node.index), {}};
        case NodeKind::sum:
            break;
        case NodeKind::product: {
            Fraction product = operand(0);
            for (std::size_t i = 1; i < node.operands.size(); ++i)
                product = field_.product(product, operand(i));
            return product;
        }
        case NodeKind::power:
            return field_.power(operand(0), node.index);
        case NodeKind::quotient:
            if (operand(1).is_zero()) {
                throw Error(ErrorCode::division_by_zero, "the denominator is zero", {}, node.offset);
            }
            return field_.quotient(operand(0), operand(1));
        case NodeKind::application:
            return application(block_.applications[node.index]);
        case NodeKind::derivative: {
            Fraction result = operand(0);
            for (std::size_t i = 0; i < node.order; ++i) result = field_.derivative(result, node.index);
            return result;
        }
    }
    return {};
}

FractionField::Common Expander::over_common_denominator(const NodeArgument& argument) {
    std::vector<Fraction> entries;
    entries.reserve(argument.coordinates.size());
    for (const NodeId coordinate : argument.coordinates) entries.push_back(*known_[coordinate]);
    entries.push_back(*known_[argument.mass]);
    return field_.over_common_denominator(entries);
}

/// p(argument) or p[arguments], computed from numerators, over the product of all denominators: a map is
/// homogeneous in each argument.
Fraction Expander::application(const Application& application) {
    const GroundMap& map = block_.maps[application.map];
    const bool value = application.form == Application::Form::value;
    std::vector<std::vector<Argument>> arguments(map.directions.size());
    Fraction result{1, {}};
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        for (const NodeArgument& argument : application.arguments[i]) {
            auto [numerators, denominator] = over_common_denominator(argument);
            Ring mass = std::move(numerators.back());
            numerators.pop_back();
            arguments[i].push_back({std::move(numerators), std::move(mass)});
            if (denominator.empty()) continue;
            const std::size_t copies = value ? map.directions[i].degree : 1;
            result = field_.product(result, field_.power({1, denominator}, copies));
        }
    }
    std::vector<Fraction> entries;
    entries.reserve(map.coefficients.size());
    for (const NodeId coefficient : map.coefficients) entries.push_back(*known_[coefficient]);
    auto [coefficients, denominator] = field_.over_common_denominator(entries);
    result = field_.product(result, {1, std::move(denominator)});

    // The last direction is contracted first, row by row.
    std::size_t terms = 0;
    for (const Ring& coefficient : coefficients) terms = std::max(terms, coefficient.size());
    std::size_t rows = coefficients.size();
    for (std::size_t i = arguments.size(); i-- > 0;) {
        std::vector<Argument> all = arguments[i];
        if (value) all.assign(map.directions[i].degree, arguments[i].front());
        const std::size_t size = greatest_size(all, limits_);
        terms = saturating_product(terms, size);
        rows /= monomials(map.directions[i]).size();
        field_.spend(size, saturating_product(terms, rows));
    }
    const auto contract = [&](const auto& one_direction) {
        return contracted(map.directions, coefficients, one_direction);
    };
    Ring numerator;
    if (!value) {
        Integer scale = 1;
        for (const Direction& direction : map.directions) scale *= factorial(direction.degree);
        numerator = contract([&](std::size_t i, std::span<const Ring> row) {
            return map.directions[i].dimension == 1 ? engine_blossom(row, arguments[i])
                                                    : polar_form<Ring>(map.directions[i], row, arguments[i]);
        });
        numerator *= Ring(application.scale / Rational(scale));
    } else {
        numerator = contract([&](std::size_t i, std::span<const Ring> row) {
            return value_in(map.directions[i], row, arguments[i].front());
        });
    }
    field_.spend(numerator.size(), numerator.size());
    result.numerator *= numerator;
    return result.is_zero() ? Fraction{} : field_.reduced(std::move(result));
}

}  // namespace blossom::proofs
