#pragma once

#include <blossom/proofs/syntax.hpp>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace blossom::proofs {

/// What a name of a block was declared as.
enum class Meaning { parameter, map, number, point, vector, frame, let };

/// One name of a block and the lines that declare it. Several lines may declare members of one family, and
/// several lines `let` give its clauses.
struct Declared {
    Meaning meaning = Meaning::number;
    std::vector<const Statement*> statements;
    std::vector<const Expression*>
        members;  ///< u_2, u_1..u_n if single members are declared; otherwise all are
};

/// The declarations of a block. The bare name x and the family x_i are different names.
///
/// Errors of the constructor, each with its offset: `syntax` for a name that is declared twice and for a word
/// of the language.
class Names {
public:
    explicit Names(const Block& block);

    /// The declaration of a name without indices, or nullptr.
    const Declared* bare(const std::string& name) const;
    /// The declaration of the members of a family other than by `let`: their own, or that of the bare name,
    /// which also declares them unless they have lines `let`.
    const Declared* family(const std::string& name) const;
    /// The clauses `let w_{...} = ...`, or nullptr.
    const std::vector<const Statement*>* clauses(const std::string& name) const;

private:
    void declare(const Statement& statement);
    void declare_bare(const std::string& name, Meaning meaning, const Statement& statement,
                      std::size_t offset);
    void declare_member(const Expression& name_or_run, Meaning meaning, const Statement& statement);
    void declare_let(const Statement& statement);
    bool fit_same_members(const std::vector<Expression>& a, const std::vector<Expression>& b) const;

    std::map<std::string, Declared> bare_;
    std::map<std::string, Declared> families_;
    std::map<std::string, std::vector<const Statement*>> clauses_;
};

/// Whether some clause with this many indices has a name among them. If so, a member that fits none is an
/// error.
bool has_open_index(const std::vector<const Statement*>& clauses, std::size_t indices);

/// Whether some clause may fit this member: it has the same number of indices, and no different integer among
/// them.
bool may_fit(const std::vector<const Statement*>& clauses, const Expression& member);

}  // namespace blossom::proofs
