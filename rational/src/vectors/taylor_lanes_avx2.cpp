// Compiled for AVX2; run only where the processor has it.

#include "taylor_lanes_operations.hpp"

namespace blossom::taylor_lanes {

namespace {

struct Four {
    using Vector = std::int64_t __attribute__((vector_size(32), may_alias));
};

}  // namespace

const Operations avx2_operations = OperationsOf<Four>::table;

}  // namespace blossom::taylor_lanes
