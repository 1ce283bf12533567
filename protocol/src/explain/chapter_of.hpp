#pragma once

#include <blossom/rational/limits.hpp>
#include <blossom/worked/document.hpp>

#include <string>
#include <string_view>
#include <vector>

#include <blossom/protocol/json.hpp>

namespace blossom::protocol {

/// The chapter that works out a request, or of statements one for each claim. The request is answered first,
/// so that what is wrong with it is reported as for itself. Errors: those of the request; `unknown_op` for
/// one without chapter.
std::vector<worked::Document> chapters_of(const Json& request, const Limits& limits);

/// The operations for which there is one.
std::vector<std::string_view> chapter_names();
/// Whether there is one for the operation of this name.
bool has_chapter(std::string_view operation);

/// What is said where there is none.
std::string no_chapter(std::string_view operation);

}  // namespace blossom::protocol
