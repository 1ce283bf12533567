#pragma once

#include <blossom/rational/rational.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace blossom::proofs::second {

/// The form of a node of the tree. Children are in the order of the text.
enum class Form : std::uint8_t {
    number,
    name,         ///< `text`; what it means is `meaning`, after the names were looked up
    member,       ///< `text`_{children}
    unit_vector,  ///< delta
    pair,         ///< <u, v>
    tuple,        ///< (a, b, ...)
    terms,        ///< a + b - c: children, subtracted if flagged
    factors,      ///< a * b / c: children, divisors if flagged
    negation,
    power,  ///< base, exponent
    sum,    ///< domain, body: binds `slot`
    product,
    mean,
    determinant,  ///< size, entry: binds `slot` and `slot + 1`
    size,
    binomial,
    factorial,
    bernstein,
    basis,           ///< bspline: children j, d, i, t; the family `text` has the knots
    sign,            ///< of a permutation
    image,           ///< P(i): children P, i
    choice,          ///< if: condition, value, other value
    comparison,      ///< of integers, by `relation`: two children
    membership,      ///< integer, set; `relation` is equal or different
    map_value,       ///< `text`(arguments)
    map_derivative,  ///< D(`text`, orders)(arguments); the first groups[0] children are orders
    blossom,         ///< `text`[arguments; arguments]
    point_list,      ///< of a net: arguments
    derivative,      ///< of an expression: expression, name, order
    interval,        ///< lo..hi
    without,
    subsets,
    partitions,
    permutations,
    copies,        ///< an argument repeated `count` times: expression, count
    run,           ///< a_1..a_n: two members
    family,        ///< e : i in S, ...: set, exclusions, e; binds `slot`
    excluded,      ///< i != e
    excluded_set,  ///< i not in S
};

/// The kind of a value, independent of its numbers.
enum class Kind : std::uint8_t {
    unknown,  ///< only of abbreviations that use nothing but themselves
    integer,
    possible_integer,  ///< a member of an abbreviation: an integer if a clause fits, otherwise a number
    number,
    geometric,  ///< a point, a vector or a pair: coordinates and a mass
    set,
    set_of_sets,
    permutation,
    condition,
};

constexpr bool is_number_kind(Kind kind) { return kind <= Kind::number; }

/// What a name means.
enum class Meaning : std::uint8_t {
    unresolved,
    local,  ///< bound by a sum, a range, a pattern, a `for all` or as a variable of `poly`: `target` is the
            ///< slot
    parameter,     ///< of the block: `target` is its number
    abbreviation,  ///< let: `target` is the family
    declared,      ///< by point, vector, frame or number: `target` is the declaration
    map,           ///< `target` is the map
    free_number,
};

enum class Relation : std::uint8_t { equal, different, less, less_or_equal, greater, greater_or_equal };

using NodeId = std::uint32_t;

struct Node {
    Form form = Form::number;
    Kind kind = Kind::unknown;
    Meaning meaning = Meaning::unresolved;
    Relation relation = Relation::equal;
    bool may_be_bound = false;  ///< a member that a `for all` of this line may bind
    std::uint32_t target = 0;
    std::uint32_t slot = 0;  ///< of what the node binds
    std::uint32_t text = 0;  ///< the number of the name in the reading
    std::size_t offset = 0;
    Rational value;
    std::vector<NodeId> children;
    std::vector<bool> flags;          ///< one per child
    std::vector<std::size_t> groups;  ///< the ends of the arguments of each direction in `children`
};

}  // namespace blossom::proofs::second
