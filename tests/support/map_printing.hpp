#pragma once

// How a failed check prints polynomials and arguments.

#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/core/maps/argument.hpp>

#include <string>

#include "number_printing.hpp"

template <>
struct Catch::StringMaker<blossom::Argument> {
    static std::string convert(const blossom::Argument& argument) {
        std::string text("(");
        return text.append(blossom::to_string(argument.u))
            .append(", ")
            .append(blossom::to_string(argument.mass))
            .append(")");
    }
};

template <>
struct Catch::StringMaker<blossom::Polynomial> {
    static std::string convert(const blossom::Polynomial& polynomial) { return blossom::to_text(polynomial); }
};

template <>
struct Catch::StringMaker<blossom::SparsePolynomial> {
    static std::string convert(const blossom::SparsePolynomial& polynomial) {
        return blossom::to_text(polynomial, blossom::numbered_names("x", polynomial.variables()));
    }
};
