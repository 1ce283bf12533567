#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace blossom::proofs {

/// A function of the language and the number of its arguments.
struct Function {
    std::string_view name;
    std::size_t least;
    std::size_t most;
    std::string_view form;  ///< for messages
};

inline constexpr Function functions[] = {
    {"sum", 3, 4, "sum(i, low, high, e) or sum(i, S, e)"},
    {"prod", 3, 4, "prod(i, low, high, e) or prod(i, S, e)"},
    {"mean", 3, 4, "mean(i, S, e) or mean(i, low, high, e)"},
    {"size", 1, 1, "size(S)"},
    {"subsets", 2, 2, "subsets(n, k) or subsets(S, k)"},
    {"partitions", 1, 1, "partitions(n) or partitions(S)"},
    {"permutations", 1, 1, "permutations(n)"},
    {"sign", 1, 1, "sign(P)"},
    {"determinant", 4, 4, "determinant(i, j, n, e)"},
    {"if", 3, 3, "if(i == j, a, b)"},
    {"without", 2, 2, "without(n, S)"},
    {"binomial", 2, 2, "binomial(n, k)"},
    {"factorial", 1, 1, "factorial(n)"},
    {"bernstein", 3, 3, "bernstein(i, n, t)"},
    {"bspline", 5, 5, "bspline(j, d, x, i, t)"},
};

/// The function of that name, or nullptr.
inline const Function* find_function(std::string_view name) {
    for (const Function& function : functions) {
        if (function.name == name) return &function;
    }
    return nullptr;
}
inline bool is_function(std::string_view name) { return find_function(name) != nullptr; }

}  // namespace blossom::proofs
