#pragma once

#include "operation.hpp"

/// The only list of the operations, in the order of the help: each file NAME.cpp defines NAME_operation().
#define BLOSSOM_OPERATIONS(entry)                                                                         \
    entry(agree) entry(blossom) entry(evaluate) entry(derivative) entry(control_points) entry(convert)    \
        entry(graph) entry(subdivide) entry(elevate) entry(reduce) entry(inverse_formula)                 \
            entry(insert_knots) entry(remove_knot) entry(segments) entry(join) entry(continuity)          \
                entry(basis_functions) entry(roots) entry(prove) entry(audit) entry(import) entry(export) \
                    entry(certify) entry(explain) entry(exercise) entry(barycentric)

namespace blossom::protocol {

#define BLOSSOM_DECLARATION(name) Operation name##_operation();
BLOSSOM_OPERATIONS(BLOSSOM_DECLARATION)
#undef BLOSSOM_DECLARATION

}  // namespace blossom::protocol
