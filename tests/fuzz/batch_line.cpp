// Lines under limits so small that every input is answered quickly.

#include <cstddef>
#include <cstdint>

#include "answered_line.hpp"

namespace {

blossom::Limits small_limits() {
    blossom::Limits limits;
    limits.degree = 12;
    limits.digits = 300;
    limits.nesting = 20;
    limits.polarization_terms = 1 << 8;
    limits.expansion_terms = 1 << 8;
    limits.expansion_work = 20'000;
    limits.numbers = 1 << 10;
    limits.line_bytes = 1 << 14;
    return limits;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const blossom::Limits limits = small_limits();
    check_answered({data, size}, limits);
    return 0;
}
