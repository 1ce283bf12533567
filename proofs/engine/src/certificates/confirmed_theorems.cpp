#include "certificate_checker.hpp"

#include <blossom/rational/error.hpp>

#include <algorithm>
#include <map>

namespace blossom::proofs::second {

namespace {

/// The entries for the lines `claim` of one text.
std::vector<Confirmed> confirmed_lines(std::span<const Certificate* const> certificates,
                                       CertificateChecker& checker) {
    const Certificate& first = *certificates.front();
    std::map<std::size_t, Confirmed> lines;
    for (const Case& which : checker.claimed_cases(first.text)) {
        Confirmed& line = lines[which.line];
        line.id = first.id;
        line.title = first.title;
        line.line = which.line;
        ++line.cases;
    }
    if (lines.empty()) throw Error(ErrorCode::syntax, "the text claims nothing");
    std::map<std::size_t, std::vector<std::vector<std::pair<std::string, long long>>>> proved;
    for (const Certificate* certificate : certificates) {
        const std::string problem = checker.problem_of(*certificate);
        if (problem.empty()) {
            proved[certificate->which.line].push_back(certificate->which.parameters);
            const auto known = lines.find(certificate->which.line);
            for (const std::string& condition : checker.added_conditions()) {
                if (known == lines.end()) break;
                std::vector<std::string>& where = known->second.where;
                if (std::ranges::find(where, condition) == where.end()) where.push_back(condition);
            }
            continue;
        }
        const auto line = lines.find(certificate->which.line);
        Confirmed& entry = line != lines.end() ? line->second : lines.begin()->second;
        if (entry.problem.empty()) entry.problem = problem;
    }
    std::vector<Confirmed> result;
    for (auto& [number, line] : lines) {
        std::vector<std::vector<std::pair<std::string, long long>>>& cases = proved[number];
        std::ranges::sort(cases);
        cases.erase(std::ranges::unique(cases).begin(), cases.end());
        line.proved = cases.size();
        line.confirmed = line.proved == line.cases;
        if (!line.confirmed && line.problem.empty()) line.problem = "a case has no certificate";
        result.push_back(std::move(line));
    }
    return result;
}

}  // namespace

std::vector<Confirmed> confirmed_theorems(std::span<const Certificate> certificates, const Limits& limits) {
    std::vector<std::vector<const Certificate*>> groups;
    std::map<std::pair<std::string, std::string>, std::size_t> places;  // by text and id
    for (const Certificate& certificate : certificates) {
        const auto [place, is_new] = places.try_emplace({certificate.text, certificate.id}, groups.size());
        if (is_new) groups.emplace_back();
        groups[place->second].push_back(&certificate);
    }
    std::vector<Confirmed> result;
    CertificateChecker checker(limits);
    for (const std::vector<const Certificate*>& group : groups) {
        try {
            for (Confirmed& line : confirmed_lines(group, checker)) result.push_back(std::move(line));
        } catch (const Error& error) {
            Confirmed& entry = result.emplace_back();
            entry.id = group.front()->id;
            entry.title = group.front()->title;
            entry.problem = error.message();
        }
    }
    return result;
}

}  // namespace blossom::proofs::second
