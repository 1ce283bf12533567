#pragma once

#include <blossom/proofs/syntax.hpp>
#include <blossom/worked/formula.hpp>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace blossom::worked {

/// The expressions of a block of the identity language as formulas, with its parameters and indices as they
/// are.
class StatementFormulas {
public:
    explicit StatementFormulas(const proofs::Block& block) : block_(block) {}

    Formula operator()(const proofs::Expression& expression);
    /// Arguments, members and the like: a run t_1..t_n gives t_1, ..., t_n.
    std::vector<Formula> list(const std::vector<proofs::Expression>& expressions);
    /// n = 1, ..., 8
    Formula range(const proofs::Range& range);
    /// The map `name` at its variables.
    static Formula at_variables(const std::vector<std::string>& names);

private:
    /// What a name stands for that sum, prod or mean binds.
    enum class Bound { integer, set, partition, permutation };
    /// Where sum, prod and mean take their index from, and how many there are.
    struct Collection {
        Formula below;
        std::optional<Formula> above;
        Formula size;
        Bound member = Bound::integer;
    };

    std::vector<Formula> terms(const proofs::Expression& expression);
    std::vector<Formula> factors(const proofs::Expression& expression);
    Formula negative(const proofs::Expression& expression);
    Formula name(const proofs::Expression& expression);
    Formula call(const proofs::Expression& expression);
    Formula iterated(const proofs::Expression& expression);
    Collection collection(const proofs::Expression& expression);
    Collection members(const proofs::Expression& set, Formula index);
    Formula determinant(const proofs::Expression& expression);
    Formula bspline(const std::vector<proofs::Expression>& children);
    Formula value(const proofs::Expression& expression);
    Formula derivative(const proofs::Expression& expression);
    Formula blossom(const proofs::Expression& expression);
    Formula family(const proofs::Expression& expression);
    std::vector<Formula> entries(const proofs::Expression& expression);
    /// A set, or the set 1..n of an integer n.
    Formula set(const proofs::Expression& expression);
    bool is_set(const proofs::Expression& expression) const;
    /// Whether derivatives of the map are taken along vectors.
    bool takes_directions(std::string_view map) const;
    const proofs::Statement* clause(std::string_view name) const;

    const proofs::Block& block_;
    std::map<std::string, Bound, std::less<>> bound_;
};

}  // namespace blossom::worked
