#pragma once

// The class `Evaluation` and the definitions of its members.
#include "second_evaluation_class.hpp"
#include "second_evaluation_derivatives.hpp"
#include "second_evaluation_lines.hpp"
#include "second_evaluation_maps.hpp"
#include "second_evaluation_nets.hpp"
#include "second_evaluation_numbers.hpp"
#include "second_evaluation_points.hpp"
