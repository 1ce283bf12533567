#include <blossom/rational/error.hpp>

namespace blossom {

std::string_view error_name(ErrorCode code) {
    switch (code) {
        case ErrorCode::syntax:
            return "syntax";
        case ErrorCode::inexact_number:
            return "inexact_number";
        case ErrorCode::not_a_number:
            return "not_a_number";
        case ErrorCode::zero_denominator:
            return "zero_denominator";
        case ErrorCode::division_by_zero:
            return "division_by_zero";
        case ErrorCode::inexact_division:
            return "inexact_division";
        case ErrorCode::overflow:
            return "overflow";
        case ErrorCode::missing_field:
            return "missing_field";
        case ErrorCode::unknown_field:
            return "unknown_field";
        case ErrorCode::unknown_op:
            return "unknown_op";
        case ErrorCode::wrong_kind:
            return "wrong_kind";
        case ErrorCode::wrong_arity:
            return "wrong_arity";
        case ErrorCode::empty_interval:
            return "empty_interval";
        case ErrorCode::degree_too_low:
            return "degree_too_low";
        case ErrorCode::bad_knots:
            return "bad_knots";
        case ErrorCode::outside_domain:
            return "outside_domain";
        case ErrorCode::not_adjacent:
            return "not_adjacent";
        case ErrorCode::not_continuous:
            return "not_continuous";
        case ErrorCode::mismatched_dimensions:
            return "mismatched_dimensions";
        case ErrorCode::incomplete_net:
            return "incomplete_net";
        case ErrorCode::degenerate_simplex:
            return "degenerate_simplex";
        case ErrorCode::not_affine:
            return "not_affine";
        case ErrorCode::different_spaces:
            return "different_spaces";
        case ErrorCode::zero_weight:
            return "zero_weight";
        case ErrorCode::missing_sample:
            return "missing_sample";
        case ErrorCode::limit_exceeded:
            return "limit_exceeded";
        case ErrorCode::internal:
            return "internal";
    }
    return "error";
}

}  // namespace blossom
