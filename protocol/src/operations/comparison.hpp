#pragma once

#include <blossom/rational/limits.hpp>
#include <blossom/rational/rational.hpp>

#include <cstddef>
#include <vector>

#include <blossom/protocol/json.hpp>

namespace blossom::protocol {

/// The result of a comparison, in the shape of the compared numbers.
struct Difference {
    Json error;  ///< computed - exact
    Json ulps;   ///< its size in units in the last place of the exact value
};

/// Whether a value is a list of pairs of an index, or exponents, and a number or point.
bool is_indexed(const Json& value);

/// Compares computed numbers with exact ones of the same shape, and counts the wrong ones.
class Comparison {
public:
    /// With `sparse`, an index that is missing in one list stands for a zero.
    Comparison(bool sparse, const Limits& limits) : sparse_(sparse), limits_(limits) {}

    /// Errors: those of `read_double`; `mismatched_dimensions` for values of another shape; `incomplete_net`;
    /// `overflow` for an exact number beyond the doubles; at their place in `computed`.
    Difference operator()(const Json& exact, const Json& computed);

    const Rational& greatest() const { return greatest_; }  ///< error in units in the last place
    std::size_t count() const { return count_; }
    std::size_t wrong() const { return wrong_; }  ///< numbers that are not the nearest double

private:
    Difference of_numbers(const Json& exact, const Json& computed);
    Difference of_elements(const Json& exact, const Json& computed);
    Difference of_members(const Json& exact, const Json& computed);
    /// The entries of both lists by index: first those of the exact list in its order, then the others.
    Difference of_entries(const Json& exact, const Json& computed);
    /// Where the computed list has the entry of each index of the exact one, or its size for none, and then
    /// the entries of other indices.
    std::vector<std::size_t> places_of_entries(const Json& exact, const Json::Array& found) const;
    std::vector<std::size_t> read_index_of(const Json& value) const;

    bool sparse_;
    const Limits& limits_;
    Rational greatest_;
    std::size_t wrong_ = 0;
    std::size_t count_ = 0;
};

}  // namespace blossom::protocol
