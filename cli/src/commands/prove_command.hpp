#pragma once

#include <blossom/rational/limits.hpp>

#include <optional>
#include <string>
#include <vector>

#include "protocol_names.hpp"
#include "responses.hpp"
#include "streams/streams.hpp"

namespace blossom::cli {

/// What the command `prove` is asked for.
struct ProveCommand {
    std::vector<std::string> paths;       ///< files, folders, or "-"
    std::vector<std::string> statements;  ///< of -e: a claim each
    std::vector<std::string> degrees;     ///< "b=2" or "f=2,3": the maps of the statements
    bool only_format = false;
    bool as_json = false;
    bool quiet = false;
    std::string certificate;  ///< the file for it, or empty
    std::string coq;          ///< the file for lemmas, or empty
    std::string latex;        ///< the folder, or the file, for theorems in LaTeX, or empty
    std::string junit;        ///< the file for a report in JUnit's XML, or empty
    std::size_t jobs = 1;
    Limits limits;
};

/// Decides everything and reports it in order. Success when all is as expected, `refused` when something is
/// not, `wrong_usage` when a text could not be read.
Outcome prove(const ProveCommand& command, const Streams& streams);

/// Checks the certificates of a file and says how many proofs were confirmed. `refused` when one was not.
Outcome check_certificate_file(const std::string& path, const Limits& limits, const Streams& streams);

}  // namespace blossom::cli
