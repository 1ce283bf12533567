#include "table.hpp"

namespace blossom::protocol {

const std::vector<Operation>& operations() {
    static const std::vector<Operation> all = [] {
        std::vector<Operation> described;
        for (const auto describe : operation_table) {
            described.push_back(describe());
            described.back().options =
                completed(std::move(described.back().options), described.back().request);
        }
        return described;
    }();
    return all;
}

}  // namespace blossom::protocol
