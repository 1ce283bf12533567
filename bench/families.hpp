#pragma once

#include "report.hpp"

/// One file each.
void measure_values(const Report& report);
void measure_constructions(const Report& report);
void measure_operations(const Report& report);
void measure_evaluation(const Report& report);
void measure_splines(const Report& report);
void measure_patches(const Report& report);
void measure_threads(const Report& report);
void measure_machine(const Report& report);
