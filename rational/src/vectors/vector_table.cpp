#include "vector_table.hpp"

#include <blossom/rational/error.hpp>

#include <cstdlib>
#include <string>
#include <string_view>

namespace blossom::vectors {

namespace {

struct Level {
    std::string_view name;
    const Table* table;  ///< null if this build or the processor does not have the level
};

constexpr Table portable_table{.residues = &residues::portable_operations,
                               .taylor = &taylor_lanes::portable_operations,
                               .eight_sums = nullptr,
                               .eight_wide_sums = nullptr,
                               .factor_products = nullptr,
                               .fold_blocks = nullptr,
                               .gcds = nullptr,
                               .integers_of_residues = nullptr};

const Table* avx2_table() {
#if defined(BLOSSOM_VECTORS_AVX2)
    static constexpr Table table = [] {
        Table result = portable_table;
        result.residues = &residues::avx2_operations;
        return result;
    }();
    if (__builtin_cpu_supports("avx2")) return &table;
#endif
    return nullptr;
}

const Table* avx512_table() {
#if defined(BLOSSOM_VECTORS_AVX512)
    static constexpr Table table{.residues = &residues::avx512_operations,
                                 .taylor = &taylor_lanes::avx512_operations,
                                 .eight_sums = &eight_sums::avx512_operations,
                                 .eight_wide_sums = &eight_sums::wide_avx512_operations,
                                 .factor_products = factor_products::avx512_multiply,
                                 .fold_blocks = fold_blocks::avx512_fold,
                                 .gcds = &gcd_lanes::avx512_operations,
                                 .integers_of_residues = residues::avx512_integers_of_residues};
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512ifma"))
        return &table;
#endif
    return nullptr;
}

}  // namespace

const Table& chosen_table() {
    const Level levels[] = {{"ifma", avx512_table()}, {"avx2", avx2_table()}, {"portable", &portable_table}};
    // NOLINTNEXTLINE(concurrency-mt-unsafe): the library never writes the environment
    const char* const variable = std::getenv("BLOSSOM_VECTOR_LEVEL");
    const std::string_view greatest = variable != nullptr ? variable : levels[0].name;
    bool allowed = false;
    for (const Level& level : levels) {
        allowed = allowed || level.name == greatest;
        if (allowed && level.table != nullptr) return *level.table;
    }
    throw Error(ErrorCode::wrong_kind, "the environment variable BLOSSOM_VECTOR_LEVEL is \"" +
                                           std::string(greatest) +
                                           R"("; it must be "ifma", "avx2" or "portable")");
}

}  // namespace blossom::vectors
