#include <fmt/format.h>
#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/maps/hermite_curve.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include "kind.hpp"

namespace blossom::protocol {

namespace {

/// The value and the derivatives at each end.
struct Ends {
    std::vector<Coordinates> left;
    std::vector<Coordinates> right;
};

/// The points of one end; none for an empty list.
Points read_end(Fields& fields, std::string_view name, const Limits& limits) {
    return fields.required(name, [&](const Json& value) {
        return read_array(value).empty() ? Points() : read_points(value, limits);
    });
}

/// The points of both ends, all of one form.
Points read_ends(Fields& fields, Ends& ends, const Limits& limits) {
    Points left = read_end(fields, "left", limits);
    Points right = read_end(fields, "right", limits);
    ends = {left.list(), right.list()};
    if (left.empty()) return right;
    if (!right.empty() && (left.scalar != right.scalar || left.dimension != right.dimension)) {
        throw Error(ErrorCode::mismatched_dimensions,
                    "the points at the right end are not of the form of those at the left end; all are "
                    "numbers, or all are arrays of the same length of at least 1",
                    Part::right / 0);
    }
    return left;
}

/// Appends the derivatives of the denominator at one end as last coordinates.
void append_derivatives(std::vector<Coordinates>& points, const std::vector<Rational>& denominator) {
    if (denominator.size() != points.size()) {
        throw Error(ErrorCode::wrong_arity, fmt::format("{} derivatives of the denominator for {} of the map",
                                                        denominator.size(), points.size()));
    }
    for (std::size_t k = 0; k < points.size(); ++k) points[k].push_back(denominator[k]);
}

/// Field "denominator": {"left": numbers, "right": numbers}.
bool read_denominator(const Json& value, Ends& ends, const Limits& limits) {
    Fields fields(value);
    bool zero = true;
    for (const auto& [name, points] : {std::pair("left", &ends.left), std::pair("right", &ends.right)}) {
        fields.required(name, [&, at_end = points](const Json& list) {
            const std::vector<Rational> numbers = read_numbers(list, limits);
            append_derivatives(*at_end, numbers);
            zero = zero && std::ranges::all_of(numbers, &Rational::is_zero);
            return true;
        });
    }
    fields.finish();
    if (zero) throw Error(ErrorCode::zero_denominator, "the denominator is the polynomial 0");
    return true;
}

/// {"kind": "hermite", "left", "right", "interval"?, "degree"?, "denominator"?, "homogeneous"?}
Map read_hermite(Fields& fields, const Limits& limits) {
    Ends ends;
    const Points first = read_ends(fields, ends, limits);
    const std::size_t count = ends.left.size() + ends.right.size();
    if (count == 0) {
        throw Error(ErrorCode::wrong_arity, R"("left" and "right" have at least one point together)",
                    Part::left);
    }
    require_degree(count, limits);
    require_numbers(count, first.dimension, limits);
    check_degree(fields, count, limits);
    const auto interval =
        fields.optional("interval", [&](const Json& value) { return read_interval(value, limits); });
    const bool divided =
        fields
            .optional("denominator", [&](const Json& value) { return read_denominator(value, ends, limits); })
            .value_or(false);
    PointForm form{.scalar = first.scalar, .rational = divided};
    if (read_homogeneous(fields)) {
        form = divided
                   ? PointForm{.scalar = false, .rational = true, .homogeneous = true}
                   : within(ends.left.empty() ? "right" : "left", [&] { return homogeneous_form(first); });
    }
    return {HermiteCurve(ends.left, ends.right, interval.value_or(Interval())), form};
}

Json write(const HermiteCurve& curve, const PointForm& form) {
    Json map = Json::Object{
        {"kind", "hermite"}, {"degree", curve.degree()}, {"interval", to_json(curve.interval())}};
    const PointForm numerators{.scalar = form.scalar};
    Json::Array points[2], denominators[2];
    std::size_t count = 0;
    for (Coordinates point : curve.derivatives().to_points()) {
        const std::size_t end = count++ < curve.left_count() ? 0 : 1;
        if (form.separate_weights()) {
            denominators[end].emplace_back(std::move(point.back()));
            point.pop_back();
        }
        points[end].push_back(to_json(point, numerators));
    }
    map["left"] = std::move(points[0]);
    map["right"] = std::move(points[1]);
    if (form.separate_weights()) {
        map["denominator"] =
            Json::Object{{"left", std::move(denominators[0])}, {"right", std::move(denominators[1])}};
    }
    if (form.homogeneous) map["homogeneous"] = true;
    return map;
}

/// "at 0: 1, 2; at 1: 5"
std::string ends_text(const Json& ends, const Interval& interval) {
    std::string text;
    for (const auto& [name, parameter] :
         {std::pair("left", interval.a()), std::pair("right", interval.b())}) {
        const Json& list = *ends.find(name);
        if (list.array()->empty()) continue;
        text +=
            fmt::format("{}at {}: {}", text.empty() ? "" : "; ", to_string(parameter), numbers_text(list));
    }
    return text;
}

std::string formula(const HermiteCurve& curve, const Map& map, std::string_view name) {
    const Json written = write(curve, map.form);
    const Json* denominator = written.find("denominator");
    return fmt::format(
        "{}: curve of degree {} with the value and derivatives {}{}", name, curve.degree(),
        ends_text(written, curve.interval()),
        denominator ? ", divided by the one with " + ends_text(*denominator, curve.interval()) : "");
}

/// Field "counts": how many values and derivatives at each end.
std::pair<std::size_t, std::size_t> read_counts(const Json& value, const Limits& limits) {
    const auto counts = read_list(value, [&](const Json& count) { return read_count(count, limits); });
    if (counts.size() == 2) return {counts[0], counts[1]};
    throw Error(ErrorCode::wrong_arity,
                "there is one count for each of the two ends, not " + std::to_string(counts.size()));
}

/// "to": "hermite", "interval"?, "counts"?
Target::Convert read_hermite_target(Fields& request, const Limits& limits) {
    const auto counts =
        request.optional("counts", [&](const Json& value) { return read_counts(value, limits); });
    return [counts, wanted = read_wanted_interval(request, limits)](
               const PolynomialMap& map, const Interval& own, const Limits& allowed) -> AnyMap {
        const BezierCurve curve = control_points(map, wanted.value_or(own), allowed);
        const std::size_t n = curve.degree();
        if (counts && counts->first + counts->second != n + 1) {
            throw Error(ErrorCode::wrong_arity,
                        fmt::format("the curve of degree {} has {} values and derivatives at both ends "
                                    "together, not {} and {}",
                                    n, n + 1, counts->first, counts->second),
                        Place{"counts"});
        }
        return hermite_form(curve, counts ? counts->first : n / 2 + 1, allowed);
    };
}

Members hermite_members() {
    const Shape numbers = Shape::list(ValueKind::number);
    const Shape points = Shape::list(ValueKind::point);
    return {{required("left", points,
                      "the value at a and the derivatives of order 1, 2, ... there; the list may be empty"),
             required("right", points, "the same at b"),
             defaulted("interval", ValueKind::interval, "the interval `[a, b]`, by default `[0, 1]`"),
             defaulted("degree", ValueKind::count, "one less than the number of points in both lists"),
             optional("denominator",
                      Shape::object({{required("left", numbers, "its value and derivatives at a"),
                                      required("right", numbers, "the same at b")}}),
                      "the value and the derivatives of a denominator, as many as of the map"),
             homogeneous_field()}};
}

}  // namespace

constinit const Kind hermite_kind{
    .name = "hermite",
    .words = {{{"hermite", read_hermite, hermite_members,
                "A polynomial curve by its value and derivatives at two ends."}}},
    .write = write_value<HermiteCurve, write>,
    .formula = formula_of_value<HermiteCurve, formula>,
    .target = {"hermite",
               read_hermite_target,
               true,
               {.name = "counts",
                .value = "L,R",
                .help = "for hermite: how many derivatives at each end, the value included",
                .is_list = true}},
};

}  // namespace blossom::protocol
