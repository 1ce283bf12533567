#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/rational/error.hpp>

#include <string>
#include <utility>

namespace blossom {

namespace {

PointArray net(std::span<const Coordinates> points) {
    return within(Part::control_net, [&] { return PointArray(points); });
}

void require_complete(const NetShape& shape, std::size_t points) {
    if (points == shape.size()) return;
    throw Error(ErrorCode::incomplete_net,
                "the control net has " + std::to_string(points) + " points; its shape needs " +
                    std::to_string(shape.size()),
                Part::control_net);
}

}  // namespace

BezierPatch::BezierPatch(NetShape shape, std::span<const Coordinates> control_net)
    : BezierPatch(std::move(shape), net(control_net)) {}

BezierPatch::BezierPatch(NetShape shape, PointArray control_net)
    : shape_(std::move(shape)), control_net_(std::move(control_net)) {
    require_complete(shape_, control_net_.size());
}

PatchArguments diagonal(const NetShape& shape, const PatchPoint& point) {
    PatchArguments arguments;
    for (std::size_t f = 0; f < shape.factors(); ++f) arguments.emplace_back(shape[f].degree, point.at(f));
    return arguments;
}

}  // namespace blossom
