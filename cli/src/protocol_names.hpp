#pragma once

#include <blossom/protocol/answer.hpp>

/// The program is the protocol library with options and streams around it, and uses its names as they are.

namespace blossom::cli {

using namespace protocol;  // NOLINT(google-build-using-namespace): the same product

}  // namespace blossom::cli
