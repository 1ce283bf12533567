#include <blossom/core/blossom/agreement.hpp>

#include <string>

#include "patch_constructions.hpp"
#include "polarization.hpp"
#include "run_construction.hpp"

namespace blossom {

namespace {

/// Runs the constructions; `excess(construction)` gives the reason not to run one, or "".
template <class Value, class Excess, class Run>
Agreement<Value> side_by_side(std::initializer_list<Construction> constructions, const Excess& excess,
                              const Run& run) {
    Agreement<Value> agreement;
    for (const Construction construction : constructions) {
        std::string reason = excess(construction);
        std::optional<Value> value;
        if (reason.empty()) value = run(construction);
        agreement.results.push_back({construction, std::move(value), std::move(reason)});
    }
    return agreement;
}

/// The three constructions; for a curve of degree n, regrouped polarization follows if polarization is too
/// expensive.
template <class Map, class Arguments>
Agreement<Coordinates> agreement_at(const Map& map, const Arguments& arguments, std::size_t terms,
                                    std::optional<std::size_t> n, const Limits& limits) {
    const auto excess = [&](Construction construction) -> std::string {
        const bool regrouped = construction == Construction::regrouped_polarization;
        if (construction == Construction::polarization && terms > limits.polarization_terms) {
            return "more terms than the limit polarization_terms = " +
                   std::to_string(limits.polarization_terms);
        }
        if (!regrouped || regrouping_work(*n, limits.regrouping_work) <= limits.regrouping_work) return "";
        return "more multiply-adds than the limit regrouping_work = " +
               std::to_string(limits.regrouping_work);
    };
    const auto run = [&](Construction construction) {
        return blossom_value(map, arguments, construction, limits);
    };
    using enum Construction;
    if (!n || terms <= limits.polarization_terms)
        return side_by_side<Coordinates>({symmetric, polarization, casteljau}, excess, run);
    return side_by_side<Coordinates>({symmetric, polarization, regrouped_polarization, casteljau}, excess,
                                     run);
}

/// A bound on the bits of a coefficient of the expanded blossom: a change of basis and the common denominator
/// of the binomials.
std::size_t coefficient_bits(const NetShape& shape, const PointArray& points, std::size_t frame_bits) {
    std::size_t bits = bits_of(points);
    for (std::size_t f = 0; f < shape.factors(); ++f) bits += shape[f].degree * (4 + frame_bits);
    return bits;
}

/// The number of terms of the blossom at distinct symbolic points. Errors: `limit_exceeded`.
std::size_t symbolic_terms(const NetShape& shape, const Limits& limits) {
    std::size_t terms = 1;
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        for (std::size_t i = 0; i < shape[f].degree && terms <= limits.expansion_terms; ++i)
            terms *= shape[f].dimension + 1;
    }
    require_within(terms, limits.expansion_terms, "expansion_terms",
                   "the number of terms of the blossom, at least");
    return terms;
}

/// The term operations of polarization at these points: the value at a sum of N points of dimension s has C(N
/// s + n, n) terms.
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

/// The tuples (1, x_1, ..., x_s), one point per argument.
TupleLists<SparsePolynomial> symbolic_points(const NetShape& shape) {
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
    return arguments;
}

/// points(symbols) gives the symbolic points (1, x_1, ..., x_s) as arguments of the map.
template <class Points>
Agreement<std::vector<SparsePolynomial>> symbolic_agreement(const PatchMap& map, std::size_t frame_bits,
                                                            const Points& points, const Limits& limits) {
    const NetShape& shape = shape_of(map);
    const std::size_t terms = symbolic_terms(shape, limits);
    require_result_bits(coefficient_bits(shape, points_of(map), frame_bits), limits,
                        terms * points_of(map).dimension());
    const TupleLists<SparsePolynomial> arguments = points(symbolic_points(shape));
    const Integer work = symbolic_work(shape);
    const auto excess = [&](Construction construction) -> std::string {
        if (construction != Construction::polarization || work <= Integer(limits.expansion_work)) return "";
        return to_string(work) + " term operations, more than the limit expansion_work = " +
               std::to_string(limits.expansion_work);
    };
    const auto run = [&](Construction construction) {
        auto value = run_construction(map, construction, arguments, limits);
        const Rational scale(1, value.denominator);
        for (SparsePolynomial& numerator : value.numerators) numerator *= scale;
        return std::move(value.numerators);
    };
    using enum Construction;
    return side_by_side<std::vector<SparsePolynomial>>({symmetric, polarization, casteljau}, excess, run);
}

using Symbols = TupleLists<SparsePolynomial>;

}  // namespace

Agreement<Coordinates> agreement(const PolynomialMap& map, std::span<const Argument> arguments,
                                 const Limits& limits) {
    require_arity(degree_of(map), arguments.size());
    const ClearedArguments cleared = cleared_one_by_one(arguments);
    const std::size_t terms = polarization_terms(
        multiplicities(std::span<const HomogeneousPair<Integer>>(cleared.pairs)), limits.polarization_terms);
    return agreement_at(map, arguments, terms, arguments.size(), limits);
}

Agreement<Coordinates> agreement(const PatchMap& map, const PatchArguments& arguments, const Limits& limits) {
    require_arguments(shape_of(map), arguments);
    const std::size_t terms = polarization_terms(multiplicities(arguments), limits.polarization_terms);
    return agreement_at(map, arguments, terms, std::nullopt, limits);
}

Agreement<std::vector<SparsePolynomial>> agreement_for_all_arguments(const PolynomialMap& map,
                                                                     const Limits& limits) {
    const auto points = [&](Symbols symbols) {
        const auto* bezier = std::get_if<BezierCurve>(&map);
        if (!bezier) return symbols;
        const auto& [a, b] = std::pair(bezier->interval().a(), bezier->interval().b());
        // (1, u) becomes ((b - u) / (b - a), (u - a) / (b - a)).
        for (auto& tuple : symbols.front()) {
            const SparsePolynomial u = Rational(1) / (b - a) * tuple[1];
            tuple = {SparsePolynomial(b / (b - a)) - u, u - SparsePolynomial(a / (b - a))};
        }
        return symbols;
    };
    const auto as_one_segment = [](const auto& curve) -> PatchMap { return as_patch(curve); };
    return symbolic_agreement(std::visit(as_one_segment, map), frame_bits(map), points, limits);
}

Agreement<std::vector<SparsePolynomial>> agreement_for_all_arguments(const PatchMap& map,
                                                                     const Limits& limits) {
    const bool barycentric = std::holds_alternative<BezierPatch>(map);
    const auto points = [&](Symbols symbols) {
        return barycentric ? sheared(std::move(symbols), -1) : symbols;
    };
    return symbolic_agreement(map, 0, points, limits);
}

std::vector<SparsePolynomial> elementary_symmetric_form(const PolynomialMap& map, const Limits& limits) {
    require_result_bits(coefficient_bits(shape_of(map), points_of(map), frame_bits(map)), limits,
                        points_of(map).numbers().size());
    const PolynomialCurve curve = monomial_form(map, limits);
    std::vector<SparsePolynomial> forms;
    for (const auto row : curve.coefficients().rows()) {
        const Quotients<Integer> normalised = constructions::normalised_coefficients(row);
        const Integer denominator = normalised.denominator * curve.coefficients().denominator();
        SparsePolynomial form;
        for (std::size_t k = 0; k < row.size(); ++k) {
            const SparsePolynomial function =
                k == 0 ? SparsePolynomial(1) : SparsePolynomial::variable(k - 1);
            form += SparsePolynomial(Rational(normalised.numerators[k], denominator)) * function;
        }
        forms.push_back(std::move(form));
    }
    return forms;
}

}  // namespace blossom
