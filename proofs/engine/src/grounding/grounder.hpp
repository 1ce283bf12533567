#pragma once

#include <blossom/core/sparse_polynomial.hpp>
#include <blossom/proofs/ground.hpp>
#include <blossom/rational/error.hpp>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace blossom::proofs {

/// Throws the `syntax` error of what stands at `offset` of the text.
[[noreturn]] inline void refuse(const std::string& message, std::size_t offset) {
    throw Error(ErrorCode::syntax, message, "", offset);
}

using Set = std::vector<long long>;
using Bound = std::variant<long long, Set>;

/// Grounds the expressions of one block.
class Grounder {
public:
    explicit Grounder(const Limits& limits) : limits_(limits) {}

    void bind(const std::string& name, Bound value) { bound_[name] = std::move(value); }
    void unbind(const std::string& name) { bound_.erase(name); }
    const Bound* bound(const std::string& name) const;

    void declare_map(const Statement& statement);
    void declare_points(const Statement& statement);
    void declare_polynomial(const Statement& statement);
    void declare_raised(const Statement& statement);
    void declare_let(const Statement& statement);

    NodeId scalar(const Expression& e);
    long long integer(const Expression& e);
    /// first, ..., last. Errors: `limit_exceeded` for more than `expansion_terms`.
    Set interval(const Expression& first, const Expression& last);
    /// A degree, dimension, order or number of copies.
    std::size_t count(const Expression& e);
    /// The members of t_1..t_n, or the only name.
    std::vector<Expression> members(const Expression& name_or_run);
    std::size_t scalar_symbol(const Expression& name);
    /// What is bound now is what abbreviations see.
    void finish_parameters() { parameters_ = bound_; }

    GroundBlock& block() { return block_; }
    const Limits& limits() const { return limits_; }

private:
    /// A number, or an argument with coordinates and mass.
    using Value = std::variant<NodeId, NodeArgument>;
    /// Binds a name for as long as it lives.
    class Binding {
    public:
        Binding(Grounder& grounder, const std::string& name, Bound value);
        Binding(const Binding&) = delete;
        Binding& operator=(const Binding&) = delete;
        Binding(Binding&&) = delete;
        Binding& operator=(Binding&&) = delete;
        ~Binding();

    private:
        Grounder& grounder_;
        std::string name_;
        std::optional<Bound> hidden_;
    };
    struct Space {
        std::size_t dimension;
        int mass;
    };

    Value value(const Expression& e);
    Value name(const Expression& e);
    Value let_value(const std::string& name, const Expression& e);
    Value call(const Expression& e);
    Value sum_of(const Expression& e, std::vector<Value> values);
    Value scaled(NodeId factor, const Value& value);
    Value binary(const Expression& e);
    NodeId power(const Expression& e);
    NodeId application(const Expression& e);
    NodeId bernstein(const Expression& e);
    NodeArgument argument(const Expression& e, const Direction& direction);
    void add_arguments(const Expression& e, const Direction& direction, std::vector<NodeArgument>& arguments);

    std::vector<Value> over_range(const Expression& call);
    Set set_of(const Expression& e);
    std::vector<Bound> elements_of(const Expression& e);
    std::vector<Expression> run_members(const Expression& run);
    std::vector<long long> family_indices(const Expression& family);
    std::string full_name(const Expression& name);

    NodeId constant(Rational value);
    void spend(std::size_t steps, std::size_t offset);
    NodeId symbol_node(std::size_t number);
    std::size_t symbol(const std::string& name, bool coefficient);
    NodeId polynomial_node(const SparsePolynomial& polynomial);
    NodeId add(std::vector<NodeId> operands);
    NodeId multiply(std::vector<NodeId> operands);
    NodeId divide(NodeId a, NodeId b, std::size_t offset);
    NodeId raise(NodeId base, std::size_t exponent, std::size_t offset);
    NodeId push(Node node, std::size_t offset = 0);
    const Rational* constant_value(NodeId id) const;
    NodeArgument lifted(const Value& value, const Direction& direction, std::size_t offset);
    NodeArgument as_argument(const Value& value, std::size_t dimension);

    std::size_t map_named(const Expression& e) const;
    void add_map(GroundMap map, std::size_t offset);
    void require_new(const std::string& name, std::size_t offset) const;
    std::vector<Direction> directions(const Statement& statement);

    const Limits& limits_;
    GroundBlock block_;
    std::map<std::string, Bound> bound_;
    std::map<std::string, Bound> parameters_;
    std::map<std::string, std::size_t> local_symbols_;  ///< variables of the polynomial being read
    std::map<std::string, std::size_t> symbols_;
    std::map<std::string, std::size_t> maps_;
    std::map<std::string, Space> spaces_;  ///< of points and vectors, by the name without indices
    std::map<std::string, std::vector<const Statement*>> lets_;
    std::map<std::string, Value> let_values_;
    std::set<std::string> open_lets_;
    std::map<Rational, NodeId> constants_;
    std::size_t depth_ = 0;
    std::size_t steps_ = 0;  ///< of grounding, against `expansion_work`
};

}  // namespace blossom::proofs
