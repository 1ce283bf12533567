// Two threads compared with one, by wall-clock time: batches of values of a blossom and of a curve, and the
// best that the machine can do.

#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/spline/curve_values.hpp>

#include <thread>

#include "cases.hpp"
#include "families.hpp"

namespace {

using namespace blossom;

constexpr std::size_t degree = 20;
constexpr std::size_t bits = 7;

std::string text_of(std::span<const Rational> values) {
    std::string text;
    for (const Rational& value : values) text += to_string(value) + " ";
    return text;
}

/// Compares `run(jobs, results)` with two jobs and with one, for `count` results in memory that is allocated
/// before.
template <class Run>
void compare_threads(const Report& report, const char* work, std::size_t count, const Run& run) {
    std::vector<Rational> results[] = {std::vector<Rational>(count), std::vector<Rational>(count)};
    const auto side = [&](const char* name, std::size_t jobs) {
        return Side{name, [&results, &run, jobs] { run(jobs, results[jobs - 1]); },
                    [&results, jobs] { return text_of(results[jobs - 1]); }};
    };
    report.compare("threads", work, degree, bits, {side("engine", 2), side("one thread", 1)},
                   measure::Clock::wall);
}

/// A chain of multiplications in registers, which uses no memory.
void run_multiplications(std::size_t steps) {
    std::uint64_t x = steps;
    for (std::size_t i = 0; i < steps; ++i) x = x * x + 1;
    volatile std::uint64_t kept = x;
    (void)kept;
}

/// Divides the steps into equal shares.
void share_multiplications(std::size_t steps, std::size_t jobs) {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < jobs; ++i) others.emplace_back(run_multiplications, steps / jobs);
    run_multiplications(steps / jobs);
}

}  // namespace

void measure_threads(const Report& report) {
    const std::size_t count = report.quick() ? 100 : 20000;
    const Case given = make_case(degree, bits);
    if (report.wants("bare multiplications", degree, bits)) {
        compare_threads(report, "bare multiplications", 0, [&](std::size_t jobs, std::span<Rational>) {
            constexpr std::size_t steps_a_value = 200;
            share_multiplications(count * steps_a_value, jobs);
        });
    }
    if (report.wants("blossom batch", degree, bits)) {
        const Blossom blossom(curve_of(given));
        const std::vector<std::vector<Argument>> tuples(count, arguments_of(given));
        compare_threads(report, "blossom batch", count, [&](std::size_t jobs, std::span<Rational> results) {
            blossom.values(tuples, results, jobs);
        });
    }
    if (report.wants("evaluation batch", degree, bits)) {
        const CurveValues curve(curve_of(given));
        std::mt19937_64 random(degree);
        std::vector<Rational> parameters;
        for (std::size_t i = 0; i < count; ++i) parameters.push_back(number(random, bits));
        compare_threads(
            report, "evaluation batch", count,
            [&](std::size_t jobs, std::span<Rational> results) { curve.at(parameters, results, jobs); });
    }
}
