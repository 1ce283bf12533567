#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace blossom {

constexpr std::size_t least_piece_of_a_thread = 8;

/// See `on_threads`. Not inlined, because the work of a single thread needs none of this.
template <class Run>
[[gnu::noinline]] void on_several_threads(std::size_t count, std::size_t threads, const Run& run) {
    constexpr std::size_t pieces_a_thread = 8;
    const std::size_t piece = std::max(least_piece_of_a_thread, count / (threads * pieces_a_thread) / 8 * 8);
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
        std::vector<std::jthread> workers;
        workers.reserve(threads - 1);
        for (std::size_t i = 1; i < threads; ++i) workers.emplace_back(work);
        work();
    }
    if (error) std::rethrow_exception(error);
}

/// Calls run(begin, end) for pieces that together cover 0..count, on at most `jobs` threads, including this
/// one. Pieces are assigned as threads become free; the first error stops the work and is thrown here.
template <class Run>
[[gnu::always_inline]] inline void on_threads(std::size_t count, std::size_t jobs, const Run& run) {
    const std::size_t threads = std::min(jobs, count / least_piece_of_a_thread);
    if (threads <= 1) return run(std::size_t{0}, count);
    on_several_threads(count, threads, run);
}

}  // namespace blossom
