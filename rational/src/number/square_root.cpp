#include <blossom/rational/square_root.hpp>

#include "backend.hpp"

namespace blossom {

namespace {

std::optional<Integer> exact_square_root(const Integer& value) {
    if (value.sign() < 0) return std::nullopt;
    Integer root = IntegerAccess::from_number(sqrt(IntegerAccess::to_number(value)));
    return root * root == value ? std::optional(std::move(root)) : std::nullopt;
}

}  // namespace

std::optional<Rational> exact_square_root(const Rational& value) {
    const auto numerator = exact_square_root(value.numerator());
    const auto denominator = exact_square_root(value.denominator());
    if (!numerator || !denominator) return std::nullopt;
    return Rational(*numerator, *denominator);
}

}  // namespace blossom
