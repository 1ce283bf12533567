#include "proof_task.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "decision_text.hpp"
#include "operations/map_options.hpp"

namespace blossom::cli {

std::vector<std::string> statement_files(const std::string& path) {
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

std::vector<ProofText> read_texts(const ProveCommand& command, const Streams& streams) {
    std::vector<ProofText> texts;
    const auto add = [&](std::string name, std::string content, std::size_t prelude) {
        proofs::Document document = proofs::parse(content, command.limits);
        if (document.errors.empty() && !command.only_format) {
            try {
                proofs::require_claim(document);
            } catch (const Error& error) {
                document.errors.push_back(error);
            }
        }
        texts.push_back({std::move(name), std::move(content), prelude, std::move(document)});
    };
    for (const std::string& path : command.paths) {
        for (const std::string& file : statement_files(path)) {
            add(file == "-" ? "standard input" : file,
                read_all(file == "-" ? streams.input : file_source(file), command.limits.line_bytes), 0);
        }
    }
    const std::string maps = map_lines(command.degrees);
    for (const std::string& claim : command.statements)
        add("statement", maps + statement_text(claim), maps.size());
    if (texts.empty()) throw UsageError("prove needs a file, a folder or a statement with -e");
    return texts;
}

std::string report_text(const ProofTask& task, const proofs::Decision& decision, const Style& style) {
    const std::string& id = task.block->id;
    const std::string title =
        id.empty() ? fmt::format("{}:{}", task.text->name, task.text->line(decision.offset)) : id;
    std::string text = readable(*task.block, decision, title, style);
    if (const Error* error = decision.error()) text += task.text->diagnostic(*error);
    return text;
}

}  // namespace blossom::cli
