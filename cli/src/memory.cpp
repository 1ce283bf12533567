#include <malloc.h>
#include <blossom/rational/resource_budget.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <new>
#include <utility>

// The program counts all of its memory in operator new, so that a request is refused before it takes memory
// that other programs need: see `blossom::ResourceBudget`.

namespace {

constexpr std::size_t header = sizeof(std::size_t);
constexpr std::size_t chunk_step = 2 * header;

/// What the C library takes for a block, with its header.
constexpr std::size_t chunk_size(std::size_t size) {
    return std::max(2 * chunk_step, (size + header + chunk_step - 1) / chunk_step * chunk_step);
}

// AddressSanitizer sees the use of a block that was given back only if the block is not used again.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define BLOSSOM_ADDRESS_SANITIZER
#endif
#endif
// In a module of another program, threads end and leave behind what they have kept.
#if defined(BLOSSOM_ADDRESS_SANITIZER) || defined(__SANITIZE_ADDRESS__) || defined(BLOSSOM_THREADS_END)
constexpr bool keeps_blocks = false;
#else
constexpr bool keeps_blocks = true;
#endif

/// The blocks that this thread gave back last, by the size of their chunks: a request mostly needs the sizes
/// that the one before needed. Nothing here has a destructor, so that objects of any lifetime may give back;
/// threads end with the program.
class KeptBlocks {
public:
    /// A block, or nullptr if there is none.
    void* take(std::size_t chunk) {
        if (chunk > largest) return nullptr;
        List& list = lists_[chunk / chunk_step];
        if (!list.first) return nullptr;
        --list.length;
        return std::exchange(list.first, list.first->next);
    }
    /// False if there are enough.
    bool keep(void* block, std::size_t chunk) noexcept {
        if (chunk > largest) return false;
        List& list = lists_[chunk / chunk_step];
        if (list.length == most) return false;
        ++list.length;
        list.first = new (block) Block{list.first};
        return true;
    }

private:
    struct Block {
        Block* next;
    };
    struct List {
        Block* first;
        std::size_t length;
    };
    static constexpr std::size_t largest = 1024;
    static constexpr std::size_t most = keeps_blocks ? 32 : 0;

    std::array<List, largest / chunk_step + 1> lists_;
};
constinit thread_local KeptBlocks kept_blocks{};

[[noreturn, gnu::cold]] void refuse(std::size_t taken) {
    blossom::give_back_bytes(taken);
    throw std::bad_alloc();
}

template <class Allocate>
void* counted(std::size_t chunk, const Allocate& allocate) {
    blossom::take_bytes(chunk);
    void* const block = allocate();
    if (!block) refuse(chunk);
    return block;
}

void give_back(void* block, std::size_t chunk) noexcept {
    if (!block) return;
    blossom::give_back_bytes(chunk);
    if (!kept_blocks.keep(block, chunk)) std::free(block);
}

void give_back(void* block) noexcept { give_back(block, chunk_size(malloc_usable_size(block))); }

std::size_t rounded(std::size_t size, std::align_val_t alignment) {
    const auto step = static_cast<std::size_t>(alignment);
    return (size + step - 1) / step * step;
}

}  // namespace

void* operator new(std::size_t size) {
    const std::size_t chunk = chunk_size(size);
    return counted(chunk, [&] {
        void* const kept = kept_blocks.take(chunk);
        return kept ? kept : std::malloc(std::max(size, chunk - header));
    });
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    const std::size_t whole = rounded(size, alignment);
    return counted(chunk_size(whole),
                   [&] { return std::aligned_alloc(static_cast<std::size_t>(alignment), whole); });
}
void operator delete(void* block) noexcept { give_back(block); }
void operator delete(void* block, std::size_t size) noexcept { give_back(block, chunk_size(size)); }
void operator delete(void* block, std::align_val_t /*alignment*/) noexcept {
    if (block) blossom::give_back_bytes(chunk_size(malloc_usable_size(block)));
    std::free(block);
}
void operator delete(void* block, std::size_t size, std::align_val_t alignment) noexcept {
    if (block) blossom::give_back_bytes(chunk_size(rounded(size, alignment)));
    std::free(block);
}
