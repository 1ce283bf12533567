#pragma once

#include <blossom/core/blossom/agreement.hpp>

#include <string>
#include <vector>

#include <blossom/protocol/json.hpp>
#include "maps/points.hpp"

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

/// The results by the names of the constructions that were run.
template <class Value, class Write>
Json construction_values(const Agreement<Value>& agreement, const Write& write) {
    Json::Object values;
    for (const auto& [construction, value, reason] : agreement.results) {
        if (value) values.emplace_back(construction_name(construction), write(*value));
    }
    return values;
}

/// The values by all constructions at the arguments; `degree` is the member "degree" or "degrees".
Json agreement_at_arguments(const Agreement<Coordinates>& agreement, const Json::Object& degree,
                            const PointForm& form);

/// One text per coordinate, or the text of the only one. A rational map has one more, its denominator.
Json expansion_texts(const std::vector<SparsePolynomial>& coordinates, const PointForm& form,
                     const std::vector<std::string>& names);

/// The expansions in symbolic arguments with these names. `members` are the degree and the other members
/// before the expansion.
Json agreement_for_all(const Agreement<std::vector<SparsePolynomial>>& agreement, Json::Object members,
                       const PointForm& form, const std::vector<std::string>& names);

}  // namespace blossom::protocol
