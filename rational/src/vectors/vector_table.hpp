#pragma once

// All functions that use vector instructions, in one table per level of these.

#include "eight_sums.hpp"
#include "factor_products.hpp"
#include "fold_blocks.hpp"
#include "gcd_lanes.hpp"
#include "residue_batches.hpp"
#include "residue_lanes.hpp"
#include "taylor_lanes.hpp"

namespace blossom::vectors {

/// The functions of a level of vector instructions. A null pointer stands for a kernel that the level lacks;
/// callers then use another algorithm.
struct Table {
    const residues::Operations* residues;    ///< on every level
    const taylor_lanes::Operations* taylor;  ///< on every level
    const eight_sums::Operations* eight_sums;
    const eight_sums::WideOperations* eight_wide_sums;
    factor_products::Multiply factor_products;
    fold_blocks::Fold fold_blocks;
    const gcd_lanes::Operations* gcds;
    residues::IntegersOfResidues integers_of_residues;
};

/// The table of the highest level that this build, the processor and the environment variable
/// BLOSSOM_VECTOR_LEVEL allow: "ifma" (all), "avx2" or "portable"; without the variable all levels are
/// allowed.
/// Errors: `wrong_kind` if the variable has another value.
const Table& chosen_table();

/// The chosen table, which never changes while the program runs.
inline const Table& table() {
    static const Table& chosen = chosen_table();
    return chosen;
}

}  // namespace blossom::vectors
