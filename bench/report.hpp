#pragma once

// What all families of measurements share: the selection of rows, the check that all sides agree, and the
// output.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "measure.hpp"

/// One way to compute the same result.
struct Side {
    std::string name;
    std::function<void()> run;
    std::function<std::string()> text;  ///< the result of `run` as text
};

/// Prints rows of CSV for the selected operations.
class Report {
public:
    static constexpr const char* header =
        "family,work,degree,bits,engine_ns,peer,peer_ns,ratio,least_ratio,greatest_ratio,peak_memory_kib";

    /// The selected rows; empty members select all.
    struct Selection {
        std::string work;
        std::optional<std::size_t> degree;
        std::optional<std::size_t> bits;
        bool quick = false;
    };

    explicit Report(Selection selection);

    bool quick() const { return selection_.quick; }
    /// Whether this row is selected; to be checked before its sides are prepared.
    bool wants(std::string_view work, std::size_t degree, std::size_t bits) const;
    /// Checks that all sides give the same result and times them in turn, the engine first. Ends the program
    /// if a result differs.
    void compare(const char* family, const char* work, std::size_t degree, std::size_t bits,
                 const std::vector<Side>& sides, measure::Clock clock = measure::Clock::cpu) const;

private:
    Selection selection_;
    measure::Effort effort_;
};
