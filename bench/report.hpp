#pragma once

// What all families of measurements share: which rows are asked for, that all sides agree, and the rows.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "measure.hpp"

/// One way to do the same work.
struct Side {
    std::string name;
    std::function<void()> run;
    std::function<std::string()> text;  ///< of what `run` found
};

/// Prints rows of CSV for the work that is asked for.
class Report {
public:
    static constexpr const char* header =
        "family,work,degree,bits,engine_ns,peer,peer_ns,ratio,least_ratio,greatest_ratio,peak_memory_kib";

    /// Empty or none stands for all.
    struct Selection {
        std::string work;
        std::optional<std::size_t> degree;
        std::optional<std::size_t> bits;
        bool quick = false;
    };

    explicit Report(Selection selection);

    bool quick() const { return selection_.quick; }
    /// Whether this row is asked for: look before preparing its sides.
    bool wants(std::string_view work, std::size_t degree, std::size_t bits) const;
    /// Checks that all sides give the same and times them in turns, the engine first. Ends the program if one
    /// differs.
    void compare(const char* family, const char* work, std::size_t degree, std::size_t bits,
                 const std::vector<Side>& sides, measure::Clock clock = measure::Clock::cpu) const;

private:
    Selection selection_;
    measure::Effort effort_;
};
