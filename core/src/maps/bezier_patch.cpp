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

void require_arguments(const NetShape& shape, const PatchArguments& arguments) {
    const auto refuse = [](ErrorCode code, const std::string& what, std::size_t given, std::size_t needed,
                           const Place& place) {
        throw Error(code,
                    what + " must have length " + std::to_string(needed) + ", not " + std::to_string(given),
                    place);
    };
    if (arguments.size() != shape.factors()) {
        refuse(ErrorCode::wrong_arity, "the list of argument lists, one a factor,", arguments.size(),
               shape.factors(), Part::arguments);
    }
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        if (arguments[f].size() != shape[f].degree) {
            refuse(ErrorCode::wrong_arity, "the argument list of factor " + std::to_string(f),
                   arguments[f].size(), shape[f].degree, Part::arguments / f);
        }
        for (std::size_t i = 0; i < arguments[f].size(); ++i) {
            if (arguments[f][i].size() == shape[f].dimension + 1) continue;
            refuse(ErrorCode::mismatched_dimensions,
                   "argument " + std::to_string(i) + " of factor " + std::to_string(f),
                   arguments[f][i].size(), shape[f].dimension + 1, Part::arguments / f / i);
        }
    }
}

PatchArguments diagonal(const NetShape& shape, const PatchPoint& point) {
    PatchArguments arguments;
    for (std::size_t f = 0; f < shape.factors(); ++f) arguments.emplace_back(shape[f].degree, point.at(f));
    return arguments;
}

}  // namespace blossom
