#include "proof_records.hpp"

#include <fmt/format.h>
#include <blossom/proofs/coq.hpp>
#include <blossom/worked/general_statement.hpp>
#include <pugixml.hpp>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <sstream>
#include <string_view>

#include "certificates/proof_certificate.hpp"
#include "json/json_text.hpp"

namespace blossom::cli {

namespace {

void write_certificates(std::vector<ProofTask>& tasks, const std::string& path) {
    std::vector<proofs::second::Certificate> certificates;
    for (ProofTask& task : tasks) std::ranges::move(task.certificates, std::back_inserter(certificates));
    write_file(path, to_text(certificates_json(certificates)) + "\n");
}

/// Writes the lemmas and returns the number of cases without a lemma.
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

/// `id`, with a suffix -2, -3, ... if an earlier statement has the same id.
std::string unused_name(const std::string& id, std::set<std::string>& used) {
    std::string name = id;
    for (std::size_t i = 2; !used.insert(name).second; ++i) name = fmt::format("{}-{}", id, i);
    return name;
}

/// Writes one file per theorem if `path` is a folder, which is made if it does not exist, or all theorems
/// into one file.
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

/// The test cases of one text, with the numbers of failures and errors.
class Suite {
public:
    Suite(pugi::xml_node suites, const ProofText& text)
        : text_(text), node_(suites.append_child("testsuite")) {
        node_.append_attribute("name") = text.name.c_str();
        for (const Error& error : text.document.errors) {
            const std::string place = fmt::format("line {}", text.line(error.offset().value_or(0)));
            complain(begin(place), "error", "not read", text.diagnostic(error));
        }
    }

    void append(const ProofTask& task) {
        for (const proofs::Decision& decision : task.decisions) append(task, decision);
    }

    void end() {
        node_.append_attribute("tests") = tests_;
        node_.append_attribute("failures") = failures_;
        node_.append_attribute("errors") = errors_;
    }

private:
    void append(const ProofTask& task, const proofs::Decision& decision) {
        const std::string place = fmt::format("line {}", text_.line(decision.offset));
        const std::string& id = task.block->id;
        pugi::xml_node node = begin(id.empty() ? place : id + ", " + place);
        const proofs::Verdict verdict = decision.verdict();
        if (decision.as_expected()) return;
        const bool decided = verdict == proofs::Verdict::proved || verdict == proofs::Verdict::refuted;
        complain(node, decided ? "failure" : "error", proofs::verdict_name(verdict),
                 report_text(task, decision, {}));
    }

    pugi::xml_node begin(const std::string& name) {
        ++tests_;
        pugi::xml_node node = node_.append_child("testcase");
        node.append_attribute("classname") = text_.name.c_str();
        node.append_attribute("name") = name.c_str();
        return node;
    }

    void complain(pugi::xml_node node, std::string_view element, std::string_view message,
                  const std::string& report) {
        ++(element == "failure" ? failures_ : errors_);
        pugi::xml_node complaint = node.append_child(std::string(element).c_str());
        complaint.append_attribute("message") = std::string(message).c_str();
        complaint.text().set(report.c_str());
    }

    const ProofText& text_;
    pugi::xml_node node_;
    unsigned tests_ = 0;
    unsigned failures_ = 0;
    unsigned errors_ = 0;
};

/// The report of a run in the XML format of JUnit: one suite per text, one test case per line `claim` or
/// `refute`. An unexpected verdict is a failure. An undecided line, a disagreement of the two roads and a
/// block that cannot be read are errors. Each has the text that `prove` prints.
std::string junit_report(const std::vector<ProofText>& texts, const std::vector<ProofTask>& tasks) {
    pugi::xml_document document;
    pugi::xml_node suites = document.append_child("testsuites");
    suites.append_attribute("name") = "blossom prove";
    for (const ProofText& text : texts) {
        Suite suite(suites, text);
        for (const ProofTask& task : tasks) {
            if (task.text == &text) suite.append(task);
        }
        suite.end();
    }
    std::ostringstream stream;
    document.save(stream, "  ", pugi::format_indent, pugi::encoding_utf8);
    return stream.str();
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
