#include <blossom/core/patch/patch_agreement.hpp>
#include <blossom/core/patch/patch_subdivision.hpp>
#include <blossom/rational/error.hpp>

#include <numeric>
#include <string>

#include "blossom/compare_constructions.hpp"
#include "blossom/polarization.hpp"
#include "blossom/run_construction.hpp"
#include "maps/patch_kernel.hpp"

namespace blossom {

namespace {

const NetShape& shape_of(const PatchMap& map) {
    return std::visit([](const auto& patch) -> const NetShape& { return patch.shape(); }, map);
}

/// The first element as it is, and the others each plus or minus it: between the vertices of a simplex and
/// its first vertex with the edges from there.
std::vector<Coordinates> sheared_frame(std::size_t dimension, int sign) {
    std::vector<Coordinates> elements(dimension + 1, Coordinates(dimension + 1));
    elements[0][0] = 1;
    for (std::size_t k = 1; k <= dimension; ++k) {
        elements[k][0] = sign;
        elements[k][k] = 1;
    }
    return elements;
}

/// The net over another frame in every factor.
PointArray sheared(const NetShape& shape, const PointArray& polar, int sign, const Limits& limits) {
    BezierPatch net(shape, polar);
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        net = with_frame(net, f, sheared_frame(shape[f].dimension, sign), limits);
    }
    return net.control_net();
}

/// The first coordinate plus or minus the sum of the others.
template <class R>
TupleLists<R> sheared(TupleLists<R> arguments, int sign) {
    for (auto& list : arguments) {
        for (Tuple<R>& tuple : list) {
            for (std::size_t k = 1; k < tuple.size(); ++k) tuple[0] += R(sign) * tuple[k];
        }
    }
    return arguments;
}

template <class R>
std::vector<R> row_over(std::span<const Integer> row) {
    return {row.begin(), row.end()};
}

template <class R>
Quotients<R> by_symmetric_functions(const PatchMap& map, const TupleLists<R>& arguments,
                                    const Limits& limits) {
    const NetShape& shape = shape_of(map);
    const auto* polynomial = std::get_if<PolynomialPatch>(&map);
    const PointArray polar = polynomial
                                 ? polar_of(shape, polynomial->coefficients())
                                 : sheared(shape, std::get<BezierPatch>(map).control_net(), -1, limits);
    const TupleLists<R> tuples = polynomial ? arguments : sheared(arguments, 1);
    std::vector<std::vector<R>> functions;
    functions.reserve(shape.factors());
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        functions.push_back(constructions::times_linear_forms<R>(shape[f].dimension, 0, {R(1)}, tuples[f]));
    }
    Quotients<R> value{{}, polar.denominator()};
    for (const auto row : polar.rows()) {
        value.numerators.push_back(
            constructions::contracted(row_over<R>(row), std::span(std::as_const(functions))));
    }
    return value;
}

template <class R>
Quotients<R> by_polarization(const PatchMap& map, const TupleLists<R>& arguments) {
    const NetShape& shape = shape_of(map);
    const auto* polynomial = std::get_if<PolynomialPatch>(&map);
    const PointArray form =
        polynomial ? polynomial->coefficients() : form_of(shape, std::get<BezierPatch>(map).control_net());
    const auto value_at = [&](const std::vector<Tuple<R>>& tuples, const std::vector<std::size_t>&) {
        std::vector<std::vector<R>> monomials;
        monomials.reserve(shape.factors());
        for (std::size_t f = 0; f < shape.factors(); ++f) {
            monomials.push_back(constructions::monomials(tuples[f], shape[f].degree));
        }
        std::vector<R> values;
        for (const auto row : form.rows()) {
            values.push_back(
                constructions::contracted(row_over<R>(row), std::span(std::as_const(monomials))));
        }
        return values;
    };
    std::vector<constructions::Groups<Tuple<R>>> groups;
    Quotients<R> value{{}, form.denominator()};
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        groups.push_back(constructions::grouped(std::span<const Tuple<R>>(arguments[f])));
        value.denominator *= factorial(shape[f].degree);
    }
    value.numerators = constructions::polarized<R>(shape, groups, value_at);
    return value;
}

template <class R>
Quotients<R> by_casteljau(const PatchMap& map, const TupleLists<R>& arguments, const Limits& limits) {
    const NetShape& shape = shape_of(map);
    const auto* polynomial = std::get_if<PolynomialPatch>(&map);
    const PointArray net = polynomial ? sheared(shape, polar_of(shape, polynomial->coefficients()), 1, limits)
                                      : std::get<BezierPatch>(map).control_net();
    const TupleLists<R> tuples = polynomial ? sheared(arguments, -1) : arguments;
    Quotients<R> value{{}, net.denominator()};
    for (const auto row : net.rows()) {
        value.numerators.push_back(constructions::folded_to_value<R>(shape, row_over<R>(row), tuples));
    }
    return value;
}

template <class R>
Quotients<R> run(const PatchMap& map, const TupleLists<R>& arguments, Construction construction,
                 const Limits& limits) {
    switch (construction) {
        case Construction::symmetric:
            return by_symmetric_functions(map, arguments, limits);
        case Construction::polarization:
            return by_polarization(map, arguments);
        case Construction::regrouped_polarization:
        case Construction::casteljau:
            break;
    }
    return by_casteljau(map, arguments, limits);
}

const PointArray& numbers_of(const PatchMap& map) {
    if (const auto* polynomial = std::get_if<PolynomialPatch>(&map)) return polynomial->coefficients();
    return std::get<BezierPatch>(map).control_net();
}

std::size_t terms_of_polarization(const PatchArguments& arguments, std::size_t limit) {
    std::vector<std::size_t> multiplicities;
    for (const auto& list : arguments) {
        for (const auto& group : constructions::grouped(std::span<const Coordinates>(list))) {
            multiplicities.push_back(group.second);
        }
    }
    return polarization_terms(multiplicities, limit);
}

/// The term operations of polarization on distinct symbolic points: the value at a sum of N points of
/// dimension s has C(N s + n, n) terms.
Integer symbolic_work(const NetShape& shape) {
    Integer work = 1;
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        const auto [s, n] = shape[f];
        Integer own;
        for (std::size_t size = 0; size <= n; ++size) own += binomial(n, size) * binomial(size * s + n, n);
        work *= own;
    }
    return work;
}

TupleLists<SparsePolynomial> symbolic_points(const NetShape& shape, bool barycentric) {
    TupleLists<SparsePolynomial> arguments;
    std::size_t used = 0;
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        auto& list = arguments.emplace_back();
        for (std::size_t i = 0; i < shape[f].degree; ++i) {
            auto& tuple = list.emplace_back(1, SparsePolynomial(1));
            for (std::size_t k = 0; k < shape[f].dimension; ++k)
                tuple.push_back(SparsePolynomial::variable(used++));
        }
    }
    return barycentric ? sheared(std::move(arguments), -1) : arguments;
}

}  // namespace

Coordinates blossom_value(const PatchMap& map, const PatchArguments& arguments, Construction construction,
                          const Limits& limits) {
    const NetShape& shape = shape_of(map);
    require_arguments(shape, arguments);
    const std::size_t bits = bits_of(numbers_of(map));
    if (construction == Construction::regrouped_polarization) {
        throw Error(ErrorCode::wrong_kind,
                    "regrouped-polarization is a construction of curves; a patch has symmetric, polarization "
                    "and casteljau",
                    Part::construction);
    }
    if (construction == Construction::polarization) {
        require_within(terms_of_polarization(arguments, limits.polarization_terms), limits.polarization_terms,
                       "polarization_terms", "the number of terms of polarization, at least",
                       Part::arguments);
        const IntegerArguments integers = cleared_together(arguments, bits, limits);
        return reduced(by_polarization(map, integers.tuples), integers.denominator);
    }
    const IntegerArguments integers = cleared_one_by_one(arguments, bits, limits);
    return reduced(run(map, integers.tuples, construction, limits), integers.denominator);
}

Agreement<Coordinates> agreement(const PatchMap& map, const PatchArguments& arguments, const Limits& limits) {
    require_arguments(shape_of(map), arguments);
    const std::size_t terms = terms_of_polarization(arguments, limits.polarization_terms);
    const auto excess = [&](Construction construction) -> std::string {
        return construction == Construction::polarization ? polarization_excess(terms, limits) : "";
    };
    const auto value = [&](Construction construction) {
        return blossom_value(map, arguments, construction, limits);
    };
    return collected_agreement<Coordinates>(excess, value);
}

Agreement<std::vector<SparsePolynomial>> agreement_for_all_arguments(const PatchMap& map,
                                                                     const Limits& limits) {
    const NetShape& shape = shape_of(map);
    std::size_t terms = 1;
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        for (std::size_t i = 0; i < shape[f].degree && terms <= limits.expansion_terms; ++i) {
            terms *= shape[f].dimension + 1;
        }
    }
    require_within(terms, limits.expansion_terms, "expansion_terms",
                   "the number of terms of the blossom, at least");

    const TupleLists<SparsePolynomial> symbols =
        symbolic_points(shape, std::holds_alternative<BezierPatch>(map));
    return symbolic_agreement(symbolic_work(shape), limits, [&](Construction construction) {
        return run(map, symbols, construction, limits);
    });
}

}  // namespace blossom
