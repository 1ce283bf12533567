#pragma once

#include <string>

#include "operation.hpp"

namespace blossom::protocol {

/// The library that wrote a file, and what it wrote.
Field format_field();
Field document_field();

/// --format, for field "format".
Option format_option();
/// --document, for field "document".
Option document_option(std::string help);

}  // namespace blossom::protocol
