#pragma once

#include "report.hpp"

/// The families of measurements, one file each.
void measure_values(const Report& report);
void measure_constructions(const Report& report);
void measure_operations(const Report& report);
void measure_curves(const Report& report);
void measure_evaluation(const Report& report);
void measure_splines(const Report& report);
void measure_agreement(const Report& report);
void measure_patches(const Report& report);
void measure_threads(const Report& report);
void measure_machine(const Report& report);
/// A table in Markdown of times at several degrees and of exponents, for the operation `only`, or for all if
/// it is empty.
void measure_growth(const std::string& only);
