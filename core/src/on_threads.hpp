#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace blossom {

/// Calls run(begin, end) for pieces of 0..count that cover it, on at most `jobs` threads, this one among
/// them. Pieces are handed out as threads become free; the first error ends the work and is thrown here.
template <class Run>
void on_threads(std::size_t count, std::size_t jobs, const Run& run) {
    constexpr std::size_t least_piece = 8;
    constexpr std::size_t pieces_a_thread = 8;
    const std::size_t threads = std::max<std::size_t>(1, std::min(jobs, count / least_piece));
    if (threads == 1) return run(std::size_t{0}, count);

    const std::size_t piece = std::max(least_piece, count / (threads * pieces_a_thread) / 8 * 8);
    std::atomic<std::size_t> next = 0;
    std::exception_ptr error;
    std::mutex error_mutex;
    const auto work = [&] {
        try {
            for (std::size_t begin = next.fetch_add(piece); begin < count; begin = next.fetch_add(piece))
                run(begin, std::min(begin + piece, count));
        } catch (...) {
            next = count;
            const std::lock_guard lock(error_mutex);
            if (!error) error = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> helpers;
        helpers.reserve(threads - 1);
        for (std::size_t i = 1; i < threads; ++i) helpers.emplace_back(work);
        work();
    }
    if (error) std::rethrow_exception(error);
}

}  // namespace blossom
