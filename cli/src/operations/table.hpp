#pragma once

#include "operations/operation.hpp"

namespace blossom::cli {

Operation agree_operation();
Operation blossom_operation();
Operation control_points_operation();
Operation derivative_operation();
Operation evaluate_operation();

}  // namespace blossom::cli
