#include "statement_formulas.hpp"

#include <algorithm>

/// The functions of the identity language as formulas.

namespace blossom::worked {

using proofs::Expression;
using proofs::ExpressionKind;

namespace {

/// {1, ..., n}
Formula first_integers(Formula n) {
    if (n.kind == FormulaKind::number && n.value.sign() >= 0 && n.value <= Rational(3)) {
        std::vector<Formula> members;
        for (Rational i(1); i <= n.value; i += Rational(1)) members.push_back(number(i));
        return set_of(std::move(members));
    }
    return set_of({number(1), symbol("…"), std::move(n)});
}

/// How many integers lie from `low` to `high`.
Formula count_of(const Formula& low, const Formula& high) {
    if (low == number(1)) return high;
    std::vector<Formula> terms = high.kind == FormulaKind::sum ? high.parts : std::vector{high};
    Rational constant(1);
    if (low.kind == FormulaKind::number) constant -= low.value;
    if (terms.back().kind == FormulaKind::number) {
        constant += terms.back().value;
        terms.pop_back();
    }
    if (low.kind != FormulaKind::number) terms.push_back(product({number(-1), low}));
    if (!constant.is_zero() || terms.empty()) terms.push_back(number(constant));
    return sum(std::move(terms));
}

bool is_call(const Expression& e, std::string_view name) {
    return e.kind == ExpressionKind::call && e.name == name;
}

}  // namespace

Formula StatementFormulas::call(const Expression& e) {
    const std::vector<Expression>& children = e.children;
    if (e.name == "sum" || e.name == "prod" || e.name == "mean") return iterated(e);
    if (e.name == "determinant") return determinant(e);
    if (e.name == "bspline") return bspline(children);
    if (e.name == "if") return cases_of((*this)(children[1]), (*this)(children[0]), (*this)(children[2]));
    if (e.name == "without")
        return relation("∖", {first_integers((*this)(children[0])), (*this)(children[1])});
    if (e.name == "size") return size_of((*this)(children[0]));
    if (e.name == "partitions") return application(words("Part"), {set(children[0])});
    if (e.name == "permutations") return application(words("Perm"), {first_integers((*this)(children[0]))});
    std::vector<Formula> arguments = list(children);
    if (e.name == "binomial") return binomial_of(std::move(arguments[0]), std::move(arguments[1]));
    if (e.name == "factorial") return factorial_of(std::move(arguments[0]));
    if (e.name == "bernstein") {
        return application(power(index(symbol("B"), std::move(arguments[0])), std::move(arguments[1])),
                           {std::move(arguments[2])});
    }
    if (e.name == "sign") return application(words("sgn"), std::move(arguments));
    return worked::call(e.name, std::move(arguments));
}

bool StatementFormulas::is_set(const Expression& e) const {
    if (is_call(e, "without") || is_call(e, "partitions")) return true;
    if (e.kind != ExpressionKind::name) return false;
    if (e.children.empty()) {
        const auto found = bound_.find(e.name);
        if (found != bound_.end()) return found->second != Bound::integer;
    }
    const proofs::Statement* line = clause(e.name);
    return line && line->kind == proofs::StatementKind::let && is_call(line->sides[1], "without");
}

Formula StatementFormulas::set(const Expression& e) {
    Formula formula = (*this)(e);
    return is_set(e) ? formula : first_integers(std::move(formula));
}

Formula StatementFormulas::iterated(const Expression& e) {
    Collection from = collection(e);
    auto hidden = bound_.extract(e.children[0].name);
    bound_[e.children[0].name] = from.member;
    Formula body = (*this)(e.children.back());
    bound_.erase(e.children[0].name);
    if (hidden) bound_.insert(std::move(hidden));
    const std::string sign = e.name == "prod" ? "∏" : "∑";
    Formula all = summation(sign, std::move(from.below), std::move(from.above), std::move(body));
    if (e.name != "mean") return all;
    return product({fraction(number(1), std::move(from.size)), std::move(all)});
}

StatementFormulas::Collection StatementFormulas::collection(const Expression& e) {
    const Formula index = (*this)(e.children[0]);
    if (e.children.size() == 3) return members(e.children[1], index);
    Formula low = (*this)(e.children[1]);
    Formula high = (*this)(e.children[2]);
    Formula size = count_of(low, high);
    return {equation({index, std::move(low)}), std::move(high), std::move(size)};
}

StatementFormulas::Collection StatementFormulas::members(const Expression& e, Formula index) {
    if (is_call(e, "subsets")) {
        const Formula size = (*this)(e.children[1]);
        const Formula of = (*this)(e.children[0]);
        Formula below =
            list_of({relation("⊆", {index, set(e.children[0])}), equation({size_of(index), size})});
        return {
            std::move(below), {}, binomial_of(is_set(e.children[0]) ? size_of(of) : of, size), Bound::set};
    }
    Formula all = (*this)(e);
    Formula below = relation("∈", {std::move(index), all});
    if (is_call(e, "permutations"))
        return {std::move(below), {}, factorial_of((*this)(e.children[0])), Bound::permutation};
    const auto found = e.kind == ExpressionKind::name ? bound_.find(e.name) : bound_.end();
    const Bound member = is_call(e, "partitions")                                     ? Bound::partition
                         : found != bound_.end() && found->second == Bound::partition ? Bound::set
                                                                                      : Bound::integer;
    return {std::move(below), {}, size_of(std::move(all)), member};
}

Formula StatementFormulas::determinant(const Expression& e) {
    const Formula both = list_of({(*this)(e.children[0]), (*this)(e.children[1])});
    const Formula matrix = application(symbol("det"), {(*this)(e.children[3])});
    return power(index(matrix, equation({both, number(1)})), (*this)(e.children[2]));
}

/// The polynomial of a B-spline on the span that stands above it.
Formula StatementFormulas::bspline(const std::vector<Expression>& children) {
    const Formula span = (*this)(children[3]);
    const Formula knots = symbol(children[2].name);
    const Formula next =
        span.kind == FormulaKind::number ? number(span.value + Rational(1)) : sum({span, number(1)});
    return application(power(index(symbol("N"), list_of({(*this)(children[0]), (*this)(children[1])})),
                             interval_of(index(knots, span), index(knots, next))),
                       {(*this)(children[4])});
}

}  // namespace blossom::worked
