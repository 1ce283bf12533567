#include "symbolic_curves.hpp"

namespace blossom::testing {

SymbolicArguments runs(std::size_t k, const SymbolicArgument& first, std::size_t l,
                       const SymbolicArgument& second) {
    return joined({copies(k, first), copies(l, second)});
}

Symbols end_values(const SymbolicBlossom& p, const SymbolicArgument& a, const SymbolicArgument& b) {
    Symbols values;
    for (std::size_t k = 0; k <= p.degree(); ++k) values.push_back(p(runs(p.degree() - k, a, k, b)));
    return values;
}

std::vector<Symbols> symbolic_pyramid(const Symbols& points, const Symbol& a, const Symbol& b,
                                      const SymbolicArguments& arguments) {
    std::vector<Symbols> levels{points};
    for (const auto& [u, v] : arguments) {
        const Symbol left = b * v - u;
        const Symbol right = u - a * v;
        const Symbols& below = levels.back();
        Symbols level;
        for (std::size_t i = 0; i + 1 < below.size(); ++i)
            level.push_back(left * below[i] + right * below[i + 1]);
        levels.push_back(std::move(level));
    }
    return levels;
}

}  // namespace blossom::testing
