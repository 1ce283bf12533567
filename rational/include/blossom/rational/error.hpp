#pragma once

#include <cstddef>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <blossom/rational/place.hpp>

namespace blossom {

/// What went wrong, as a closed list. `error_name` gives the word that the protocol uses for it.
///
/// "Undefined" (for instance `empty_interval`) and "too big here" (`limit_exceeded`) are different codes:
/// the second may succeed with other limits, the first never.
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

/// The protocol's word for a code, for instance "zero_denominator".
std::string_view error_name(ErrorCode code);

/// The one exception type of the library.
///
/// `message` is one sentence that names the place, the value and the rule. `place` is the offending part of
/// the input, relative to what was being read or called. `offset` is where in a text that was being read, in
/// bytes from its beginning. `limit` is the name of the limit that is exceeded, see `limit_error`; "" if none
/// is.
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

    /// The same error seen from outside: its place lies below `outer`.
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
    /// The same error in other words.
    Error saying(std::string message) const {
        Error error = *this;
        error.message_ = std::move(message);
        return error;
    }
    /// The same error, for exceeding the limit with this name, a literal.
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

/// Runs `action`; an error in it lies below the parameter, or the element of a list.
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
