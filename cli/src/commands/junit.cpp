#include "junit.hpp"

#include <fmt/format.h>
#include <pugixml.hpp>

#include <sstream>
#include <string_view>

namespace blossom::cli {

namespace {

/// The cases of one text, and how many of them are not well.
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

}  // namespace

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

}  // namespace blossom::cli
