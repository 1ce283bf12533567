#pragma once

#include <blossom/rational/limits.hpp>

#include <optional>
#include <string>
#include <vector>

#include "protocol_names.hpp"
#include "responses.hpp"
#include "streams/streams.hpp"

namespace blossom::cli {

/// The options of the command `prove`.
struct ProveCommand {
    std::vector<std::string> paths;       ///< files, folders, or "-"
    std::vector<std::string> statements;  ///< of the options -e, one claim per option
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

/// Decides all claims and reports them in order. `success` if every verdict is as expected, `refused` if one
/// is not, `wrong_usage` if a text could not be read.
Outcome prove(const ProveCommand& command, const Streams& streams);

/// Checks the certificates of a file and prints how many proofs are confirmed. `refused` if one is not.
Outcome check_certificate_file(const std::string& path, const Limits& limits, const Streams& streams);

}  // namespace blossom::cli
