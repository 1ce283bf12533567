#pragma once

// How a failed check prints numbers and errors.

#include <blossom/rational/error.hpp>
#include <blossom/rational/rational.hpp>

#include <string>

#include "catch.hpp"

template <>
struct Catch::StringMaker<blossom::Integer> {
    static std::string convert(const blossom::Integer& value) { return blossom::to_string(value); }
};

template <>
struct Catch::StringMaker<blossom::Rational> {
    static std::string convert(const blossom::Rational& value) { return blossom::to_string(value); }
};

template <>
struct Catch::StringMaker<std::optional<blossom::ErrorCode>> {
    static std::string convert(const std::optional<blossom::ErrorCode>& code) {
        return code ? std::string(blossom::error_name(*code)) : "no error";
    }
};
