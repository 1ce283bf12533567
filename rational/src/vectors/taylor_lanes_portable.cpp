#include "taylor_lanes_operations.hpp"

namespace blossom::taylor_lanes {

namespace {

// Two lanes are what every processor of 64 bits has.
struct Pair {
    using Vector = std::int64_t __attribute__((vector_size(16), may_alias));
};

}  // namespace

const Operations portable_operations = OperationsOf<Pair>::table;

}  // namespace blossom::taylor_lanes
