// Prints one line per path: its cases and their kinds, its checks, the failures, and the time.

#define CATCH_CONFIG_EXTERNAL_INTERFACES  // needed by version 2, which declares listeners only with it
#include <cstdio>

#include "each_case.hpp"
#include "support/catch.hpp"

namespace {

#if __has_include(<catch2/catch_all.hpp>)
using Listener = Catch::EventListenerBase;
#else
using Listener = Catch::TestEventListenerBase;
#endif

using blossom::testing::Counts;

class CountsOfPaths : public Listener {
public:
    using Listener::Listener;

    void testCaseStarting(const Catch::TestCaseInfo& info) override {
        Listener::testCaseStarting(info);
        Counts::of_path() = {};
        timer_.start();
    }
    void testCaseEnded(const Catch::TestCaseStats& stats) override {
        const Counts& counts = Counts::of_path();
        std::printf("%s: %zu cases", counts.path.c_str(), counts.cases);
        const char* before = " (";
        for (const auto& [kind, cases] : counts.kinds) {
            std::printf("%s%zu %s", before, cases, kind.c_str());
            before = ", ";
        }
        const auto& checks = stats.totals.assertions;
        std::printf("%s, %zu checks, %zu failed, %.1f s\n", counts.kinds.empty() ? "" : ")",
                    static_cast<std::size_t>(checks.total()), static_cast<std::size_t>(checks.failed),
                    timer_.getElapsedSeconds());
        std::fflush(stdout);
        Listener::testCaseEnded(stats);
    }

private:
    Catch::Timer timer_;
};

}  // namespace

CATCH_REGISTER_LISTENER(CountsOfPaths)
