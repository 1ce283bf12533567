#pragma once

#include <blossom/protocol/json.hpp>

#include <string>
#include <string_view>
#include <vector>

/// What the protocol says of itself: for documents, bindings and the validation of requests.

namespace blossom::protocol {

/// A field of a request, or a member of a result.
struct FieldDescription {
    std::string name;
    std::string kind;                            ///< in words: "count", "list of numbers"
    std::vector<std::string_view> alternatives;  ///< the words that it may be, where it is a word
    bool required;                               ///< it is there in every request, or every result
    std::string documentation;
};

/// An operation, which a request names in its field "op".
struct OperationDescription {
    std::string name;
    std::string summary;        ///< what it does, in a few words
    std::string documentation;  ///< one sentence more
    std::vector<FieldDescription>
        fields;  ///< besides "op", and "id" and "numbers", which every request may have
    std::vector<FieldDescription> result;
};

/// All operations, in the order of the help.
const std::vector<OperationDescription>& operation_descriptions();

/// The JSON Schema (draft 2020-12) of requests and responses, which are its definitions "request" and
/// "response". For each operation NAME there are the definitions "NAME_request" and "NAME_result".
Json schema();

}  // namespace blossom::protocol
