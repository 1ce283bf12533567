#pragma once

#include <blossom/proofs/certificate.hpp>
#include <blossom/proofs/doubtful_names.hpp>
#include <blossom/proofs/parser.hpp>
#include <blossom/proofs/prover.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "limit_flags.hpp"
#include "protocol_names.hpp"
#include "prove_command.hpp"
#include "text/readable.hpp"

/// The texts that `prove` decides, and their blocks.

namespace blossom::cli {

/// A text as the user wrote it, with its origin.
struct ProofText {
    std::string name;
    std::string content;
    std::size_t prelude;  ///< the bytes in front of what the user wrote: the maps of --degree
    proofs::Document document;

    std::size_t line(std::size_t offset) const {
        return proofs::line_and_column(written(), offset - std::min(offset, prelude)).line;
    }
    std::string diagnostic(const Error& error) const {
        const std::size_t offset = error.offset().value_or(0);
        const Error flagged = with_flag(error);
        if (offset < prelude)
            return proofs::diagnostic("--degree", std::string_view(content).substr(0, prelude), flagged);
        return proofs::diagnostic(name, written(), flagged.at(offset - prelude));
    }

private:
    std::string_view written() const { return std::string_view(content).substr(prelude); }
};

/// A block to be decided.
struct ProofTask {
    std::size_t number = 0;
    const ProofText* text = nullptr;
    const proofs::Block* block = nullptr;
    std::vector<proofs::Decision> decisions;
    std::vector<proofs::Warning> warnings;
    std::vector<proofs::second::Certificate> certificates;
    std::vector<std::string> lemmas;
    std::size_t without_lemma = 0;
};

/// The path itself, or all files *.blossom in it if it is a folder. Errors: std::system_error for a
/// folder without one.
std::vector<std::string> statement_files(const std::string& path);

/// The maps of --degree as lines of the language. Errors: `UsageError`.
std::string map_lines(const std::vector<std::string>& degrees);

/// The text of an option -e; the word "claim" may be left out.
std::string statement_text(const std::string& claim);

/// The texts of the files, then those of the options -e. Errors: `UsageError` if there are none.
std::vector<ProofText> read_texts(const ProveCommand& command, const Streams& streams);

/// The verdict, and the error below it.
std::string report_text(const ProofTask& task, const proofs::Decision& decision, const Style& style);

}  // namespace blossom::cli
