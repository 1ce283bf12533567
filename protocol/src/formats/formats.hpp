#pragma once

#include <string_view>
#include <vector>

#include "floats.hpp"
#include "maps/map.hpp"

/// The files of other libraries.

namespace blossom::protocol {

/// The places of the numbers of a curve in the object that a library writes for it.
struct NumberPlaces {
    Place degree;
    Place knots;
    Place control_points;
    Place weights;
    bool rows = true;  ///< the control points are a list of points, not of all their coordinates
};

/// The file format of a library.
struct ForeignFormat {
    std::string_view name;
    /// Every curve of a document. Errors: those of its parts, with their place in the document.
    std::vector<Map> (*read)(const Json& document, Floats floats, const Limits& limits);
    /// A document with these B-splines. Errors: `wrong_kind` for what the format cannot represent;
    /// `overflow`.
    Json (*write)(const std::vector<Map>& splines);
    Place first_curve;  ///< in a document
    NumberPlaces numbers;
    Floats floats = Floats::binary64;  ///< what its numbers are, unless a request says it
    bool text = false;                 ///< a document may be a text that is no JSON
};

/// The place, in a document of one curve, of the number at `of_map` in the map that is read from it.
Place place_in_document(const ForeignFormat& format, const Place& of_map);

std::vector<std::string_view> format_names();
/// Whether a document of the format of that name may be a text that is no JSON.
bool may_be_text(const Json& format_name);
/// The format of that name. Errors: `wrong_kind`.
const ForeignFormat& read_format(const Json& name);

/// The curve as a bspline that every format can represent: a single polynomial becomes one segment, and a
/// polar knot vector gets the two knots that it lacks, equal to its ends unless they would occur too often.
/// Errors: `wrong_kind`.
Map as_textbook_spline(const Map& map, const Limits& limits);

}  // namespace blossom::protocol
