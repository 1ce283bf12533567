#include "elementary.hpp"

#include <blossom/core/algebra/polynomial.hpp>

#include <array>

namespace blossom::worked {

std::vector<Rational> elementary_values(std::span<const Argument> arguments) {
    Polynomial coefficients = 1;
    for (const Argument& argument : arguments) {
        const std::array<Rational, 2> factor{argument.mass, argument.u};
        coefficients *= Polynomial(factor);
    }
    std::vector<Rational> values;
    for (std::size_t k = 0; k <= arguments.size(); ++k) values.push_back(coefficients[k]);
    return values;
}

}  // namespace blossom::worked
