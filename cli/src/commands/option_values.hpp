#pragma once

#include <CLI/CLI.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace blossom::cli {

/// An argument in the form in which CLI11 takes it for a value if it is one, whatever its first character is.
std::string protected_value(const std::string& argument);

/// The values of an option as they were typed.
std::vector<std::string> results_of(const CLI::Option& option);

/// The first value of an option, or `otherwise` if the option was not given.
std::string result_of(const CLI::Option& option, const std::string& otherwise = "");

/// Errors: `UsageError`, with the name of the option, unless `text` is an integer from `least` to `greatest`.
std::size_t integer(const std::string& text, const std::string& name, std::size_t least,
                    std::size_t greatest);

/// An option with one value, which the program passes on unchanged.
CLI::Option* add_value(CLI::App& app, const std::string& name, const std::string& value, std::string help);

/// The flags of the limits, from their table.
class LimitOptions {
public:
    explicit LimitOptions(CLI::App& app);
    Limits read() const;

private:
    std::vector<const CLI::Option*> options_;
};

}  // namespace blossom::cli
