#pragma once

#include <blossom/rational/limits.hpp>

#include <functional>
#include <ranges>
#include <string>
#include <string_view>
#include <vector>

#include <blossom/protocol/json.hpp>
#include "answer.hpp"
#include "description/members.hpp"
#include "json/fields.hpp"
#include "maps/map.hpp"
#include "text/readable.hpp"

namespace blossom::protocol {

/// One option of a command: what it writes into the request.
struct Option {
    std::string name;  ///< "--at", or in capitals the name of a positional argument, which may be repeated
    Place field;       ///< what it writes
    /// What to call its value in the help; empty for a flag. For a word without it these are its
    /// alternatives, "a|b".
    std::string value;
    std::string help;  ///< where it is empty, the documentation of the field counts
    std::function<void(Json& request, const std::vector<std::string>& values, const Limits& limits)> apply;
    bool repeated = false;  ///< it may be given several times
    bool files = false;   ///< its values name files, or folders of statements: the texts in them are applied
    bool of_map = false;  ///< it may write the field of the map that has this name instead
};

/// What a command shows to a person.
struct Answered {
    const Json& request;
    const Answer& answer;
    const Limits& limits;
    Style style;

    const Json& result() const { return answer.result; }
    /// Whether the request is about one map, and that map.
    bool has_given() const { return !answer.given.empty(); }
    const Map& given() const { return answer.given.front(); }
};

/// One operation of the protocol, and the command of the same name.
struct Operation {
    std::string_view name = {};  ///< as the table has it
    std::string_view summary;
    std::string_view documentation;  ///< one sentence
    Members request;                 ///< its fields besides those of every request
    Members result;
    std::vector<std::string> example;  ///< the arguments of an example for the help, which runs it
    std::vector<Option> options;
    Answer (*answer)(Request& request, const Limits& limits);
    std::string (*render)(const Answered& answered);
    bool has_own_command = false;  ///< the command of this name does more and is made elsewhere
    std::string (*plot)(const Answered& answered) = nullptr;  ///< an SVG picture, where there is one
    std::string (*mesh)(const Answered& answered) = nullptr;  ///< of a patch: a mesh as an OBJ file
    bool explains = false;  ///< a command behind `explain`: its options write the request that is explained
};

/// The options of fields with what their fields say: the alternatives of a word, and the help.
std::vector<Option> completed(std::vector<Option> options, const Members& request);

std::size_t operation_count();
/// An operation of the table, which is described when it is first asked for.
const Operation& operation_at(std::size_t index);
/// The operation of this name, or nullptr.
const Operation* operation_of(std::string_view name);

/// All of them, in the order of the help.
inline auto operations() {
    return std::views::iota(std::size_t{0}, operation_count()) | std::views::transform(operation_at);
}

}  // namespace blossom::protocol
