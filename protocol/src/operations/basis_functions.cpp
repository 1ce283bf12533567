#include <fmt/format.h>
#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/core/curve/derivative.hpp>
#include <blossom/core/nurbs/rational_basis.hpp>
#include <blossom/core/spline/basis_functions.hpp>
#include <blossom/core/spline/greville.hpp>

#include <iterator>
#include <optional>
#include <utility>

#include "knot_fields.hpp"
#include "map_options.hpp"
#include "maps/points.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

/// The functions that a request is about.
struct BasisRequest {
    KnotVector knots;
    std::optional<std::vector<Rational>> weights = {};
    std::size_t order = 0;  ///< of the derivatives
    bool single = false;    ///< only function n, that of the knots given, with n more knots before them
};

/// Degree + 2 knots are those of one B-spline.
BasisRequest read_function_knots(Fields& request, const Limits& limits) {
    KnotFields fields = read_knot_fields(request, limits);
    if (!fields.polar && fields.degree > 0 && fields.knots.size() == fields.degree + 2)
        return {.knots = knots_around(fields.degree, fields.knots), .single = true};
    return {.knots = knot_vector(std::move(fields))};
}

BasisRequest read_functions(Fields& request, const Limits& limits) {
    BasisRequest basis = read_function_knots(request, limits);
    basis.order =
        request.optional("order", [&](const Json& value) { return read_count(value, limits); }).value_or(0);
    basis.weights = request.optional("weights", [&](const Json& value) {
        if (basis.single) {
            throw Error(
                ErrorCode::wrong_arity,
                "a rational basis function is a quotient by all functions of a basis, and these knots "
                "have one B-spline");
        }
        auto weights = read_list(value, [&](const Json& weight) { return read_weight(weight, limits); });
        require_weights(weights, basis.knots.points());
        return weights;
    });
    return basis;
}

Json numbers_json(const Polynomial& polynomial, std::size_t degree) {
    Json::Array coefficients;
    for (std::size_t k = 0; k <= degree; ++k) coefficients.emplace_back(polynomial[k]);
    return coefficients;
}

Json piece_json(std::size_t span, const Interval& interval, const Polynomial& numerator, std::size_t degree) {
    return Json::Object{{"segment", span},
                        {"interval", to_json(interval)},
                        {"coefficients", numbers_json(numerator, degree)}};
}

Json rational_functions_json(const BasisRequest& basis, const Limits& limits) {
    const std::size_t n = basis.knots.degree();
    const std::size_t degree = n * (basis.order + 1);
    require_within(degree, limits.degree, "degree", "the degree of the derivative", Part::order);
    require_numbers(basis.knots.points() * (n + 1), 2 * (degree + 1), limits);
    std::vector<Json::Array> functions(basis.knots.points());
    for (const RationalPieces& pieces : within(
             "weights", [&] { return rational_basis(basis.knots, *basis.weights, basis.order, limits); })) {
        for (std::size_t i = 0; i <= n; ++i) {
            Json piece = piece_json(pieces.span, pieces.interval, pieces.numerators[i], degree);
            piece["denominator"] = numbers_json(pieces.denominator, degree);
            functions[pieces.first_point + i].push_back(std::move(piece));
        }
    }
    return Json::Array(std::make_move_iterator(functions.begin()), std::make_move_iterator(functions.end()));
}

Json functions_json(const BasisRequest& basis, const Limits& limits) {
    if (basis.weights) return rational_functions_json(basis, limits);
    const KnotVector& knots = basis.knots;
    const std::size_t n = knots.degree();
    const std::size_t first = basis.single ? n : 0;
    const std::size_t end = basis.single ? n + 1 : knots.points();
    require_numbers(end - first, (n + 1) * (n + 1), limits);
    Json::Array functions;
    for (std::size_t j = first; j < end; ++j) {
        Json::Array pieces;
        for (const auto& [span, interval, polynomial] : basis_function(knots, j, limits)) {
            const PolynomialMap derived = derivative_map(PolynomialCurve(polynomial, n), basis.order);
            pieces.push_back(piece_json(span - first, interval,
                                        std::get<PolynomialCurve>(derived).coordinate(0),
                                        degree_of(derived)));
        }
        functions.emplace_back(std::move(pieces));
    }
    return functions;
}

BasisValues basis_values_at(const BasisRequest& basis, const Rational& t, const Limits& limits) {
    if (basis.weights) {
        return rational_basis_derivatives(basis.knots, *basis.weights, basis.order, t, limits);
    }
    if (!basis.single) return basis_derivatives(basis.knots, basis.order, t, limits);
    const Interval support = basis.knots.domain();
    if (t < support.a() || t > support.b()) return {0, {0}};
    BasisValues all = basis_derivatives(basis.knots, basis.order, t, limits);
    return {0, {std::move(all.values[basis.knots.degree() - all.first_point])}};
}

Json values_json(const BasisRequest& basis, const std::vector<Rational>& parameters, const Limits& limits) {
    require_numbers(parameters.size(), basis.knots.degree() + 1, limits);
    Json::Array list;
    within("at", [&] {
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            within(i, [&] {
                BasisValues found = basis_values_at(basis, parameters[i], limits);
                list.emplace_back(
                    Json::Object{{"first_function", found.first_point},
                                 {"values", Json::Array(found.values.begin(), found.values.end())}});
            });
        }
    });
    return list;
}

Json abscissae_json(const BasisRequest& basis) {
    std::vector<Rational> abscissae = greville_abscissae(basis.knots);
    if (basis.single) return Json::Array{std::move(abscissae[basis.knots.degree()])};
    return Json::Array(abscissae.begin(), abscissae.end());
}

Answer answer_basis_functions(Request& request, const Limits& limits) {
    const BasisRequest basis = read_functions(request, limits);
    const auto parameters =
        request.optional("at", [&](const Json& value) { return read_numbers(value, limits); });
    request.finish();
    if (parameters) return Json::Object{{"basis_values", values_json(basis, *parameters, limits)}};
    Json result = Json::Object{{"functions", functions_json(basis, limits)}};
    if (basis.knots.degree() > 0) result["greville"] = abscissae_json(basis);
    return result;
}

/// "N2", of a derivative "N2'", "N2^(4)", of a rational function "R2".
std::string function_name(const Answered& answered, std::size_t j) {
    const Json* order = answered.request.find("order");
    const std::size_t k = order ? read_count(*order, answered.limits) : 0;
    constexpr std::size_t most_primes = 3;
    return fmt::format("{}{}{}", answered.request.find("weights") ? "R" : "N", j,
                       k <= most_primes ? std::string(k, '\'') : fmt::format("^({})", k));
}

std::string basis_values_text(const Answered& answered) {
    std::string text;
    const Json::Array& parameters = *answered.request.find("at")->array();
    const Json::Array& list = *answered.result().find("basis_values")->array();
    for (std::size_t i = 0; i < list.size(); ++i) {
        std::size_t j = std::stoul(list[i].find("first_function")->number()->text);
        for (const std::string& value : member_texts(list[i], "values")) {
            text += fmt::format("  {}({}) = {}\n", function_name(answered, j++), point_text(parameters[i]),
                                answered.style.bold(value));
        }
    }
    return text;
}

std::string polynomial_of_piece_text(const Json& coefficients) {
    std::vector<Rational> numbers;
    for (const Json& coefficient : *coefficients.array()) numbers.push_back(*coefficient.exact());
    return to_text(Polynomial(std::span<const Rational>(numbers)));
}

std::string piece_text(const Json& piece) {
    const std::string numerator = polynomial_of_piece_text(*piece.find("coefficients"));
    const Json* denominator = piece.find("denominator");
    return denominator ? fmt::format("({}) / ({})", numerator, polynomial_of_piece_text(*denominator))
                       : numerator;
}

std::string render_basis_functions(const Answered& answered) {
    if (answered.result().find("basis_values")) return basis_values_text(answered);
    const bool with_abscissae = answered.result().find("greville");
    const auto abscissae =
        with_abscissae ? member_texts(answered.result(), "greville") : std::vector<std::string>{};
    std::string text;
    std::size_t j = 0;
    for (const Json& pieces : *answered.result().find("functions")->array()) {
        text += fmt::format("{}{}:\n", function_name(answered, j),
                            with_abscissae ? ", Greville abscissa " + abscissae[j] : "");
        for (const Json& piece : *pieces.array()) {
            const std::vector<std::string> ends = member_texts(piece, "interval");
            text += fmt::format("  on [{}, {}]: {}\n", ends[0], ends[1], piece_text(piece));
        }
        ++j;
    }
    return text;
}

Members basis_functions_request() {
    FieldList fields = knot_members();
    fields.push_back(optional("weights", numbers_shape(),
                              "one number per function, none of them 0: the functions are rational"));
    fields.push_back(optional("order", ValueKind::count,
                              "the order of the derivatives; by default 0, the functions themselves"));
    fields.push_back(optional("at", numbers_shape(), "the parameters; by default the result is polynomials"));
    return {std::move(fields)};
}

Members basis_functions_result() {
    const Shape piece = Shape::object(
        {{required("segment", ValueKind::count, "the index of the knot at which the segment begins"),
          required("interval", ValueKind::interval, "the ends of the segment"),
          required("coefficients", numbers_shape(), "the polynomial there, lowest power first"),
          optional("denominator", numbers_shape(), "with `weights`: the polynomial that divides it")}});
    const Shape values = Shape::object(
        {{required("first_function", ValueKind::count, "the first function that is not zero there"),
          required("values", numbers_shape(), "the values of this and the next functions")}});
    return {{},
            {{{required("functions", Shape::list(Shape::list(piece)),
                        "for each function its polynomials on the segments where it is not zero"),
               optional("greville", numbers_shape(), "the Greville abscissa of each function")},
              {required("basis_values", Shape::list(values),
                        "with `at`: the values that are not zero, for each parameter")}}}};
}

}  // namespace

Operation basis_functions_operation() {
    return {
        .summary =
            "Compute the B-spline basis functions over knots, as polynomials or as values at parameters",
        .documentation =
            "Each function is given within the domain of the knots; degree + 2 knots are those of one "
            "B-spline, which is given on its support.",
        .request = basis_functions_request(),
        .result = basis_functions_result(),
        .example = {"basis-functions", "--knots", "0,0,0,1,2,2,2", "--degree", "2"},
        .options = {field_option("--knots", "knots", "T0,T1,...", number_list),
                    field_option("--degree", "degree", "N", count), word_option("--convention", "convention"),
                    field_option("--weights", "weights", "W0,W1,...", number_list),
                    field_option("--order", "order", "K", count),
                    field_option("--at", "at", "T1,T2,...", number_list)},
        .answer = answer_basis_functions,
        .render = render_basis_functions,
    };
}

}  // namespace blossom::protocol
