#include "report.hpp"

#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>

namespace {

long peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

}  // namespace

Report::Report(Selection selection) : selection_(std::move(selection)) {
    if (selection_.quick) effort_ = {1, 1e-5};
}

bool Report::wants(std::string_view work, std::size_t degree, std::size_t bits) const {
    return (selection_.work.empty() || selection_.work == work) &&
           selection_.degree.value_or(degree) == degree && selection_.bits.value_or(bits) == bits;
}

void Report::compare(const char* family, const char* work, std::size_t degree, std::size_t bits,
                     const std::vector<Side>& sides, measure::Clock clock) const {
    std::vector<std::function<void()>> runs;
    std::string expected;
    for (const Side& side : sides) {
        side.run();
        const std::string text = side.text();
        if (runs.empty()) expected = text;
        if (text != expected) {
            std::fprintf(stderr, "%s, degree %zu, %zu bits: %s gives another result\n", work, degree, bits,
                         side.name.c_str());
            std::exit(1);
        }
        runs.push_back(side.run);
    }
    measure::Effort effort = effort_;
    effort.clock = clock;
    const measure::Comparison comparison = measure::compare(runs, effort);
    for (std::size_t i = 1; i < sides.size(); ++i) {
        const measure::Ratio& ratio = comparison.ratios[i - 1];
        std::printf("%s,%s,%zu,%zu,%.1f,%s,%.1f,%.3g,%.3g,%.3g,%ld\n", family, work, degree, bits,
                    1e9 * comparison.seconds[0], sides[i].name.c_str(), 1e9 * comparison.seconds[i],
                    ratio.median, ratio.least, ratio.greatest, peak_memory());
    }
    std::fflush(stdout);
}
