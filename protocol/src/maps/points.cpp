#include "points.hpp"

#include <blossom/core/nurbs/rational_curve.hpp>
#include <blossom/rational/error.hpp>

#include "text/readable.hpp"

namespace blossom::protocol {

namespace {

void require_weight(const Rational& weight) {
    if (!weight.is_zero()) return;
    throw Error(
        ErrorCode::zero_weight,
        "the weight is 0; with \"homogeneous\": true, points carry their weight and may have weight 0");
}

Coordinates read_coordinates(const Json& value, bool scalar, const Limits& limits) {
    if (scalar) return {read_number(value, limits)};
    return read_numbers(value, limits);
}

/// All texts if there are few, otherwise the first and the last.
std::string joined(const std::vector<std::string>& texts) {
    constexpr std::size_t most = 24;
    constexpr std::size_t shown_at_each_end = 4;
    std::string text;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (i > 0) text += ", ";
        if (texts.size() > most && i == shown_at_each_end) {
            i = texts.size() - shown_at_each_end;
            text += "... (" + std::to_string(texts.size() - 2 * shown_at_each_end) + " more), ";
        }
        text += texts[i];
    }
    return text;
}

}  // namespace

Rational read_weight(const Json& value, const Limits& limits) {
    Rational weight = read_number(value, limits);
    require_weight(weight);
    return weight;
}

void require_weights(std::span<const Rational> weights, std::size_t points) {
    if (weights.size() != points) {
        throw Error(ErrorCode::wrong_arity, std::to_string(weights.size()) + " weights for " +
                                                std::to_string(points) +
                                                " control points; one each is needed");
    }
    for (std::size_t i = 0; i < weights.size(); ++i) within(i, [&] { require_weight(weights[i]); });
}

void append_weights(Points& points, std::span<const Rational> weights) {
    std::vector<Rational> numbers;
    numbers.reserve(points.numbers.size() + weights.size());
    auto coordinate = points.numbers.begin();
    for (const Rational& weight : weights) {
        for (std::size_t j = 0; j < points.dimension; ++j) numbers.push_back(*coordinate++ * weight);
        numbers.push_back(weight);
    }
    points.numbers = std::move(numbers);
    ++points.dimension;
}

Json to_json(const Coordinates& point, const PointForm& form) {
    if (form.separate_weights()) {
        if (!point.back().is_zero()) return to_json(projected(point), PointForm{.scalar = form.scalar});
        throw Error(ErrorCode::zero_weight,
                    "the weight is 0, so that there is no such point; \"homogeneous\": true gives it with "
                    "its weight");
    }
    if (form.scalar) return point.front();
    return Json::Array(point.begin(), point.end());
}

Coordinates answered_point(const Json& value) {
    const Json::Array* written = value.array();
    if (!written) return {*value.exact()};
    Coordinates point;
    for (const Json& coordinate : *written) point.push_back(*coordinate.exact());
    return point;
}

Coordinates read_point(const Json& value, const PointForm& form, std::size_t dimension,
                       const Limits& limits) {
    Coordinates point = read_coordinates(value, form.scalar, limits);
    if (point.size() == dimension && !point.empty()) return point;
    throw Error(ErrorCode::mismatched_dimensions, "the point has " + std::to_string(point.size()) +
                                                      " coordinates, not " + std::to_string(dimension));
}

std::vector<Coordinates> Points::list() const {
    std::vector<Coordinates> list;
    list.reserve(size());
    for (auto begin = numbers.begin(); begin != numbers.end();) {
        const auto end = begin + static_cast<std::ptrdiff_t>(dimension);
        list.emplace_back(begin, end);
        begin = end;
    }
    return list;
}

void read_next_point(const Json& value, Points& points, const Limits& limits) {
    const Json::Array* coordinates = value.array();
    const std::size_t dimension = coordinates ? coordinates->size() : 1;
    if (points.empty()) {
        points.scalar = !coordinates;
        points.dimension = dimension;
    }
    if (points.scalar == !coordinates && dimension == points.dimension && dimension > 0) {
        if (!coordinates) {
            points.numbers.push_back(read_number(value, limits));
        } else {
            for (std::size_t j = 0; j < dimension; ++j)
                points.numbers.push_back(within(j, [&] { return read_number((*coordinates)[j], limits); }));
        }
        return;
    }
    // A number that is none is said before the form.
    read_coordinates(value, !coordinates, limits);
    throw Error(ErrorCode::mismatched_dimensions,
                "the point is not of the form of those before; all are numbers, or all are arrays of the "
                "same length of at least 1");
}

Points read_points(const Json& value, const Limits& limits) {
    const Json::Array& elements = read_array(value);
    if (elements.empty()) throw Error(ErrorCode::wrong_arity, "at least one point is needed");
    Points points;
    points.numbers.reserve(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i)
        within(i, [&] { read_next_point(elements[i], points, limits); });
    require_numbers(points.size(), points.dimension, limits);
    return points;
}

WeightedPoints read_control_points(Fields& fields, const Limits& limits) {
    const auto read = [&](const Json& list) { return read_points(list, limits); };
    Points points =
        fields.required("control_points", [&](const Json& value) { return read_written_list(value, read); });
    const auto weights =
        fields.optional("weights", [&](const Json& value) { return read_numbers(value, limits); });
    PointForm form{.scalar = points.scalar};
    if (read_homogeneous(fields)) {
        refuse_weights(fields);
        form = within("control_points", [&] { return homogeneous_form(points); });
    } else if (weights) {
        form.rational = true;
        within("weights", [&] { require_weights(*weights, points.size()); });
        append_weights(points, *weights);
    }
    return {std::move(points), form};
}

void write_coefficients(Json& map, std::vector<Coordinates> coefficients, const PointForm& form) {
    const PointForm numerators{.scalar = form.scalar};
    Json::Array written;
    Json::Array denominator;
    for (Coordinates& coefficient : coefficients) {
        if (form.separate_weights()) {
            denominator.emplace_back(std::move(coefficient.back()));
            coefficient.pop_back();
        }
        written.push_back(to_json(coefficient, numerators));
    }
    map["coefficients"] = std::move(written);
    if (form.separate_weights()) map["denominator"] = std::move(denominator);
    if (form.homogeneous) map["homogeneous"] = true;
}

void refuse_weights(const Fields& fields) {
    if (!fields.has("weights")) return;
    throw Error(ErrorCode::wrong_kind,
                R"(with "homogeneous": true the control points carry their weights; leave "weights" out)",
                Place{"weights"});
}

Field homogeneous_field() {
    return optional("homogeneous", ValueKind::flag,
                    "points have their weight as their last coordinate: see [rational maps](#rational-maps)");
}

bool read_homogeneous(Fields& fields) { return fields.optional("homogeneous", read_boolean).value_or(false); }

PointForm homogeneous_form(const Points& points) {
    if (points.scalar || points.dimension < 2) {
        throw Error(
            ErrorCode::mismatched_dimensions,
            "with \"homogeneous\": true a point is an array of its coordinates, at least 1, and its weight");
    }
    return {.scalar = false, .rational = true, .homogeneous = true};
}

void check_degree(Fields& fields, std::size_t points, const Limits& limits) {
    const auto degree =
        fields.optional("degree", [&](const Json& value) { return read_count(value, limits); });
    if (!degree || *degree + 1 == points) return;
    throw Error(ErrorCode::wrong_arity,
                std::to_string(points) + " points make the degree " + std::to_string(points - 1) + ", not " +
                    std::to_string(*degree),
                Place{"degree"});
}

void require_numbers(std::size_t count, std::size_t dimension, const Limits& limits) {
    std::size_t numbers = 0;
    if (__builtin_mul_overflow(count, dimension, &numbers)) numbers = limits.numbers + 1;
    require_within(numbers, limits.numbers, "numbers", "the count of numbers");
}

void require_degree(std::size_t points, const Limits& limits) {
    require_within(points - 1, limits.degree, "degree", "the degree");
}

std::string control_points_text(const Json& map) {
    std::string text = joined(member_texts(map, "control_points"));
    if (map.find("weights")) text += ", weights " + joined(member_texts(map, "weights"));
    return text;
}

std::string numbers_text(const Json& numbers) {
    std::vector<std::string> texts;
    for (const Json& number : *numbers.array()) texts.push_back(point_text(number));
    return joined(texts);
}

}  // namespace blossom::protocol
