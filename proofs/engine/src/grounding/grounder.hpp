#pragma once

#include <blossom/core/algebra/sparse_polynomial.hpp>
#include <blossom/proofs/ground.hpp>
#include <blossom/rational/error.hpp>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "language/kinds.hpp"

namespace blossom::proofs {

/// Throws `syntax` at an offset of the text.
[[noreturn]] inline void refuse(const std::string& message, std::size_t offset) {
    throw Error(ErrorCode::syntax, message, {}, offset);
}

using Set = std::vector<long long>;
struct Permutation {
    std::vector<long long> images;
};
/// The value of a name that runs over a range or a set.
using Bound = std::variant<long long, Set, std::vector<Set>, Permutation>;
/// A number, or an argument with coordinates and mass.
using Value = std::variant<NodeId, NodeArgument>;

/// Grounds the expressions of one block, whose kinds are known to match.
class Grounder {
public:
    explicit Grounder(const Limits& limits) : limits_(limits) {}

    /// Binds a name during its lifetime.
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
        std::optional<Value> hidden_variable_;
    };

    void bind(const std::string& name, Bound value) { bound_[name] = std::move(value); }
    /// Reads the declarations and infers all kinds. The names bound at this time are the parameters of the
    /// block, which abbreviations see wherever they are used.
    void begin(const Block& block);

    /// The lines `claim` and `refute` with kinds that do not match, by their numbers in the block.
    const std::map<const Statement*, Error>& unfit() const { return kinds_->unfit(); }
    void declare_map(const Statement& statement);
    void declare_polynomial(const Statement& statement);
    void declare_raised(const Statement& statement);
    Relation relation(const Statement& statement);

    long long integer(const Expression& e);
    /// first, ..., last. Errors: `limit_exceeded` for more than `expansion_terms`.
    Set interval(const Expression& first, const Expression& last);
    /// A degree, dimension, order or number of copies.
    std::size_t count(const Expression& e);

    GroundBlock& block() { return block_; }
    const Limits& limits() const { return limits_; }

private:
    using Bindings = std::map<std::string, Bound>;
    /// Variables of a `poly` or of `for all` during its lifetime. Abbreviations see them, so that known
    /// values of abbreviations are set aside; maps that are already declared do not.
    class Variables {
    public:
        explicit Variables(Grounder& grounder);
        Variables(const Variables&) = delete;
        Variables& operator=(const Variables&) = delete;
        Variables(Variables&&) = delete;
        Variables& operator=(Variables&&) = delete;
        ~Variables();

    private:
        Grounder& grounder_;
        std::map<std::string, Value> hidden_;
        std::map<std::string, Value> let_values_;
    };
    const Bound* bound(const std::string& name) const;
    NodeId scalar(const Expression& e);
    Value value(const Expression& e);
    Value name(const Expression& e);
    Value bound_variable(const Expression& name);
    std::size_t bound_symbol(const std::string& shown);
    Value variable(const std::string& full, const Declared* declared, std::size_t offset);
    Value let_value(const std::string& full, const Expression& e);
    bool binds(const Statement& clause, const std::vector<long long>& indices);
    bool is_abbreviated(const std::vector<const Statement*>& clauses, const Expression& e);
    Value without_clause(const std::string& full, const Expression& e);
    bool is_declared_member(const Declared& family, const Expression& e);
    Value call(const Expression& e);
    Value zero_of(const Kind& kind);
    Value sum_of(std::vector<Value> values, const Kind& kind);
    Value scaled(NodeId factor, const Value& value);
    Value sum(const Expression& e);
    Value product(const Expression& e);
    Value chosen(const Expression& e);
    NodeId power(const Expression& e);
    NodeId derivative(const Expression& e);
    NodeId bernstein(const Expression& e);
    NodeId determinant(const Expression& e);
    NodeId determinant(const std::vector<std::vector<NodeId>>& rows);
    NodeId bspline(const Expression& e);
    NodeId basis_function(const Expression& knots, long long j, long long degree, long long span, NodeId t,
                          std::size_t offset);

    NodeId application(const Expression& e);
    NodeId blossom(const Expression& e, Application result);
    NodeId value_of(const Expression& e, Application result);
    NodeId derivative_of(const Expression& e, Application result);
    NodeArgument place_of(const Expression& e, const GroundMap& map, std::size_t direction);
    NodeId push(Application application);
    NodeArgument argument(const Expression& e, std::size_t dimension);
    /// The argument in the coordinates of the map's frame, if it has one.
    NodeArgument placed(const NodeArgument& argument, const GroundMap& map);
    void add_arguments(const Expression& e, const GroundMap& map, std::size_t direction,
                       std::vector<NodeArgument>& arguments);

    std::vector<Value> over_range(const Expression& call);
    Set set_of(const Expression& e);
    Set base_set(const Expression& e);
    std::vector<Bound> elements_of(const Expression& e);
    std::vector<Bound> subsets(const Expression& e);
    std::vector<Bound> partitions(const Expression& e);
    std::vector<Bound> permutations(const Expression& e);
    bool holds(const Expression& comparison);
    const Permutation* permutation(const std::string& name) const;
    std::vector<Expression> run_members(const Expression& run);
    std::vector<long long> family_indices(const Expression& family);
    std::string full_name(const Expression& name);

    NodeId constant(Rational value);
    void spend(std::size_t steps, std::size_t offset);
    NodeId symbol_node(std::size_t number);
    std::size_t symbol(const std::string& key, Symbol symbol);
    NodeId polynomial_node(const SparsePolynomial& polynomial);
    NodeId add(std::vector<NodeId> operands);
    NodeId multiply(std::vector<NodeId> operands);
    NodeId divide(NodeId a, NodeId b, std::size_t offset);
    NodeId raise(NodeId base, std::size_t exponent, std::size_t offset);
    NodeId push(Node node, std::size_t offset = 0);
    const Rational* constant_value(NodeId id) const;
    /// Whether a mass is 1, after expansion if necessary.
    bool is_one(NodeId id) const;
    NodeArgument as_argument(const Value& value);

    void add_map(GroundMap map);
    std::vector<Direction> directions(const Statement& statement);
    void add_net(const Statement& statement, GroundMap& map);

    const Limits& limits_;
    GroundBlock block_;
    const Block* text_ = nullptr;
    std::optional<Names> names_;
    std::optional<Kinds> kinds_;
    Bindings bound_;
    Bindings parameters_;
    std::map<std::string, Value> variables_;  ///< by full names
    std::map<std::string, std::size_t> symbols_;
    std::map<std::string, std::size_t> maps_;
    std::map<std::string, Value> let_values_;
    std::set<std::string> open_lets_;
    std::map<Rational, NodeId> constants_;
    std::size_t depth_ = 0;
    std::size_t steps_ = 0;  ///< spent on grounding, limited by `expansion_work`
};

/// Limits the elements over which a sum runs; an error has the offset of the sum.
void require_elements(const Integer& elements, const Limits& limits, std::size_t offset);

}  // namespace blossom::proofs
