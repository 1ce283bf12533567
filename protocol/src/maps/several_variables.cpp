// Polynomials in several variables: kind polynomial with "variables".

#include <fmt/format.h>
#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/core/patch/patch_conversion.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <map>

#include "polynomial_fields.hpp"
#include "several_variables.hpp"

namespace blossom::protocol {

namespace {

/// One polynomial per coordinate.
struct Coordinatewise {
    std::vector<SparsePolynomial> coordinates;
    bool scalar = true;
};

using Names = std::vector<std::string>;

Names read_variables(const Json& value, const Limits& limits) {
    Names names = read_list(value, [](const Json& element) { return read_text(element); });
    if (names.empty())
        throw Error(ErrorCode::wrong_arity, "a polynomial in several variables has at least one");
    require_within(names.size(), limits.variables, "variables", "the number of variables");
    for (std::size_t i = 0; i < names.size(); ++i) {
        within(i, [&] {
            const NamedPolynomial read = parse_polynomial(names[i], {}, limits);
            if (read.names != Names{names[i]} || read.polynomial != SparsePolynomial::variable(0)) {
                throw Error(ErrorCode::syntax, quoted(names[i]) + " is not the name of a variable");
            }
            const auto first = std::ranges::find(names, names[i]);
            if (first != names.begin() + static_cast<std::ptrdiff_t>(i)) {
                throw Error(ErrorCode::syntax, "the variable " + names[i] + " occurs twice");
            }
        });
    }
    return names;
}

Coordinatewise read_texts(const Json& value, const Names& names, const Limits& limits) {
    const auto read = [&](const Json& text) {
        return parse_polynomial(read_text(text), names, limits).polynomial;
    };
    if (value.text()) return {{read(value)}, true};
    Coordinatewise result{read_list(value, read), false};
    if (result.coordinates.empty())
        throw Error(ErrorCode::wrong_arity, "a map needs at least one coordinate");
    return result;
}

/// [[i, j, ...], point], ...
Coordinatewise read_terms(const Json& value, const Names& names, const Limits& limits) {
    const Json::Array& entries = read_array(value);
    if (entries.empty()) throw Error(ErrorCode::wrong_arity, "a list of terms has at least one");
    require_within(entries.size(), limits.expansion_terms, "expansion_terms", "the number of terms");
    Coordinatewise result;
    std::vector<std::vector<SparsePolynomial>> terms;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        within(i, [&] {
            const Json::Array& pair = read_array(entries[i]);
            if (pair.size() != 2)
                throw Error(ErrorCode::wrong_arity, "a term is a pair of exponents and a point");
            const auto exponents = within(0, [&] {
                auto list =
                    read_list(pair[0], [&](const Json& element) { return read_count(element, limits); });
                if (list.size() == names.size()) return list;
                throw Error(ErrorCode::wrong_arity,
                            fmt::format("{} exponents for {} variables", list.size(), names.size()));
            });
            within(1, [&] {
                const bool scalar = !pair[1].array();
                const Coordinates point =
                    scalar ? Coordinates{read_number(pair[1], limits)} : read_numbers(pair[1], limits);
                if (i == 0) {
                    result.scalar = scalar;
                    terms.resize(point.size());
                }
                if (scalar != result.scalar || point.size() != terms.size() || point.empty()) {
                    throw Error(ErrorCode::mismatched_dimensions,
                                "the point is not of the form of that of term 0");
                }
                for (std::size_t j = 0; j < point.size(); ++j) {
                    terms[j].push_back(SparsePolynomial::term(point[j], exponents));
                }
            });
        });
    }
    for (const auto& of_coordinate : terms) result.coordinates.push_back(sum(of_coordinate));
    return result;
}

SparsePolynomial read_denominator(const Json& value, const Names& names, const Limits& limits) {
    const Coordinatewise read =
        value.text() ? read_texts(value, names, limits) : read_terms(value, names, limits);
    if (!read.scalar)
        throw Error(ErrorCode::mismatched_dimensions, "a denominator has numbers as coefficients");
    if (read.coordinates.front().is_zero()) {
        throw Error(ErrorCode::zero_denominator, "the denominator is the polynomial 0");
    }
    return read.coordinates.front();
}

std::size_t actual_degree(const Coordinatewise& map, std::optional<std::size_t> variable) {
    std::size_t degree = 0;
    for (const SparsePolynomial& coordinate : map.coordinates) {
        degree = std::max(degree, variable ? coordinate.degree_in(*variable) : coordinate.total_degree());
    }
    return degree;
}

/// The shape of a total degree or of one degree per variable; by default the actual total degree.
NetShape read_shape(Fields& fields, const Coordinatewise& map, const Names& names, const Limits& limits) {
    const auto degrees = fields.optional("degrees", [&](const Json& value) {
        return read_each_direction(value, names.size(), "degrees",
                                   [&](const Json& degree) { return read_count(degree, limits); });
    });
    const auto degree =
        fields.optional("degree", [&](const Json& value) { return read_count(value, limits); });
    if (degrees && degree) {
        throw Error(ErrorCode::wrong_kind,
                    R"(a polynomial has a total "degree" or one of "degrees" a variable, not both)",
                    Place{"degree"});
    }
    if (degrees) return within("degrees", [&] { return NetShape::tensor(*degrees, limits); });
    const std::size_t total = degree.value_or(actual_degree(map, {}));
    return within("degree", [&] { return NetShape::simplex(names.size(), total, limits); });
}

/// The exponents that occur in any of the coordinates, with one coefficient per coordinate.
std::map<std::vector<std::size_t>, Coordinates> terms_of(const PolynomialPatch& patch) {
    const std::size_t variables = patch.shape().dimension();
    std::map<std::vector<std::size_t>, Coordinates> terms;
    for (std::size_t j = 0; j < patch.dimension(); ++j) {
        const SparsePolynomial polynomial = patch.coordinate(j);
        for (std::size_t term = 0; term < polynomial.size(); ++term) {
            std::vector<std::size_t> exponents(variables);
            for (std::size_t i = 0; i < std::min(variables, polynomial.variables()); ++i)
                exponents[i] = polynomial.exponent(term, i);
            Coordinates& point = terms[exponents];
            point.resize(patch.dimension());
            point[j] = polynomial.coefficient(term);
        }
    }
    if (terms.empty()) terms[std::vector<std::size_t>(variables)] = Coordinates(patch.dimension());
    return terms;
}

/// What the map is when its polynomials are read.
Map map_of(Fields& fields, Coordinatewise map, Names names, const Limits& limits) {
    const auto denominator = fields.optional(
        "denominator", [&](const Json& value) { return read_denominator(value, names, limits); });
    const PointForm form =
        read_polynomial_form(fields, map.coordinates.size(), map.scalar, denominator.has_value());
    if (denominator) map.coordinates.push_back(*denominator);
    const bool tensor = fields.has("degrees");
    const NetShape shape = read_shape(fields, map, names, limits);
    require_numbers(shape.size(), map.coordinates.size(), limits);
    try {
        return {Patch{PolynomialPatch(shape, map.coordinates, limits), tensor, {}, std::move(names)}, form};
    } catch (const Error& error) {
        if (error.code() != ErrorCode::degree_too_low) throw;
        throw error.at(tensor ? Place{"degrees"} : Place{"degree"});
    }
}

/// "(x - 1)", "(x + 2)" or "x".
std::string difference_text(const std::string& name, const Rational& center) {
    if (center.is_zero()) return name;
    return "(" + name + (center.sign() < 0 ? " + " : " - ") + to_string(abs(center)) + ")";
}

Shape terms_shape() { return Shape::list(Shape::pair(Shape::list(ValueKind::count), ValueKind::point), 1); }

/// The formal degrees of a polynomial in several variables.
Choice formal_degrees() {
    return {
        {optional("degree", ValueKind::count,
                  "the formal total degree, by default the actual one; the blossom takes this many points")},
        {optional(
            "degrees", Shape::list(ValueKind::count),
            "instead of `degree`: one formal degree per variable. The map is then a tensor product, and "
            "its blossom takes this many numbers per variable")}};
}

}  // namespace

Members members_in_several_variables() {
    return {
        {required("variables", Shape::list(ValueKind::text, 1), "the names of the variables, in order"),
         optional("denominator", Shape::one_of({ValueKind::polynomial_text, terms_shape()}),
                  "a polynomial, or its terms: the map is rational"),
         homogeneous_field()},
        {{{required("text",
                    Shape::one_of({ValueKind::polynomial_text, Shape::list(ValueKind::polynomial_text, 1)}),
                    "a polynomial in these variables, or one per coordinate")},
          {required(
              "terms", terms_shape(),
              R"(pairs of exponents and a point; for x^2 + 3xy this is `[[[2, 0], "1"], [[1, 1], "3"]]`)")}},
         formal_degrees()}};
}

Map read_several_variables(Fields& fields, const Limits& limits) {
    Names names =
        fields.required("variables", [&](const Json& value) { return read_variables(value, limits); });
    Coordinatewise map = read_polynomials(
        fields, "terms", [&](const Json& value) { return read_texts(value, names, limits); },
        [&](const Json& value) { return read_terms(value, names, limits); });
    return map_of(fields, std::move(map), std::move(names), limits);
}

Members expansion_members() {
    return {{required("variables", Shape::list(ValueKind::text, 1), "the names of the variables, in order"),
             required("center", Shape::list(ValueKind::number, 1), "the point, one number per variable"),
             required("terms", terms_shape(),
                      "pairs of exponents and a point, the coefficient of these powers of the differences "
                      "from the centre"),
             optional("denominator", terms_shape(), "the terms of a polynomial: the map is rational"),
             homogeneous_field()},
            {formal_degrees()}};
}

Map read_expansion(Fields& fields, const Limits& limits) {
    Names names =
        fields.required("variables", [&](const Json& value) { return read_variables(value, limits); });
    Coordinates center =
        fields.required("center", [&](const Json& value) { return read_tuple(value, names.size(), limits); });
    Coordinatewise terms =
        fields.required("terms", [&](const Json& value) { return read_terms(value, names, limits); });
    Map map = map_of(fields, std::move(terms), std::move(names), limits);
    auto& patch = std::get<Patch>(map.value);
    Coordinates back = center;
    for (Rational& coordinate : back) coordinate = -coordinate;
    patch.map = shifted(std::get<PolynomialPatch>(patch.map), back, limits);
    patch.center = std::move(center);
    return map;
}

Json write(const PolynomialPatch& polynomial, const Patch& patch, const PointForm& form) {
    const bool expanded = !patch.center.empty();
    Json map = Json::Object{{"kind", expanded ? "taylor" : "polynomial"},
                            {"variables", Json::Array(patch.variables.begin(), patch.variables.end())}};
    write_degrees(map, patch);
    if (expanded) map["center"] = Json::Array(patch.center.begin(), patch.center.end());
    const PointForm numerators{.scalar = form.scalar};
    Json::Array terms, denominator;
    for (auto& [exponents, point] : terms_of(expanded ? shifted(polynomial, patch.center) : polynomial)) {
        Coordinates numerator = point;
        const Json index = Json::Array(exponents.begin(), exponents.end());
        if (form.separate_weights()) {
            if (!numerator.back().is_zero()) denominator.emplace_back(Json::Array{index, numerator.back()});
            numerator.pop_back();
        }
        const bool zero = std::ranges::all_of(numerator, &Rational::is_zero);
        if (!zero || terms.empty()) terms.emplace_back(Json::Array{index, to_json(numerator, numerators)});
    }
    map["terms"] = std::move(terms);
    if (form.separate_weights()) map["denominator"] = std::move(denominator);
    if (form.homogeneous) map["homogeneous"] = true;
    return map;
}

std::string degree_text(const Patch& patch) {
    return fmt::format("formal degree{} {}", patch.tensor ? "s" : "",
                       fmt::join(degrees_of(patch.shape()), ", "));
}

std::string formula(const PolynomialPatch& polynomial, const Map& map, std::string_view name) {
    const auto& patch = std::get<Patch>(map.value);
    const auto& names = patch.variables;
    const bool expanded = !patch.center.empty();
    const PolynomialPatch shown = expanded ? shifted(polynomial, patch.center) : polynomial;
    std::vector<std::string> factors = names;
    for (std::size_t i = 0; expanded && i < names.size(); ++i)
        factors[i] = difference_text(names[i], patch.center[i]);
    std::vector<std::string> texts;
    texts.reserve(shown.dimension());
    for (std::size_t j = 0; j < shown.dimension(); ++j)
        texts.push_back(to_text(shown.coordinate(j), factors));
    return fmt::format("{}({}) = {}", name, fmt::join(names, ", "),
                       coordinates_text(std::move(texts), map.form));
}

}  // namespace blossom::protocol
