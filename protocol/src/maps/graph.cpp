#include "graph.hpp"

#include <blossom/core/patch/patch_graph.hpp>

#include "dispatch_on_kind.hpp"

namespace blossom::protocol {

Map graph_of(const Map& map, const Limits& limits) {
    const GraphForm form = map.form.rational ? GraphForm::homogeneous : GraphForm::points;
    const auto of_curve = [&](const OnePolynomial auto& curve) -> AnyMap {
        const auto one = [&](const auto& single) -> AnyMap { return graph(single, form, limits); };
        return std::visit(one, polynomial_map(curve, limits));
    };
    const auto of_spline = [&](const BSplineCurve& curve) -> AnyMap { return graph(curve, form, limits); };
    const auto of_patch = [&](Patch patch) -> AnyMap {
        if (const auto* net = std::get_if<BezierPatch>(&patch.map)) {
            patch.map = graph(*net, patch.frames, form, limits);
        } else {
            patch.map = graph(std::get<PolynomialPatch>(patch.map), form, limits);
        }
        return patch;
    };
    const auto of_tensor = [&](const TensorBSpline& spline) -> AnyMap { return graph(spline, form, limits); };
    PointForm of_points = map.form;
    of_points.scalar = false;
    return {dispatch_on_kind<AnyMap>(map, Overloads{of_curve, of_spline, of_patch, of_tensor}, Place()),
            of_points, map.variable};
}

}  // namespace blossom::protocol
