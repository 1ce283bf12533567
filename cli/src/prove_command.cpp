#include "prove_command.hpp"

#include <fmt/format.h>
#include <blossom/proofs/formatter.hpp>
#include <blossom/proofs/parser.hpp>
#include <blossom/proofs/prover.hpp>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>

#include "decisions.hpp"
#include "operations/map_options.hpp"

namespace blossom::cli {

namespace {

struct Text {
    std::string name;
    std::string content;
    proofs::Document document;
};

/// A block on its way: decided by some thread, reported in order.
struct Task {
    const Text* text;
    const proofs::Block* block;
    std::vector<proofs::Decision> decisions;
    bool done = false;
};

struct Count {
    std::size_t theorems = 0;
    std::size_t proved = 0;
    std::size_t refuted = 0;
    std::size_t unexpected = 0;
    std::size_t undecided = 0;
    std::size_t unread = 0;

    void add(const Count& other) {
        theorems += other.theorems;
        proved += other.proved;
        refuted += other.refuted;
        unexpected += other.unexpected;
        undecided += other.undecided;
        unread += other.unread;
    }
};

std::vector<std::string> files_of(const std::string& path) {
    if (path == "-" || !std::filesystem::is_directory(path)) return {path};
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
        if (entry.is_regular_file() && entry.path().extension() == ".blossom")
            files.push_back(entry.path().string());
    }
    std::ranges::sort(files);
    if (files.empty()) {
        throw std::system_error(std::make_error_code(std::errc::no_such_file_or_directory),
                                path + " holds no file *.blossom");
    }
    return files;
}

/// A claim of the command line as a text: the maps of --degree, then the claim.
std::string statement_text(const std::string& claim, const std::vector<std::string>& degrees) {
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
    for (const std::string_view word : {"theorem ", "for ", "map ", "claim ", "refute "}) {
        if (claim.starts_with(word)) return text + claim + "\n";
    }
    return text + "claim " + claim + "\n";
}

std::vector<Text> read_texts(const ProveCommand& command, const Streams& streams) {
    std::vector<Text> texts;
    const auto add = [&](std::string name, std::string content) {
        proofs::Document document = proofs::parse(content, command.limits);
        texts.push_back({std::move(name), std::move(content), std::move(document)});
    };
    for (const std::string& path : command.paths) {
        for (const std::string& file : files_of(path)) {
            add(file == "-" ? "standard input" : file,
                read_all(file == "-" ? streams.input : file_source(file), command.limits.line_bytes));
        }
    }
    for (const std::string& claim : command.statements)
        add("statement", statement_text(claim, command.degrees));
    if (texts.empty()) throw UsageError("prove needs a file, a folder or a statement with -e");
    return texts;
}

std::string title_of(const Task& task, const proofs::Decision& decision) {
    const std::size_t line = proofs::place_of(task.text->content, decision.offset).line;
    const std::string& id = task.block->id;
    return id.empty() ? fmt::format("{}:{}", task.text->name, line) : id;
}

/// One line for the verdict, what it rests on, and the counterexample or the error below.
std::string report_text(const Task& task, const proofs::Decision& decision, const Style& style) {
    const std::string verdict = fmt::format("{:<9}", proofs::verdict_name(decision.verdict));
    std::string text = decision.as_expected() ? style.good(verdict) : style.bad(verdict);
    text += " " + title_of(task, decision);
    if (decision.verdict == proofs::Verdict::proved) {
        text += fmt::format("  ({} {}, {} terms)", decision.cases, decision.cases == 1 ? "case" : "cases",
                            decision.terms);
    }
    if (!decision.as_expected() && !decision.error) {
        text += style.bad(decision.expects_proof ? "  which was claimed" : "  which was to be refuted");
    }
    text += "\n";
    if (!decision.conditions.empty())
        text += fmt::format("    if {}\n", fmt::join(decision.conditions, ", "));
    if (decision.counterexample) text += readable(*decision.counterexample);
    if (decision.error) text += proofs::diagnostic(task.text->name, task.text->content, *decision.error);
    return text;
}

/// Decides the tasks on several threads and hands each to `report` in order.
void run_tasks(std::vector<Task>& tasks, const ProveCommand& command,
               const std::function<void(const Task&)>& report) {
    std::mutex mutex;
    std::condition_variable finished;
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < tasks.size(); i = next++) {
            auto decisions = proofs::decide(*tasks[i].block, command.limits);
            const std::scoped_lock lock(mutex);
            tasks[i].decisions = std::move(decisions);
            tasks[i].done = true;
            finished.notify_one();
        }
    };
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < std::min(command.jobs, tasks.size()); ++i) threads.emplace_back(work);
    for (Task& task : tasks) {
        std::unique_lock lock(mutex);
        finished.wait(lock, [&] { return task.done; });
        lock.unlock();
        report(task);
    }
}

Count count_of(const std::vector<proofs::Decision>& decisions) {
    Count count;
    count.theorems = 1;
    for (const proofs::Decision& decision : decisions) {
        if (decision.verdict == proofs::Verdict::proved) ++count.proved;
        if (decision.verdict == proofs::Verdict::refuted) ++count.refuted;
        if (decision.verdict == proofs::Verdict::undecided) ++count.undecided;
        if (!decision.as_expected()) ++count.unexpected;
    }
    return count;
}

std::string summary_text(const std::vector<std::pair<std::string, Count>>& rows) {
    std::size_t width = 5;
    for (const auto& [name, count] : rows) width = std::max(width, name.size());
    std::string text =
        fmt::format("\n{:<{}}  theorems  proved  refuted  undecided  unread  unexpected\n", "", width);
    const auto row = [&](const std::string& name, const Count& count) {
        return fmt::format("{:<{}}  {:>8}  {:>6}  {:>7}  {:>9}  {:>6}  {:>10}\n", name, width, count.theorems,
                           count.proved, count.refuted, count.undecided, count.unread, count.unexpected);
    };
    Count total;
    for (const auto& [name, count] : rows) {
        text += row(name, count);
        total.add(count);
    }
    return rows.size() == 1 ? text : text + row("total", total);
}

Outcome format_all(const std::vector<Text>& texts, const Streams& streams) {
    for (const Text& text : texts) {
        for (const Error& error : text.document.errors)
            streams.errors(proofs::diagnostic(text.name, text.content, error));
        if (!text.document.errors.empty()) return Outcome::wrong_usage;
        streams.output(proofs::formatted(text.document));
    }
    return Outcome::success;
}

/// One line of JSON a claim.
Json line_of(const Task& task, const proofs::Decision& decision) {
    Json line = Json::Object{{"id", task.block->id},
                             {"file", task.text->name},
                             {"line", proofs::place_of(task.text->content, decision.offset).line},
                             {"kind", decision.expects_proof ? "claim" : "refute"}};
    const Json result = to_json(decision);
    for (const auto& [name, value] : *result.object()) line[name] = value;
    return line;
}

}  // namespace

Outcome prove(const ProveCommand& command, const Streams& streams) {
    const std::vector<Text> texts = read_texts(command, streams);
    if (command.only_format) return format_all(texts, streams);
    std::vector<Task> tasks;
    std::vector<std::pair<std::string, Count>> rows;
    for (const Text& text : texts) {
        rows.emplace_back(text.name, Count{});
        rows.back().second.unread = text.document.errors.size();
        for (const Error& error : text.document.errors)
            streams.errors(proofs::diagnostic(text.name, text.content, error));
        for (const proofs::Block& block : text.document.blocks) tasks.push_back({&text, &block, {}, false});
    }
    const Style style(streams.coloured_output);
    std::size_t reported = 0;
    const auto progress = [&](std::size_t number) {
        if (!streams.shows_progress || command.as_json) return;
        const std::string name = number < tasks.size() ? tasks[number].block->id : "";
        streams.errors(name.empty() ? "\r\x1b[K"
                                    : fmt::format("\r\x1b[K[{}/{}] {}", number + 1, tasks.size(), name));
    };
    progress(0);
    run_tasks(tasks, command, [&](const Task& task) {
        Count& count = rows[static_cast<std::size_t>(task.text - texts.data())].second;
        count.add(count_of(task.decisions));
        if (streams.shows_progress && !command.as_json) streams.errors("\r\x1b[K");
        for (const proofs::Decision& decision : task.decisions) {
            if (command.as_json) {
                streams.output(to_text(line_of(task, decision)) + "\n");
            } else if (!command.quiet || !decision.as_expected()) {
                streams.output(report_text(task, decision, style));
            }
        }
        progress(++reported);
    });
    if (!command.as_json && (command.paths.size() + command.statements.size() > 1 || tasks.size() > 1)) {
        streams.output(summary_text(rows));
    }
    Count total;
    for (const auto& [name, count] : rows) total.add(count);
    if (total.unread > 0) return Outcome::wrong_usage;
    return total.unexpected > 0 ? Outcome::refused : Outcome::success;
}

}  // namespace blossom::cli
