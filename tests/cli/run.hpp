#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "commands/command_line.hpp"
#include "support/catch.hpp"

/// The program as a function for tests.

namespace blossom::cli {

struct Run {
    int status;
    std::string output;
    std::string errors;
};

inline Run run(const std::vector<std::string>& arguments, std::string input = "", bool coloured = false) {
    Run result{};
    const auto source = [&](std::span<char> room) {
        const std::size_t count = std::min(room.size(), input.size());
        std::copy_n(input.begin(), count, room.begin());
        input.erase(0, count);
        return count;
    };
    const auto into = [](std::string& text) {
        return [&text](std::string_view part) {
            text += part;
            return true;
        };
    };
    result.status = static_cast<int>(
        cli::run(arguments, {source, into(result.output), into(result.errors), coloured, coloured}));
    return result;
}

inline bool contains(const std::string& text, const std::string& part) {
    CAPTURE(text, part);
    return text.find(part) != std::string::npos;
}

}  // namespace blossom::cli

using namespace blossom;
using namespace blossom::cli;
