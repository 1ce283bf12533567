#pragma once

#include <blossom/proofs/ground.hpp>
#include <blossom/rational/combinatorics.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <span>
#include <vector>

namespace blossom::proofs {

/// An argument over a ring R.
template <class R>
struct RingArgument {
    std::vector<R> coordinates;
    R mass;
};

/// The definition of the blossom, which shares nothing with the engine's constructions: with F the
/// homogeneous form of degree n of the map, in coordinates x_1..x_s and mass w,
///
///     n! p[u_1, ..., u_n] = D_{u_1} ... D_{u_n} F,   D_u = u_1 d/dx_1 + ... + u_s d/dx_s + mass d/dw.
///
/// `coefficients`: one for each of `monomials(direction)`. Returns n! times the value. Cost: per argument,
/// one multiplication by each remaining coefficient of F.
template <class R>
R polar_form(const Direction& direction, std::span<const R> coefficients,
             std::span<const RingArgument<R>> arguments) {
    std::map<std::vector<std::size_t>, R> form;
    const auto exponents = monomials(direction);
    for (std::size_t i = 0; i < exponents.size(); ++i) form[exponents[i]] = coefficients[i];
    std::size_t degree = direction.degree;
    for (const RingArgument<R>& argument : arguments) {
        std::map<std::vector<std::size_t>, R> derivative;
        for (const auto& monomial : monomials({degree - 1, direction.dimension})) {
            std::size_t total = 0;
            for (const std::size_t exponent : monomial) total += exponent;
            R sum = argument.mass * form[monomial] * R(Integer(degree - total));
            for (std::size_t j = 0; j < monomial.size(); ++j) {
                std::vector<std::size_t> above = monomial;
                ++above[j];
                sum += argument.coordinates[j] * form[above] * R(Integer(above[j]));
            }
            derivative[monomial] = std::move(sum);
        }
        form = std::move(derivative);
        --degree;
    }
    return form[std::vector<std::size_t>(direction.dimension, 0)];
}

/// The value of the form itself: the sum of coefficient * coordinates^alpha * mass^(n - |alpha|).
template <class R>
R form_value(const Direction& direction, std::span<const R> coefficients, const RingArgument<R>& argument) {
    std::vector<std::vector<R>> powers;
    powers.reserve(argument.coordinates.size());
    for (const R& coordinate : argument.coordinates) powers.push_back({R(1), coordinate});
    powers.push_back({R(1), argument.mass});
    for (auto& list : powers) {
        while (list.size() <= direction.degree) list.push_back(list.back() * list[1]);
    }
    R sum(0);
    const auto exponents = monomials(direction);
    for (std::size_t i = 0; i < exponents.size(); ++i) {
        R product = coefficients[i];
        std::size_t total = 0;
        for (std::size_t j = 0; j < exponents[i].size(); ++j) {
            product *= powers[j][exponents[i][j]];
            total += exponents[i][j];
        }
        sum += product * powers.back()[direction.degree - total];
    }
    return sum;
}

/// Applies `contract` to the coefficients in one direction after the other, the last one first: the rows of
/// each step are the coefficients in that direction.
template <class R, class Contract>
R contracted(const std::vector<Direction>& directions, std::vector<R> coefficients,
             const Contract& contract) {
    for (std::size_t i = directions.size(); i-- > 0;) {
        const std::size_t length = monomials(directions[i]).size();
        std::vector<R> shorter;
        for (std::size_t row = 0; row < coefficients.size(); row += length) {
            shorter.push_back(contract(i, std::span<const R>(coefficients).subspan(row, length)));
        }
        coefficients = std::move(shorter);
    }
    return coefficients.front();
}

}  // namespace blossom::proofs
