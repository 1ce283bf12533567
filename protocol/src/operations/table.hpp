#pragma once

#include "operation.hpp"

/// The operations, one file each.

namespace blossom::protocol {

Operation agree_operation();
Operation audit_operation();
Operation barycentric_operation();
Operation basis_functions_operation();
Operation basis_matrix_operation();
Operation blossom_operation();
Operation bounds_operation();
Operation certify_operation();
Operation clamp_operation();
Operation compose_operation();
Operation continuity_operation();
Operation control_points_operation();
Operation convert_operation();
Operation derivative_operation();
Operation elevate_operation();
Operation evaluate_operation();
Operation exercise_operation();
Operation explain_operation();
Operation export_operation();
Operation extrema_operation();
Operation gcd_operation();
Operation graph_operation();
Operation import_operation();
Operation inflections_operation();
Operation insert_knots_operation();
Operation interpolate_operation();
Operation intersections_operation();
Operation inverse_formula_operation();
Operation jacobian_operation();
Operation join_operation();
Operation nearest_operation();
Operation normal_operation();
Operation periodic_operation();
Operation polar_operation();
Operation product_operation();
Operation prove_operation();
Operation quotient_operation();
Operation reduce_operation();
Operation remove_knot_operation();
Operation reparametrise_operation();
Operation restrict_operation();
Operation resultant_operation();
Operation reverse_operation();
Operation roots_operation();
Operation segments_operation();
Operation self_intersections_operation();
Operation subdivide_operation();
Operation sum_operation();
Operation transform_operation();
Operation trim_operation();

inline constexpr std::string_view explain_name = "explain";
inline constexpr std::string_view prove_name = "prove";

struct OperationEntry {
    std::string_view name;
    Operation (*describe)();
};

/// In the order of the help.
inline constexpr OperationEntry operation_table[] = {
    {"agree", agree_operation},
    {"blossom", blossom_operation},
    {"evaluate", evaluate_operation},
    {"derivative", derivative_operation},
    {"control-points", control_points_operation},
    {"convert", convert_operation},
    {"graph", graph_operation},
    {"subdivide", subdivide_operation},
    {"elevate", elevate_operation},
    {"reduce", reduce_operation},
    {"interpolate", interpolate_operation},
    {"inverse-formula", inverse_formula_operation},
    {"insert-knots", insert_knots_operation},
    {"remove-knot", remove_knot_operation},
    {"segments", segments_operation},
    {"join", join_operation},
    {"continuity", continuity_operation},
    {"clamp", clamp_operation},
    {"trim", trim_operation},
    {"reverse", reverse_operation},
    {"reparametrise", reparametrise_operation},
    {"periodic", periodic_operation},
    {"sum", sum_operation},
    {"product", product_operation},
    {"quotient", quotient_operation},
    {"transform", transform_operation},
    {"polar", polar_operation},
    {"restrict", restrict_operation},
    {"compose", compose_operation},
    {"jacobian", jacobian_operation},
    {"normal", normal_operation},
    {"bounds", bounds_operation},
    {"gcd", gcd_operation},
    {"resultant", resultant_operation},
    {"basis-functions", basis_functions_operation},
    {"basis-matrix", basis_matrix_operation},
    {"roots", roots_operation},
    {"extrema", extrema_operation},
    {"inflections", inflections_operation},
    {"nearest", nearest_operation},
    {"intersections", intersections_operation},
    {"self-intersections", self_intersections_operation},
    {prove_name, prove_operation},
    {"audit", audit_operation},
    {"import", import_operation},
    {"export", export_operation},
    {"certify", certify_operation},
    {explain_name, explain_operation},
    {"exercise", exercise_operation},
    {"barycentric", barycentric_operation},
};

}  // namespace blossom::protocol
