#pragma once

#include "operation.hpp"

/// The operations, one file each.

namespace blossom::protocol {

Operation agree_operation();
Operation audit_operation();
Operation barycentric_operation();
Operation basis_functions_operation();
Operation blossom_operation();
Operation certify_operation();
Operation continuity_operation();
Operation control_points_operation();
Operation convert_operation();
Operation derivative_operation();
Operation elevate_operation();
Operation evaluate_operation();
Operation exercise_operation();
Operation explain_operation();
Operation export_operation();
Operation graph_operation();
Operation import_operation();
Operation insert_knots_operation();
Operation inverse_formula_operation();
Operation join_operation();
Operation prove_operation();
Operation reduce_operation();
Operation remove_knot_operation();
Operation roots_operation();
Operation segments_operation();
Operation subdivide_operation();

/// In the order of the help.
inline constexpr Operation (*operation_table[])() = {
    agree_operation,       blossom_operation,         evaluate_operation,
    derivative_operation,  control_points_operation,  convert_operation,
    graph_operation,       subdivide_operation,       elevate_operation,
    reduce_operation,      inverse_formula_operation, insert_knots_operation,
    remove_knot_operation, segments_operation,        join_operation,
    continuity_operation,  basis_functions_operation, roots_operation,
    prove_operation,       audit_operation,           import_operation,
    export_operation,      certify_operation,         explain_operation,
    exercise_operation,    barycentric_operation,
};

}  // namespace blossom::protocol
