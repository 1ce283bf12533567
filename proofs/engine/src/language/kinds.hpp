#pragma once

#include <blossom/proofs/syntax.hpp>
#include <blossom/rational/error.hpp>

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "names.hpp"

namespace blossom::proofs {

enum class KindName {
    unknown,       ///< of an abbreviation that refers only to itself
    integer,       ///< made of integers only, so that its value is known when a case is grounded
    number,        ///< a number that may depend on variables
    point,         ///< coordinates, with mass 1
    vector,        ///< coordinates, with mass 0
    pair,          ///< coordinates, with any mass
    set,           ///< of integers
    sets,          ///< a collection of sets of integers
    partitions,    ///< the value of partitions(n): collections of sets
    permutation,   ///< of 1..n
    permutations,  ///< the value of permutations(n)
};

/// The kind of the value of an expression.
struct Kind {
    KindName name = KindName::unknown;
    std::size_t dimension = 0;  ///< of a point, vector or pair

    bool is_number() const { return name == KindName::number || name == KindName::integer; }
    bool is_geometric() const {
        return name == KindName::point || name == KindName::vector || name == KindName::pair;
    }
    friend bool operator==(const Kind&, const Kind&) = default;
};

inline constexpr Kind integer_kind{KindName::integer, 0};
inline constexpr Kind number_kind{KindName::number, 0};

/// Throws `syntax`.
[[noreturn]] void refuse_kind(const std::string& message, std::size_t offset);

/// Checks that the two ends of a run t_1..t_n have the same name with indices, of which only the last
/// differs.
///
/// Error: `syntax` at the first name otherwise.
void check_run(const Expression& run);

/// "a vector of dimension 2"
std::string to_text(const Kind& kind);

/// The dimensions of the directions of a map.
using Dimensions = std::vector<std::size_t>;

/// The kinds of all expressions of a block for one choice of its parameters, inferred from the declarations
/// before anything is evaluated: a name has the kind with which it was declared, an abbreviation the common
/// kind of its clauses.
///
/// Errors, each with its offset: `syntax` for kinds that do not match, and in a strict block for undeclared
/// names; `wrong_arity`. Errors of a line `claim` or `refute` are kept for that line. Cost: the size of the
/// block, times the depth of abbreviations that use each other.
class Kinds {
public:
    /// `count` gives the value of a dimension.
    Kinds(const Block& block, const Names& names, std::function<std::size_t(const Expression&)> count);

    Kind of(const Expression& e) const;
    /// The errors of lines `claim` and `refute`, which do not affect other lines.
    const std::map<const Statement*, Error>& unfit() const { return unfit_; }
    /// The common kind of the clauses of an abbreviation with indices.
    Kind of_family(const std::string& name) const;

private:
    /// Names that hide others during its lifetime.
    class Scope {
    public:
        explicit Scope(Kinds& kinds) : kinds_(kinds) {}
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;
        Scope(Scope&&) = delete;
        Scope& operator=(Scope&&) = delete;
        ~Scope() {
            for (const auto& [name, is_family] : added_) kinds_.local(name, is_family).pop_back();
        }

        void add(const std::string& name, const Kind& kind, bool is_family = false) {
            kinds_.local(name, is_family).push_back(kind);
            added_.emplace_back(name, is_family);
        }

    private:
        Kinds& kinds_;
        std::vector<std::pair<std::string, bool>> added_;
    };
    std::vector<Kind>& local(const std::string& name, bool is_family) {
        return (is_family ? family_scope_ : scope_)[name];
    }

    void infer_abbreviations(const Block& block);
    Kind clause_kind(const Statement& clause);
    void check(const Statement& statement);
    void check_members(const Statement& statement);
    void check_polynomial(const Statement& statement);
    void check_relation(const Statement& statement);
    void add_map(const std::string& name, Dimensions dimensions) { maps_[name] = std::move(dimensions); }
    const Dimensions* map_named(const std::string& name) const;

    Kind infer(const Expression& e);
    Kind inferred(const Expression& e);
    Kind name(const Expression& e);
    Kind member(const Expression& e);
    Kind declared(const Declared& declared);
    Kind sum(const Expression& e);
    Kind sum(Kind a, Kind b, bool difference, std::size_t offset);
    Kind product(const Expression& e);
    Kind product(const Kind& a, const Kind& b, std::size_t offset);
    Kind quotient(const Kind& a, const Kind& b, std::size_t offset, std::size_t divisor_offset);
    Kind call(const Expression& e);
    Kind over(const Expression& e);
    Kind determinant(const Expression& e);
    Kind choice(const Expression& e);
    Kind bspline(const Expression& e);
    Kind element_of(const Expression& e);
    void comparison(const Expression& e);
    Kind value(const Expression& e);
    const Dimensions& required_map(const Expression& e) const;
    void orders(const Expression& e, const Dimensions& dimensions);
    Kind blossom(const Expression& e);
    Kind derivative(const Expression& e);
    void argument(const Expression& e, std::size_t dimension);
    void member_of_blossom(const Expression& e, std::size_t dimension);
    void family(const Expression& e, std::size_t dimension);

    void require_integer(const Expression& e);
    Kind require_number(const Expression& e);
    void require_set(const Expression& e);

    const Block& block_;
    const Names& names_;
    std::function<std::size_t(const Expression&)> count_;
    std::map<std::string, Dimensions> maps_;
    std::map<std::string, Kind> bare_lets_;
    std::map<std::string, Kind> family_lets_;
    std::map<std::string, std::vector<Kind>> scope_;  ///< of bare names that hide others, innermost last
    std::map<std::string, std::vector<Kind>> family_scope_;  ///< the same for families
    std::map<const Expression*, Kind> known_;
    std::map<const Statement*, Error> unfit_;
};

}  // namespace blossom::proofs
