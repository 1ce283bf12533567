#pragma once

#include "formats.hpp"

/// The formats of the table in `formats.cpp`, each in a file of its own.

namespace blossom::protocol {

/// The object of `ts_bspline_save`: one curve, with all coordinates in one list.
extern const ForeignFormat tinyspline_format;
/// The object of geomdl's `export_json`: curves, surfaces or volumes.
extern const ForeignFormat geomdl_format;
/// The object of splinepy's `io.json.export`: splines in any number of directions.
extern const ForeignFormat splinepy_format;
/// A NURBS mesh of MFEM, a text: see `mfem.cpp`.
extern const ForeignFormat mfem_format;
/// The curves of FITPACK, as SciPy has them: see `fitpack.cpp`.
extern const ForeignFormat fitpack_format;
/// The data of an SVG path: see `svg_path.hpp`.
extern const ForeignFormat svg_format;

}  // namespace blossom::protocol
