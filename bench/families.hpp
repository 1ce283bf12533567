#pragma once

#include "report.hpp"

/// One file each.
void measure_values(const Report& report);
void measure_constructions(const Report& report);
void measure_operations(const Report& report);
void measure_curves(const Report& report);
void measure_evaluation(const Report& report);
void measure_splines(const Report& report);
void measure_patches(const Report& report);
void measure_agreement(const Report& report);
void measure_threads(const Report& report);
void measure_machine(const Report& report);
/// A table in Markdown of times at several degrees, with the exponents; of one work alone, unless empty.
void measure_growth(const std::string& only);
