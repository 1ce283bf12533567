#pragma once

#include "certificates/reading/second_reading.hpp"

#include <blossom/rational/resource_budget.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace blossom::proofs::second {

using IntegerSet = std::vector<long long>;  ///< increasing; or the images of 1..n under a permutation

/// The value that a binder has bound: an integer (or the position of a value), a set, or a set of sets. Sets
/// must outlive the binder.
struct Slot {
    long long integer = 0;
    const IntegerSet* set = nullptr;
    const std::vector<IntegerSet>* sets = nullptr;
};
using Scope = std::vector<Slot>;

/// Calls a function at the end of a scope, also after an error.
template <class Function>
class AtEnd {
public:
    explicit AtEnd(Function function) : function_(std::move(function)) {}
    AtEnd(const AtEnd&) = delete;
    AtEnd& operator=(const AtEnd&) = delete;
    AtEnd(AtEnd&&) = delete;
    AtEnd& operator=(AtEnd&&) = delete;
    ~AtEnd() { function_(); }

private:
    Function function_;
};

/// Limits the work of an evaluation.
class WorkLimit {
public:
    explicit WorkLimit(const Limits& limits) : limits_(limits) {}

    void step(std::size_t count = 1) {
        steps_ += count;
        if (steps_ > limits_.expansion_work) exceeded("expansion_work", limits_.expansion_work);
        constexpr std::uint64_t words_of_step = 64;
        spend_work(words_of_step * count);
    }

    /// Counts one nested call during its lifetime.
    class Level {
    public:
        explicit Level(WorkLimit& work) : work_(work) {
            work.step();
            if (++work.depth_ > deepest * std::min(work.limits_.nesting, most_nesting)) {
                --work.depth_;
                exceeded("nesting", work.limits_.nesting);
            }
        }
        Level(const Level&) = delete;
        Level& operator=(const Level&) = delete;
        Level(Level&&) = delete;
        Level& operator=(Level&&) = delete;
        ~Level() { --work_.depth_; }

        static constexpr std::size_t most_nesting = 200;  ///< fits a stack of 8 MiB in every build

    private:
        static constexpr std::size_t deepest = 10;  ///< nested calls per bracket
        WorkLimit& work_;
    };

    /// Limits nested abbreviations, which need more of the stack than other calls.
    void require_few_abbreviations(std::size_t count) const {
        if (count > 2 * std::min(limits_.nesting, Level::most_nesting)) exceeded("nesting", limits_.nesting);
    }

    const Limits& limits() const { return limits_; }

private:
    [[noreturn]] static void exceeded(const char* name, std::size_t limit);

    Limits limits_;
    std::size_t steps_ = 0;
    std::size_t depth_ = 0;
};

/// The integers, sets and conditions of one case, for which no field is needed.
class Counting {
public:
    Counting(const Reading& reading, std::vector<long long> parameters);

    const std::vector<long long>& parameters() const { return parameters_; }
    void push_parameter(long long value);
    void pop_parameter();
    WorkLimit& work() { return work_; }

    /// The value of an expression of kind integer, which can have a denominator.
    Rational value(NodeId id, Scope& scope);
    /// The same, as an integer. Errors: `wrong_kind` if it is not an integer.
    long long integer(NodeId id, Scope& scope);
    /// The same, from 0 to `limit`.
    std::size_t count(NodeId id, Scope& scope, std::size_t limit, const char* what);
    std::vector<long long> integers(const std::vector<NodeId>& ids, Scope& scope);
    bool holds(NodeId condition, Scope& scope);
    IntegerSet set(NodeId id, Scope& scope);

    /// Calls `body` for every member of the domain, bound to the slot.
    void each(NodeId domain, std::uint32_t slot, Scope& scope, const std::function<void()>& body);
    /// The members over which a family of arguments ranges.
    IntegerSet family_members(const Node& family, Scope& scope);
    /// Calls `body` for every choice of the ranges, whose names have the slots 0, 1, ...
    void each_range(const std::vector<Range>& ranges, Scope& scope, const std::function<void()>& body);

    /// The first clause that fits, and its scope with the names of its patterns.
    const Clause* fitting_clause(std::uint32_t abbreviation, const std::vector<long long>& indices,
                                 Scope& scope);
    /// Whether a member that fits no clause is an error, because some pattern has a name.
    bool needs_clause(std::uint32_t abbreviation, std::size_t indices) const;
    /// Whether the lines of a declared family declare this member.
    bool is_declared(const Declaration& declaration, const std::vector<long long>& indices);

    std::size_t dimension(const Declaration& declaration);

private:
    Rational iteration(const Node& node, Scope& scope);
    Rational abbreviation(const Node& node, Scope& scope);
    Rational function(const Node& node, Scope& scope);
    void each_subset(const Node& subsets, std::uint32_t slot, Scope& scope,
                     const std::function<void()>& body);
    void each_partition(const Node& partitions, std::uint32_t slot, Scope& scope,
                        const std::function<void()>& body);
    void each_permutation(const Node& permutations, std::uint32_t slot, Scope& scope,
                          const std::function<void()>& body);
    void each_choice_of(const std::vector<Range>& ranges, std::size_t place, Scope& scope,
                        const std::function<void()>& body);
    /// 1..n, or the given set.
    IntegerSet ground_set(NodeId id, Scope& scope);

    const Reading& reading_;
    std::vector<long long> parameters_;
    WorkLimit work_;
    std::map<std::vector<long long>, Rational> known_;  ///< of abbreviations: family, indices
    std::set<std::vector<long long>> in_work_;
};

/// Errors: `limit_exceeded` if the product of two such numbers has too many digits.
void require_short_product(const Rational& a, const Rational& b, const Limits& limits);

/// base^exponent for any integer exponent. Errors: `division_by_zero`; `limit_exceeded` beyond limits.digits.
Rational integer_power(const Rational& base, const Rational& exponent, const Limits& limits,
                       std::size_t offset);

/// "t_3", "t_{-1}", "t_{1,2}".
std::string name_of_member(const std::string& family, const std::vector<long long>& indices);

}  // namespace blossom::proofs::second
