#pragma once

#include <blossom/worked/document.hpp>

#include <string>

namespace blossom::worked {

/// The document with an index behind the names of its maps and blossoms, P1 and p1, so that several documents
/// can stand side by side.
Document renamed(Document document, const std::string& index);

}  // namespace blossom::worked
