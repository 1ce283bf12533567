#include <blossom/rational/error.hpp>
#include <blossom/rational/limits.hpp>

namespace blossom {

void require_within(std::size_t value, std::size_t limit, std::string_view name, std::string_view what,
                    const Place& place) {
    if (value <= limit) return;
    std::string message(what);
    message += ' ';
    message += std::to_string(value);
    message += " exceeds the limit ";
    message += name;
    message += " = ";
    message += std::to_string(limit);
    throw Error(ErrorCode::limit_exceeded, message, place);
}

void require_result_bits(std::size_t bits, const Limits& limits, std::size_t count) {
    // A bound from above, up to the last digit: log10(2) < 0.30103.
    const std::size_t digits = bits / 100'000 * 30'103 + bits % 100'000 * 30'103 / 100'000;
    require_within(digits, limits.digits, "digits", "the size of the result in decimal digits, at most");
    if (digits != 0 && count > limits.output_digits / digits) {
        throw Error(
            ErrorCode::limit_exceeded,
            "a result of " + std::to_string(count) + " numbers of up to " + std::to_string(digits) +
                " decimal digits exceeds the limit output_digits = " + std::to_string(limits.output_digits));
    }
}

}  // namespace blossom
