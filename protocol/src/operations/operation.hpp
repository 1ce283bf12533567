#pragma once

#include <blossom/rational/limits.hpp>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <blossom/protocol/json.hpp>
#include "answer.hpp"
#include "json/fields.hpp"
#include "maps/map.hpp"
#include "text/readable.hpp"

namespace blossom::protocol {

/// One option of a command: what it writes into the request.
struct Option {
    std::string name;   ///< "--at", or in capitals the name of a positional argument, which may be repeated
    Place field;        ///< what it writes
    std::string value;  ///< what to call its value in the help; alternatives as "a|b"; empty for a flag
    std::string help;
    std::function<void(Json& request, const std::vector<std::string>& values, const Limits& limits)> apply;
    bool repeated = false;  ///< it may be given several times
    bool files = false;  ///< its values name files, or folders of statements: the texts in them are applied
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
    std::string_view name;
    std::string_view summary;
    std::vector<std::string> example;  ///< the arguments of an example for the help, which runs it
    std::vector<Option> options;
    Answer (*answer)(Request& request, const Limits& limits);
    std::string (*render)(const Answered& answered);
    bool has_own_command = false;  ///< the command of this name does more and is made elsewhere
    std::string (*plot)(const Answered& answered) = nullptr;  ///< an SVG picture, where there is one
    std::string (*mesh)(const Answered& answered) = nullptr;  ///< of a patch: a mesh as an OBJ file
    bool explains = false;  ///< a command behind `explain`: its options write the request that is explained
};

/// All of them, in the order of the help.
const std::vector<Operation>& operations();

}  // namespace blossom::protocol
