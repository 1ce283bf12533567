#pragma once

// Interleaved timing in one process: many short rounds A B A B ..., each by the CPU time of this thread, so
// that other work on the machine affects both sides equally.

#include <ctime>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace measure {

/// Seconds of CPU time of this thread.
inline double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Seconds of wall-clock time since a fixed point.
inline double wall_seconds() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

enum class Clock { cpu, wall };

struct Effort {
    int rounds = 21;
    double seconds_a_round = 0.002;
    double seconds = 2;  ///< for all rounds: at least three, but fewer than `rounds` if one takes long
    Clock clock = Clock::cpu;
};

inline double seconds_of(const std::function<void()>& run, std::size_t repetitions,
                         Clock clock = Clock::cpu) {
    const auto now = clock == Clock::cpu ? cpu_seconds : wall_seconds;
    const double start = now();
    for (std::size_t i = 0; i < repetitions; ++i) run();
    return (now() - start) / static_cast<double>(repetitions);
}

/// The number of repetitions that take about one round.
inline std::size_t repetitions(const std::function<void()>& run, double seconds) {
    std::size_t count = 1;
    for (;;) {
        const double taken = seconds_of(run, count) * static_cast<double>(count);
        if (taken >= seconds / 2) return count;
        count = taken <= 0 ? count * 16
                           : std::max(count + 1, static_cast<std::size_t>(static_cast<double>(count) *
                                                                          std::min(16.0, seconds / taken)));
    }
}

inline double median(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t n = values.size();
    return n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

/// The ratio of the times of a further side and the first: its median and its range.
struct Ratio {
    double median = 0;
    double least = 0;
    double greatest = 0;
};
struct Comparison {
    std::vector<double> seconds;  ///< the median of each side
    std::vector<Ratio> ratios;    ///< of side i + 1 to side 0
};

inline Comparison compare(const std::vector<std::function<void()>>& sides, const Effort& effort) {
    std::vector<std::size_t> counts;
    for (const auto& side : sides) counts.push_back(repetitions(side, effort.seconds_a_round));
    std::vector<std::vector<double>> times(sides.size());
    double taken = 0;
    for (int round = 0; round < effort.rounds && (round < 3 || taken < effort.seconds); ++round) {
        for (std::size_t i = 0; i < sides.size(); ++i) {
            times[i].push_back(seconds_of(sides[i], counts[i], effort.clock));
            taken += times[i].back() * static_cast<double>(counts[i]);
        }
    }
    Comparison result;
    for (const auto& side : times) result.seconds.push_back(median(side));
    for (std::size_t i = 1; i < sides.size(); ++i) {
        std::vector<double> ratios;
        for (std::size_t round = 0; round < times[i].size(); ++round)
            ratios.push_back(times[i][round] / times[0][round]);
        result.ratios.push_back({median(ratios), std::ranges::min(ratios), std::ranges::max(ratios)});
    }
    return result;
}

}  // namespace measure
