#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <set>
#include <utility>

#include "grounder.hpp"

/// Names, the variables of `for all`, and abbreviations.

namespace blossom::proofs {

Value Grounder::name(const Expression& e) {
    const bool bare = e.children.empty();
    const std::string full = full_name(e);
    const auto taken = variables_.find(full);
    if (taken != variables_.end()) return taken->second;
    if (bare) {
        if (const Bound* value = bound(e.name)) {
            if (const long long* number = std::get_if<long long>(value)) return constant(*number);
            refuse(quoted(e.name) + " is a set, expected a number", e.offset);
        }
        if (e.name == "delta") return NodeArgument{{constant(1)}, constant(0)};
    }
    if (!names_)
        refuse(quoted(full) + " is not known here: a range has parameters of lines above and integers",
               e.offset);
    const Declared* declared = bare ? names_->bare(e.name) : names_->family(e.name);
    if (bare ? declared && declared->meaning == Meaning::let : names_->clauses(e.name) != nullptr)
        return let_value(full, e);
    if (!bare && text_->strict && !(declared && is_declared_member(*declared, e)))
        refuse(full + " is not declared; in a strict text every name is", e.offset);
    return variable(full, declared, e.offset);
}

/// A number, or the coordinates of a point or vector.
Value Grounder::variable(const std::string& full, const Declared* declared, std::size_t offset) {
    const bool geometric =
        declared && (declared->meaning == Meaning::point || declared->meaning == Meaning::vector ||
                     declared->meaning == Meaning::frame);
    if (!geometric) return symbol_node(symbol(full, {full}));
    const Statement& statement = *declared->statements.front();
    const std::size_t dimension = count(statement.dimension[0]);
    NodeArgument result{{}, constant(declared->meaning == Meaning::vector ? 0 : 1)};
    if (declared->meaning != Meaning::frame) {
        for (std::size_t i = 1; i <= dimension; ++i) {
            const std::string coordinate = full + "." + std::to_string(i);
            result.coordinates.push_back(symbol_node(symbol(coordinate, {coordinate})));
        }
        return result;
    }
    // The first point of a frame is the origin, the others are the unit points.
    std::size_t position = 0;
    while (statement.expressions[position].name != full) {
        if (++position == statement.expressions.size())
            refuse("the points of a frame have no indices", offset);
    }
    result.coordinates.assign(dimension, constant(0));
    if (position > 0) result.coordinates[position - 1] = constant(1);
    return result;
}

Grounder::Variables::Variables(Grounder& grounder)
    : grounder_(grounder),
      hidden_(grounder.variables_),
      let_values_(std::exchange(grounder.let_values_, {})) {}

Grounder::Variables::~Variables() {
    grounder_.variables_ = std::move(hidden_);
    grounder_.let_values_ = std::move(let_values_);
}

std::size_t Grounder::bound_symbol(const std::string& shown) {
    return symbol("bound " + shown + " " + std::to_string(block_.symbols.size()), {shown, false, true});
}

/// A variable of `for all`: a number, or the coordinates of a point or vector.
Value Grounder::bound_variable(const Expression& name) {
    const Declared* declared = name.children.empty() ? names_->bare(name.name) : names_->family(name.name);
    const std::string full = full_name(name);
    const bool geometric =
        declared && (declared->meaning == Meaning::point || declared->meaning == Meaning::vector);
    if (!geometric) return symbol_node(bound_symbol(full));
    NodeArgument result{{}, constant(declared->meaning == Meaning::vector ? 0 : 1)};
    const std::size_t dimension = count(declared->statements.front()->dimension[0]);
    for (std::size_t i = 1; i <= dimension; ++i)
        result.coordinates.push_back(symbol_node(bound_symbol(full + "." + std::to_string(i))));
    return result;
}

/// The two sides of a line.
Relation Grounder::relation(const Statement& statement) {
    std::optional<Variables> variables;
    if (!statement.quantified.empty()) variables.emplace(*this);
    Relation result;
    result.offset = statement.offset;
    std::set<std::string> taken;
    for (const Expression& quantified : statement.quantified) {
        const bool run = quantified.kind == ExpressionKind::run;
        for (const Expression& name : run ? run_members(quantified) : std::vector<Expression>{quantified}) {
            const std::string full = full_name(name);
            if (!taken.insert(full).second) refuse(full + " stands after \"for all\" twice", name.offset);
            const auto* clauses = name.children.empty() ? nullptr : names_->clauses(name.name);
            if (clauses && is_abbreviated(*clauses, name))
                refuse("\"for all\" takes variables; " + full + " is an abbreviation", name.offset);
            Value variable = bound_variable(name);
            const bool number = std::holds_alternative<NodeId>(variable);
            for (const NodeId id : number ? std::vector<NodeId>{std::get<NodeId>(variable)}
                                          : std::get<NodeArgument>(variable).coordinates) {
                result.quantified.push_back(block_.nodes[id].index);
            }
            variables_[full] = std::move(variable);
        }
    }
    result.left = scalar(statement.sides[0]);
    result.right = scalar(statement.sides[1]);
    return result;
}

/// Whether a line declares this member, by its indices or in a run.
bool Grounder::is_declared_member(const Declared& family, const Expression& e) {
    if (family.members.empty()) return true;
    const std::string full = full_name(e);
    return std::ranges::any_of(family.members, [&](const Expression* declared) {
        if (declared->kind != ExpressionKind::run) return full_name(*declared) == full;
        return std::ranges::any_of(run_members(*declared),
                                   [&](const Expression& member) { return full_name(member) == full; });
    });
}

/// The value of the first abbreviation whose indices fit. It is evaluated in the scope of its declaration: it
/// sees the parameters of the block and its own indices, but no names at the place of its use.
Value Grounder::let_value(const std::string& full, const Expression& e) {
    const auto known = let_values_.find(full);
    if (known != let_values_.end()) return known->second;
    if (!open_lets_.insert(full).second) refuse("the abbreviation " + full + " refers to itself", e.offset);
    std::vector<long long> indices;
    indices.reserve(e.children.size());
    for (const Expression& index : e.children) indices.push_back(integer(index));
    std::optional<Value> result;
    Bindings outer = std::exchange(bound_, parameters_);
    try {
        if (e.children.empty()) {
            result = value(names_->bare(e.name)->statements.front()->sides[1]);
        } else {
            for (const Statement* clause : *names_->clauses(e.name)) {
                bound_ = parameters_;
                if (!binds(*clause, indices)) continue;
                result = value(clause->sides[1]);
                break;
            }
        }
    } catch (...) {
        bound_ = std::move(outer);
        open_lets_.erase(full);
        throw;
    }
    bound_ = std::move(outer);
    open_lets_.erase(full);
    if (!result) result = without_clause(full, e);
    return let_values_[full] = *result;
}

/// Whether the clause fits the indices; binds the names among its patterns. A name fits any integer, unless
/// it is a parameter of the block; any other pattern fits its value.
bool Grounder::binds(const Statement& clause, const std::vector<long long>& indices) {
    const auto& patterns = clause.sides[0].children;
    if (patterns.size() != indices.size()) return false;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const Expression& pattern = patterns[i];
        const bool any =
            pattern.kind == ExpressionKind::name && pattern.children.empty() && !bound(pattern.name);
        if (any) {
            bound_[pattern.name] = indices[i];
        } else if (integer(pattern) != indices[i]) {
            return false;
        }
    }
    return true;
}

bool Grounder::is_abbreviated(const std::vector<const Statement*>& clauses, const Expression& e) {
    std::vector<long long> indices;
    indices.reserve(e.children.size());
    for (const Expression& index : e.children) indices.push_back(integer(index));
    const Bindings outer = bound_;
    const bool fits = std::ranges::any_of(clauses, [&](const Statement* clause) {
        bound_ = parameters_;
        return binds(*clause, indices);
    });
    bound_ = outer;
    return fits;
}

/// The value of a member that fits no clause: the declared number, point or vector of that name. An
/// undeclared member is a free number, or an error if a clause has a name as a pattern.
Value Grounder::without_clause(const std::string& full, const Expression& e) {
    const Declared* declared = names_->family(e.name);
    const std::vector<const Statement*>& clauses = *names_->clauses(e.name);
    if (!declared &&
        (has_open_index(clauses, e.children.size()) || kinds_->of_family(e.name).is_geometric())) {
        std::string reason;
        for (const Statement* clause : clauses) {
            for (const Expression& index : clause->sides[0].children) {
                const bool parameter = index.kind == ExpressionKind::name && index.children.empty() &&
                                       parameters_.contains(index.name);
                if (parameter)
                    reason =
                        "; " + index.name + " is a parameter of the block there, and stands for its value";
            }
        }
        refuse("no line \"let\" fits " + full + reason, e.offset);
    }
    if (text_->strict && !(declared && is_declared_member(*declared, e)))
        refuse(full + " is not declared, and no line \"let\" fits it", e.offset);
    return variable(full, declared, e.offset);
}

}  // namespace blossom::proofs
