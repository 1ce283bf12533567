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

/// A block for one choice of its integer parameters: sums, indices, sets and abbreviations are gone, and what
/// remains is an identity between expressions in numbered symbols, with maps of given degrees.

namespace blossom::proofs {

using NodeId = std::size_t;

/// The values of integer parameters, in order: those of the block, then those of the line.
using Parameters = std::vector<std::pair<std::string, long long>>;

enum class NodeKind { constant, symbol, sum, product, quotient, power, application, derivative };

/// A node of an expression. Operands are nodes made before it, so that nodes may be worked through in order.
struct Node {
    NodeKind kind = NodeKind::constant;
    Rational value;                ///< of a constant
    std::size_t index = 0;         ///< number of the symbol or application, or the exponent
    std::vector<NodeId> operands;  ///< of sum, product, quotient, power, derivative
    std::size_t offset = 0;        ///< of a quotient: its place in the text
    std::size_t order = 0;         ///< of a derivative with respect to the symbol `index`
};

/// An argument of a map on an affine space: coordinates and a mass, 1 for points and 0 for vectors.
struct NodeArgument {
    std::vector<NodeId> coordinates;
    NodeId mass = 0;
};

/// A direction of a map: its formal degree, and the dimension of the affine space it lives on.
struct Direction {
    std::size_t degree = 0;
    std::size_t dimension = 1;

    friend bool operator==(const Direction&, const Direction&) = default;
};

/// The exponents of all monomials of a direction, those of total degree at most `degree`: 0, 1, ..., degree
/// in one variable.
std::vector<std::vector<std::size_t>> monomials(const Direction& direction);
/// The exponents of their products, in the order of the coefficients of a map: the last direction runs
/// fastest.
std::vector<std::vector<std::size_t>> monomials(const std::vector<Direction>& directions);

/// A map: for every product of monomials, with one monomial per direction, the coefficient; the last
/// direction runs fastest. A map that is given by its net has the barycentric coordinates of its frame as
/// variables, the first of them in the place of the mass.
struct GroundMap {
    std::string name;
    std::vector<Direction> directions;
    std::vector<NodeId> coefficients;
    std::vector<NodeId> conditions;  ///< what must not vanish for the map to be defined
    std::vector<std::vector<NodeId>>
        barycentric;  ///< of a net: the rows that take (x_1, ..., x_s, mass) there
};

/// p(...) at one argument per direction; p[...] at `degree` arguments per direction; or a derivative, which
/// is `scale` times the blossom of its arguments.
struct Application {
    enum class Form { value, blossom, derivative };
    std::size_t map = 0;
    Form form = Form::value;
    Rational scale = 1;
    std::vector<std::size_t> orders;   ///< of a derivative: how many of the last arguments are directions
    std::vector<NodeArgument> places;  ///< of a derivative: where it is taken
    std::vector<std::vector<NodeArgument>> arguments;
    std::size_t offset = 0;
};

/// A variable: a number of the text, a coordinate, or a coefficient of a map. Bound variables are those of a
/// `poly` and of `for all`, which may have the name of another one.
struct Symbol {
    std::string name;
    bool is_coefficient = false;
    bool is_bound = false;
    bool is_control_point = false;  ///< of a map that is given by its net

    /// Whether the values of a map are linear in it.
    bool is_map_value() const { return is_coefficient || is_control_point; }
};

struct Relation {
    NodeId left = 0;
    NodeId right = 0;
    std::size_t statement = 0;  ///< its number in the block
    std::size_t offset = 0;
    std::vector<std::size_t> quantified;  ///< symbols of a hypothesis that holds for all their values
    Parameters parameters;                ///< of the ranges in the line itself
    std::optional<Error> error;           ///< of a claim that means nothing for these parameters
};

struct GroundBlock {
    Parameters parameters;
    std::vector<Node> nodes;
    std::vector<Symbol> symbols;
    std::vector<GroundMap> maps;
    std::vector<Application> applications;
    std::vector<Relation> assumptions;  ///< left != right
    std::vector<Relation> hypotheses;
    std::vector<Relation> claims;  ///< and refutations
};

/// All nodes that a node is made of directly: its operands or, of an application, arguments and coefficients.
std::vector<NodeId> operands_of(const GroundBlock& block, NodeId node);
/// The nodes from which `roots` are made, in order, themselves included.
std::set<NodeId> nodes_below(const GroundBlock& block, std::vector<NodeId> roots);
/// What must not vanish for `roots` to be defined: every divisor from which they are made, cancelled or not.
std::set<NodeId> divisors_below(const GroundBlock& block, const std::vector<NodeId>& roots);

/// Every choice of the integer parameters of a block, in order: the first parameter varies slowest.
/// Errors: `limit_exceeded` beyond `limits.expansion_terms` of them; those of the bounds.
std::vector<Parameters> parameter_choices(const Block& block, const Limits& limits);

/// The lines `claim` and `refute`, by their numbers in the block, whose kinds do not fit. Errors: those of
/// the declarations and other lines.
std::set<std::size_t> unfit_claims(const Block& block, const Parameters& parameters, const Limits& limits);

/// The block at one choice. Cost: the size of the result. Errors, each with its offset: `syntax` for names
/// that are not known and what does not fit together; `wrong_arity`; `limit_exceeded`.
GroundBlock ground(const Block& block, const Parameters& parameters, const Limits& limits);

}  // namespace blossom::proofs
