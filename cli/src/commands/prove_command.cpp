#include "prove_command.hpp"

#include <fmt/format.h>
#include <blossom/proofs/coq.hpp>
#include <blossom/proofs/formatter.hpp>
#include <blossom/proofs/prover.hpp>

#include <algorithm>

#include "certificates/proof_certificate.hpp"
#include "decisions.hpp"
#include "json/json_text.hpp"
#include "operations/map_options.hpp"
#include "proof_records.hpp"
#include "proof_task.hpp"
#include "streams/ordered_work.hpp"

namespace blossom::cli {

namespace {

struct Count {
    std::size_t theorems = 0;
    std::size_t proved = 0;
    std::size_t refuted = 0;
    std::size_t unexpected = 0;
    std::size_t undecided = 0;
    std::size_t unread = 0;
    std::size_t disagreements = 0;

    void add(const Count& other) {
        theorems += other.theorems;
        proved += other.proved;
        refuted += other.refuted;
        unexpected += other.unexpected;
        undecided += other.undecided;
        unread += other.unread;
        disagreements += other.disagreements;
    }
};

/// The name of a case in Coq without its number, such as "block_7_fj_eq20_n_3".
std::string lemma_name(const ProofTask& task, const proofs::ProvedCase& proved) {
    std::string name = fmt::format("block_{}_{}", task.number + 1, task.block->id);
    for (const auto& [parameter, value] : proved.block.parameters)
        name += "_" + parameter + "_" + std::to_string(value);
    for (char& c : name) {
        if (c == '-' || c == '.') c = '_';
    }
    return name;
}

/// Decides one task and keeps the records that the command writes.
void decide(ProofTask& task, const ProveCommand& command) {
    const auto record = [&](const proofs::ProvedCase& proved) {
        if (!command.certificate.empty()) task.certificates.push_back(proved.certificate);
        if (command.coq.empty()) return;
        const std::string name = fmt::format("{}_line_{}_{}", lemma_name(task, proved),
                                             task.text->line(proved.relation.offset), task.lemmas.size());
        if (auto lemma = proofs::coq_lemma(proved, name)) {
            task.lemmas.push_back(std::move(*lemma));
        } else {
            ++task.without_lemma;
        }
    };
    const bool records = !command.certificate.empty() || !command.coq.empty();
    proofs::DecisionOptions options;
    if (records) options.on_proof = record;
    try {
        task.warnings = proofs::doubtful_names(*task.block);
    } catch (const Error&) {
        task.warnings.clear();  // an error of the declarations is the error of every decision
    }
    task.decisions = proofs::decide(*task.block, command.limits, options);
}

/// The warnings of a task, each as "warning: file:3:7: ..." with a caret.
std::string warnings_text(const ProofTask& task) {
    std::string text;
    for (const proofs::Warning& warning : task.warnings)
        text += "warning: " +
                task.text->diagnostic(Error(ErrorCode::syntax, warning.message, {}, warning.offset));
    return text;
}

Count count_of(const std::vector<proofs::Decision>& decisions) {
    Count count;
    count.theorems = 1;
    for (const proofs::Decision& decision : decisions) {
        const proofs::Verdict verdict = decision.verdict();
        if (verdict == proofs::Verdict::proved) ++count.proved;
        if (verdict == proofs::Verdict::refuted) ++count.refuted;
        if (verdict == proofs::Verdict::undecided) ++count.undecided;
        if (verdict == proofs::Verdict::disagreement) ++count.disagreements;
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

Outcome format_all(const std::vector<ProofText>& texts, const Streams& streams) {
    for (const ProofText& text : texts) {
        for (const Error& error : text.document.errors) streams.errors(text.diagnostic(error));
        if (!text.document.errors.empty()) return Outcome::wrong_usage;
        streams.output(proofs::formatted(text.document));
    }
    return Outcome::success;
}

/// One line of JSON per claim.
Json line_of(const ProofTask& task, const proofs::Decision& decision) {
    Json line =
        Json::Object{{"id", task.block->id},
                     {"file", task.text->name},
                     {"line", task.text->line(decision.offset)},
                     {"kind", decision.expectation == proofs::Expectation::proof ? "claim" : "refute"}};
    const Json result = to_json(*task.block, decision);
    for (const auto& [name, value] : *result.object()) line[name] = value;
    Json::Array warnings;
    for (const proofs::Warning& warning : task.warnings) {
        warnings.emplace_back(
            Json::Object{{"line", task.text->line(warning.offset)}, {"message", warning.message}});
    }
    if (!warnings.empty()) line["warnings"] = std::move(warnings);
    return line;
}

}  // namespace

Outcome check_certificate_file(const std::string& path, const Limits& limits, const Streams& streams) {
    std::vector<proofs::second::Certificate> certificates;
    try {
        const std::string text = read_all(path == "-" ? streams.input : file_source(path), limits.line_bytes);
        certificates = read_certificates(parse_json(text, limits), limits);
    } catch (const Error& error) {
        const std::string place = error.place().empty() ? "" : " (at " + pointer_of(error.place()) + ")";
        throw UsageError(path + " is not a certificate: " + error.message() + place);
    }
    bool complete = !certificates.empty();
    std::size_t confirmed = 0;
    for (const proofs::second::Confirmed& line : proofs::second::confirmed_theorems(certificates, limits)) {
        complete = complete && line.confirmed;
        confirmed += line.confirmed ? 1 : 0;
        streams.output(fmt::format("{:<9} {}, line {}: {} of {} cases\n",
                                   line.confirmed ? "confirmed" : "open",
                                   line.id.empty() ? "a statement without a name" : line.id, line.line + 1,
                                   line.proved, line.cases));
        if (!line.where.empty())
            streams.output(fmt::format("    only where {}\n", fmt::join(line.where, ", ")));
        if (!line.problem.empty()) streams.output(fmt::format("    {}\n", line.problem));
    }
    streams.output(
        fmt::format("{} {} confirmed in all cases\n", confirmed, confirmed == 1 ? "claim" : "claims"));
    return complete ? Outcome::success : Outcome::refused;
}

Outcome prove(const ProveCommand& command, const Streams& streams) {
    const std::vector<ProofText> texts = read_texts(command, streams);
    if (command.only_format) return format_all(texts, streams);
    std::vector<ProofTask> tasks;
    std::vector<std::pair<std::string, Count>> rows;
    for (const ProofText& text : texts) {
        rows.emplace_back(text.name, Count{});
        rows.back().second.unread = text.document.errors.size();
        for (const Error& error : text.document.errors) streams.errors(text.diagnostic(error));
        for (const proofs::Block& block : text.document.blocks) {
            ProofTask& task = tasks.emplace_back();
            task.number = tasks.size() - 1;
            task.text = &text;
            task.block = &block;
        }
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
    const auto report = [&](const ProofTask* const& done) {
        const ProofTask& task = *done;
        rows[static_cast<std::size_t>(task.text - texts.data())].second.add(count_of(task.decisions));
        if (streams.shows_progress && !command.as_json) streams.errors("\r\x1b[K");
        if (!command.as_json) streams.errors(warnings_text(task));
        for (const proofs::Decision& decision : task.decisions) {
            if (command.as_json) {
                streams.output(to_text(line_of(task, decision)) + "\n");
            } else if (!command.quiet || !decision.as_expected()) {
                streams.output(report_text(task, decision, style));
            }
        }
        progress(++reported);
        return true;
    };
    OrderedWork<ProofTask*> work(
        std::min(command.jobs, tasks.size()), [&](ProofTask*& task) { decide(*task, command); }, report);
    for (ProofTask& task : tasks) work.add(&task);
    work.finish();
    if (!command.as_json && (command.paths.size() + command.statements.size() > 1 || tasks.size() > 1)) {
        streams.output(summary_text(rows));
    }
    write_records(texts, tasks, command, streams);
    Count total;
    for (const auto& [name, count] : rows) total.add(count);
    if (total.disagreements > 0) return Outcome::disagreement;
    if (total.unread > 0) return Outcome::wrong_usage;
    return total.unexpected > 0 ? Outcome::refused : Outcome::success;
}

}  // namespace blossom::cli
