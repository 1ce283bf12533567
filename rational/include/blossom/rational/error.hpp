#pragma once

#include <cstddef>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <blossom/rational/place.hpp>

namespace blossom {

/// The kinds of errors. `error_name` gives the word that the protocol uses for each.
///
/// An undefined result (for instance `empty_interval`) and a result that is too large (`limit_exceeded`) have
/// different codes: only the second can succeed with other limits.
enum class ErrorCode {
    syntax,
    inexact_number,
    not_a_number,
    zero_denominator,
    division_by_zero,
    inexact_division,
    overflow,
    missing_field,
    unknown_field,
    unknown_op,
    wrong_kind,
    wrong_arity,
    empty_interval,
    degree_too_low,
    bad_knots,
    outside_domain,
    not_adjacent,
    not_continuous,
    mismatched_dimensions,
    incomplete_net,
    degenerate_simplex,
    not_affine,        ///< weights whose sum is not 1, or not 0 for a vector
    different_spaces,  ///< points or vectors of two affine spaces
    zero_weight,
    missing_sample,
    limit_exceeded,
    internal,  ///< a defect of the program itself
};

/// The word of the protocol for a code, for instance "zero_denominator".
std::string_view error_name(ErrorCode code);

/// The only exception type of the library.
///
/// `message` is one sentence that names the place, the value and the rule. `place` is the offending part of
/// the input, relative to what was read or called. `offset` is the position in the text that was read, in
/// bytes from its beginning. `limit` is the name of the exceeded limit, see `limit_error`, or "".
class Error : public std::exception {
public:
    Error(ErrorCode code, std::string message, Place place = {}, std::optional<std::size_t> offset = {})
        : code_(code), message_(std::move(message)), place_(std::move(place)), offset_(offset) {}

    ErrorCode code() const { return code_; }
    const std::string& message() const { return message_; }
    const Place& place() const { return place_; }
    std::optional<std::size_t> offset() const { return offset_; }
    std::string_view limit() const { return limit_; }
    const char* what() const noexcept override { return message_.c_str(); }

    /// The same error with a place relative to the caller: below `outer`.
    Error below(const Place& outer) const { return at(outer.around(place_)); }
    /// The same error at another place.
    Error at(Place place) const {
        Error error = *this;
        error.place_ = std::move(place);
        return error;
    }
    Error at(std::size_t offset) const {
        Error error = *this;
        error.offset_ = offset;
        return error;
    }
    /// The same error with another message.
    Error saying(std::string message) const {
        Error error = *this;
        error.message_ = std::move(message);
        return error;
    }
    /// The same error with the name of the exceeded limit, a string literal.
    Error exceeding(std::string_view limit) const {
        Error error = *this;
        error.limit_ = limit;
        return error;
    }

private:
    ErrorCode code_;
    std::string message_;
    Place place_;
    std::optional<std::size_t> offset_;
    std::string_view limit_;
};

/// Runs `action`; the place of an error becomes a part of this parameter or of this element of a list.
template <class Action>
decltype(auto) within(Part part, const Action& action) {
    try {
        return action();
    } catch (const Error& error) {
        throw error.below(part);
    }
}
template <class Action>
decltype(auto) within(std::size_t index, const Action& action) {
    try {
        return action();
    } catch (const Error& error) {
        throw error.below({index});
    }
}

}  // namespace blossom
