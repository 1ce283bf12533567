#include "vector_level.hpp"

#include <cstdlib>

namespace blossom::vectors {

std::string_view level() {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): nothing here writes the environment
    const char* variable = std::getenv("BLOSSOM_VECTOR_LEVEL");
    return variable ? variable : "ifma";
}

}  // namespace blossom::vectors
