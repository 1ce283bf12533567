#pragma once

#include <pugixml.hpp>

#include "document/layout.hpp"

namespace blossom::worked {

/// Appends <math> with the layout to `parent`.
pugi::xml_node append_math(pugi::xml_node parent, const Layout& layout, bool display = false);

/// A document's markup without declaration, without added white space.
std::string markup_of(const pugi::xml_document& document);

}  // namespace blossom::worked
