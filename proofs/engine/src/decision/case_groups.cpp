#include <blossom/proofs/case_groups.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace blossom::proofs {

Cases cases_with(const Decision& decision, Verdict verdict) {
    Cases found;
    for (const CaseDecision& one : decision.cases) {
        if (one.verdict == verdict) found.push_back(&one);
    }
    return found;
}

std::vector<CaseGroup> groups_by_condition(const Decision& decision) {
    std::map<std::vector<std::string>, Cases> groups;
    for (const CaseDecision* one : cases_with(decision, Verdict::proved)) {
        std::vector<std::string> needed;
        for (const Condition& condition : one->conditions) {
            if (!condition.assumed) needed.push_back(condition.text);
        }
        groups[needed].push_back(one);
    }
    std::vector<CaseGroup> list;
    list.reserve(groups.size());
    for (auto& [needed, cases] : groups) list.push_back({needed, std::move(cases)});
    return list;
}

std::vector<Run> runs_of(const Cases& cases) {
    std::set<long long> values;
    for (const CaseDecision* one : cases) values.insert(one->parameters.front().second);
    std::vector<Run> runs;
    for (const long long value : values) {
        if (!runs.empty() && runs.back().last + 1 == value) {
            runs.back().last = value;
        } else {
            runs.push_back({value, value});
        }
    }
    return runs;
}

std::vector<Range> ranges_of(const Block& block, const Statement& line) {
    std::vector<Range> ranges;
    for (const Statement& statement : block.statements) {
        if (statement.kind == StatementKind::parameter) ranges.push_back(statement.ranges.front());
    }
    ranges.insert(ranges.end(), line.ranges.begin(), line.ranges.end());
    return ranges;
}

}  // namespace blossom::proofs
