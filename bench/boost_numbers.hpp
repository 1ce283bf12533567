#pragma once

// Boost's rational numbers, which the textbook loops use.

#include <blossom/rational/rational.hpp>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/gmp.hpp>

#include <span>

#include "textbook.hpp"

using boost::multiprecision::cpp_rational;
using boost::multiprecision::mpq_rational;

template <class Number>
textbook::Numbers<Number> boost_numbers(std::span<const blossom::Rational> values) {
    textbook::Numbers<Number> result;
    for (const blossom::Rational& value : values) result.push_back(Number(to_string(value)));
    return result;
}
