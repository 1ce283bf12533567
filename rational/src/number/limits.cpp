#include <blossom/rational/error.hpp>
#include <blossom/rational/limits.hpp>

#include <algorithm>
#include <cstdint>

namespace blossom {

namespace {

using Clock = std::chrono::steady_clock;

thread_local Clock::time_point deadline = Clock::time_point::max();
thread_local std::uint32_t calls = 0;

}  // namespace

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

TimeLimit::TimeLimit(std::size_t seconds) : outer_(deadline) {
    if (seconds > 0) deadline = std::min(outer_, Clock::now() + std::chrono::seconds(seconds));
}

TimeLimit::~TimeLimit() { deadline = outer_; }

void require_time() {
    constexpr std::uint32_t calls_between_looks = 64;
    if (deadline == Clock::time_point::max() || ++calls % calls_between_looks != 0 ||
        Clock::now() <= deadline)
        return;
    throw Error(ErrorCode::limit_exceeded, "the time of one case exceeds the limit timeout");
}

void require_result_bits(std::size_t bits, const Limits& limits, std::size_t count) {
    // log10(2) < 1/3, so that bits / 3 bounds the decimal digits from above, up to the last one.
    const std::size_t digits = bits / 3;
    require_within(digits, limits.digits, "digits", "the size of the result in decimal digits, at most");
    if (digits != 0 && count > limits.output_digits / digits) {
        throw Error(
            ErrorCode::limit_exceeded,
            "a result of " + std::to_string(count) + " numbers of up to " + std::to_string(digits) +
                " decimal digits exceeds the limit output_digits = " + std::to_string(limits.output_digits));
    }
}

}  // namespace blossom
