#include "proof_records.hpp"

#include <fmt/format.h>
#include <blossom/proofs/coq.hpp>
#include <blossom/worked/general_statement.hpp>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>

#include "certificates/proof_certificate.hpp"
#include "json/json_text.hpp"
#include "junit.hpp"

namespace blossom::cli {

namespace {

void write_certificates(std::vector<ProofTask>& tasks, const std::string& path) {
    std::vector<proofs::second::Certificate> certificates;
    for (ProofTask& task : tasks) std::ranges::move(task.certificates, std::back_inserter(certificates));
    write_file(path, to_text(certificates_json(certificates)) + "\n");
}

/// Writes the lemmas; gives the number of cases without one.
std::size_t write_lemmas(const std::vector<ProofTask>& tasks, const std::string& path) {
    std::string text = proofs::coq_preamble();
    std::size_t without = 0;
    for (const ProofTask& task : tasks) {
        for (const std::string& lemma : task.lemmas) text += lemma;
        without += task.without_lemma;
    }
    write_file(path, text);
    return without;
}

/// `id`, or id-2, id-3, ... for what has the same id as an earlier one.
std::string unused_name(const std::string& id, std::set<std::string>& used) {
    std::string name = id;
    for (std::size_t i = 2; !used.insert(name).second; ++i) name = fmt::format("{}-{}", id, i);
    return name;
}

/// A file each in a folder, which is made where there is none, or all in one file.
void write_theorems(const std::vector<ProofTask>& tasks, const std::filesystem::path& path) {
    const bool in_folder = path.filename().empty() || std::filesystem::is_directory(path);
    if (in_folder) std::filesystem::create_directories(path);
    std::set<std::string> used;
    std::string all;
    for (const ProofTask& task : tasks) {
        if (task.decisions.empty()) continue;
        const std::string name = unused_name(task.block->id.empty() ? "statement" : task.block->id, used);
        const std::string fragment = fmt::format("% theorem {0}\n{1}% end of theorem {0}\n", name,
                                                 worked::render_latex_theorem(*task.block, task.decisions));
        if (in_folder) {
            write_file(path / (name + ".tex"), fragment);
        } else {
            all += (all.empty() ? "" : "\n") + fragment;
        }
    }
    if (!in_folder) write_file(path, all);
}

}  // namespace

void write_records(const std::vector<ProofText>& texts, std::vector<ProofTask>& tasks,
                   const ProveCommand& command, const Streams& streams) {
    if (!command.certificate.empty()) write_certificates(tasks, command.certificate);
    if (!command.latex.empty()) write_theorems(tasks, command.latex);
    if (!command.junit.empty()) write_file(command.junit, junit_report(texts, tasks));
    const std::size_t without_lemma = command.coq.empty() ? 0 : write_lemmas(tasks, command.coq);
    if (without_lemma > 0 && !command.as_json) {
        streams.output(fmt::format(
            "{} cases have no lemma: they have hypotheses, maps of several variables, or are too long\n",
            without_lemma));
    }
}

}  // namespace blossom::cli
