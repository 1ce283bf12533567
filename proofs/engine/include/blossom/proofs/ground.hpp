#pragma once

#include <blossom/proofs/syntax.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/limits.hpp>
#include <blossom/rational/rational.hpp>

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// A block for one choice of its integer parameters. Sums, indices, sets and abbreviations are resolved; an
/// identity between expressions in numbered symbols, with maps of given degrees, remains.

namespace blossom::proofs {

using NodeId = std::size_t;

/// The values of integer parameters, in order: those of the block, then those of the line.
using Parameters = std::vector<std::pair<std::string, long long>>;

enum class NodeKind { constant, symbol, sum, product, quotient, power, application, derivative };

/// A node of an expression. Its operands precede it in the list of nodes, so that nodes can be processed in
/// order.
struct Node {
    NodeKind kind = NodeKind::constant;
    Rational value;                ///< of a constant
    std::size_t index = 0;         ///< the number of the symbol or application, or the exponent
    std::vector<NodeId> operands;  ///< of sum, product, quotient, power, derivative
    std::size_t offset = 0;        ///< of a quotient: its position in the text
    std::size_t order = 0;         ///< of a derivative with respect to the symbol `index`
};

/// An argument of a map on an affine space: coordinates and a mass, which is 1 for points and 0 for vectors.
struct NodeArgument {
    std::vector<NodeId> coordinates;
    NodeId mass = 0;
};

/// A direction of a map: its formal degree, and the dimension of its affine space.
struct Direction {
    std::size_t degree = 0;
    std::size_t dimension = 1;

    friend bool operator==(const Direction&, const Direction&) = default;
};

/// The exponents of all monomials of a direction, of total degree at most `degree`: 0, 1, ..., degree in one
/// variable.
std::vector<std::vector<std::size_t>> monomials(const Direction& direction);
/// The exponents of products of monomials, one per direction, in the order of the coefficients of a map: the
/// last direction changes fastest.
std::vector<std::vector<std::size_t>> monomials(const std::vector<Direction>& directions);

/// A map: one coefficient for every product of monomials, one per direction; the last direction changes
/// fastest. The variables of a map that is given by its net are the barycentric coordinates of its frame, the
/// first of them in the place of the mass.
struct GroundMap {
    std::string name;
    std::vector<Direction> directions;
    std::vector<NodeId> coefficients;
    std::vector<NodeId> conditions;  ///< nodes that must not vanish, otherwise the map is undefined
    std::vector<std::vector<NodeId>>
        barycentric;  ///< of a net: the rows that map (x_1, ..., x_s, mass) to barycentric coordinates
};

/// p(...) at one argument per direction; p[...] at `degree` arguments per direction; or a derivative, which
/// is `scale` times the blossom at its arguments.
struct Application {
    enum class Form { value, blossom, derivative };
    std::size_t map = 0;
    Form form = Form::value;
    Rational scale = 1;
    /// of a derivative: the number of directions at the end of the arguments
    std::vector<std::size_t> orders;
    std::vector<NodeArgument> places;  ///< of a derivative: the points at which it is taken
    std::vector<std::vector<NodeArgument>> arguments;
    std::size_t offset = 0;
};

/// A variable: a number of the text, a coordinate, or a coefficient of a map. Bound variables, of a `poly` or
/// of `for all`, may have the same name as another variable.
struct Symbol {
    std::string name;
    bool is_coefficient = false;
    bool is_bound = false;
    bool is_control_point = false;  ///< of a map that is given by its net

    /// Whether values of a map are linear in the symbol.
    bool is_map_value() const { return is_coefficient || is_control_point; }
};

struct Relation {
    NodeId left = 0;
    NodeId right = 0;
    std::size_t statement = 0;  ///< the number of the line in the block
    std::size_t offset = 0;
    std::vector<std::size_t> quantified;  ///< symbols of a hypothesis that holds for all their values
    Parameters parameters;                ///< of the ranges in the line itself
    std::optional<Error> error;           ///< of a claim that has no meaning for these parameters
};

struct GroundBlock {
    Parameters parameters;
    std::vector<Node> nodes;
    std::vector<Symbol> symbols;
    std::vector<GroundMap> maps;
    std::vector<Application> applications;
    std::vector<Relation> assumptions;  ///< left != right
    std::vector<Relation> hypotheses;
    std::vector<Relation> claims;  ///< claims and refutations
};

/// The direct operands of a node; for an application, its arguments and coefficients.
std::vector<NodeId> operands_of(const GroundBlock& block, NodeId node);
/// The nodes from which `roots` are made, in order, including `roots`.
std::set<NodeId> nodes_below(const GroundBlock& block, std::vector<NodeId> roots);
/// The nodes that must not vanish for `roots` to be defined: every divisor in them, cancelled or not.
std::set<NodeId> divisors_below(const GroundBlock& block, const std::vector<NodeId>& roots);

/// Every choice of the integer parameters of a block, in order: the first parameter changes slowest.
/// Errors: `limit_exceeded` if there are more than `limits.expansion_terms` choices; those of the bounds.
std::vector<Parameters> parameter_choices(const Block& block, const Limits& limits);

/// The lines `claim` and `refute` with kinds that do not match, by their numbers in the block. Errors: those
/// of the declarations and of other lines.
std::set<std::size_t> unfit_claims(const Block& block, const Parameters& parameters, const Limits& limits);

/// The block for one choice. Cost: the size of the result. Errors, each with its offset: `syntax` for unknown
/// names and kinds that do not match; `wrong_arity`; `limit_exceeded`.
GroundBlock ground(const Block& block, const Parameters& parameters, const Limits& limits);

}  // namespace blossom::proofs
