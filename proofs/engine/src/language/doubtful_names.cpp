#include <blossom/proofs/doubtful_names.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "functions.hpp"
#include "names.hpp"

namespace blossom::proofs {

namespace {

/// Whether inserting, deleting or replacing one letter, or exchanging two adjacent ones, turns one name into
/// the other.
bool resembles(std::string_view a, std::string_view b) {
    if (a.size() > b.size()) std::swap(a, b);
    if (b.size() - a.size() > 1) return false;
    std::size_t same = 0;
    while (same < a.size() && a[same] == b[same]) ++same;
    a.remove_prefix(same);
    b.remove_prefix(same);
    if (a.size() < b.size()) return a == b.substr(1);
    if (a.empty()) return false;
    if (a.substr(1) == b.substr(1)) return true;
    return a.size() > 1 && a[0] == b[1] && a[1] == b[0] && a.substr(2) == b.substr(2);
}

/// The free names of a block and the places where they occur. A family counts as one name.
class FreeNames {
public:
    explicit FreeNames(const Block& block) : names_(block) {
        for (const Statement& statement : block.statements) read(statement);
    }

    struct Occurrences {
        std::size_t count = 0;
        std::size_t first = 0;
    };
    const std::map<std::string, Occurrences>& bare() const { return bare_; }
    const std::map<std::string, Occurrences>& families() const { return families_; }
    const std::set<std::string>& known() const { return known_; }

private:
    using Scope = std::vector<std::string>;

    void read(const Statement& statement) {
        Scope scope;
        for (const std::string& name : statement.names) known_.insert(name);
        if (statement.kind == StatementKind::polynomial)
            scope.assign(statement.names.begin() + 1, statement.names.end());
        if (statement.kind == StatementKind::let) {
            known_.insert(statement.sides[0].name);
            for (const Expression& index : statement.sides[0].children) {
                if (index.kind == ExpressionKind::name && index.children.empty()) scope.push_back(index.name);
            }
            read(statement.sides[1], scope);
            return;
        }
        const bool declares =
            statement.kind == StatementKind::point || statement.kind == StatementKind::vector ||
            statement.kind == StatementKind::frame || statement.kind == StatementKind::number;
        for (const Range& range : statement.ranges) {
            read(range.first, scope);
            read(range.last, scope);
            scope.push_back(range.name);
        }
        for (const Expression& name : statement.quantified) {
            scope.push_back(name.kind == ExpressionKind::run ? name.children[0].name : name.name);
        }
        for (const Expression& e : statement.expressions) {
            if (declares) {
                known_.insert(e.kind == ExpressionKind::run ? e.children[0].name : e.name);
            } else {
                read(e, scope);
            }
        }
        for (const Expression& e : statement.frame) read(e, scope);
        for (const Expression& e : statement.sides) read(e, scope);
    }

    void read(const Expression& e, Scope& scope) {
        if (e.kind == ExpressionKind::name) occur(e, scope);
        const std::size_t depth = scope.size();
        const bool binds =
            e.kind == ExpressionKind::family ||
            (e.kind == ExpressionKind::call && e.children.size() >= 3 &&
             (e.name == "sum" || e.name == "prod" || e.name == "mean" || e.name == "determinant"));
        if (e.kind == ExpressionKind::family) {
            for (const auto& group : e.groups) {
                for (const Expression& child : group) read(child, scope);
            }
            scope.push_back(e.name);
            read(e.children[0], scope);
        } else if (binds) {
            const std::size_t binders = e.name == "determinant" ? 2 : 1;
            for (std::size_t i = binders; i + 1 < e.children.size(); ++i) read(e.children[i], scope);
            for (std::size_t i = 0; i < binders; ++i) scope.push_back(e.children[i].name);
            read(e.children.back(), scope);
        } else {
            for (const Expression& child : e.children) read(child, scope);
            for (const auto& group : e.groups) {
                for (const Expression& child : group) read(child, scope);
            }
        }
        scope.resize(depth);
    }

    void occur(const Expression& name, const Scope& scope) {
        if (std::ranges::find(scope, name.name) != scope.end()) return;
        const bool bare = name.children.empty();
        if (bare ? names_.bare(name.name) || name.name == "delta"
                 : names_.family(name.name) || names_.clauses(name.name)) {
            return;
        }
        Occurrences& found = (bare ? bare_ : families_)[name.name];
        if (found.count++ == 0) found.first = name.offset;
    }

    Names names_;
    std::map<std::string, Occurrences> bare_;
    std::map<std::string, Occurrences> families_;
    std::set<std::string> known_;
};

}  // namespace

std::vector<Warning> doubtful_names(const Block& block) {
    if (block.strict) return {};
    constexpr std::size_t least_letters = 4;
    const FreeNames free(block);
    std::set<std::string> known = free.known();
    known.insert("delta");
    for (const Function& function : functions) known.insert(std::string(function.name));
    std::vector<Warning> warnings;
    const auto consider = [&](const std::string& name, const FreeNames::Occurrences& found) {
        const auto near = std::ranges::find_if(known, [&](const std::string& other) {
            return other != name && std::max(other.size(), name.size()) >= least_letters &&
                   resembles(name, other);
        });
        if (near != known.end()) {
            warnings.push_back(
                {found.first, quoted(name) +
                                  " is not declared and therefore stands for any number; did you mean " +
                                  quoted(*near) + "?"});
        } else if (found.count == 1) {
            warnings.push_back(
                {found.first, quoted(name) + " is not declared and occurs once; it stands for any number"});
        }
    };
    for (const auto& [name, found] : free.bare()) consider(name, found);
    for (const auto& [name, found] : free.families()) consider(name, found);
    std::ranges::sort(warnings, {}, &Warning::offset);
    return warnings;
}

}  // namespace blossom::proofs
