#include "completion.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace blossom::cli {

namespace {

struct CompletedOption {
    std::string name;  ///< with its dashes; empty for a positional argument
    std::string help;
    std::vector<std::string> values;  ///< alternatives, where the value is one of a few
    bool takes_value;
};

struct CompletedCommand {
    std::string name;
    std::string help;
    std::vector<CompletedOption> options;
};

/// The alternatives in "a|b|c"; none for the name of a value.
std::vector<std::string> alternatives(const std::string& value_name) {
    if (value_name.find('|') == std::string::npos) return {};
    return CLI::detail::split(value_name, '|');
}

std::vector<CompletedOption> options_of(const CLI::App& app) {
    std::vector<CompletedOption> options;
    for (const CLI::Option* option : app.get_options()) {
        const bool takes_value = option->get_items_expected_max() > 0;
        const auto values = takes_value ? alternatives(option->get_type_name()) : std::vector<std::string>{};
        const auto& names = option->get_lnames();
        options.push_back(
            {names.empty() ? "" : "--" + names.front(), option->get_description(), values, takes_value});
    }
    return options;
}

std::vector<CompletedCommand> commands_of(const CLI::App& app) {
    std::vector<CompletedCommand> commands;
    for (const CLI::App* command : app.get_subcommands({})) {
        commands.push_back({command->get_name(), command->get_description(), options_of(*command)});
    }
    return commands;
}

/// Quotes a text for a shell, and escapes brackets and colons, which are special in the descriptions of zsh.
std::string shell_quoted(std::string_view text, std::string_view escaped = "") {
    std::string result = "'";
    for (const char c : text) {
        if (c == '\'') {
            result += "'\\''";
            continue;
        }
        if (escaped.find(c) != std::string_view::npos) result += '\\';
        result += c;
    }
    return result + "'";
}

std::string option_names(const std::vector<CompletedOption>& options) {
    std::vector<std::string> names;
    for (const CompletedOption& option : options) {
        if (!option.name.empty()) names.push_back(option.name);
    }
    return fmt::format("{}", fmt::join(names, " "));
}

std::string bash_command(const CompletedCommand& command) {
    std::string cases;
    std::string positional;
    for (const CompletedOption& option : command.options) {
        if (option.name.empty()) {
            if (!option.values.empty()) positional = fmt::format(" {}", fmt::join(option.values, " "));
        } else if (option.takes_value) {
            cases += fmt::format("        {}) words='{}' ;;\n", option.name, fmt::join(option.values, " "));
        }
    }
    return fmt::format("    {})\n      case $previous in\n{}        *) words='{}{}' ;;\n      esac ;;\n",
                       command.name, cases, option_names(command.options), positional);
}

std::string bash_script(const CLI::App& app) {
    const std::vector<CompletedCommand> commands = commands_of(app);
    std::vector<std::string> names;
    std::string cases;
    for (const CompletedCommand& command : commands) {
        names.push_back(command.name);
        cases += bash_command(command);
    }
    return fmt::format(R"(_blossom() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} words=
  case ${{COMP_WORDS[1]}} in
{}    *) words='{} {}' ;;
  esac
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
}}
complete -o default -F _blossom blossom
)",
                       cases, fmt::join(names, " "), option_names(options_of(app)));
}

std::string zsh_argument(const CompletedOption& option) {
    const std::string help = shell_quoted("[" + option.help + "]", ":");
    const std::string values = option.values.empty()
                                   ? "':value:_files'"
                                   : fmt::format("':value:({})'", fmt::join(option.values, " "));
    if (option.name.empty()) return fmt::format("        '*'{}\n", values);
    // _arguments expects the help in brackets.
    return fmt::format("        '{}'{}{}\n", option.name, help, option.takes_value ? values : "");
}

std::string zsh_script(const CLI::App& app) {
    std::string names;
    std::string cases;
    for (const CompletedCommand& command : commands_of(app)) {
        names += fmt::format("    {}\n", shell_quoted(command.name + ":" + command.help));
        std::string arguments;
        for (const CompletedOption& option : command.options) {
            std::string line = zsh_argument(option);
            line.back() = ' ';
            arguments += line + "\\\n";
        }
        cases += fmt::format("    {})\n      _arguments \\\n{}        ;;\n", command.name, arguments);
    }
    return fmt::format(R"(#compdef blossom
_blossom() {{
  local -a commands=(
{}  )
  if (( CURRENT == 2 )); then
    _describe command commands
    return
  fi
  local command=$words[2]
  shift words
  (( CURRENT-- ))
  case $command in
{}  esac
}}
compdef _blossom blossom
)",
                       names, cases);
}

std::string fish_script(const CLI::App& app) {
    std::string script = "complete -c blossom -f\n";
    for (const CompletedCommand& command : commands_of(app)) {
        script += fmt::format("complete -c blossom -n __fish_use_subcommand -a {} -d {}\n", command.name,
                              shell_quoted(command.help, "\\"));
        const std::string condition = fmt::format("'__fish_seen_subcommand_from {}'", command.name);
        for (const CompletedOption& option : command.options) {
            const std::string values =
                option.values.empty() ? "" : fmt::format(" -a '{}'", fmt::join(option.values, " "));
            if (option.name.empty()) {
                if (!values.empty())
                    script += fmt::format("complete -c blossom -n {}{}\n", condition, values);
                continue;
            }
            script +=
                fmt::format("complete -c blossom -n {} -l {}{}{} -d {}\n", condition, option.name.substr(2),
                            option.takes_value ? " -r" : "", values, shell_quoted(option.help, "\\"));
        }
    }
    return script;
}

}  // namespace

std::string completion_script(const CLI::App& app, std::string_view shell) {
    if (shell == "bash") return bash_script(app);
    return shell == "zsh" ? zsh_script(app) : fish_script(app);
}

}  // namespace blossom::cli
