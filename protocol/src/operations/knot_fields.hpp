#pragma once

#include <blossom/core/maps/knot_vector.hpp>
#include <blossom/rational/limits.hpp>

#include <vector>

#include "description/members.hpp"
#include "json/fields.hpp"

/// The fields "degree", "knots" and "convention", which stand for a B-spline basis.

namespace blossom::protocol {

struct KnotFields {
    std::size_t degree = 0;
    std::vector<Rational> knots;
    bool polar = false;
};

KnotFields read_knot_fields(Fields& fields, const Limits& limits);

/// With the number of functions that belongs to the knots in their convention. Errors: `bad_knots`, at
/// "knots".
KnotVector knot_vector(KnotFields fields);

FieldList knot_members();

}  // namespace blossom::protocol
