// Compiled for AVX-512; runs only on processors that have it.

#include "taylor_lanes_operations.hpp"

namespace blossom::taylor_lanes {

namespace {

struct Eight {
    using Vector = std::int64_t __attribute__((vector_size(64), may_alias));
};

}  // namespace

const Operations avx512_operations = OperationsOf<Eight>::table;

}  // namespace blossom::taylor_lanes
