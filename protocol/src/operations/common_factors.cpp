#include <fmt/format.h>
#include <blossom/core/algebra/resultant.hpp>
#include <blossom/core/algebra/sparse_algebra.hpp>
#include <blossom/core/blossom/conversion.hpp>

#include <algorithm>

#include "listing.hpp"
#include "map_list.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

/// Scalar polynomials in the same variables.
struct ScalarPolynomials {
    std::vector<SparsePolynomial> list;
    std::vector<std::string> variables;  ///< of several
    bool tensor = false;                 ///< with a degree per variable
    std::string variable = "t";          ///< of one

    bool are_curves() const { return variables.empty(); }
};

SparsePolynomial as_sparse(const Polynomial& polynomial) {
    std::vector<SparsePolynomial> terms;
    for (std::size_t k = 0; k <= polynomial.degree(); ++k)
        terms.push_back(SparsePolynomial::term(polynomial[k], std::vector{k}));
    return sum(terms);
}

Polynomial as_dense(const SparsePolynomial& polynomial) {
    std::vector<Rational> coefficients(polynomial.total_degree() + 1);
    for (std::size_t i = 0; i < polynomial.size(); ++i)
        coefficients[polynomial.degree(i)] = polynomial.coefficient(i);
    return Polynomial(coefficients);
}

struct AsPolynomial {
    ScalarPolynomials& all;
    const Limits& limits;

    SparsePolynomial operator()(const OnePolynomial auto& curve) const {
        require_variables({});
        return as_sparse(monomial_form(polynomial_map(curve, limits), limits).coordinate(0));
    }
    SparsePolynomial operator()(const Patch& patch) const {
        const auto* polynomial = std::get_if<PolynomialPatch>(&patch.map);
        if (!polynomial) {
            throw Error(ErrorCode::wrong_kind,
                        "a control net is no polynomial in named variables; \"convert\" makes one of it");
        }
        if (all.list.empty()) {
            all.variables = patch.variables;
            all.tensor = patch.tensor;
        }
        require_variables(patch.variables);
        return polynomial->coordinate(0);
    }

private:
    void require_variables(const std::vector<std::string>& variables) const {
        if (variables == all.variables) return;
        throw Error(ErrorCode::mismatched_dimensions,
                    "the polynomials of one request have the same variables in the same order");
    }
};

ScalarPolynomials read_polynomials(Fields& request, const Limits& limits) {
    const std::vector<Map> maps = read_maps_field(request, limits);
    if (maps.empty()) throw Error(ErrorCode::wrong_arity, "at least one map is needed", Place{"maps"});
    ScalarPolynomials all;
    all.variable = maps.front().variable;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        within("maps", [&] {
            within(i, [&] {
                if (maps[i].form.rational || dimension_of(maps[i]) != 1) {
                    throw Error(ErrorCode::mismatched_dimensions,
                                "a scalar polynomial is needed, neither a rational map nor one with several "
                                "coordinates");
                }
                all.list.push_back(
                    dispatch_on_kind<SparsePolynomial>(maps[i], AsPolynomial{all, limits}, Place()));
            });
        });
    }
    return all;
}

/// A polynomial of its own degree as a map.
Map map_of_polynomial(const SparsePolynomial& polynomial, const ScalarPolynomials& like,
                      const Limits& limits) {
    if (like.are_curves()) return {PolynomialCurve(as_dense(polynomial)), {}, like.variable};
    std::vector<std::size_t> degrees = polynomial.degrees();
    degrees.resize(like.variables.size());
    const NetShape shape = like.tensor ? NetShape::tensor(degrees, limits)
                                       : NetShape::simplex(degrees.size(), polynomial.total_degree(), limits);
    return {Patch{PolynomialPatch(shape, std::span(&polynomial, 1), limits), like.tensor, {}, like.variables},
            {}};
}

Answer answer_gcd(Request& request, const Limits& limits) {
    const ScalarPolynomials given = read_polynomials(request, limits);
    request.finish();
    SparsePolynomial common;
    for (const SparsePolynomial& polynomial : given.list) {
        common = given.are_curves() ? as_sparse(gcd(as_dense(common), as_dense(polynomial)))
                                    : gcd(common, polynomial);
    }
    return answer_of(within("maps", [&] { return map_of_polynomial(common, given, limits); }), "maps");
}

/// Without the variable, which does not occur; the later ones move up.
SparsePolynomial without_variable(const SparsePolynomial& polynomial, std::size_t variable) {
    std::vector<SparsePolynomial> terms;
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        std::vector<std::size_t> exponents;
        for (std::size_t k = 0; k < polynomial.variables(); ++k) {
            if (k != variable) exponents.push_back(polynomial.exponent(i, k));
        }
        terms.push_back(SparsePolynomial::term(polynomial.coefficient(i), exponents));
    }
    return sum(terms);
}

Answer answer_resultant(Request& request, const Limits& limits) {
    ScalarPolynomials given = read_polynomials(request, limits);
    std::optional<std::size_t> eliminated;
    if (!given.are_curves()) {
        eliminated = request.required("variable", [&](const Json& value) {
            const auto found = std::ranges::find(given.variables, read_text(value));
            if (found != given.variables.end())
                return static_cast<std::size_t>(found - given.variables.begin());
            throw Error(ErrorCode::wrong_kind, "\"" + read_text(value) + "\" is none of the variables");
        });
    }
    request.finish();
    if (given.list.size() != 2) {
        throw Error(ErrorCode::wrong_arity,
                    fmt::format("a resultant is one of two polynomials, not of {}", given.list.size()),
                    Place{"maps"});
    }
    if (!eliminated)
        return Json::Object{{"value", resultant(as_dense(given.list[0]), as_dense(given.list[1]))}};
    const SparsePolynomial found =
        without_variable(resultant(given.list[0], given.list[1], *eliminated), *eliminated);
    given.variables.erase(given.variables.begin() + static_cast<std::ptrdiff_t>(*eliminated));
    if (given.variables.empty()) return Json::Object{{"value", as_dense(found)[0]}};
    if (given.variables.size() == 1) {
        given.variable = given.variables.front();
        given.variables.clear();
    }
    return answer_of(within("maps", [&] { return map_of_polynomial(found, given, limits); }), "maps");
}

std::string render_resultant(const Answered& answered) {
    if (!answered.answer.maps.empty()) return described_listing(answered);
    return "Resultant: " + answered.style.bold(member_text(answered.result(), "value")) + "\n";
}

}  // namespace

Operation gcd_operation() {
    return {
        .summary = "Compute the greatest common divisor of scalar polynomials",
        .documentation = "Its leading coefficient is 1.",
        .request = {{maps_field("the polynomials, all in one variable or all in the same variables")}},
        .result = {{map_member("the greatest common divisor, of its actual degree")}},
        .example = {"gcd", "t^3 - t", "t^2 - 2t + 1"},
        .options = {maps_option("MAP",
                                "the polynomials: as text, as maps of the protocol, lists of them, or the "
                                "output of other commands")},
        .answer = answer_gcd,
        .render = described_listing,
        .plot = plot_of_result,
    };
}

Operation resultant_operation() {
    return {
        .summary = "Compute the resultant of two scalar polynomials",
        .documentation =
            "It is 0 where they have a common root; in several variables one of them is eliminated.",
        .request = {{maps_field("the two polynomials, both in one variable or both in the same variables"),
                     optional("variable", ValueKind::text,
                              "in several variables: the one that is eliminated")}},
        .result = {{},
                   {{{required("value", ValueKind::number, "the resultant")},
                     {map_member("in several variables: the resultant, a polynomial in the others")}}}},
        .example = {"resultant", "t^2 - 2", "t^3 - t - 1"},
        .options = {maps_option("MAP",
                                "the two polynomials: as text, as maps of the protocol, a list of them, or "
                                "the output of other commands"),
                    field_option("--variable", "variable", "X", plain_text)},
        .answer = answer_resultant,
        .render = render_resultant,
    };
}

}  // namespace blossom::protocol
