#include <fmt/format.h>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include "kinds.hpp"
#include "text/readable.hpp"

namespace blossom::protocol {

namespace {

/// The coefficients of the denominator as the last coordinate, filled up with zeros to a common length.
void append_denominator(std::vector<Coordinates>& coefficients, std::vector<Rational> denominator) {
    if (std::ranges::all_of(denominator, &Rational::is_zero)) {
        throw Error(ErrorCode::zero_denominator, "the denominator is the polynomial 0");
    }
    const std::size_t length = std::max(coefficients.size(), denominator.size());
    coefficients.resize(length, Coordinates(coefficients.front().size()));
    denominator.resize(length);
    for (std::size_t k = 0; k < length; ++k) coefficients[k].push_back(std::move(denominator[k]));
}

}  // namespace

Map read_taylor(Fields& fields, const Limits& limits) {
    const Rational center =
        fields.required("center", [&](const Json& value) { return read_number(value, limits); });
    Points read =
        fields.required("coefficients", [&](const Json& value) { return read_points(value, limits); });
    const auto denominator =
        fields.optional("denominator", [&](const Json& value) { return read_numbers(value, limits); });
    const auto degree =
        fields.optional("degree", [&](const Json& value) { return read_count(value, limits); });
    PointForm form{.scalar = read.scalar, .rational = denominator.has_value()};
    if (denominator) within("denominator", [&] { append_denominator(read.points, *denominator); });
    if (read_homogeneous(fields)) {
        form = denominator ? PointForm{.scalar = false, .rational = true, .homogeneous = true}
                           : within("coefficients", [&] { return homogeneous_form(read); });
    }
    within("coefficients", [&] { require_degree(read.points.size(), limits); });
    const PolynomialCurve checked(read.points, degree);
    return {TaylorCurve{center, checked.coefficients()}, form};
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

}  // namespace blossom::protocol
