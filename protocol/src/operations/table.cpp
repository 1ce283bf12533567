#include "table.hpp"

namespace blossom::protocol {

const std::vector<Operation>& operations() {
    static const std::vector<Operation> table = [] {
#define BLOSSOM_ENTRY(name) name##_operation(),
        std::vector<Operation> all{BLOSSOM_OPERATIONS(BLOSSOM_ENTRY)};
#undef BLOSSOM_ENTRY
        for (Operation& operation : all)
            operation.options = completed(std::move(operation.options), operation.request);
        return all;
    }();
    return table;
}

}  // namespace blossom::protocol
