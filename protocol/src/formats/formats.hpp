#pragma once

#include <string_view>
#include <vector>

#include "floats.hpp"
#include "foreign_spline.hpp"

/// The files of other libraries.

namespace blossom::protocol {

/// The file format of a library, which its own file defines and the table in `formats.cpp` lists.
struct ForeignFormat {
    std::string_view name;
    /// Every map of a document. Errors: those of its parts, with their place in the document.
    std::vector<ForeignSpline> (*read)(const Json& document, Floats floats, const Limits& limits);
    /// A document with these maps of the kind bspline, in the textbook convention, whose numbers are rounded.
    /// Errors: `wrong_kind`, `wrong_arity`, `mismatched_dimensions` for what the format cannot represent.
    Json (*write)(const std::vector<Map>& splines);
    Floats floats = Floats::binary64;  ///< what its numbers are, unless a request says it
    bool curves_only = false;          ///< it has no maps in several directions
    bool weights = false;              ///< whether it has a place for weights apart from the coordinates
    bool text = false;                 ///< a document may be a text that is no JSON
    bool pieces = false;               ///< it has no knots: a document has the segments of splines
};

std::vector<std::string_view> format_names();
/// Whether a document of the format of that name may be a text that is no JSON.
bool may_be_text(const Json& format_name);
/// The format of that name. Errors: `wrong_kind`.
const ForeignFormat& read_format(const Json& name);

/// The maps of a document, whose numbers are the decimals that are written where `floats` says so.
/// Errors: those of `ForeignFormat::read`.
std::vector<ForeignSpline> read_document(const ForeignFormat& format, const Json& document, Floats floats,
                                         const Limits& limits);

/// The map as a format can represent it: a bspline in the textbook convention. A map that is a single
/// polynomial becomes one segment, and a polar knot vector gets the two knots that it lacks, equal to its
/// ends unless they would occur too often. Where a format has no place for weights, points with their weight
/// count as points of one dimension more. Errors: `wrong_kind` for a map over a simplex or in barycentric
/// coordinates.
Map as_foreign_spline(const ForeignFormat& format, const Map& map, const Limits& limits);

}  // namespace blossom::protocol
