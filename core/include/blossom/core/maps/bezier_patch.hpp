#pragma once

#include <blossom/core/constructions/net_shape.hpp>
#include <blossom/core/maps/point_array.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace blossom {

/// One argument per factor: s + 1 coordinates with respect to the vertices of the simplex. Their sum is the
/// mass, 1 for a point and 0 for a vector; any other sum is a homogeneous argument.
using PatchPoint = std::vector<Coordinates>;

/// The arguments of a blossom over a product of simplices: one list per factor, as long as its degree.
using PatchArguments = std::vector<std::vector<Coordinates>>;

/// A polynomial map on a product of simplices into Q^d by its control net: the value at barycentric
/// coordinates x is the sum over the net of the points times prod_f n_f! / (i_0! ... i_s!) x_f0^(i_0) ...
/// x_fs^(i_s).
///
/// Point i of the net is the blossom value with i_k copies of vertex k. The vertices themselves have no
/// coordinates here: arguments are barycentric, and `BarycentricFrame` computes them from points of Q^s.
/// Source: DeRose, section 5; Fernandez-Jambrina, section 2. Statements: derose-tensor-def,
/// derose-tri-points, fj-tri-def.
class BezierPatch {
public:
    /// Takes points in the order of `NetShape`. Errors: `incomplete_net` unless there are as many as the
    /// shape has; those of `PointArray`. The places are below `Part::control_net`.
    BezierPatch(NetShape shape, std::span<const Coordinates> control_net);
    BezierPatch(NetShape shape, PointArray control_net);

    const NetShape& shape() const { return shape_; }
    std::size_t dimension() const { return control_net_.dimension(); }
    const PointArray& control_net() const { return control_net_; }

    friend bool operator==(const BezierPatch&, const BezierPatch&) = default;
    /// "degree 1 on a simplex of dimension 2, control net (0), (1), (2)".
    friend std::string to_string(const BezierPatch& patch);
    friend std::size_t hash_value(const BezierPatch& patch) {
        return hash_of(patch.shape_, patch.control_net_);
    }

private:
    NetShape shape_;
    PointArray control_net_;
};

/// Errors: `wrong_arity` unless there is one list per factor, as long as its degree; `mismatched_dimensions`
/// unless each argument has s + 1 coordinates. The places are below `Part::arguments`.
void require_arguments(const NetShape& shape, const PatchArguments& arguments);

/// In each factor, as many copies of its argument as its degree.
PatchArguments diagonal(const NetShape& shape, const PatchPoint& point);

}  // namespace blossom
