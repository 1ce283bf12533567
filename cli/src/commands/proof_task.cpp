#include "proof_task.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "decision_text.hpp"
#include "operations/map_options.hpp"
#include "prove_statement.hpp"

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

namespace {

std::string title_of(const ProofTask& task, const proofs::Decision& decision) {
    const std::string& id = task.block->id;
    return id.empty() ? fmt::format("{}:{}", task.text->name, task.text->line(decision.offset)) : id;
}

}  // namespace

std::string report_text(const ProofTask& task, const proofs::Decision& decision, const Style& style) {
    std::string text = readable(*task.block, decision, title_of(task, decision), style);
    if (const Error* error = decision.error()) text += task.text->diagnostic(*error);
    return text;
}

}  // namespace blossom::cli
