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

/// What the thread may still use. Without a budget nothing is limited.
struct ThreadResources {
    static constexpr std::int64_t unlimited = std::numeric_limits<std::int64_t>::max() / 4;

    std::int64_t words_until_check = unlimited;  ///< the time and the whole work are checked at 0
    std::int64_t words_after_check = unlimited;
    std::int64_t bytes = unlimited;
    std::int64_t nanoseconds = unlimited;  ///< of processor time
    std::int64_t checked_at = 0;  ///< the processor time of this thread at the last check; 0 before the first
    const Limits* limits = nullptr;
};
extern constinit thread_local ThreadResources thread_resources;

/// Limits what this thread uses as long as the object lives, by `Limits::work`, `memory` and `timeout`.
///
/// Work is counted where numbers are made: in arithmetic beyond 64 bits, in the kernels, which count before
/// they start, and in allocations. Memory is counted by programs that replace `operator new`, see
/// `take_bytes`. A budget within another one ends no later than the outer one, and what it uses counts there
/// too.
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

/// Counts word operations. Cost: a subtraction; now and then the processor time is read.
/// Errors: `limit_exceeded` if the budget of this thread is used up.
inline void spend_work(std::uint64_t words) {
    constexpr auto most = static_cast<std::uint64_t>(ThreadResources::unlimited);
    thread_resources.words_until_check -= static_cast<std::int64_t>(std::min(words, most));
    if (thread_resources.words_until_check < 0) check_resources();
}

/// The word operations of a product of numbers of so many words each.
constexpr std::uint64_t words_of_product(std::uint64_t a, std::uint64_t b) {
    constexpr std::uint64_t longest_schoolbook = 256;
    return std::max(a, b) * std::min({a, b, longest_schoolbook});
}

/// A budget is used up, as what `operator new` may throw.
class ResourcesExceeded : public std::bad_alloc {
public:
    enum class Resource { work, memory, time };

    ResourcesExceeded(Resource resource, std::size_t limit) : resource_(resource), limit_(limit) {}
    const char* what() const noexcept override { return "the resources of a request are used up"; }
    Error error() const;

private:
    Resource resource_;
    std::size_t limit_;
};

/// Checks the resources of this thread after bytes, and the work of taking them, have been subtracted from
/// them. What is refused is given back. Errors: `ResourcesExceeded`.
[[gnu::cold]] void check_taken(std::int64_t bytes, std::int64_t words);

/// Counts bytes that this thread takes, and the work of taking them, for a replacement of `operator new`.
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
/// Bytes that are given back.
inline void give_back_bytes(std::size_t bytes) noexcept {
    thread_resources.bytes += static_cast<std::int64_t>(bytes);
}

/// What a lack of memory is for the person who asked: `limit_exceeded`, with the limit if there was one.
Error resource_error(const std::bad_alloc& problem);

/// From now on, large numbers take their memory with `operator new`, so that a lack of memory is an
/// exception. For programs, before they compute: the number library GMP ends the process otherwise.
void allocate_numbers_with_new();

/// Registers what this thread keeps for large numbers until it ends. Without this call the first large number
/// does it, and the C library ends the process if memory is lacking then.
void prepare_thread_for_numbers();

}  // namespace blossom
