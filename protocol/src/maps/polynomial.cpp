#include <fmt/format.h>
#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/core/blossom/conversion.hpp>

#include <algorithm>

#include "kind.hpp"
#include "polynomial_fields.hpp"

namespace blossom::protocol {

namespace {

/// The coordinates, as a request writes them.
struct Written {
    PolynomialCurve curve;
    bool scalar = true;
    std::string variable;  ///< "" while none has occurred
};

[[noreturn]] void refuse_variables(const std::vector<std::string>& names) {
    const bool contained =
        names[0].find(names[1]) != std::string::npos || names[1].find(names[0]) != std::string::npos;
    throw Error(
        ErrorCode::syntax,
        fmt::format("a polynomial in one variable is expected, and both {} and {} occur; {}", names[0],
                    names[1],
                    contained ? "write a product with '*'"
                              : fmt::format(R"(of one in several these are named, by "variables": ["{}"] )"
                                            "or --variables {}",
                                            fmt::join(names, "\", \""), fmt::join(names, ","))));
}

Polynomial read_one_text(const std::string& text, std::string& variable, const Limits& limits) {
    const NamedPolynomial named = parse_polynomial(text, {}, limits);
    if (named.names.size() > 1) refuse_variables(named.names);
    UnivariateText read = univariate(named);
    const bool constant = read.polynomial.degree() == 0;
    if (!constant && !variable.empty() && variable != read.name) {
        throw Error(ErrorCode::syntax, "the variable is called " + read.name + " here, and " + variable +
                                           " before; it must be the same");
    }
    if (!constant) variable = read.name;
    return std::move(read.polynomial);
}

Written read_texts(const Json& value, const Limits& limits) {
    std::string variable;
    if (const std::string* text = value.text()) {
        const Polynomial polynomial = read_one_text(*text, variable, limits);
        return {PolynomialCurve(polynomial), true, variable};
    }
    const auto coordinates = read_list(
        value, [&](const Json& element) { return read_one_text(read_text(element), variable, limits); });
    if (coordinates.empty()) throw Error(ErrorCode::wrong_arity, "a map needs at least one coordinate");
    return {PolynomialCurve(coordinates), false, variable};
}

Written read_coefficients(const Json& value, const Limits& limits) {
    const Points points = read_points(value, limits);
    require_degree(points.size(), limits);
    return {PolynomialCurve(points.array()), points.scalar, ""};
}

Polynomial read_denominator(const Json& value, std::string& variable, const Limits& limits) {
    Polynomial denominator;
    if (const std::string* text = value.text()) {
        denominator = read_one_text(*text, variable, limits);
    } else {
        const auto& elements = read_array(value);
        require_within(elements.size(), limits.degree + 1, "degree", "one more than the degree");
        denominator = Polynomial(std::span<const Rational>(read_numbers(value, limits)));
    }
    if (denominator.is_zero())
        throw Error(ErrorCode::zero_denominator, "the denominator is the polynomial 0");
    return denominator;
}

/// {"kind": "polynomial", "coefficients" or "text", "degree"?, "denominator"?, "homogeneous"?}
Map read_polynomial(Fields& fields, const Limits& limits) {
    Written written = read_polynomials(
        fields, "coefficients", [&](const Json& value) { return read_texts(value, limits); },
        [&](const Json& value) { return read_coefficients(value, limits); });
    const auto denominator = fields.optional(
        "denominator", [&](const Json& value) { return read_denominator(value, written.variable, limits); });
    const auto degree =
        fields.optional("degree", [&](const Json& value) { return read_count(value, limits); });
    const PointForm form =
        read_polynomial_form(fields, written.curve.dimension(), written.scalar, denominator.has_value());
    const std::size_t actual =
        std::max(written.curve.actual_degree(), denominator ? denominator->degree() : 0);
    const std::size_t formal = degree.value_or(actual);
    require_numbers(std::max(formal, actual) + 1, written.curve.dimension() + (denominator ? 1 : 0), limits);
    if (denominator || formal != written.curve.degree()) {
        std::vector<Polynomial> coordinates = coordinates_of(written.curve);
        if (denominator) coordinates.push_back(*denominator);
        written.curve = PolynomialCurve(coordinates, degree);
    }
    return {std::move(written.curve), form, written.variable.empty() ? "t" : std::move(written.variable)};
}

Json write(const PolynomialCurve& curve, const PointForm& form) {
    Json map = Json::Object{{"kind", "polynomial"}, {"degree", curve.degree()}};
    write_coefficients(map, curve.coefficients().to_points(), form);
    return map;
}

std::string formula(const PolynomialCurve& curve, const Map& map, std::string_view name) {
    std::vector<std::string> texts;
    for (const Polynomial& coordinate : coordinates_of(curve))
        texts.push_back(to_text(coordinate, map.variable));
    return fmt::format("{}({}) = {}", name, map.variable, coordinates_text(std::move(texts), map.form));
}

/// "to": "monomial".
Target::Convert read_monomial_target(Fields&, const Limits&) {
    return [](const PolynomialMap& map, const Interval&, const Limits& limits) -> AnyMap {
        return monomial_form(map, limits);
    };
}

std::string polynomial_degree(const Map& map) {
    return ", formal degree " + std::to_string(std::get<PolynomialCurve>(map.value).degree());
}

Members polynomial_members() {
    return {
        {defaulted("degree", ValueKind::count,
                   "the formal degree; at least the actual degree of all coordinates, which is the default"),
         optional("denominator",
                  Shape::one_of({ValueKind::polynomial_text, Shape::list(ValueKind::number, 1)}),
                  "a polynomial, or the list of its coefficients, by which the map is divided"),
         homogeneous_field()},
        {{{required("coefficients", Shape::list(ValueKind::point, 1), "lowest power first")},
          {required(
              "text", Shape::one_of({ValueKind::polynomial_text, Shape::list(ValueKind::polynomial_text, 1)}),
              "a polynomial such as `\"1 + 2t - t^3/4\"`, or one per coordinate; the variable may have any "
              "name")}}}};
}

}  // namespace

constinit const Kind polynomial_kind{
    .name = "polynomial",
    .words = {{{"polynomial", read_polynomial, polynomial_members,
                "A polynomial in one variable for each coordinate."}}},
    .write = write_value<PolynomialCurve, write>,
    .formula = formula_of_value<PolynomialCurve, formula>,
    .target = {"monomial", read_monomial_target},
    .degree_text = polynomial_degree,
};

}  // namespace blossom::protocol
