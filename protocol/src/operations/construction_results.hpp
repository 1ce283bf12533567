#pragma once

#include <blossom/core/blossom/agreement.hpp>

#include <blossom/protocol/json.hpp>

namespace blossom::protocol {

/// {"construction", "reason"} for each construction that was not run.
template <class Value>
Json skipped_constructions(const Agreement<Value>& agreement) {
    Json::Array list;
    for (const auto& result : agreement.results) {
        if (result.value) continue;
        list.emplace_back(Json::Object{{"construction", construction_name(result.construction)},
                                       {"reason", result.skipped}});
    }
    return list;
}

/// By the name of each construction that was run what it gave.
template <class Value, class Write>
Json construction_values(const Agreement<Value>& agreement, const Write& write) {
    Json::Object values;
    for (const auto& [construction, value, reason] : agreement.results) {
        if (value) values.emplace_back(construction_name(construction), write(*value));
    }
    return values;
}

}  // namespace blossom::protocol
