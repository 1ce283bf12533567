#pragma once

#include <blossom/core/algebra/polynomial.hpp>
#include <blossom/core/algebra/sparse_polynomial.hpp>
#include <blossom/rational/limits.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace blossom {

/// A polynomial with the names of its variables: variable i of `polynomial` is called names[i].
struct NamedPolynomial {
    SparsePolynomial polynomial;
    std::vector<std::string> names;
};

/// Reads a polynomial: `1 + 2t + 4t^2 - t^3`, `-3/4 x^2*y`, `(t-1/2)^3`.
///
/// Numbers are exact: integers, decimals and what else `unsigned_number_length` measures, `0.5`, `.5`,
/// `1.5e-3`, `½`. Marks are read as `written_mark` has them, and superscripts are exponents: `x² − 3·x`. A
/// variable is a letter or '_' followed by
/// letters, digits or '_'. Juxtaposition means product and binds like `*` and `/`, from left to right: `1/2t`
/// is t/2. Only division by constants is allowed. An exponent after `^` is a number without sign. `names`
/// lists the variables that may occur, in order; if it is empty, any variable may occur, and they are
/// numbered in the order of their first occurrence.
///
/// Cost: that of expanding the expression. Errors: `syntax`, with the column; `zero_denominator`;
/// `limit_exceeded` for degree, digits, nesting, terms and work, before they are spent.
NamedPolynomial parse_polynomial(std::string_view text, std::span<const std::string> names = {},
                                 const Limits& limits = {});

/// A polynomial in one variable, whatever its name; "t" when the text is constant.
struct UnivariateText {
    Polynomial polynomial;
    std::string name;
};
/// Errors: `syntax` when a second variable occurs.
UnivariateText univariate(const NamedPolynomial& read);
/// Errors: those of `parse_polynomial` and `univariate`.
UnivariateText parse_univariate(std::string_view text, const Limits& limits = {});

/// The terms by increasing degree, `1 + 2t + 4t^2 - t^3`, `-2 + x^2 + 3x*y`, `2/3 u1`; "0" for zero.
/// `parse_polynomial` reads this text.
std::string to_text(const SparsePolynomial& polynomial, std::span<const std::string> names);
std::string to_text(const Polynomial& polynomial, std::string_view name = "t");

/// The dense form of a polynomial in variable 0, and back.
Polynomial dense(const SparsePolynomial& polynomial);
SparsePolynomial sparse(const Polynomial& polynomial);

/// u1, ..., un.
std::vector<std::string> numbered_names(std::string_view letter, std::size_t n);

}  // namespace blossom
