#pragma once

#include <blossom/core/maps/argument.hpp>

#include <span>
#include <vector>

namespace blossom::worked {

/// e_0, ..., e_n of homogeneous arguments: the coefficients of prod (mass_i + u_i X).
std::vector<Rational> elementary_values(std::span<const Argument> arguments);

}  // namespace blossom::worked
