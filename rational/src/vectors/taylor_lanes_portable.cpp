#include "taylor_lanes_operations.hpp"

namespace blossom::digit_rows {

namespace {

// Two lanes are what every processor of 64 bits has.
struct Pair {
    using Vector = std::int64_t __attribute__((vector_size(16), may_alias));
};

}  // namespace

const Operations portable_operations = OperationsOf<Pair>::table;

}  // namespace blossom::digit_rows
