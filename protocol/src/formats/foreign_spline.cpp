#include "foreign_spline.hpp"

#include <fmt/format.h>
#include <blossom/core/nurbs/rational_curve.hpp>
#include <blossom/rational/double_conversion.hpp>
#include <blossom/rational/lists.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

#include "doubles.hpp"

namespace blossom::protocol {

namespace {

/// The index that is step `i` of a place.
std::optional<std::size_t> index_at(const Place& place, std::size_t i) {
    if (i >= place.steps().size()) return std::nullopt;
    const auto* index = std::get_if<std::size_t>(&place.steps()[i]);
    return index ? std::optional(*index) : std::nullopt;
}

Place without_first(const Place& place, std::size_t count) {
    Place rest;
    for (std::size_t i = count; i < place.steps().size(); ++i) rest = rest.around({place.steps()[i]});
    return rest;
}

/// In a flat net, how far apart neighbours in each direction are.
std::vector<std::size_t> strides_of(std::span<const std::size_t> counts, const FlatOrder& order) {
    std::vector<std::size_t> strides(counts.size());
    std::size_t stride = 1;
    for (const std::size_t direction : order) {
        strides[direction] = stride;
        stride *= counts[direction];
    }
    return strides;
}

/// For each point of a net whose last index runs fastest, its place in the net in the given order.
std::vector<std::size_t> places_in(std::span<const std::size_t> counts, const FlatOrder& order) {
    const std::vector<std::size_t> strides = strides_of(counts, order);
    std::vector<std::size_t> places{0};
    for (std::size_t d = 0; d < counts.size(); ++d) {
        std::vector<std::size_t> finer;
        finer.reserve(places.size() * counts[d]);
        for (const std::size_t place : places) {
            for (std::size_t i = 0; i < counts[d]; ++i) finer.push_back(place + i * strides[d]);
        }
        places = std::move(finer);
    }
    return places;
}

/// The element of a flat list at a place in a net.
Place flat_place(const Place& list, const Place& in_net, const NumberPlaces& places, std::size_t dimension) {
    const std::vector<std::size_t> strides = strides_of(places.counts, places.order);
    std::size_t flat = 0;
    for (std::size_t d = 0; d < strides.size(); ++d) {
        const auto index = index_at(in_net, d);
        if (!index) return list;
        flat += *index * strides[d];
    }
    if (places.by_coordinate) return list.around(without_first(in_net, strides.size())) / flat;
    if (dimension == 0) return (list / flat).around(without_first(in_net, strides.size()));
    return list / (flat * dimension + index_at(in_net, strides.size()).value_or(0));
}

void require_positive(const Rational& weight) {
    if (weight.sign() > 0) return;
    throw Error(ErrorCode::zero_weight,
                "the weight is " + to_string(weight) + ", and those of a file are above 0");
}

std::string product_text(std::span<const std::size_t> counts) {
    return fmt::format("{}", fmt::join(counts, " x "));
}

/// Whether a net of these sizes has that many points.
bool has_size(std::span<const std::size_t> counts, std::size_t points) {
    std::size_t product = 1;
    for (const std::size_t count : counts) {
        if (__builtin_mul_overflow(product, count, &product)) return false;
    }
    return product == points;
}

/// The knots of one direction, with errors at the places of the document.
KnotVector knots_of_document(SplineNumbers& numbers, std::size_t d, const NumberPlaces& places) {
    try {
        return {numbers.degrees[d], std::move(numbers.knots[d]), numbers.counts[d]};
    } catch (const Error& error) {
        const Place& place = error.place();
        if (place.begins_with(Part::knots)) throw error.at(places.knots[d].around(place.inside(Part::knots)));
        if (place.begins_with(Part::degree)) throw error.at(places.degrees[d]);
        throw error.at(places.sizes.empty() ? places.points : places.sizes[d]);
    }
}

}  // namespace

FlatOrder first_fastest(std::size_t directions) {
    FlatOrder order(directions);
    std::iota(order.begin(), order.end(), std::size_t{0});
    return order;
}

Place NumberPlaces::of(const Place& of_map) const {
    return degrees.empty() ? document : document.around(inside(of_map));
}

Place NumberPlaces::inside(const Place& of_map) const {
    const bool net = counts.size() > 1;
    const std::size_t direction = net ? index_at(of_map, 1).value_or(0) : 0;
    if (of_map.begins_with(Part::degree) || of_map.begins_with(Place{"degrees"}))
        return degrees[std::min(direction, degrees.size() - 1)];
    if (of_map.begins_with(Part::knots)) {
        const std::size_t own = std::min(direction, knots.size() - 1);
        return knots[own].around(without_first(of_map, net ? 2 : 1));
    }
    if (of_map.begins_with(Place{"weights"})) return flat_place(weights, without_first(of_map, 1), *this, 0);
    if (!of_map.begins_with(Part::control_points) && !of_map.begins_with(Part::control_net)) return of_map;
    return flat_place(points, without_first(of_map, 1), *this, flat_dimension);
}

ForeignSpline foreign_spline(SplineNumbers numbers, NumberPlaces places) {
    const std::size_t directions = numbers.degrees.size();
    if (directions == 1) numbers.counts = {numbers.points.size()};
    if (!has_size(numbers.counts, numbers.points.size())) {
        throw Error(ErrorCode::incomplete_net,
                    fmt::format("there are {} control points, and {} are needed", numbers.points.size(),
                                product_text(numbers.counts)),
                    places.points);
    }
    places.counts = numbers.counts;
    PointForm form{.scalar = false};
    if (numbers.weights) {
        form.rational = true;
        try {
            require_weights(*numbers.weights, numbers.points.size());
            for (std::size_t i = 0; i < numbers.points.size(); ++i) {
                within(i, [&] { require_positive((*numbers.weights)[i]); });
                numbers.points[i] = homogeneous_point(numbers.points[i], (*numbers.weights)[i]);
            }
        } catch (const Error& error) {
            throw error.below(places.weights);
        }
    }
    std::vector<KnotVector> knots;
    for (std::size_t d = 0; d < directions; ++d) knots.push_back(knots_of_document(numbers, d, places));
    if (directions == 1)
        return {{BSplineCurve(std::move(knots.front()), std::move(numbers.points)), form}, std::move(places)};
    std::vector<Coordinates> net;
    net.reserve(numbers.points.size());
    for (const std::size_t place : places_in(numbers.counts, places.order))
        net.push_back(std::move(numbers.points[place]));
    return {{TensorBSpline(std::move(knots), std::move(net)), form}, std::move(places)};
}

std::vector<Rational> read_doubles(const Json& value) { return read_list(value, read_double); }

std::vector<Coordinates> read_rows(const Json& value) {
    std::vector<Coordinates> rows = read_list(value, read_doubles);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].size() == rows.front().size() && !rows[i].empty()) continue;
        throw Error(ErrorCode::mismatched_dimensions,
                    "control point " + std::to_string(i) + " has " + std::to_string(rows[i].size()) +
                        " coordinates; every point needs the same number, at least 1, and point 0 has " +
                        std::to_string(rows.front().size()),
                    Place{i});
    }
    return rows;
}

std::vector<Rational> read_weight_list(const Json& value) {
    return read_list(value, [](const Json& weight) {
        const Json::Array* list = weight.array();
        if (!list || list->size() != 1) return read_double(weight);
        return within(std::size_t{0}, [&] { return read_double(list->front()); });
    });
}

void require_stated(Fields& fields, std::string_view name, std::size_t found, std::string_view what) {
    fields.optional(name, [&](const Json& value) {
        const Rational stated = read_double(value);
        if (stated == Rational(Integer(found))) return true;
        throw Error(ErrorCode::mismatched_dimensions,
                    fmt::format("{} {} stated, and the document has {}", to_string(stated), what, found));
    });
}

Json::Array written_doubles(std::span<const Rational> numbers) {
    Json::Array list;
    for (const Rational& number : numbers) list.emplace_back(double_number(number));
    return list;
}

std::span<const KnotVector> knots_of(const Map& map) {
    if (const auto* curve = std::get_if<BSplineCurve>(&map.value)) return {&curve->knots(), 1};
    return std::get<TensorBSpline>(map.value).knots();
}

const std::vector<Coordinates>& control_points_of(const Map& map) {
    if (const auto* curve = std::get_if<BSplineCurve>(&map.value)) return curve->control_points();
    return std::get<TensorBSpline>(map.value).control_points();
}

WrittenSpline written_spline(const Map& map, const FlatOrder& order) {
    WrittenSpline written;
    for (const KnotVector& knots : knots_of(map)) {
        written.degrees.push_back(knots.degree());
        written.counts.push_back(knots.points());
        written.knots.push_back(written_doubles(knots.knots()));
    }
    const std::vector<Coordinates>& points = control_points_of(map);
    written.points.resize(points.size());
    if (map.form.rational) written.weights.resize(points.size());
    const std::vector<std::size_t> places = places_in(written.counts, order);
    for (std::size_t i = 0; i < points.size(); ++i) {
        Coordinates point = points[i];
        if (map.form.rational) {
            written.weights[places[i]] = double_number(point.back());
            point = projected(point);
        }
        written.dimension = point.size();
        written.points[places[i]] = written_doubles(point);
    }
    return written;
}

void require_valid_as_doubles(const Map& map) {
    const std::span<const KnotVector> all = knots_of(map);
    const auto rounded = [](const Rational& number) { return exact_rational(nearest_double(number)); };
    for (std::size_t d = 0; d < all.size(); ++d) {
        try {
            const KnotVector valid(all[d].degree(), mapped(all[d].knots(), rounded), all[d].points());
        } catch (const Error& error) {
            if (error.code() == ErrorCode::overflow) throw error.at(Part::knots);
            const Place inside = error.place().inside(Part::knots);
            throw error.saying("the nearest doubles of the knots are no knots: " + error.message())
                .at((all.size() > 1 ? Part::knots / d : Place(Part::knots)).around(inside));
        }
    }
    if (!map.form.rational) return;
    const std::vector<Coordinates>& points = control_points_of(map);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Rational& weight = points[i].back();
        const auto refuse = [&](const std::string& message) {
            throw Error(ErrorCode::zero_weight, fmt::format("weight {} is {}", i, message),
                        all.size() > 1 ? Place{"weights"} : Place{"weights", i});
        };
        if (weight.sign() <= 0) refuse(to_string(weight) + ", and those of a file are above 0");
        if (rounded(weight).is_zero()) refuse("above 0, and its nearest double is 0");
    }
}

}  // namespace blossom::protocol
