#include "maps/map.hpp"

#include <blossom/rational/number_text.hpp>

#include "maps/kinds.hpp"
#include "nearest_name.hpp"

namespace blossom::cli {

namespace {

struct Kind {
    std::string_view name;
    Map (*read)(Fields& fields, const Limits& limits);
};

constexpr Kind kinds[] = {
    {"polynomial", read_polynomial},
    {"bezier", read_bezier},
};

const Kind& read_kind(const Json& value) {
    const std::string& written = read_text(value);
    std::vector<std::string_view> names;
    std::string list;
    for (const Kind& kind : kinds) {
        if (kind.name == written) return kind;
        names.push_back(kind.name);
        list += (list.empty() ? "" : ", ") + std::string(kind.name);
    }
    throw Error(ErrorCode::wrong_kind, "the kind of map " + quoted(written) + " is not known" +
                                           suggestion(written, names) + "; known are: " + list);
}

Coordinates read_point(const Json& value, bool scalar, const Limits& limits) {
    if (scalar) return {read_number(value, limits)};
    return read_numbers(value, limits);
}

}  // namespace

std::size_t degree_of(const Map& map) {
    return std::visit([](const auto& curve) { return curve.degree(); }, map.curve);
}

std::size_t dimension_of(const Map& map) {
    return std::visit([](const auto& curve) { return curve.dimension(); }, map.curve);
}

Map read_map(const Json& value, const Limits& limits) {
    Fields fields(value);
    const Kind& kind = fields.required("kind", read_kind);
    Map map = kind.read(fields, limits);
    fields.finish();
    return map;
}

Json to_json(const Map& map) {
    if (const auto* polynomial = std::get_if<PolynomialCurve>(&map.curve)) {
        return polynomial_to_json(*polynomial, map.form);
    }
    return bezier_to_json(std::get<BezierCurve>(map.curve), map.form);
}

Json to_json(const Coordinates& point, const PointForm& form) {
    const bool divided = form.rational && !form.homogeneous;
    const Rational weight = divided ? point.back() : Rational(1);
    if (weight.is_zero()) {
        throw Error(ErrorCode::zero_weight,
                    "the weight is 0, so that there is no such point; \"homogeneous\": true gives it with "
                    "its weight");
    }
    const std::size_t dimension = point.size() - (divided ? 1 : 0);
    if (form.scalar) return point.front() / weight;
    Json::Array coordinates;
    coordinates.reserve(dimension);
    for (std::size_t i = 0; i < dimension; ++i) coordinates.emplace_back(point[i] / weight);
    return coordinates;
}

Points read_points(const Json& value, const Limits& limits) {
    const Json::Array& elements = read_array(value);
    if (elements.empty()) throw Error(ErrorCode::wrong_arity, "at least one point is needed");
    require_within(elements.size() - 1, limits.degree, "degree", "the degree");
    Points result{{}, !elements.front().array()};
    result.points.reserve(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
        within(i, [&] {
            const bool scalar = !elements[i].array();
            result.points.push_back(read_point(elements[i], scalar, limits));
            if (scalar != result.scalar || result.points[i].size() != result.points[0].size() ||
                result.points[i].empty()) {
                throw Error(ErrorCode::mismatched_dimensions,
                            "point " + std::to_string(i) +
                                " is not of the form of point 0; all are numbers, or all are "
                                "arrays of the same length of at least 1");
            }
        });
    }
    return result;
}

bool read_homogeneous(Fields& fields) { return fields.optional("homogeneous", read_boolean).value_or(false); }

PointForm homogeneous_form(const Points& points) {
    if (points.scalar || points.points.front().size() < 2) {
        throw Error(
            ErrorCode::mismatched_dimensions,
            "with \"homogeneous\": true a point is an array of its coordinates, at least 1, and its weight");
    }
    return {.scalar = false, .rational = true, .homogeneous = true};
}

void require_numbers(std::size_t count, std::size_t dimension, const Limits& limits) {
    std::size_t numbers = 0;
    if (__builtin_mul_overflow(count, dimension, &numbers)) numbers = limits.numbers + 1;
    require_within(numbers, limits.numbers, "numbers", "the count of numbers");
}

}  // namespace blossom::cli
