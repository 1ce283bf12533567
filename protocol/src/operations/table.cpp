#include "table.hpp"

namespace blossom::protocol {

const std::vector<Operation>& operations() {
    static const std::vector<Operation> table{
        agree_operation(),       blossom_operation(),         evaluate_operation(),
        derivative_operation(),  control_points_operation(),  convert_operation(),
        graph_operation(),       subdivide_operation(),       elevate_operation(),
        reduce_operation(),      inverse_formula_operation(), insert_knots_operation(),
        remove_knot_operation(), segments_operation(),        join_operation(),
        continuity_operation(),  basis_functions_operation(), roots_operation(),
        prove_operation(),       audit_operation(),           import_operation(),
        export_operation(),      certify_operation(),         explain_operation(),
        exercise_operation(),    barycentric_operation(),
    };
    return table;
}

}  // namespace blossom::protocol
