#pragma once

// The code that both polarizations by residues share.

#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/subset_sums.hpp>

#include <algorithm>
#include <optional>

#include "residues/prime_field.hpp"
#include "residues/residue_system.hpp"

namespace blossom::subset_sums {

using residues::Moduli;
using residues::moduli;
using residues::operations;
using residues::ResidueVector;
using Rows = std::span<const std::span<const Integer>>;
using Groups = std::span<const SubsetGroup>;

inline std::size_t number_of_arguments(Groups groups) {
    std::size_t n = 0;
    for (const SubsetGroup& group : groups) n += group.multiplicity;
    return n;
}

/// A bound in bits on n! p(arguments): |p| <= max |c_k| prod (|mass_i| + |u_i|).
inline std::size_t result_bits(Rows rows, Groups groups) {
    std::size_t bits = 0;
    for (const auto row : rows)
        for (const Integer& coefficient : row) bits = std::max(bits, coefficient.bit_length());
    for (const SubsetGroup& group : groups)
        bits += group.multiplicity * (abs(group.u) + abs(group.mass)).bit_length();
    return bits + factorial(number_of_arguments(groups)).bit_length();
}

/// A group modulo a prime: the point u / mass, or the vector u.
struct GroupResidue {
    std::uint64_t parameter;
    std::uint64_t mass;  ///< 1 for a vector
};

/// Returns nullopt if the prime divides the mass of a point.
inline std::optional<GroupResidue> group_residue(const PrimeField& field, const SubsetGroup& group) {
    const std::uint64_t u = field.of(group.u);
    if (group.mass.is_zero()) return GroupResidue{u, 1};
    const std::uint64_t mass = field.of(group.mass);
    if (mass == 0) return std::nullopt;
    return GroupResidue{field.product(u, field.inverse(mass)), mass};
}

inline ResidueVector residue_vector_of(std::uint64_t value) {
    ResidueVector result{};
    std::ranges::fill(result.lane, value);
    return result;
}

}  // namespace blossom::subset_sums
