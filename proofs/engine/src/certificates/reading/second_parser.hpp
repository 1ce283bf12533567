#pragma once

#include "second_reading.hpp"
#include "second_text.hpp"

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace blossom::proofs::second {

/// Builds the tree of a block by recursive descent, without looking up names.
class Parser {
public:
    Parser(std::string_view block_text, Reading& reading);

    void parse_block();

private:
    // Tokens.
    const Token& next() const { return text_.tokens[place_]; }
    const Token& after(std::size_t count) const;
    bool is_mark(std::string_view mark) const;
    bool is_word(std::string_view word) const;
    bool take_mark(std::string_view mark);
    bool take_word(std::string_view word);
    void expect_mark(std::string_view mark);
    void expect_word(std::string_view word);
    std::uint32_t expect_name();
    [[noreturn]] void fail(const std::string& expected) const;

    std::uint32_t intern(std::string_view name);
    NodeId add(Form form, std::size_t offset, std::vector<NodeId> children = {});
    Node& node(NodeId id) { return reading_.nodes_[id]; }

    // Lines.
    void parse_line();
    void parse_parameter();
    void parse_map(std::size_t offset);
    void parse_net(MapDeclaration& map);
    void parse_declaration(Declaration::Kind kind, std::size_t offset);
    void parse_frame(std::size_t offset);
    void parse_polynomial(std::size_t offset);
    void parse_raise(std::size_t offset);
    void parse_abbreviation(std::size_t offset);
    void parse_statement(Statement::Kind kind, std::size_t offset);
    void parse_for_all(Statement& statement);
    Range parse_range_of(std::uint32_t name);
    std::vector<NodeId> parse_degrees();
    /// first_i..first_j or one member: the indices of both ends.
    std::pair<std::vector<NodeId>, std::vector<NodeId>> parse_member_run(std::uint32_t name);
    Abbreviation& abbreviation(std::uint32_t name, bool bare);

    // Expressions.
    NodeId parse_expression();
    NodeId parse_factors();
    NodeId parse_signed();
    NodeId parse_power();
    NodeId parse_operand();
    NodeId parse_bracket();
    NodeId parse_pair();
    NodeId parse_word();
    std::vector<NodeId> parse_indices();
    std::vector<NodeId> parse_list(std::string_view close);
    NodeId parse_call(std::string_view name, std::size_t offset);
    NodeId parse_iteration(Form form, std::size_t offset);
    NodeId parse_determinant(std::size_t offset);
    NodeId parse_basis(std::size_t offset);
    NodeId parse_choice(std::size_t offset);
    NodeId parse_condition();
    NodeId parse_derivative(std::size_t offset);
    NodeId parse_primes(std::uint32_t name, std::size_t offset);
    NodeId derivative_of_map(NodeId map, std::vector<NodeId> orders, std::size_t offset);
    NodeId parse_set();
    void require_count(const std::vector<NodeId>& found, std::size_t least, std::size_t most,
                       std::string_view what, std::size_t offset) const;

    // Arguments of blossoms.
    NodeId parse_blossom(std::uint32_t name, std::size_t offset);
    NodeId parse_argument();
    NodeId parse_family(NodeId expression);

    Reading& reading_;
    BlockText text_;
    std::size_t place_ = 0;
    std::size_t depth_ = 0;
    std::size_t line_ = 0;
    std::map<std::string, std::uint32_t, std::less<>> interned_;
};

}  // namespace blossom::proofs::second
