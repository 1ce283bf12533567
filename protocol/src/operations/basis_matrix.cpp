#include <fmt/format.h>
#include <blossom/core/spline/basis_matrix.hpp>

#include <algorithm>
#include <array>

#include "json/json_text.hpp"
#include "knot_fields.hpp"
#include "map_options.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

std::size_t read_basis_degree(Fields& fields, const Limits& limits) {
    return fields.required("degree", [&](const Json& value) { return read_count(value, limits); });
}

Basis read_monomial_basis(Fields& fields, const Limits& limits) {
    return PowerBasis{read_basis_degree(fields, limits), 0};
}

Basis read_taylor_basis(Fields& fields, const Limits& limits) {
    const std::size_t degree = read_basis_degree(fields, limits);
    return PowerBasis{
        degree, fields.required("center", [&](const Json& value) { return read_number(value, limits); })};
}

Basis read_bernstein_basis(Fields& fields, const Limits& limits) {
    const std::size_t degree = read_basis_degree(fields, limits);
    const auto interval =
        fields.optional("interval", [&](const Json& value) { return read_interval(value, limits); });
    return BernsteinBasis{degree, interval.value_or(Interval())};
}

template <class OfNodes>
Basis read_basis_of_nodes(Fields& fields, const Limits& limits) {
    return OfNodes{fields.required("nodes", [&](const Json& value) {
        std::vector<Rational> nodes = read_numbers(value, limits);
        if (nodes.empty()) throw Error(ErrorCode::wrong_arity, "at least one node is needed");
        return nodes;
    })};
}

Basis read_bspline_basis(Fields& fields, const Limits& limits) {
    return knot_vector(read_knot_fields(fields, limits));
}

/// A value of the field "basis", and the other fields with it. On a command line these follow it in this
/// order, "taylor:3:1/2".
struct BasisWord {
    std::string_view word;
    Basis (*read)(Fields& fields, const Limits& limits);
    FieldList (*members)();
};

FieldList basis_degree_member() { return {required("degree", ValueKind::count, "the degree")}; }

FieldList basis_nodes_member(std::string documentation) {
    return {required("nodes", Shape::list(ValueKind::number, 1), std::move(documentation))};
}

constexpr std::array basis_words = {
    BasisWord{"monomial", read_monomial_basis, basis_degree_member},
    BasisWord{"bernstein", read_bernstein_basis,
              [] {
                  FieldList fields = basis_degree_member();
                  fields.push_back(
                      optional("interval", ValueKind::interval, "the interval; by default [0, 1]"));
                  return fields;
              }},
    BasisWord{"taylor", read_taylor_basis,
              [] {
                  FieldList fields = basis_degree_member();
                  fields.push_back(required("center", ValueKind::number, "the center of the powers"));
                  return fields;
              }},
    BasisWord{"lagrange", read_basis_of_nodes<LagrangeBasis>,
              [] { return basis_nodes_member("distinct numbers, one more than the degree"); }},
    BasisWord{
        "newton", read_basis_of_nodes<NewtonBasis>,
        [] { return basis_nodes_member("numbers, one more than the degree; the last does not matter"); }},
    BasisWord{"bspline", read_bspline_basis, knot_members},
};

std::vector<std::string_view> basis_names() {
    std::vector<std::string_view> names;
    for (const BasisWord& basis : basis_words) names.push_back(basis.word);
    return names;
}

Basis read_basis(const Json& value, const Limits& limits) {
    Fields fields(value);
    const std::size_t word = fields.required(
        "basis", [](const Json& name) { return read_alternative(name, basis_names(), "a basis"); });
    Basis basis = basis_words.at(word).read(fields, limits);
    fields.finish();
    return basis;
}

/// The matrix of the other direction.
Json inverse_json(const Basis& from, const Basis& to, const Limits& limits) {
    try {
        return lists_json(basis_matrix(to, from, limits));
    } catch (const Error& error) {
        throw error.saying("there is no inverse: " + error.message()).at(Place{"inverse"});
    }
}

Answer answer_basis_matrix(Request& request, const Limits& limits) {
    const auto read = [&](const Json& value) { return read_basis(value, limits); };
    const Basis from = request.required("from", read);
    const Basis to = request.required("to", read);
    const bool both = request.optional("inverse", read_boolean).value_or(false);
    request.finish();
    Json result = Json::Object{{"matrix", lists_json(basis_matrix(from, to, limits))}};
    if (both) result["inverse"] = inverse_json(from, to, limits);
    return result;
}

std::string matrix_text(const Json& matrix, std::string_view row, std::string_view column) {
    std::vector<std::vector<std::string>> rows{{""}};
    const Json::Array& lists = *matrix.array();
    for (std::size_t j = 0; j < lists.front().array()->size(); ++j)
        rows.front().push_back(fmt::format("{}{}", column, j));
    for (std::size_t i = 0; i < lists.size(); ++i) {
        rows.push_back({fmt::format("{}{}", row, i)});
        for (const Json& entry : *lists[i].array()) rows.back().push_back(point_text(entry));
    }
    return table_text(rows);
}

std::string render_basis_matrix(const Answered& answered) {
    std::string text =
        "Each function f of the first basis is the sum of the functions g of the second, times the numbers "
        "in its "
        "column:\n\n" +
        matrix_text(*answered.result().find("matrix"), "g", "f");
    if (const Json* inverse = answered.result().find("inverse"))
        text += "\nThe inverse:\n\n" + matrix_text(*inverse, "f", "g");
    return text;
}

Shape basis_shape() {
    Choice alternatives;
    for (const BasisWord& basis : basis_words) {
        FieldList fields = basis.members();
        fields.insert(fields.begin(), required("basis", Shape::words({basis.word}), "the kind of basis"));
        alternatives.push_back(std::move(fields));
    }
    return Shape::object({{}, {std::move(alternatives)}});
}

/// "bernstein:3:0,2" as a basis; JSON as it stands.
Json basis_of_text(std::string_view text) {
    if (text.starts_with('{')) return parse_json(text, Limits{});
    const std::vector<std::string> parts = split(text, ':');
    Json basis = Json::Object{{"basis", parts.empty() ? std::string() : parts.front()}};
    const auto* const known =
        std::ranges::find(basis_words, std::string_view(*basis.find("basis")->text()), &BasisWord::word);
    if (known == basis_words.end()) return basis;
    const FieldList fields = known->members();
    if (parts.size() > fields.size() + 1)
        throw UsageError(fmt::format("\"{}\" has more parts than a basis of this kind", text));
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const std::string name(fields[i - 1].name);
        const bool list = name == "nodes" || name == "knots" || name == "interval";
        basis[name] = list ? number_list(parts[i]) : name == "degree" ? count(parts[i]) : Json(parts[i]);
    }
    return basis;
}

}  // namespace

Operation basis_matrix_operation() {
    const std::string text =
        "\"monomial:N\", \"bernstein:N:A,B\", \"taylor:N:C\", \"lagrange:X0,X1,...\", "
        "\"newton:X0,X1,...\", \"bspline:N:T0,T1,...\", or JSON";
    return {
        .summary = "Compute the matrix that takes coefficients in one basis to those in another",
        .documentation =
            "Column j has the coefficients of function j of the first basis in the second, whose span "
            "contains it.",
        .request = {{required("from", basis_shape(), "the basis of the coefficients that are known"),
                     required("to", basis_shape(), "the basis of the new coefficients"),
                     optional("inverse", ValueKind::boolean, "give the matrix of the other direction too")}},
        .result = {{required("matrix", tuples_shape(),
                             "one row per function of `to`, one column per function of `from`"),
                    optional("inverse", tuples_shape(),
                             "with `inverse`: the matrix of the other direction")}},
        .example = {"basis-matrix", "--from", "monomial:2", "--to", "bernstein:2:0,2"},
        .options = {field_option("--from", "from", "BASIS", basis_of_text,
                                 "the basis of the coefficients that are known: " + text),
                    field_option("--to", "to", "BASIS", basis_of_text, "the basis of the new coefficients"),
                    flag_option("--inverse", "inverse")},
        .answer = answer_basis_matrix,
        .render = render_basis_matrix,
    };
}

}  // namespace blossom::protocol
