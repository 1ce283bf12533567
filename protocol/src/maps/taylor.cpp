#include <fmt/format.h>
#include <blossom/core/blossom/conversion.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include "kind.hpp"
#include "text/readable.hpp"

namespace blossom::protocol {

namespace {

/// Appends the coefficients of the denominator as last coordinate, padded with zeros to a common length.
void append_denominator(std::vector<Coordinates>& coefficients, std::vector<Rational> denominator) {
    if (std::ranges::all_of(denominator, &Rational::is_zero)) {
        throw Error(ErrorCode::zero_denominator, "the denominator is the polynomial 0");
    }
    const std::size_t length = std::max(coefficients.size(), denominator.size());
    coefficients.resize(length, Coordinates(coefficients.front().size()));
    denominator.resize(length);
    for (std::size_t k = 0; k < length; ++k) coefficients[k].push_back(std::move(denominator[k]));
}

/// {"kind": "taylor", "center", "coefficients", "degree"?, "denominator"?, "homogeneous"?}
Map read_taylor(Fields& fields, const Limits& limits) {
    const Rational center =
        fields.required("center", [&](const Json& value) { return read_number(value, limits); });
    const Points read =
        fields.required("coefficients", [&](const Json& value) { return read_points(value, limits); });
    const auto denominator =
        fields.optional("denominator", [&](const Json& value) { return read_numbers(value, limits); });
    const auto degree =
        fields.optional("degree", [&](const Json& value) { return read_count(value, limits); });
    PointForm form{.scalar = read.scalar, .rational = denominator.has_value()};
    std::vector<Coordinates> coefficients = read.list();
    if (denominator) within("denominator", [&] { append_denominator(coefficients, *denominator); });
    if (read_homogeneous(fields)) {
        form = denominator ? PointForm{.scalar = false, .rational = true, .homogeneous = true}
                           : within("coefficients", [&] { return homogeneous_form(read); });
    }
    within("coefficients", [&] { require_degree(coefficients.size(), limits); });
    const PolynomialCurve given(coefficients);
    const std::size_t formal = degree.value_or(given.actual_degree());
    require_numbers(formal + 1, given.dimension(), limits);
    return {TaylorCurve{center, PolynomialCurve(coefficients, formal).coefficients()}, form};
}

Json write(const TaylorCurve& curve, const PointForm& form) {
    Json map =
        Json::Object{{"kind", "taylor"}, {"degree", curve.coefficients.size() - 1}, {"center", curve.center}};
    write_coefficients(map, curve.coefficients.to_points(), form);
    return map;
}

std::string formula(const TaylorCurve& curve, const Map& map, std::string_view name) {
    const Json written = write(curve, map.form);
    const Json* denominator = written.find("denominator");
    return fmt::format(
        "{}: coefficients {}{} of the powers of t - ({})", name, numbers_text(*written.find("coefficients")),
        denominator ? " divided by " + numbers_text(*denominator) : "", to_string(curve.center));
}

/// "to": "taylor", "center"?
Target::Convert read_taylor_target(Fields& request, const Limits& limits) {
    const auto center =
        request.optional("center", [&](const Json& value) { return read_number(value, limits); });
    return [center = center.value_or(0)](const PolynomialMap& map, const Interval&,
                                         const Limits& allowed) -> AnyMap {
        return taylor_form(monomial_form(map, allowed), center, allowed);
    };
}

Members taylor_members() {
    return {{required("center", ValueKind::number, "the number a"),
             required("coefficients", Shape::list(ValueKind::point, 1),
                      "the coefficients of the powers of t - a, lowest power first"),
             defaulted("degree", ValueKind::count,
                       "the formal degree; by default one less than the number of coefficients"),
             optional("denominator", Shape::list(ValueKind::number, 1),
                      "the coefficients of a polynomial by which the map is divided"),
             homogeneous_field()}};
}

}  // namespace

constinit const Kind taylor_kind{
    .name = "taylor",
    .words = {{{"taylor", read_taylor, taylor_members, "A polynomial by its expansion at a number."}}},
    .write = write_value<TaylorCurve, write>,
    .formula = formula_of_value<TaylorCurve, formula>,
    .target = {"taylor",
               read_taylor_target,
               false,
               {"center", "A", "the centre of the powers for taylor; by default 0; of a patch a point", false,
                true}},
};

}  // namespace blossom::protocol
