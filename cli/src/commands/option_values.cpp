#include "option_values.hpp"

#include <fmt/format.h>

#include <charconv>
#include <system_error>
#include <utility>

#include "limit_flags.hpp"
#include "operations/map_options.hpp"

namespace blossom::cli {

namespace {

// This character, with which no text on a command line begins, marks values that begin like options: "-t^2"
// and "-1/2" are polynomials and numbers, "[1]" and "" are texts.
constexpr char value_mark = '\x1f';

}  // namespace

std::string protected_value(const std::string& argument) {
    const bool option = argument == "-h" || argument.starts_with("--");
    const bool special = argument.empty() || argument.front() == '-' || argument.front() == '[';
    return special && !option ? value_mark + argument : argument;
}

std::vector<std::string> results_of(const CLI::Option& option) {
    std::vector<std::string> values = option.results();
    for (std::string& value : values) {
        if (value.starts_with(value_mark)) value.erase(0, 1);
    }
    return values;
}

std::string result_of(const CLI::Option& option, const std::string& otherwise) {
    return option.count() == 0 ? otherwise : results_of(option).front();
}

std::size_t integer(const std::string& text, const std::string& name, std::size_t least,
                    std::size_t greatest) {
    std::size_t value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc{} || end != text.data() + text.size() || value < least || value > greatest) {
        throw UsageError(
            fmt::format("{} must be an integer from {} to {}, not \"{}\"", name, least, greatest, text));
    }
    return value;
}

CLI::Option* add_value(CLI::App& app, const std::string& name, const std::string& value, std::string help) {
    return app.add_option(name, CLI::callback_t(), std::move(help))->type_name(value);
}

LimitOptions::LimitOptions(CLI::App& app) {
    const Limits defaults;
    for (const LimitEntry& entry : limit_table()) {
        const std::string help = fmt::format("{}; by default {}", entry.help, defaults.*entry.member);
        options_.push_back(add_value(app, flag_of(entry), "N", help)->group("Limits"));
    }
}

Limits LimitOptions::read() const {
    Limits limits;
    for (std::size_t i = 0; i < options_.size(); ++i) {
        const LimitEntry& entry = limit_table()[i];
        if (options_[i]->count() == 0) continue;
        limits.*entry.member = integer(result_of(*options_[i]), options_[i]->get_name(), 0, entry.greatest);
    }
    return limits;
}

}  // namespace blossom::cli
