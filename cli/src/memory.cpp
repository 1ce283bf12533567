#include <malloc.h>
#include <blossom/rational/resource_budget.hpp>

#include <cstdlib>
#include <new>

// Memory is counted where all of it comes from, so that a request is refused before it takes what other
// programs need: see `blossom::ResourceBudget`.

namespace {

void* counted(void* block) {
    if (!block) throw std::bad_alloc();
    try {
        blossom::take_bytes(malloc_usable_size(block));
    } catch (...) {
        std::free(block);
        throw;
    }
    return block;
}

void give_back(void* block) noexcept {
    if (block) blossom::give_back_bytes(malloc_usable_size(block));
    std::free(block);
}

}  // namespace

void* operator new(std::size_t size) { return counted(std::malloc(size == 0 ? 1 : size)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
    const auto step = static_cast<std::size_t>(alignment);
    return counted(std::aligned_alloc(step, (size + step - 1) / step * step));
}
void operator delete(void* block) noexcept { give_back(block); }
void operator delete(void* block, std::size_t /*size*/) noexcept { give_back(block); }
void operator delete(void* block, std::align_val_t /*alignment*/) noexcept { give_back(block); }
void operator delete(void* block, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept {
    give_back(block);
}
