#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string_view>

#include <blossom/rational/error.hpp>
#include <blossom/rational/place.hpp>

namespace blossom {

/// What one request may cost. Every operation that could take much memory predicts its size and, before it
/// allocates, refuses with `limit_exceeded`, which names the limit. docs/limits.md documents the defaults.
struct Limits {
    std::size_t degree = 10'000;                ///< formal degree of a map, and exponents in text
    std::size_t digits = 1'000'000;             ///< decimal digits of one number, read or computed
    std::size_t nesting = 200;                  ///< brackets within brackets, in text and in JSON
    std::size_t variables = 256;                ///< variables of one polynomial
    std::size_t polarization_terms = 1 << 20;   ///< terms of one polarization sum, prod(m_i + 1)
    std::size_t regrouping_work = 500'000'000;  ///< multiply-adds of one regrouped polarization, n^4 / 4
    std::size_t expansion_terms = 1 << 18;      ///< terms of one polynomial in several variables
    std::size_t expansion_work = 200'000'000;   ///< term operations of one symbolic computation
    std::size_t numbers = 1 << 22;              ///< numbers that make up one map or one result
    std::size_t output_digits = 250'000'000;    ///< decimal digits of one whole result, estimated from above
    std::size_t line_bytes = 16 << 20;          ///< one line of a batch
    std::size_t work = 40'000'000'000;          ///< word operations of a `ResourceBudget`
    std::size_t memory = 1 << 30;               ///< bytes that a `ResourceBudget` takes at once
    std::size_t timeout = 10;  ///< seconds of processor time of a `ResourceBudget`; 0: no limit
};

/// `limit_exceeded` with the message "<what> the limit <name> = <limit>"; `what` names what exceeds the
/// limit.
Error limit_error(std::string_view what, std::string_view name, std::size_t limit, const Place& place = {},
                  std::optional<std::size_t> offset = {});

/// Throws `limit_exceeded` unless `value <= limit`.
/// The message reads "<what> <value> exceeds the limit <name> = <limit>".
void require_within(std::size_t value, std::size_t limit, std::string_view name, std::string_view what,
                    const Place& place);
inline void require_within(std::size_t value, std::size_t limit, std::string_view name, std::string_view what,
                           Part part) {
    if (value > limit) require_within(value, limit, name, what, Place(part));
}
inline void require_within(std::size_t value, std::size_t limit, std::string_view name,
                           std::string_view what) {
    if (value > limit) require_within(value, limit, name, what, Place());
}

/// The same for the product of `factors`, which may exceed a word; `what` names what the product counts.
void require_product_within(std::initializer_list<std::size_t> factors, std::size_t limit,
                            std::string_view name, std::string_view what, const Place& place = {});

/// Throws `limit_exceeded` if a result of `count` numbers of at most `bits` binary digits each might have
/// more than `limits.digits` decimal digits per number, or more than `limits.output_digits` in all.
void require_result_bits(std::size_t bits, const Limits& limits, std::size_t count = 1);

}  // namespace blossom
