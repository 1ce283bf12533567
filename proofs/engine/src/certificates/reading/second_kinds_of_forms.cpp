#include "second_names.hpp"

#include <blossom/rational/error.hpp>

namespace blossom::proofs::second {

Kind NameTable::infer_other(const Node& other) {
    const std::vector<NodeId>& children = other.children;
    switch (other.form) {
        case Form::determinant:
            require_integers({children[2]});
            require(children[3], Kind::number, "an entry of a determinant");
            return Kind::number;
        case Form::size:
            require_set(children[0]);
            return Kind::integer;
        case Form::binomial:
        case Form::factorial:
            require_integers(children);
            return Kind::integer;
        case Form::bernstein:
            require_integers({children[0], children[1]});
            require(children[2], Kind::number, "the variable of a Bernstein polynomial");
            return Kind::number;
        case Form::basis:
            require_integers({children[0], children[1], children[2]});
            require(children[3], Kind::number, "the variable of a B-spline");
            if (check_ && infer_name(other) > Kind::number) {
                throw Error(ErrorCode::wrong_kind, "the knots of bspline are numbers", {}, other.offset);
            }
            return Kind::number;
        case Form::sign:
            require(children[0], Kind::permutation, "what has a sign");
            return Kind::integer;
        case Form::image:
            require_integers(children);
            return Kind::integer;
        case Form::comparison:
            require_integers(children);
            return Kind::condition;
        case Form::membership:
            require_integers({children[0]});
            require_set(children[1]);
            return Kind::condition;
        default:
            return infer_argument(other);
    }
}

Kind NameTable::infer_argument(const Node& other) {
    const std::vector<NodeId>& children = other.children;
    switch (other.form) {
        case Form::interval:
        case Form::partitions:
        case Form::permutations:
        case Form::subsets:
        case Form::without:
            return require_set(static_cast<NodeId>(&other - reading_.nodes_.data()));
        case Form::derivative:
            require(children[0], Kind::number, "what is differentiated");
            infer(children[1]);
            if (children.size() > 2) require_integers({children[2]});
            return Kind::number;
        case Form::copies:
            require_value(children[0]);
            require_integers({children[1]});
            return Kind::number;
        case Form::excluded:
            require_integers(children);
            return Kind::condition;
        case Form::excluded_set:
            require_set(children[0]);
            return Kind::condition;
        case Form::family:
            require_set(children.front());
            for (std::size_t i = 1; i + 1 < children.size(); ++i) infer(children[i]);
            require_value(children.back());
            return Kind::number;
        default:
            break;
    }
    for (const NodeId child : children) infer(child);
    return Kind::number;
}

Kind NameTable::require_set(NodeId id) {
    const std::vector<NodeId>& children = node(id).children;
    Kind kind = Kind::set;
    switch (node(id).form) {
        case Form::interval:
            require_integers(children);
            break;
        case Form::without:
            require_integers({children[0]});
            require_set(children[1]);
            break;
        case Form::subsets:
        case Form::partitions:
            kind = infer(children[0]);
            if (kind > Kind::possible_integer && kind != Kind::set && check_) {
                throw Error(ErrorCode::wrong_kind, "a number of members or a set is expected here", {},
                            node(children[0]).offset);
            }
            if (children.size() > 1) require_integers({children[1]});
            kind = Kind::set_of_sets;
            break;
        case Form::permutations:
            require_integers(children);
            kind = Kind::set_of_sets;
            break;
        default:
            kind = infer(id);
            if (kind != Kind::set && kind != Kind::set_of_sets && check_) {
                throw Error(ErrorCode::wrong_kind, "a set is expected here", {}, node(id).offset);
            }
    }
    node(id).kind = kind;
    return kind;
}

}  // namespace blossom::proofs::second
