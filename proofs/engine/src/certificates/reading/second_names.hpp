#pragma once

#include "second_reading.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace blossom::proofs::second {

/// Looks up all names of a block, innermost binding first, and decides all kinds.
class NameTable {
public:
    explicit NameTable(Reading& reading) : reading_(reading) {}

    void resolve();

private:
    struct BareName {
        Meaning meaning = Meaning::unresolved;
        std::uint32_t target = 0;
    };
    struct FamilyName {
        std::optional<std::uint32_t> own;        ///< the declaration of members
        std::optional<std::uint32_t> inherited;  ///< the declaration of the bare name
        std::optional<std::uint32_t> abbreviation;
        bool is_net = false;
    };
    struct LocalName {
        std::uint32_t name;
        Kind kind;
    };

    Node& node(NodeId id) { return reading_.nodes_[id]; }
    std::string quoted_name(std::uint32_t name) const;

    // Declarations.
    void enter_names();
    void enter_bare(std::uint32_t name, Meaning meaning, std::size_t target, std::size_t offset);
    void enter_declarations();
    void enter_abbreviations();
    void merge_declaration(std::uint32_t later);

    // Looking up.
    void resolve_parameters();
    void resolve_maps();
    void resolve_clauses();
    void resolve_statement(Statement& statement);
    void resolve_quantified(Statement& statement, Quantified& quantified);
    void resolve(NodeId id);
    void resolve_each_child(NodeId id);
    void resolve_children(NodeId id);
    void resolve_name(NodeId id);
    void resolve_member(NodeId id);
    void resolve_binder(NodeId id);
    void resolve_map_use(NodeId id);
    void resolve_derivative(NodeId id);
    Kind kind_of_members(NodeId domain);
    std::uint32_t push(std::uint32_t name, Kind kind);
    void start_frame();
    /// Only the first `count` parameters may be used; all if there is no `count`.
    void undeclared(std::uint32_t name, const std::string& shown, std::size_t offset) const;

    // Kinds.
    void decide_kinds();
    bool improve_abbreviations();
    Kind infer(NodeId id);
    Kind kind_of_abbreviation(const Node& name) const;
    Kind kind_of_declaration(std::uint32_t declaration) const;
    Kind infer_terms(const Node& terms);
    Kind infer_factors(const Node& factors);
    Kind infer_power(const Node& power);
    Kind infer_choice(const Node& choice);
    Kind infer_iteration(const Node& iteration);
    Kind infer_name(const Node& name);
    Kind infer_other(const Node& other);
    Kind infer_argument(const Node& other);
    Kind require(NodeId id, Kind kind, const char* what);
    Kind require_value(NodeId id);
    Kind require_set(NodeId id);
    void require_integers(const std::vector<NodeId>& children);
    Kind join(Kind one, Kind other, std::size_t offset) const;

    Reading& reading_;
    std::map<std::uint32_t, BareName> bare_;
    std::map<std::uint32_t, FamilyName> families_;
    std::vector<LocalName> locals_;
    std::uint32_t most_locals_ = 0;
    std::set<std::uint32_t> bound_families_;
    /// maps of this line and of later lines may not be used
    std::size_t map_line_ = static_cast<std::size_t>(-1);
    bool check_ = false;  ///< whether kinds that do not match are errors
};

}  // namespace blossom::proofs::second
