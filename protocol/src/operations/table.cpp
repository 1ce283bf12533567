#include "table.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <iterator>
#include <mutex>
#include <optional>

namespace blossom::protocol {

std::size_t operation_count() { return std::size(operation_table); }

const Operation& operation_at(std::size_t index) {
    // Not std::call_once, whose exceptions need more memory.
    static std::array<std::atomic<const Operation*>, std::size(operation_table)> ready{};
    static std::array<std::optional<Operation>, std::size(operation_table)> described;
    static std::mutex mutex;
    if (const Operation* known = ready[index].load(std::memory_order_acquire)) return *known;
    const std::scoped_lock lock(mutex);
    if (!described[index]) {
        const OperationEntry& entry = operation_table[index];
        Operation operation = entry.describe();
        operation.name = entry.name;
        operation.options = completed(std::move(operation.options), operation.request);
        described[index] = std::move(operation);
        ready[index].store(&*described[index], std::memory_order_release);
    }
    return *described[index];
}

const Operation* operation_of(std::string_view name) {
    const auto* const entry = std::ranges::find(operation_table, name, &OperationEntry::name);
    if (entry == std::ranges::end(operation_table)) return nullptr;
    return &operation_at(static_cast<std::size_t>(entry - operation_table));
}

}  // namespace blossom::protocol
