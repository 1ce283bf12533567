#include <fmt/format.h>
#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/core/spline/basis_functions.hpp>
#include <blossom/core/spline/greville.hpp>

#include "map_options.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

constexpr std::string_view convention_names[] = {"textbook", "polar"};

/// The number of control points that belongs to the knots in this convention.
KnotVector read_knots(Fields& request, const Limits& limits) {
    const std::size_t degree =
        request.required("degree", [&](const Json& value) { return read_count(value, limits); });
    std::vector<Rational> knots =
        request.required("knots", [&](const Json& value) { return read_numbers(value, limits); });
    const auto convention = request.optional("convention", [](const Json& value) {
        return read_alternative(value, convention_names, "a convention of knots");
    });
    const bool polar = convention == 1;
    const std::size_t more = polar ? knots.size() + 1 : knots.size();
    const std::size_t fewer = polar ? degree : degree + 1;
    if (more <= fewer + degree || (polar && degree == 0)) {
        throw Error(ErrorCode::bad_knots,
                    std::to_string(knots.size()) + " knots of degree " + std::to_string(degree) +
                        " are too few for a domain in this convention",
                    Place{"knots"});
    }
    const std::size_t points = more - fewer;
    return {degree, std::move(knots), points};
}

Json piece_json(const PolynomialPiece& piece, std::size_t degree) {
    Json::Array coefficients;
    for (std::size_t k = 0; k <= degree; ++k) coefficients.emplace_back(piece.polynomial[k]);
    return Json::Object{{"segment", piece.span},
                        {"interval", to_json(piece.interval)},
                        {"coefficients", std::move(coefficients)}};
}

Json functions_json(const KnotVector& knots, const Limits& limits) {
    const std::size_t numbers_of_one = (knots.degree() + 1) * (knots.degree() + 1);
    require_numbers(knots.points(), numbers_of_one, limits);
    Json::Array functions;
    for (std::size_t j = 0; j < knots.points(); ++j) {
        Json::Array pieces;
        for (const PolynomialPiece& piece : basis_function(knots, j, limits)) {
            pieces.push_back(piece_json(piece, knots.degree()));
        }
        functions.emplace_back(std::move(pieces));
    }
    return functions;
}

Json values_json(const KnotVector& knots, const std::vector<Rational>& parameters, const Limits& limits) {
    require_numbers(parameters.size(), knots.degree() + 1, limits);
    Json::Array list;
    within("at", [&] {
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            within(i, [&] {
                BasisValues found = basis_values(knots, parameters[i], limits);
                list.emplace_back(
                    Json::Object{{"first_function", found.first_point},
                                 {"values", Json::Array(found.values.begin(), found.values.end())}});
            });
        }
    });
    return list;
}

Answer answer_basis_functions(Request& request, const Limits& limits) {
    const KnotVector knots = read_knots(request, limits);
    const auto parameters =
        request.optional("at", [&](const Json& value) { return read_numbers(value, limits); });
    request.finish();
    if (parameters) return Json::Object{{"basis_values", values_json(knots, *parameters, limits)}};
    Json result = Json::Object{{"functions", functions_json(knots, limits)}};
    if (knots.degree() > 0) {
        const std::vector<Rational> abscissae = greville_abscissae(knots);
        result["greville"] = Json::Array(abscissae.begin(), abscissae.end());
    }
    return result;
}

std::string values_text(const Answered& answered) {
    std::string text;
    const Json::Array& parameters = *answered.request.find("at")->array();
    const Json::Array& list = *answered.result().find("basis_values")->array();
    for (std::size_t i = 0; i < list.size(); ++i) {
        std::size_t j = std::stoul(list[i].find("first_function")->number()->text);
        for (const std::string& value : member_texts(list[i], "values")) {
            text +=
                fmt::format("  N{}({}) = {}\n", j++, point_text(parameters[i]), answered.style.bold(value));
        }
    }
    return text;
}

std::string polynomial_text(const Json& piece) {
    std::vector<Rational> coefficients;
    for (const Json& coefficient : *piece.find("coefficients")->array())
        coefficients.push_back(*coefficient.exact());
    return to_text(Polynomial(std::span<const Rational>(coefficients)));
}

std::string render_basis_functions(const Answered& answered) {
    if (answered.result().find("basis_values")) return values_text(answered);
    const bool with_abscissae = answered.result().find("greville");
    const auto abscissae =
        with_abscissae ? member_texts(answered.result(), "greville") : std::vector<std::string>{};
    std::string text;
    std::size_t j = 0;
    for (const Json& pieces : *answered.result().find("functions")->array()) {
        text += fmt::format("N{}{}:\n", j, with_abscissae ? ", Greville abscissa " + abscissae[j] : "");
        for (const Json& piece : *pieces.array()) {
            const std::vector<std::string> ends = member_texts(piece, "interval");
            text += fmt::format("  on [{}, {}]: {}\n", ends[0], ends[1], polynomial_text(piece));
        }
        ++j;
    }
    return text;
}

Members basis_functions_result() {
    const Shape piece = Shape::object(
        {{required("segment", ValueKind::count, "the index of the knot at which the segment begins"),
          required("interval", ValueKind::interval, "the ends of the segment"),
          required("coefficients", numbers_shape(), "the polynomial there, lowest power first")}});
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
        .documentation = "Each function is given within the domain of the knots.",
        .request = {{required("degree", ValueKind::count, "the degree"),
                     required("knots", numbers_shape(), "the knots"),
                     optional("convention", Shape::words(convention_names),
                              "textbook (the default): with the first and last knot, on which no point "
                              "depends; polar: without them"),
                     optional("at", numbers_shape(),
                              "the parameters; by default the result is polynomials")}},
        .result = basis_functions_result(),
        .example = {"basis-functions", "--knots", "0,0,0,1,2,2,2", "--degree", "2"},
        .options = {field_option("--knots", "knots", "T0,T1,...", number_list),
                    field_option("--degree", "degree", "N", count), word_option("--convention", "convention"),
                    field_option("--at", "at", "T1,T2,...", number_list)},
        .answer = answer_basis_functions,
        .render = render_basis_functions,
    };
}

}  // namespace blossom::protocol
