// Lines under the default limits, with memory counted as in the program.

#include <blossom/rational/resource_budget.hpp>

#include <cstddef>
#include <cstdint>

#include "answered_line.hpp"

// Memory that libFuzzer allocates with its own operator is released by the operator of the program.
extern "C" const char* __asan_default_options() { return "alloc_dealloc_mismatch=0"; }  // NOLINT

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const blossom::Limits limits = [] {
        blossom::allocate_numbers_with_new();
        return blossom::Limits{};
    }();
    check_answered({data, size}, limits);
    return 0;
}
