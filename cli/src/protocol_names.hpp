#pragma once

#include <blossom/protocol/answer.hpp>

/// The program uses the names of the protocol library without qualification.

namespace blossom::cli {

using namespace protocol;  // NOLINT(google-build-using-namespace): the same product

}  // namespace blossom::cli
