#include "second_names.hpp"

#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <utility>

namespace blossom::proofs::second {

void NameTable::resolve(NodeId id) {
    switch (node(id).form) {
        case Form::name:
            return resolve_name(id);
        case Form::member:
            return resolve_member(id);
        case Form::sum:
        case Form::product:
        case Form::mean:
        case Form::family:
        case Form::determinant:
            return resolve_binder(id);
        case Form::map_value:
        case Form::map_derivative:
        case Form::blossom:
            return resolve_map_use(id);
        case Form::derivative:
            return resolve_derivative(id);
        default:
            return resolve_children(id);
    }
}

// By index: resolving a child adds no nodes, but may move the children in memory.
void NameTable::resolve_each_child(NodeId id) {
    std::size_t place = 0;
    while (place < node(id).children.size()) resolve(node(id).children[place++]);
}

void NameTable::resolve_children(NodeId id) {
    resolve_each_child(id);
    if (node(id).form != Form::basis) return;
    const FamilyName& family = families_[node(id).text];
    node(id).may_be_bound = bound_families_.contains(node(id).text);
    if (family.abbreviation) {
        node(id).meaning = Meaning::abbreviation;
        node(id).target = *family.abbreviation;
    } else if (family.own || family.inherited) {
        node(id).meaning = Meaning::declared;
        node(id).target = family.own ? *family.own : *family.inherited;
    } else {
        node(id).meaning = Meaning::free_number;
        if (!family.is_net && !node(id).may_be_bound) {
            undeclared(node(id).text, "the family " + quoted_name(node(id).text), node(id).offset);
        }
    }
}

void NameTable::resolve_name(NodeId id) {
    Node& name = node(id);
    for (std::size_t slot = locals_.size(); slot-- > 0;) {
        if (locals_[slot].name != name.text) continue;
        name.meaning = Meaning::local;
        name.target = static_cast<std::uint32_t>(slot);
        name.kind = locals_[slot].kind;
        return;
    }
    // Only a running name may hide the vector.
    if (reading_.names_[name.text] == "delta") {
        name.form = Form::unit_vector;
        return;
    }
    const auto known = bare_.find(name.text);
    if (known == bare_.end()) {
        name.meaning = Meaning::free_number;
        undeclared(name.text, quoted_name(name.text), name.offset);
        return;
    }
    name.meaning = known->second.meaning;
    name.target = known->second.target;
    if (name.meaning == Meaning::map) {
        throw Error(ErrorCode::wrong_kind,
                    quoted_name(name.text) + " is a map and has no value without arguments", {}, name.offset);
    }
}

void NameTable::resolve_member(NodeId id) {
    resolve_each_child(id);
    Node& member = node(id);
    member.may_be_bound = bound_families_.contains(member.text);
    const FamilyName& family = families_[member.text];
    if (family.abbreviation) {
        member.meaning = Meaning::abbreviation;
        member.target = *family.abbreviation;
    } else if (family.own || family.inherited) {
        member.meaning = Meaning::declared;
        member.target = family.own ? *family.own : *family.inherited;
    } else {
        member.meaning = Meaning::free_number;
        if (!family.is_net && !member.may_be_bound) {
            undeclared(member.text, "the family " + quoted_name(member.text), member.offset);
        }
    }
}

Kind NameTable::kind_of_members(NodeId domain) {
    const Node& set = node(domain);
    switch (set.form) {
        case Form::interval:
        case Form::without:
            return Kind::integer;
        case Form::subsets:
            return Kind::set;
        case Form::partitions:
            return Kind::set_of_sets;
        case Form::permutations:
            return Kind::permutation;
        default:
            break;
    }
    if (set.form == Form::name && set.meaning == Meaning::local) {
        if (set.kind == Kind::set) return Kind::integer;
        if (set.kind == Kind::set_of_sets) return Kind::set;
    }
    throw Error(ErrorCode::wrong_kind, "a set is expected here", {}, set.offset);
}

void NameTable::resolve_binder(NodeId id) {
    const Form form = node(id).form;
    const std::vector<NodeId> children = node(id).children;
    if (form == Form::determinant) {
        resolve(children[2]);
        node(id).slot = push(node(children[0]).text, Kind::integer);
        push(node(children[1]).text, Kind::integer);
        resolve(children[3]);
        locals_.resize(locals_.size() - 2);
        return;
    }
    resolve(children.front());
    const Kind kind = kind_of_members(children.front());
    if (form == Form::family && kind != Kind::integer) {
        throw Error(ErrorCode::wrong_kind, "a family runs through a set of integers", {},
                    node(children.front()).offset);
    }
    for (std::size_t i = 1; i + 1 < children.size(); ++i) resolve(children[i]);
    node(id).slot = push(node(id).text, kind);
    resolve(children.back());
    locals_.pop_back();
}

void NameTable::resolve_map_use(NodeId id) {
    const std::vector<NodeId> children = node(id).children;
    for (const NodeId child : children) resolve(child);
    for (std::size_t slot = locals_.size(); slot-- > 0;) {
        if (locals_[slot].name != node(id).text) continue;
        if (locals_[slot].kind != Kind::permutation || node(id).form != Form::map_value ||
            children.size() != 1) {
            throw Error(ErrorCode::wrong_kind, quoted_name(node(id).text) + " is no map", {},
                        node(id).offset);
        }
        node(id).form = Form::image;
        node(id).target = static_cast<std::uint32_t>(slot);
        return;
    }
    const auto known = bare_.find(node(id).text);
    if (known == bare_.end() || known->second.meaning != Meaning::map) {
        throw Error(ErrorCode::syntax, quoted_name(node(id).text) + " is no map", {}, node(id).offset);
    }
    if (reading_.maps_[known->second.target].line >= map_line_) {
        throw Error(ErrorCode::syntax, "the map " + quoted_name(node(id).text) + " is declared only below",
                    {}, node(id).offset);
    }
    node(id).meaning = Meaning::map;
    node(id).target = known->second.target;
}

void NameTable::resolve_derivative(NodeId id) {
    resolve_children(id);
    const Node& variable = node(node(id).children[1]);
    bool is_number = variable.meaning == Meaning::free_number || variable.may_be_bound;
    if (variable.meaning == Meaning::local) is_number = variable.kind == Kind::number;
    if (variable.meaning == Meaning::declared) {
        is_number = reading_.declarations_[variable.target].kind == Declaration::Kind::number;
    }
    // Whether a member is an abbreviation is known only with its indices.
    if (variable.meaning == Meaning::abbreviation) is_number = variable.form == Form::member;
    if (!is_number) {
        throw Error(ErrorCode::wrong_kind, "D differentiates with respect to a number", {}, variable.offset);
    }
}

}  // namespace blossom::proofs::second
