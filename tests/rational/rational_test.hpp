#pragma once

// The includes that the tests of numbers share.

#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/number_text.hpp>
#include <blossom/rational/rational_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/failure.hpp"
#include "support/number_generators.hpp"
#include "support/number_printing.hpp"
#include "support/random.hpp"
#include "support/textbook_arithmetic.hpp"

using namespace blossom;
using namespace blossom::testing;
