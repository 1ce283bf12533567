#include "prove_statement.hpp"

#include <fmt/format.h>

#include <string_view>

#include "operations/map_options.hpp"

namespace blossom::cli {

std::string map_lines(const std::vector<std::string>& degrees) {
    std::string text;
    for (const std::string& degree : degrees) {
        const std::size_t equals = degree.find('=');
        if (equals == std::string::npos) {
            throw UsageError(
                fmt::format("--degree names a map and its degree, as in b=2, not \"{}\"", degree));
        }
        const bool several = degree.find(',') != std::string::npos;
        text += fmt::format("map {} {} {}\n", degree.substr(0, equals), several ? "degrees" : "degree",
                            degree.substr(equals + 1));
    }
    return text;
}

std::string statement_text(const std::string& claim) {
    for (const std::string_view word : {"theorem ", "for ", "map ", "claim ", "refute "}) {
        if (claim.starts_with(word)) return claim + "\n";
    }
    return "claim " + claim + "\n";
}

}  // namespace blossom::cli
