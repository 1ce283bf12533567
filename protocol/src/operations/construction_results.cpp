#include "construction_results.hpp"

#include <blossom/core/algebra/polynomial_text.hpp>

#include <algorithm>
#include <iterator>

#include "json/fields.hpp"

namespace blossom::protocol {

Json agreement_at_arguments(const Agreement<Coordinates>& agreement, const Json::Object& degree,
                            const PointForm& form) {
    Json::Object result{{"agree", agreement.agree()}};
    std::ranges::copy(degree, std::back_inserter(result));
    result.emplace_back("values", construction_values(agreement, [&](const Coordinates& value) {
                            return within("arguments", [&] { return to_json(value, form); });
                        }));
    result.emplace_back("skipped", skipped_constructions(agreement));
    return result;
}

Json expansion_texts(const std::vector<SparsePolynomial>& coordinates, const PointForm& form,
                     const std::vector<std::string>& names) {
    if (form.scalar && !form.rational) return to_text(coordinates.front(), names);
    Json::Array list;
    for (const SparsePolynomial& coordinate : coordinates) list.emplace_back(to_text(coordinate, names));
    return list;
}

Json agreement_for_all(const Agreement<std::vector<SparsePolynomial>>& agreement, Json::Object members,
                       const PointForm& form, const std::vector<std::string>& names) {
    Json::Object result{{"agree", agreement.agree()}, {"for_all_arguments", agreement.agree()}};
    std::ranges::move(members, std::back_inserter(result));
    Json expansions = construction_values(agreement, [&](const std::vector<SparsePolynomial>& coordinates) {
        return expansion_texts(coordinates, form, names);
    });
    result.emplace_back("expansion", expansions.object()->front().second);
    // If they differ, all of them are shown.
    if (!agreement.agree()) result.emplace_back("expansions", std::move(expansions));
    result.emplace_back("skipped", skipped_constructions(agreement));
    return result;
}

}  // namespace blossom::protocol
