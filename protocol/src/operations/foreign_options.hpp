#pragma once

#include <string>

#include "operation.hpp"

namespace blossom::protocol {

/// --format, for field "format".
Option format_option();
/// --document, for field "document".
Option document_option(std::string help);

}  // namespace blossom::protocol
