#pragma once

#include <blossom/proofs/certificate.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "second_tree.hpp"

/// A second reader of the identity language, written only from its description. It shares no code with the
/// prover, so that a mistake in reading shows as a difference between their answers.
namespace blossom::proofs::second {

/// A range `for name in low..high`.
struct Range {
    std::uint32_t name = 0;
    NodeId low = 0;
    NodeId high = 0;
};

/// One name, or the members first..last of a family, that a `for all` binds.
struct Quantified {
    std::uint32_t name = 0;
    bool bare = true;
    std::vector<NodeId> first;  ///< the indices; empty for a bare name
    std::vector<NodeId> last;   ///< the same except for the last index
    Kind kind = Kind::number;
    std::optional<std::uint32_t> declaration;  ///< of its kind, if that is geometric
    std::uint32_t slot = 0;                    ///< of a bare name
};

struct Statement {
    enum class Kind { claim, refute, refute_some, given, assume } kind = Kind::claim;
    std::size_t offset = 0;
    NodeId left = 0;
    NodeId right = 0;
    std::vector<Range> ranges;  ///< their names have the slots 0, 1, ...
    std::vector<Quantified> for_all;
    std::uint32_t slots = 0;
};

/// A point, vector, number or frame: a bare name with its family, or members of a family.
struct Declaration {
    enum class Kind { number, point, vector, frame } kind = Kind::number;
    std::uint32_t name = 0;
    bool bare = true;
    std::size_t offset = 0;
    std::optional<NodeId> dimension;
    std::vector<std::pair<std::vector<NodeId>, std::vector<NodeId>>>
        runs;                              ///< of members: first and last indices
    std::vector<NodeId> other_dimensions;  ///< of later lines for the same family: all are equal
    std::size_t place = 0;                 ///< of a frame point: 0 is the origin
    std::size_t frame_size = 0;
};

struct MapDeclaration {
    enum class Kind { free, net, polynomial, raised } kind = Kind::free;
    std::uint32_t name = 0;
    std::size_t offset = 0;
    std::size_t line = 0;                  ///< maps are used below the line that declares them
    std::vector<NodeId> degrees;           ///< one per direction
    std::optional<NodeId> dimension;       ///< of a simplex
    NodeId body = 0;                       ///< of a polynomial; a point_list for a net
    std::vector<std::uint32_t> variables;  ///< names; they have the slots 0, 1, ...
    std::uint32_t slots = 0;
    std::uint32_t family = 0;  ///< the name of the family of a net
    /// a member of this family without indices, which determines what its name means
    NodeId control_points = 0;
    std::uint32_t source = 0;  ///< the map whose degree is raised
};

/// One line `let`. A pattern without a node is a name and has a slot, 0, 1, ... in order.
struct Clause {
    std::vector<std::optional<NodeId>> patterns;
    std::vector<std::uint32_t> pattern_names;  ///< the names of the patterns without a node, in order
    std::size_t offset = 0;
    NodeId body = 0;
    std::uint32_t slots = 0;
};

struct Abbreviation {
    std::uint32_t name = 0;
    bool bare = true;
    Kind kind = Kind::unknown;
    std::vector<Clause> clauses;
    std::optional<std::uint32_t> declaration;  ///< of members that fit no clause
    bool inherits = false;                     ///< whether this is the declaration of the bare name
};

/// A block as read: a tree with all names looked up and all kinds decided.
class Reading {
public:
    /// Errors: `syntax` and others with the offset in `block_text`; `limit_exceeded` beyond limits.nesting.
    explicit Reading(std::string_view block_text, const Limits& limits = {});

    /// All cases of all lines `claim` and `refute`, in order. Errors: `limit_exceeded` beyond limits.numbers.
    std::vector<Case> cases() const;

    const Limits& limits() const { return limits_; }
    bool strict() const { return strict_; }
    const Node& node(NodeId id) const { return nodes_[id]; }
    const std::string& name(std::uint32_t text) const { return names_[text]; }
    const std::vector<std::string>& names() const { return names_; }
    const std::vector<Range>& parameters() const { return parameters_; }
    const std::vector<Declaration>& declarations() const { return declarations_; }
    const std::vector<MapDeclaration>& maps() const { return maps_; }
    const std::vector<Abbreviation>& abbreviations() const { return abbreviations_; }
    const std::vector<Statement>& claims() const { return claims_; }  ///< claim, refute, refute some
    const std::vector<Statement>& hypotheses() const { return hypotheses_; }
    const std::vector<Statement>& assumptions() const { return assumptions_; }

    /// Whether a symbol such as "b.2" is a coefficient of an arbitrary map or a value of a control net.
    bool is_map_value(std::string_view symbol) const;

private:
    friend class Parser;
    friend class NameTable;

    Limits limits_;
    bool strict_ = false;
    std::vector<Node> nodes_;
    std::vector<std::string> names_;
    std::vector<Range> parameters_;
    std::vector<Declaration> declarations_;
    std::vector<MapDeclaration> maps_;
    std::vector<Abbreviation> abbreviations_;
    std::vector<Statement> claims_;
    std::vector<Statement> hypotheses_;
    std::vector<Statement> assumptions_;
};

}  // namespace blossom::proofs::second
