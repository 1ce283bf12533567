#pragma once

#include <blossom/rational/error.hpp>
#include <blossom/rational/limits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>

/// What a computation may use of the machine: word operations, bytes of memory and seconds of processor time.

namespace blossom {

/// What remains for this thread. Without a budget nothing is limited.
struct ThreadResources {
    static constexpr std::int64_t unlimited = std::numeric_limits<std::int64_t>::max() / 4;

    std::int64_t words_until_check = unlimited;  ///< time and total work are checked when this reaches 0
    std::int64_t words_after_check = unlimited;
    std::int64_t bytes = unlimited;
    std::int64_t nanoseconds = unlimited;  ///< of processor time
    std::int64_t checked_at = 0;  ///< the processor time of this thread at the last check; 0 before the first
    const Limits* limits = nullptr;
};
extern constinit thread_local ThreadResources thread_resources;

/// A question of the program whether this thread should stop, or nullptr. The checks of a budget ask it,
/// about ten thousand times per second, and stop as if a limit was exceeded.
using StopQuestion = bool (*)();
extern constinit thread_local StopQuestion is_stopped;

/// Limits what this thread uses during the lifetime of the object, by `Limits::work`, `memory` and `timeout`.
///
/// Work is counted by arithmetic beyond 64 bits, by the kernels before they start, and by allocations. Memory
/// is counted in programs that replace `operator new`, see `take_bytes`. A budget inside another one ends no
/// later than the outer one, and its use counts for both.
class ResourceBudget {
public:
    /// `limits` must outlive the budget.
    explicit ResourceBudget(const Limits& limits);
    ResourceBudget(const ResourceBudget&) = delete;
    ResourceBudget& operator=(const ResourceBudget&) = delete;
    ResourceBudget(ResourceBudget&&) = delete;
    ResourceBudget& operator=(ResourceBudget&&) = delete;
    ~ResourceBudget();

private:
    ThreadResources outer_;
    ThreadResources start_;  ///< what this budget had at its start
};

/// Checks the work and the time of this thread. Errors: `limit_exceeded`.
void check_resources();

/// Counts word operations. Cost: a subtraction; sometimes also a reading of the processor time.
/// Errors: `limit_exceeded` if the budget of this thread is used up.
inline void spend_work(std::uint64_t words) {
    constexpr auto most = static_cast<std::uint64_t>(ThreadResources::unlimited);
    thread_resources.words_until_check -= static_cast<std::int64_t>(std::min(words, most));
    if (thread_resources.words_until_check < 0) check_resources();
}

/// The word operations of a product of two numbers of a and b words.
constexpr std::uint64_t words_of_product(std::uint64_t a, std::uint64_t b) {
    constexpr std::uint64_t longest_schoolbook = 256;
    return std::max(a, b) * std::min({a, b, longest_schoolbook});
}

/// The exception that `operator new` throws when a budget is used up.
class ResourcesExceeded : public std::bad_alloc {
public:
    enum class Resource { work, memory, time, stopped };

    ResourcesExceeded(Resource resource, std::size_t limit) : resource_(resource), limit_(limit) {}
    const char* what() const noexcept override { return "the resources of a request are used up"; }
    Error error() const;

private:
    Resource resource_;
    std::size_t limit_;
};

/// Checks the resources of this thread after bytes, and the work of taking them, have been subtracted from
/// them. If they do not suffice, both are added again. Errors: `ResourcesExceeded`.
[[gnu::cold]] void check_taken(std::int64_t bytes, std::int64_t words);

/// Counts bytes that this thread allocates, and the work of allocating them, in a replacement of `operator
/// new`.
/// Errors: `ResourcesExceeded`.
inline void take_bytes(std::size_t bytes) {
    constexpr std::int64_t words_of_allocation = 16;
    constexpr std::int64_t bytes_per_word = 64;  // memory is written once, several bytes at a time
    constexpr auto most = static_cast<std::size_t>(ThreadResources::unlimited);
    const auto amount = static_cast<std::int64_t>(std::min(bytes, most));
    const std::int64_t words = words_of_allocation + amount / bytes_per_word;
    thread_resources.bytes -= amount;
    thread_resources.words_until_check -= words;
    if (thread_resources.bytes < 0 || thread_resources.words_until_check < 0) check_taken(amount, words);
}
/// Counts bytes that this thread releases.
inline void give_back_bytes(std::size_t bytes) noexcept {
    thread_resources.bytes += static_cast<std::int64_t>(bytes);
}

/// A lack of memory as an error of the library: `limit_exceeded`, with the name of the limit if one was
/// exceeded.
Error resource_error(const std::bad_alloc& problem);

/// Makes large numbers allocate with `operator new` from now on, so that a lack of memory is an exception. A
/// program calls it before it computes; otherwise GMP ends the process.
void allocate_numbers_with_new();

/// Registers the storage that this thread keeps for large numbers until it ends. Otherwise the first large
/// number does it, and the C library ends the process if memory is lacking then.
void prepare_thread_for_numbers();

}  // namespace blossom
