#include "net_fields.hpp"

namespace blossom::protocol {

void refuse_net(const std::string& message) { throw Error(ErrorCode::incomplete_net, message); }

std::vector<std::size_t> read_degrees_of_directions(Fields& fields, const Limits& limits) {
    std::vector<std::size_t> degrees = fields.required("degrees", [&](const Json& value) {
        return read_list(value, [&](const Json& degree) { return read_count(degree, limits); });
    });
    if (degrees.empty())
        throw Error(ErrorCode::wrong_arity, "a tensor product has at least one direction", Place{"degrees"});
    return degrees;
}

std::vector<std::size_t> counts_of_nested(const Json& net, std::size_t levels) {
    const Json::Array& elements = read_array(net);
    if (elements.empty()) refuse_net("a control net has at least one point");
    std::vector<std::size_t> counts{elements.size()};
    if (levels > 1) {
        within(std::size_t{0}, [&] {
            const std::vector<std::size_t> inner = counts_of_nested(elements.front(), levels - 1);
            counts.insert(counts.end(), inner.begin(), inner.end());
        });
    }
    return counts;
}

Json nested(std::span<const Json> values, std::span<const std::size_t> counts) {
    if (counts.empty()) return values.front();
    Json::Array elements;
    const std::size_t each = values.size() / counts.front();
    for (std::size_t i = 0; i < counts.front(); ++i) {
        elements.push_back(nested(values.subspan(i * each, each), counts.subspan(1)));
    }
    return elements;
}

}  // namespace blossom::protocol
