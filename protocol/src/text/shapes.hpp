#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <blossom/protocol/json.hpp>

/// Numbers and points as people write them and programs print them.

namespace blossom::protocol {

/// The text without the spaces and line ends around it.
std::string_view trimmed(std::string_view text);

/// The parts of `text` between separators, without the spaces around them; none for an empty text.
std::vector<std::string> split(std::string_view text, char separator);

/// A list of numbers or of points, whose numbers are texts.
///
/// Points are separated by ';' or stand in lines of their own, their coordinates by ',' or blanks; without
/// either there is a list of numbers, and points of one number each are numbers: "1, 2", "0,0; 1,2",
/// "0 0\n1 2", "0,0 1,2". A first line of names is left out, and so is a ';' at the end. "0*4" is the number
/// four times. Lists in brackets are those of JSON and Python, of numpy with blanks instead of commas, also
/// as array(...) and with numbers such as Fraction(1, 2), and "[0]*4 + [1]".
///
/// Errors: `syntax`, with the place in the text: brackets that do not match, a row that was left out in
/// printing, points that are not separated.
Json number_list(std::string_view text);

/// The same as a list of points, each a list: "0,0" has one.
Json tuple_list(std::string_view text);

}  // namespace blossom::protocol
