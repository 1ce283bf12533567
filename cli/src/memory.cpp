#include <malloc.h>
#include <blossom/rational/resource_budget.hpp>

#include <algorithm>
#include <cstdlib>
#include <new>

// The program counts all of its memory in operator new, so that a request is refused before it takes memory
// that other programs need: see `blossom::ResourceBudget`.

namespace {

/// What the C library takes for a block, with its header.
constexpr std::size_t chunk_size(std::size_t size) {
    constexpr std::size_t header = sizeof(std::size_t);
    constexpr std::size_t step = 2 * sizeof(std::size_t);
    return std::max(2 * step, (size + header + step - 1) / step * step);
}

[[noreturn, gnu::cold]] void refuse(std::size_t size) {
    blossom::give_back_bytes(chunk_size(size));
    throw std::bad_alloc();
}

template <class Allocate>
void* counted(std::size_t size, const Allocate& allocate) {
    blossom::take_bytes(chunk_size(size));
    void* const block = allocate();
    if (!block) refuse(size);
    return block;
}

void give_back(void* block, std::size_t chunk) noexcept {
    if (!block) return;
    blossom::give_back_bytes(chunk);
    std::free(block);
}

void give_back(void* block) noexcept { give_back(block, chunk_size(malloc_usable_size(block))); }

std::size_t rounded(std::size_t size, std::align_val_t alignment) {
    const auto step = static_cast<std::size_t>(alignment);
    return (size + step - 1) / step * step;
}

}  // namespace

void* operator new(std::size_t size) {
    return counted(size, [&] { return std::malloc(std::max<std::size_t>(size, 1)); });
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    const std::size_t whole = rounded(size, alignment);
    return counted(whole, [&] { return std::aligned_alloc(static_cast<std::size_t>(alignment), whole); });
}
void operator delete(void* block) noexcept { give_back(block); }
void operator delete(void* block, std::size_t size) noexcept { give_back(block, chunk_size(size)); }
void operator delete(void* block, std::align_val_t /*alignment*/) noexcept { give_back(block); }
void operator delete(void* block, std::size_t size, std::align_val_t alignment) noexcept {
    give_back(block, chunk_size(rounded(size, alignment)));
}
