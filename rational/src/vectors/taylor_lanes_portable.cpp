#include "taylor_lanes_operations.hpp"

namespace blossom::taylor_lanes {

namespace {

// Every 64-bit processor has vectors of two lanes.
struct Pair {
    using Vector = std::int64_t __attribute__((vector_size(16), may_alias));
};

}  // namespace

const Operations portable_operations = OperationsOf<Pair>::table;

}  // namespace blossom::taylor_lanes
