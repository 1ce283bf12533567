#pragma once

// The includes that the tests of curves, splines and patches share.

#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/blossom/evaluation.hpp>
#include <blossom/core/blossom/inverse_formula.hpp>
#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/curve/derivative.hpp>
#include <blossom/core/curve/subdivision.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/de_boor.hpp>
#include <blossom/core/spline/knot_insertion.hpp>
#include <blossom/rational/combinatorics.hpp>

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
#include "support/every_construction.hpp"
#include "support/expanded_curve.hpp"
#include "support/failure.hpp"
#include "support/map_generators.hpp"
#include "support/map_printing.hpp"
#include "support/memory.hpp"
#include "support/number_generators.hpp"
#include "support/number_printing.hpp"
#include "support/patches.hpp"
#include "support/random.hpp"
#include "support/spline_generators.hpp"
#include "support/textbook_blossom.hpp"
#include "support/textbook_spline.hpp"

using namespace blossom;
using namespace blossom::testing;
