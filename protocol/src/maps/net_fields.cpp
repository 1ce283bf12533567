#include "net_fields.hpp"

namespace blossom::protocol {

void refuse_net(const std::string& message) { throw Error(ErrorCode::incomplete_net, message); }

void NetPoints::add(const Json& value) {
    const bool scalar = !value.array();
    if (points_.empty()) scalar_ = scalar;
    Coordinates point = scalar ? Coordinates{read_number(value, limits_)} : read_numbers(value, limits_);
    if (scalar != scalar_ || point.empty() || (!points_.empty() && point.size() != points_.front().size())) {
        throw Error(ErrorCode::mismatched_dimensions,
                    "the point is not of the form of those before; all are numbers, or all are arrays of the "
                    "same length of at least 1");
    }
    points_.push_back(std::move(point));
}

void append_weight(Coordinates& point, const Rational& weight) {
    if (weight.is_zero()) {
        throw Error(ErrorCode::zero_weight,
                    "the weight is 0; with \"homogeneous\": true, points carry their weight and may have "
                    "weight 0");
    }
    for (Rational& coordinate : point) coordinate *= weight;
    point.push_back(weight);
}

void refuse_weights(const Fields& fields) {
    if (!fields.has("weights")) return;
    throw Error(ErrorCode::wrong_kind,
                R"(with "homogeneous": true the control points carry their weights; leave "weights" out)",
                Place{"weights"});
}

std::vector<std::size_t> read_degrees_of_directions(Fields& fields, const Limits& limits) {
    std::vector<std::size_t> degrees = fields.required("degrees", [&](const Json& value) {
        return read_list(value, [&](const Json& degree) { return read_count(degree, limits); });
    });
    if (degrees.empty())
        throw Error(ErrorCode::wrong_arity, "a tensor product has at least one direction", Place{"degrees"});
    return degrees;
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
