#include <blossom/proofs/witness_maps.hpp>

namespace blossom::proofs {

bool is_tensor(const WitnessMap& map) { return map.directions.size() > 1; }

std::string degrees_text(const WitnessMap& map) {
    std::string text;
    for (const auto& [degree, dimension] : map.directions)
        text += (text.empty() ? "" : ", ") + std::to_string(degree);
    return (is_tensor(map) ? "degrees " : "degree ") + text;
}

std::vector<std::string> variables_of(const WitnessMap& map) {
    std::size_t count = 0;
    for (const auto& [degree, dimension] : map.directions) count += dimension;
    if (count == 1) return {"t"};
    if (count == 2 && is_tensor(map)) return {"u", "v"};
    std::vector<std::string> names;
    for (std::size_t i = 1; i <= count; ++i) names.push_back("x" + std::to_string(i));
    return names;
}

}  // namespace blossom::proofs
