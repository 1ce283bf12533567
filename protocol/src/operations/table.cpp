#include "table.hpp"

#include <blossom/rational/made_once.hpp>

#include <algorithm>
#include <array>
#include <iterator>

namespace blossom::protocol {

std::size_t operation_count() { return std::size(operation_table); }

const Operation& operation_at(std::size_t index) {
    static const std::array<MadeOnce<Operation>, std::size(operation_table)> described;
    return described[index].value([&] {
        const OperationEntry& entry = operation_table[index];
        Operation operation = entry.describe();
        operation.name = entry.name;
        operation.options = completed(std::move(operation.options), operation.request);
        return operation;
    });
}

const Operation* operation_of(std::string_view name) {
    const auto* const entry = std::ranges::find(operation_table, name, &OperationEntry::name);
    if (entry == std::ranges::end(operation_table)) return nullptr;
    return &operation_at(static_cast<std::size_t>(entry - operation_table));
}

}  // namespace blossom::protocol
