#pragma once

#include <blossom/core/blossom/blossom.hpp>

#include <functional>
#include <string>
#include <vector>

namespace blossom::testing {

struct NamedConstruction {
    std::string name;
    std::function<Coordinates(const PolynomialMap&, const std::vector<Argument>&)> value;
};

/// The constructions by name, and the one that a prepared `Blossom` chooses.
inline std::vector<NamedConstruction> every_construction() {
    std::vector<NamedConstruction> all;
    for (const Construction construction : {Construction::symmetric, Construction::polarization,
                                            Construction::regrouped_polarization, Construction::casteljau}) {
        all.push_back({std::string(construction_name(construction)),
                       [construction](const PolynomialMap& map, const std::vector<Argument>& arguments) {
                           return blossom_value(map, arguments, construction);
                       }});
    }
    all.push_back({"prepared", [](const PolynomialMap& map, const std::vector<Argument>& arguments) {
                       return Blossom(map)(arguments);
                   }});
    return all;
}

}  // namespace blossom::testing
