#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include "functions.hpp"
#include "kinds.hpp"

/// The kinds of functions, values and blossoms.

namespace blossom::proofs {

namespace {

[[noreturn]] void wrong_arity(std::size_t found, const std::string& what, std::size_t offset) {
    throw Error(ErrorCode::wrong_arity, std::to_string(found) + " " + what, {}, offset);
}

const std::string& binder_name(const Expression& call, std::size_t i) {
    const Expression& binder = call.children[i];
    if (binder.kind != ExpressionKind::name || !binder.children.empty())
        refuse_kind("the first argument of " + call.name + " is the name that runs", binder.offset);
    return binder.name;
}

}  // namespace

Kind Kinds::call(const Expression& e) {
    const Function& function = *find_function(e.name);
    const auto& arguments = e.children;
    if (arguments.size() < function.least || arguments.size() > function.most)
        wrong_arity(arguments.size(), "arguments found, expected " + std::string(function.form), e.offset);
    if (e.name == "sum" || e.name == "prod" || e.name == "mean") return over(e);
    if (e.name == "determinant") return determinant(e);
    if (e.name == "if") return choice(e);
    if (e.name == "bspline") return bspline(e);
    if (e.name == "bernstein") {
        require_integer(arguments[0]);
        require_integer(arguments[1]);
        return require_number(arguments[2]);
    }
    if (e.name == "without") {
        require_integer(arguments[0]);
        require_set(arguments[1]);
        return {KindName::set, 0};
    }
    if (e.name == "subsets" || e.name == "partitions") {
        if (infer(arguments[0]).name != KindName::set) require_integer(arguments[0]);
        if (arguments.size() == 2) require_integer(arguments[1]);
        return {e.name == "subsets" ? KindName::sets : KindName::partitions, 0};
    }
    if (e.name == "size") {
        const Kind kind = infer(arguments[0]);
        if (kind.name != KindName::set && kind.name != KindName::sets)
            refuse_kind(to_text(kind) + " found, expected a set", arguments[0].offset);
    } else if (e.name == "sign") {
        const Kind kind = infer(arguments[0]);
        if (kind.name != KindName::permutation)
            refuse_kind(to_text(kind) + " found, expected a permutation", arguments[0].offset);
    } else {
        for (const Expression& argument : arguments) require_integer(argument);
        if (e.name == "permutations") return {KindName::permutations, 0};
    }
    return {KindName::integer, 0};
}

Kind Kinds::element_of(const Expression& e) {
    const Kind kind = infer(e);
    switch (kind.name) {
        case KindName::set:
            return {KindName::integer, 0};
        case KindName::sets:
            return {KindName::set, 0};
        case KindName::partitions:
            return {KindName::sets, 0};
        case KindName::permutations:
            return {KindName::permutation, 0};
        default:
            refuse_kind(to_text(kind) + " found, expected a set", e.offset);
    }
}

/// A sum of points is a pair, whose mass is the number of points; a mean of points is a point.
Kind Kinds::over(const Expression& e) {
    const std::string& binder = binder_name(e, 0);
    Kind element{KindName::integer, 0};
    if (e.children.size() == 4) {
        require_integer(e.children[1]);
        require_integer(e.children[2]);
    } else {
        element = element_of(e.children[1]);
    }
    Scope scope(*this);
    scope.add(binder, element);
    const Kind kind = infer(e.children.back());
    if (e.name == "prod" && kind.is_geometric())
        refuse_kind("points and vectors cannot be multiplied", e.children.back().offset);
    if (!kind.is_number() && !kind.is_geometric() && kind.name != KindName::unknown)
        refuse_kind(to_text(kind) + " found, expected a number, point, vector or pair",
                    e.children.back().offset);
    if (e.name == "sum" && kind.name == KindName::point) return {KindName::pair, kind.dimension};
    return kind;
}

Kind Kinds::determinant(const Expression& e) {
    require_integer(e.children[2]);
    if (binder_name(e, 0) == binder_name(e, 1))
        refuse_kind("rows and columns of a determinant have different names", e.children[1].offset);
    Scope scope(*this);
    for (const std::size_t i : {0U, 1U}) scope.add(binder_name(e, i), {KindName::integer, 0});
    return require_number(e.children[3]);
}

void Kinds::comparison(const Expression& e) {
    if (e.kind != ExpressionKind::comparison)
        refuse_kind("the first argument of if is a comparison of integers, such as i == j", e.offset);
    require_integer(e.children[0]);
    if (e.name == "in" || e.name == "not in") {
        require_set(e.children[1]);
    } else {
        require_integer(e.children[1]);
    }
}

Kind Kinds::choice(const Expression& e) {
    comparison(e.children[0]);
    const Kind a = infer(e.children[1]);
    const Kind b = infer(e.children[2]);
    if (a == b || b.name == KindName::unknown) return a;
    if (a.name == KindName::unknown) return b;
    if (a.is_number() && b.is_number()) return {KindName::number, 0};
    if (a.is_geometric() && b.is_geometric() && a.dimension == b.dimension)
        return {KindName::pair, a.dimension};
    refuse_kind("the two choices are " + to_text(a) + " and " + to_text(b), e.offset);
}

Kind Kinds::bspline(const Expression& e) {
    for (const std::size_t i : {0U, 1U, 3U}) require_integer(e.children[i]);
    const Expression& knots = e.children[2];
    if (knots.kind != ExpressionKind::name || !knots.children.empty())
        refuse_kind("the third argument of bspline is the name of the knots", knots.offset);
    Expression knot = knots;
    knot.children.push_back({ExpressionKind::number, knots.offset, "0", {}, {}});
    if (!member(knot).is_number()) refuse_kind("the knots of bspline are numbers", knots.offset);
    require_number(e.children[4]);
    return {KindName::number, 0};
}

const Dimensions& Kinds::required_map(const Expression& e) const {
    const auto local = scope_.find(e.name);
    if (local != scope_.end() && !local->second.empty())
        refuse_kind(quoted(e.name) + " is " + to_text(local->second.back()) + " here, not a map", e.offset);
    const Dimensions* dimensions = map_named(e.name);
    if (dimensions) return *dimensions;
    refuse_kind("there is no map or function " + quoted(e.name) + "; declare it, as in \"map " + e.name +
                    " degree n\"",
                e.offset);
}

/// The kind of a value of a map, or of the image of an integer under a permutation.
Kind Kinds::value(const Expression& e) {
    const auto& arguments = e.groups[0];
    const auto local = scope_.find(e.name);
    if (local != scope_.end() && !local->second.empty() &&
        local->second.back().name == KindName::permutation) {
        if (arguments.size() != 1 || !e.children.empty())
            wrong_arity(arguments.size(), "arguments found, a permutation takes one", e.offset);
        require_integer(arguments[0]);
        return {KindName::integer, 0};
    }
    const Dimensions* dimensions = &required_map(e);
    const bool coordinates = dimensions->size() == 1 && dimensions->front() > 1 &&
                             arguments.size() == dimensions->front() && infer(arguments[0]).is_number();
    if (!coordinates && arguments.size() != dimensions->size()) {
        wrong_arity(arguments.size(),
                    "arguments found, " + e.name + " expects " + std::to_string(dimensions->size()),
                    e.offset);
    }
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (coordinates) {
            require_number(arguments[i]);
        } else {
            argument(arguments[i], (*dimensions)[i]);
        }
    }
    orders(e, *dimensions);
    return {KindName::number, 0};
}

/// D(b, k)(t), D(f, i, j)(u, v), or the directions of D(q, d_1, d_2)(u).
void Kinds::orders(const Expression& e, const Dimensions& dimensions) {
    if (e.children.empty()) return;
    if (dimensions.size() == 1 && dimensions[0] > 1) {
        for (const Expression& direction : e.children) {
            const Kind kind = infer(direction);
            if (kind != Kind{KindName::vector, dimensions[0]}) {
                refuse_kind(to_text(kind) + " found, expected " +
                                to_text(Kind{KindName::vector, dimensions[0]}) +
                                ", the direction of a derivative",
                            direction.offset);
            }
        }
        return;
    }
    if (e.children.size() != dimensions.size()) {
        wrong_arity(
            e.children.size(),
            "orders of a derivative found, " + e.name + " expects " + std::to_string(dimensions.size()),
            e.offset);
    }
    for (const Expression& order : e.children) require_integer(order);
}

Kind Kinds::blossom(const Expression& e) {
    const Dimensions* dimensions = &required_map(e);
    if (e.groups.size() != dimensions->size()) {
        wrong_arity(
            e.groups.size(),
            "directions of arguments found, " + e.name + " expects " + std::to_string(dimensions->size()),
            e.offset);
    }
    for (std::size_t i = 0; i < e.groups.size(); ++i) {
        for (const Expression& given : e.groups[i]) member_of_blossom(given, (*dimensions)[i]);
    }
    return {KindName::number, 0};
}

void check_run(const Expression& run) {
    const Expression& first = run.children[0];
    const Expression& last = run.children[1];
    const bool fits = first.kind == ExpressionKind::name && last.kind == ExpressionKind::name &&
                      first.name == last.name && !first.children.empty() &&
                      first.children.size() == last.children.size() &&
                      std::equal(first.children.begin(), first.children.end() - 1, last.children.begin());
    if (!fits)
        refuse_kind("a run goes from a name with an index to the same name, as t_1..t_n", first.offset);
}

void Kinds::member_of_blossom(const Expression& e, std::size_t dimension) {
    switch (e.kind) {
        case ExpressionKind::copies:
            require_integer(e.children[1]);
            argument(e.children[0], dimension);
            break;
        case ExpressionKind::run:
            check_run(e);
            for (const Expression& end : e.children) argument(end, dimension);
            break;
        case ExpressionKind::family:
            family(e, dimension);
            break;
        default:
            argument(e, dimension);
    }
}

void Kinds::family(const Expression& e, std::size_t dimension) {
    if (e.groups[0].size() == 2) {
        for (const Expression& bound : e.groups[0]) require_integer(bound);
    } else {
        require_set(e.groups[0][0]);
    }
    for (const Expression& excluded : e.groups[1]) {
        if (excluded.kind == ExpressionKind::name && excluded.name == e.name && excluded.children.empty())
            refuse_kind("the index " + e.name + " of the family is compared with itself", excluded.offset);
        require_integer(excluded);
    }
    for (const Expression& set : e.groups[2]) require_set(set);
    Scope scope(*this);
    scope.add(e.name, {KindName::integer, 0});
    argument(e.children[0], dimension);
}

void Kinds::argument(const Expression& e, std::size_t dimension) {
    const Kind kind = infer(e);
    if (kind.name == KindName::unknown) return;
    const bool fits = kind.is_number() ? dimension == 1 : kind.is_geometric() && kind.dimension == dimension;
    if (fits) return;
    refuse_kind(to_text(kind) + " found, expected an argument of dimension " + std::to_string(dimension),
                e.offset);
}

Kind Kinds::derivative(const Expression& e) {
    require_number(e.children[0]);
    const Expression& variable = e.children[1];
    const bool bare = variable.kind == ExpressionKind::name && variable.children.empty();
    const Declared* known = bare ? names_.bare(variable.name) : nullptr;
    const bool local = bare && scope_.contains(variable.name) && !scope_.at(variable.name).empty();
    const bool is_variable =
        variable.kind == ExpressionKind::name && infer(variable).name == KindName::number &&
        (local || (bare ? !known || known->meaning == Meaning::number : !names_.clauses(variable.name)));
    if (!is_variable) refuse_kind("a derivative is taken with respect to a variable", variable.offset);
    if (e.children.size() == 3) require_integer(e.children[2]);
    return {KindName::number, 0};
}

}  // namespace blossom::proofs
