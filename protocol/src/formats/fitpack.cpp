// A list [t, c, k], an object {"t", "c", "k"}, or the text that Python prints for either. c has a number or a
// point for each of the m = len(t) - k - 1 basis functions, or as FITPACK has it a list for each coordinate;
// it may be padded with k + 1 zeros to the length of t. The program writes one point per basis function.

#include <blossom/rational/lists.hpp>

#include <algorithm>
#include <optional>
#include <utility>

#include "doubles.hpp"
#include "foreign_formats.hpp"
#include "text/bracketed_lists.hpp"

namespace blossom::protocol {

namespace {

using Rows = std::vector<std::vector<Rational>>;

/// Cuts off the zeros behind the first `count` elements.
template <class Element, class IsZero>
void cut_padding(std::vector<Element>& elements, std::size_t count, const IsZero& is_zero) {
    for (std::size_t i = count; i < elements.size(); ++i) {
        if (is_zero(elements[i])) continue;
        throw Error(ErrorCode::wrong_arity,
                    "there are " + std::to_string(count) + " basis functions, and coefficient " +
                        std::to_string(i) + " is not 0",
                    Place{i});
    }
    elements.resize(count);
}

bool is_zero_row(const std::vector<Rational>& row) {
    return std::ranges::all_of(row, [](const Rational& number) { return number.is_zero(); });
}

/// Coordinate after coordinate, as FITPACK has them, as point after point.
std::vector<Coordinates> transposed(Rows columns, std::size_t count) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
        within(i, [&] {
            cut_padding(columns[i], count, [](const Rational& number) { return number.is_zero(); });
        });
    }
    std::vector<Coordinates> points(count);
    for (std::size_t j = 0; j < count; ++j) {
        for (const std::vector<Rational>& column : columns) points[j].push_back(column[j]);
    }
    return points;
}

/// Reads coefficients for `count` basis functions of degree k.
class CoefficientReader {
public:
    CoefficientReader(std::size_t count, std::size_t padded, bool points_first)
        : count_(count), padded_(padded), points_first_(points_first) {}

    std::vector<Coordinates> scalars(std::vector<Rational> numbers) const {
        require_size(numbers.size());
        cut_padding(numbers, count_, [](const Rational& number) { return number.is_zero(); });
        return mapped(numbers, [](const Rational& number) { return Coordinates{number}; });
    }

    std::vector<Coordinates> points(Rows rows, bool& by_coordinate) const {
        const bool by_points = fits(rows.size());
        const bool by_coordinates =
            std::ranges::all_of(rows, [&](const std::vector<Rational>& row) { return fits(row.size()); });
        if (by_points && by_coordinates && !points_first_) {
            throw Error(ErrorCode::wrong_arity,
                        std::to_string(rows.size()) +
                            " lists of as many numbers may be points or coordinates; in an object "
                            R"({"t", "c", "k"} they are points)");
        }
        by_coordinate = by_coordinates && !by_points;
        if (by_coordinate) return transposed(std::move(rows), count_);
        require_size(rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (!rows[i].empty() && rows[i].size() == rows.front().size()) continue;
            throw Error(ErrorCode::mismatched_dimensions,
                        "the point has " + std::to_string(rows[i].size()) + " coordinates, and point 0 has " +
                            std::to_string(rows.front().size()),
                        Place{i});
        }
        cut_padding(rows, count_, is_zero_row);
        return rows;
    }

private:
    bool fits(std::size_t size) const { return size == count_ || size == padded_; }
    void require_size(std::size_t size) const {
        if (fits(size)) return;
        throw Error(ErrorCode::wrong_arity,
                    std::to_string(size) + " coefficients for " + std::to_string(count_) +
                        " basis functions; with padding there are " + std::to_string(padded_));
    }

    std::size_t count_;
    std::size_t padded_;
    bool points_first_;
};

ForeignSpline read_members(const Json& knots_value, const Json& coefficients, const Json& degree_value,
                           NumberPlaces places, const Limits& limits) {
    const auto below = [](const Place& place, const auto& action) {
        try {
            return action();
        } catch (const Error& error) {
            throw error.below(place);
        }
    };
    const std::size_t degree = below(places.degrees[0], [&] { return read_count(degree_value, limits); });
    std::vector<Rational> knots = below(places.knots[0], [&] { return read_doubles(knots_value); });
    if (knots.size() < degree + 2) {
        throw Error(ErrorCode::bad_knots,
                    std::to_string(knots.size()) + " knots are too few for degree " + std::to_string(degree),
                    places.knots[0]);
    }
    bool scalar = false;
    std::vector<Coordinates> points = below(places.points, [&] {
        const CoefficientReader reader(knots.size() - degree - 1, knots.size(),
                                       places.knots[0] == Place{"t"});
        const Json::Array& elements = read_array(coefficients);
        scalar = std::ranges::none_of(elements, [](const Json& element) { return element.array(); });
        if (scalar) return reader.scalars(read_doubles(coefficients));
        return reader.points(read_list(coefficients, read_doubles), places.by_coordinate);
    });
    ForeignSpline spline = foreign_spline({{degree}, {std::move(knots)}, {}, std::move(points), std::nullopt},
                                          std::move(places));
    spline.map.form.scalar = scalar;
    return spline;
}

NumberPlaces fitpack_places(const Place& knots, const Place& coefficients, const Place& degree) {
    return {.degrees = {degree}, .knots = {knots}, .points = coefficients};
}

std::vector<ForeignSpline> read_fitpack(const Json& document, Floats floats, const Limits& limits) {
    if (const std::string* text = document.text()) {
        const Json printed = bracketed_list(*text);
        try {
            return read_fitpack(floats == Floats::decimal ? with_decimals(printed, limits) : printed, floats,
                                limits);
        } catch (const Error& error) {
            throw error.at(Place());
        }
    }
    if (const Json::Array* list = document.array()) {
        if (list->size() == 3)
            return {read_members((*list)[0], (*list)[1], (*list)[2],
                                 fitpack_places(Place() / 0, Place() / 1, Place() / 2), limits)};
        throw Error(ErrorCode::wrong_arity, "knots t, coefficients c and degree k are expected, not " +
                                                std::to_string(list->size()) + " values");
    }
    Fields fields(document);
    const auto member = [&](std::string_view name) -> const Json& {
        return *fields.required(name, [](const Json& value) { return &value; });
    };
    const Json& knots = member("t");
    const Json& coefficients = member("c");
    const Json& degree = member("k");
    return {read_members(knots, coefficients, degree, fitpack_places({"t"}, {"c"}, {"k"}), limits)};
}

Json write_fitpack(const std::vector<Map>& splines) {
    if (splines.size() != 1) {
        throw Error(ErrorCode::wrong_arity, "(t, c, k) is one curve, not " + std::to_string(splines.size()));
    }
    const Map& map = splines.front();
    if (map.form.separate_weights()) {
        throw Error(ErrorCode::wrong_kind,
                    "(t, c, k) has no place for weights; with \"homogeneous\": true they are coordinates");
    }
    WrittenSpline written = written_spline(map, first_fastest(1));
    if (map.form.scalar) {
        for (Json& point : written.points) point = Json(point.array()->front());
    }
    const std::size_t count = written.counts.front();
    const std::size_t padded = count + written.degrees.front() + 1;
    // A list of such points might be one of coordinates.
    if (!map.form.scalar && (written.dimension == count || written.dimension == padded)) {
        return Json::Object{{"t", std::move(written.knots.front())},
                            {"c", std::move(written.points)},
                            {"k", written.degrees.front()}};
    }
    return Json::Array{std::move(written.knots.front()), std::move(written.points), written.degrees.front()};
}

}  // namespace

constinit const ForeignFormat fitpack_format{
    .name = "fitpack", .read = read_fitpack, .write = write_fitpack, .curves_only = true, .text = true};

}  // namespace blossom::protocol
