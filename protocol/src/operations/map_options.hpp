#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "operation.hpp"
#include "text/shapes.hpp"

/// How a command line becomes a request.

namespace blossom::protocol {

/// The command line cannot be made into a request.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// "1, vector:2, delta, pair:3:2" as a list of blossom arguments.
Json argument_list(std::string_view text);
/// Digits as a JSON integer; anything else as it stands, to be refused where it is read.
Json count(std::string_view text);
Json plain_text(std::string_view text);
/// Polynomials: several texts, or one with ';', are the coordinates of a point; one text is a number.
Json polynomial_texts(const std::vector<std::string>& values);

/// An option that writes one field of the request. It says what the field does unless it has a `help`.
Option field_option(std::string name, const std::string& field, std::string value,
                    Json (*read)(std::string_view text), std::string help = "");

/// The same with another reading for a request about a patch; `read_patch` may look at the map.
Option field_option(std::string name, const std::string& field, std::string value,
                    Json (*read)(std::string_view text),
                    Json (*read_patch)(std::string_view text, const Json& map), std::string help = "");

/// An option whose value is one of the words of the field.
Option word_option(std::string name, const std::string& field);

/// An option without value that makes one field of the request true.
Option flag_option(std::string name, const std::string& field);

/// The options that describe a map, and then `others`; of two of one name the one in `others` counts.
std::vector<Option> with_map_options(std::vector<Option> others);

/// A map as one argument: a map of the protocol or the output of another command, control points
/// "0,0; 1,2", an SVG path of one curve, or a polynomial.
Json curve_of_text(std::string_view text, const Limits& limits);
/// An option whose value is such a map; of a field with a list of maps, it may be repeated.
Option other_map_option(std::string name, const std::string& field);
Option other_maps_option(std::string name, const std::string& field);

/// --interval, which for control points of a Bezier curve says where those that are given live, and for other
/// maps where something is wanted.
Option own_interval_option(std::string help);

/// --degrees, which belongs to a polynomial in several variables, and says what is wanted of a patch that is
/// given whole.
Option wanted_degrees_option();

/// The parameter at which something is divided, for a patch "1/2,1/4", "1/2,-" with a number in some
/// directions, or "midpoints".
Json place_of_division(std::string_view text, const Json& map);

/// Whether the request is about a control polygon, not a polynomial.
bool has_control_points(const Json& request);
/// Whether it is about a map on a product of simplices or in several variables.
bool has_patch(const Json& request);
/// Whether the map of such a request is a tensor product, with one list of arguments per direction.
bool is_tensor(const Json& map);
/// The parameters of a patch, "0,0; 1/2,1".
Json patch_parameters(std::string_view text, const Json& map);
/// The arguments of its blossom: points "1,2; vector:0,1", of a tensor product a list per direction "1,2; 0".
Json patch_arguments(std::string_view text, const Json& map);
/// Whether its control points are those of a B-spline.
bool has_knots(const Json& request);

}  // namespace blossom::protocol
