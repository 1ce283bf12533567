#include "command_line.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <blossom/rational/lists.hpp>
#include <blossom/worked/gallery.hpp>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <system_error>

#include <blossom/protocol/description.hpp>
#include <blossom/protocol/pack.hpp>
#include "completion.hpp"
#include "explain/chapter_of.hpp"
#include "explain_options.hpp"
#include "floats.hpp"
#include "json/json_text.hpp"
#include "operations/map_options.hpp"
#include "operations/table.hpp"
#include "option_values.hpp"
#include "prove_command.hpp"
#include "rounding.hpp"
#include "run_command.hpp"

namespace blossom::cli {

namespace {

/// Only `wanted` if it is one of the names, so that only the options of the command that runs are created.
std::vector<std::string_view> named_or_all(std::string_view wanted, std::vector<std::string_view> names) {
    if (std::ranges::find(names, wanted) == names.end()) return names;
    return {wanted};
}

/// What a command does once the command line is parsed.
using Action = std::function<Outcome(const Streams& streams)>;

struct Subcommand {
    const CLI::App* app;
    Action action;
};

const Subcommand& chosen(const std::vector<Subcommand>& commands) {
    return *std::ranges::find_if(commands, [](const Subcommand& command) { return command.app->parsed(); });
}

std::string shell_text(const std::string& argument) {
    const bool plain =
        argument.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_,.:/=") ==
        std::string::npos;
    const std::string quote = argument.find('"') == std::string::npos ? "\"" : "'";
    return plain ? argument : quote + argument + quote;
}

/// Runs the example of an operation, and gives the command and its output.
std::string example_text(const Operation& operation) {
    std::string text = std::string(operation.documentation) + "\n\nExample:\n  $ blossom";
    for (const std::string& argument : operation.example) text += " " + shell_text(argument);
    std::string output;
    const auto collect = [&](std::string_view part) {
        output += part;
        return true;
    };
    run(operation.example,
        {.input = [](std::span<char>) { return std::size_t{0}; }, .output = collect, .errors = collect});
    for (const std::string& line : CLI::detail::split(output, '\n'))
        text += line.empty() ? "\n" : "\n  " + line;
    return text + "\n";
}

Subcommand add_operation(CLI::App& app, const Operation& operation) {
    CLI::App* command = app.add_subcommand(std::string(operation.name), std::string(operation.summary));
    std::vector<std::pair<const Option*, const CLI::Option*>> options;
    for (const Option& option : operation.options) {
        const bool positional = !option.name.starts_with('-');
        CLI::Option* added = option.value.empty()
                                 ? command->add_flag(option.name, option.help)
                                 : add_value(*command, option.name, option.value, option.help);
        if (positional || option.repeated)
            added->expected(1, CLI::detail::expected_max_vector_size)->allow_extra_args(positional);
        options.emplace_back(&option, added);
    }
    const std::string json_help = "print the response as JSON";
    const CLI::Option* as_json = command->add_flag("--json", json_help);
    const CLI::Option* numbers = add_value(*command, "--numbers", joined(rounding_names(), {}, "|"),
                                           "also give every number correctly rounded");
    const CLI::Option* floats =
        add_value(*command, "--floats", joined(floats_names(), {}, "|"),
                  "what JSON numbers stand for, and with double also the decimals in options");
    const CLI::Option* picture =
        operation.plot ? add_value(*command, "--svg", "FILE", "also write a picture of the curves or patches")
                       : nullptr;
    const CLI::Option* mesh = operation.mesh
                                  ? add_value(*command, "--obj", "FILE",
                                              "also write a mesh of the patches, as a Wavefront OBJ file")
                                  : nullptr;
    const LimitOptions limits(*command);
    if (!operation.example.empty()) command->footer([&operation] { return example_text(operation); });

    const auto action = [=, &operation](const Streams& streams) {
        Command given{operation,
                      {},
                      result_of(*numbers),
                      result_of(*floats),
                      as_json->count() > 0,
                      picture ? result_of(*picture) : "",
                      mesh ? result_of(*mesh) : "",
                      limits.read()};
        for (const auto& [option, parsed] : options) {
            if (parsed->count() == 0) continue;
            given.options.push_back(
                {option, option->value.empty() ? std::vector<std::string>{} : results_of(*parsed)});
        }
        return run_command(given, streams);
    };
    return {command, action};
}

constexpr std::size_t most_jobs = 256;
constexpr std::string_view version_flag = "--version";
constexpr std::string_view completion_name = "completion";

Subcommand add_prove(CLI::App& app, const Operation& operation) {
    CLI::App* command = app.add_subcommand(std::string(operation.name), std::string(operation.summary));
    const auto several = [&](const std::string& name, const std::string& value, std::string help) {
        return add_value(*command, name, value, std::move(help))
            ->expected(1, CLI::detail::expected_max_vector_size);
    };
    const auto flag = [&](const std::string& name, const std::string& help) {
        return command->add_flag(name, help);
    };
    const CLI::Option* paths =
        several("FILE", "", "files of statements, or folders with files *.blossom")->allow_extra_args();
    const CLI::Option* statements =
        several("-e,--statement", "TEXT", "one statement; the word \"claim\" may be omitted")
            ->allow_extra_args(false);
    const CLI::Option* degrees =
        several("--degree", "NAME=N", "declares a map for -e: b=2, or f=2,3")->allow_extra_args(false);
    const CLI::Option* format = flag("--format", "print the files in canonical form and decide nothing");
    const CLI::Option* quiet = flag("--quiet", "print only unexpected verdicts and the summary");
    const CLI::Option* as_json = flag("--json", "print one line of JSON for each claim");
    const CLI::Option* certificate =
        add_value(*command, "--certificate", "FILE", "write a record of each proof, for check-certificate");
    const CLI::Option* coq = add_value(*command, "--coq", "FILE", "write the proved cases as lemmas of Coq");
    const CLI::Option* latex =
        add_value(*command, "--latex", "PATH",
                  "write the theorems in LaTeX for \\input: to one file, or to a folder/ with one file each");
    const CLI::Option* junit =
        add_value(*command, "--junit", "FILE", "write the verdicts as a JUnit XML report");
    const CLI::Option* jobs = add_value(*command, "--jobs", "N", "the number of threads; by default 1");
    const LimitOptions limits(*command);
    command->footer([&operation] { return example_text(operation); });
    const auto action = [=](const Streams& streams) {
        return prove({.paths = results_of(*paths),
                      .statements = results_of(*statements),
                      .degrees = results_of(*degrees),
                      .only_format = format->count() > 0,
                      .as_json = as_json->count() > 0,
                      .quiet = quiet->count() > 0,
                      .certificate = result_of(*certificate),
                      .coq = result_of(*coq),
                      .latex = result_of(*latex),
                      .junit = result_of(*junit),
                      .jobs = integer(result_of(*jobs, "1"), "--jobs", 1, most_jobs),
                      .limits = limits.read()},
                     streams);
    };
    return {command, action};
}

Outcome write_gallery(const std::filesystem::path& folder, const Streams& streams) {
    for (const worked::SiteFile& file : worked::gallery_files()) {
        const std::filesystem::path path = folder / file.path;
        std::filesystem::create_directories(path.parent_path());
        write_file(path, file.content);
    }
    streams.output((folder / "index.html").string() + "\n");
    return Outcome::success;
}

/// `explain OP ARGS...`: each operation is a subcommand of `explain`.
Subcommand add_explain(CLI::App& app, const Operation& explain, std::string_view wanted) {
    CLI::App* command = app.add_subcommand(std::string(explain.name), std::string(explain.summary));
    command->require_subcommand(0, 1);
    const CLI::Option* gallery =
        add_value(*command, "--gallery", "FOLDER", "write all chapters as a small web site");
    const auto explained_operations = std::make_shared<std::vector<Operation>>();
    for (const std::string_view name : named_or_all(wanted, chapter_names()))
        explained_operations->push_back(explained(*operation_of(name)));
    std::vector<Subcommand> commands = mapped(*explained_operations, [&](const Operation& operation) {
        return add_operation(*command, operation);
    });
    command->footer([&explain] { return example_text(explain); });
    const auto action = [=, owner = explained_operations](const Streams& streams) {
        if (gallery->count() > 0) return write_gallery(result_of(*gallery), streams);
        if (command->get_subcommands().empty()) throw UsageError("explain needs a command or --gallery");
        return chosen(commands).action(streams);
    };
    return {command, action};
}

Subcommand add_check_certificate(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("check-certificate", "Check the proofs recorded by prove --certificate");
    const CLI::Option* file =
        add_value(*command, "FILE", "", "the certificate; \"-\" is the standard input")->required();
    const LimitOptions limits(*command);
    command->footer(
        "Example:\n"
        "  $ blossom check-certificate proofs.json\n"
        "  confirmed fj-eq20, line 1: 8 of 8 cases\n"
        "  1 claims confirmed in all cases");
    const auto action = [=](const Streams& streams) {
        return check_certificate_file(result_of(*file), limits.read(), streams);
    };
    return {command, action};
}

Subcommand add_batch(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("batch", "Answer requests in JSON, one per line, from FILE or the standard input");
    const CLI::Option* file = add_value(
        *command, "FILE", "", "the file with the requests; by default, or for \"-\", the standard input");
    const CLI::Option* jobs = add_value(*command, "--jobs", "N", "the number of threads; by default 1");
    const LimitOptions limits(*command);
    command->footer(
        "Example:\n"
        "  $ echo '{\"op\": \"evaluate\", \"map\": {\"kind\": \"polynomial\", \"text\": \"t^2\"}, \"at\": "
        "[\"1/2\"]}' | blossom batch\n"
        "  {\"ok\": true, \"result\": {\"values\": [\"1/4\"]}}");
    const auto action = [=](const Streams& streams) {
        const std::size_t threads = integer(result_of(*jobs, "1"), "--jobs", 1, most_jobs);
        std::ranges::for_each(operations(), [](const Operation&) {});  // described before memory is scarce
        const std::string name = result_of(*file, "-");
        return serve_batch(name == "-" ? streams.input : file_source(name), streams.output, limits.read(),
                           threads);
    };
    return {command, action};
}

Subcommand add_schema(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("schema", "Print the JSON Schema of the requests and responses of batch");
    command->footer("Example:\n  $ blossom schema > protocol.schema.json");
    return {command, [](const Streams& streams) {
                streams.output(to_text(schema(), 2) + "\n");
                return Outcome::success;
            }};
}

Subcommand add_pack(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "pack", "Print cases with exact results, for the tests of other programs, one per line");
    const CLI::Option* family =
        add_value(*command, "FAMILY", joined(pack_families(), {}, "|"), "what the cases compute")->required();
    const CLI::Option* seed =
        add_value(*command, "--seed", "S", "the same seed gives the same cases; by default 1");
    const CLI::Option* cases = add_value(*command, "--cases", "N", "the number of cases; by default 100");
    const LimitOptions limits(*command);
    command->footer(
        "Example:\n"
        "  $ blossom pack evaluate --seed 1 --cases 1000 > evaluate.jsonl");
    const auto action = [=](const Streams& streams) {
        constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
        const Pack pack{.family = result_of(*family),
                        .seed = integer(result_of(*seed, "1"), "--seed", 0, most),
                        .cases = integer(result_of(*cases, "100"), "--cases", 0, most)};
        try {
            write_pack(pack, limits.read(),
                       [&](std::string_view line) { streams.output(std::string(line) + "\n"); });
        } catch (const Error& error) {
            throw UsageError(error.message());
        }
        return Outcome::success;
    };
    return {command, action};
}

Subcommand add_completion(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand(std::string(completion_name), "Print a completion script for a shell");
    const CLI::Option* shell =
        add_value(*command, "SHELL", std::string(completion_shells), "the shell")->required();
    command->footer("Example:\n  source <(blossom completion bash)");
    const auto action = [shell, &app](const Streams& streams) {
        const std::string name = result_of(*shell);
        const auto shells = CLI::detail::split(std::string(completion_shells), '|');
        if (std::ranges::find(shells, name) == shells.end()) {
            throw UsageError(
                fmt::format("there is completion for {}, not for \"{}\"", completion_shells, name));
        }
        streams.output(completion_script(app, name));
        return Outcome::success;
    };
    return {command, action};
}

/// A command that is not an operation.
struct OtherCommand {
    std::string_view name;
    Subcommand (*add)(CLI::App& app);
};
constexpr OtherCommand other_commands[] = {{"check-certificate", add_check_certificate},
                                           {"batch", add_batch},
                                           {"pack", add_pack},
                                           {"schema", add_schema},
                                           {completion_name, add_completion}};

/// The command that the arguments begin with, or all.
std::vector<Subcommand> add_commands(CLI::App& app, std::span<const std::string> arguments) {
    const auto word = [&](std::size_t i) {
        return i < arguments.size() ? std::string_view(arguments[i]) : std::string_view();
    };
    if (word(0) == version_flag) return {};
    std::vector<std::string_view> names;
    for (const OperationEntry& entry : operation_table) names.push_back(entry.name);
    for (const OtherCommand& other : other_commands) names.push_back(other.name);
    if (word(0) != completion_name) names = named_or_all(word(0), std::move(names));
    return mapped(names, [&](std::string_view name) {
        const Operation* const operation = operation_of(name);
        if (!operation) return std::ranges::find(other_commands, name, &OtherCommand::name)->add(app);
        if (name == explain_name) return add_explain(app, *operation, word(1));
        return operation->has_own_command ? add_prove(app, *operation) : add_operation(app, *operation);
    });
}

Outcome wrong_usage(const std::string& message, const Streams& streams) {
    streams.errors(fmt::format("{} {}\nRun with --help for more information.\n",
                               Style(streams.coloured_errors).bad("error:"), message));
    return Outcome::wrong_usage;
}

}  // namespace

Outcome run(std::span<const std::string> arguments, const Streams& given) {
    bool closed = false;
    Streams streams = given;
    streams.output = [&](std::string_view text) {
        closed = closed || !given.output(text);
        return !closed;
    };
    CLI::App app("Exact blossoms (polar forms) of polynomials over the rationals", "blossom");
    app.require_subcommand(1);
    app.set_version_flag(std::string(version_flag), "blossom " BLOSSOM_VERSION);
    app.footer(
        "A value \"-\" is read from the standard input, a value \"@NAME\" from a file.\n"
        "Exit status: 0 success, 1 a request was refused, 2 wrong usage, 3 constructions disagree.");
    app.get_formatter()->column_width(34);

    const std::vector<Subcommand> commands = add_commands(app, arguments);

    std::vector<std::string> reversed;
    // "-e" is an option of `prove` and `explain prove`; every other command reads it as a polynomial.
    const auto command = std::ranges::find_if(
        arguments, [&](const std::string& argument) { return argument != explain_name; });
    const bool proves = command != arguments.end() && *command == prove_name;
    std::ranges::transform(arguments, std::back_inserter(reversed), [&](const std::string& argument) {
        return proves && argument == "-e" ? argument : protected_value(argument);
    });
    std::ranges::reverse(reversed);
    try {
        const bool explains = arguments.size() > 1 && arguments.front() == explain_name;
        if (explains && !arguments[1].starts_with('-') && !has_chapter(arguments[1])) {
            throw UsageError(no_chapter(arguments[1]));
        }
        app.parse(std::move(reversed));
        const Outcome outcome = chosen(commands).action(streams);
        return closed ? std::max(outcome, Outcome::refused) : outcome;
    } catch (const CLI::CallForHelp&) {
        streams.output(app.help());
        return Outcome::success;
    } catch (const CLI::CallForVersion& version) {
        streams.output(std::string(version.what()) + "\n");
        return Outcome::success;
    } catch (const CLI::ParseError& error) {
        return wrong_usage(error.what(), streams);
    } catch (const UsageError& error) {
        return wrong_usage(error.what(), streams);
    } catch (const std::system_error& error) {
        return wrong_usage(error.what(), streams);
    }
}

}  // namespace blossom::cli
