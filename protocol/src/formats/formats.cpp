#include "formats.hpp"

#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/nurbs/rational_curve.hpp>
#include <blossom/core/spline/spline_join.hpp>
#include <blossom/rational/lists.hpp>

#include <algorithm>

#include "doubles.hpp"
#include "fitpack.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "svg_path.hpp"

namespace blossom::protocol {

namespace {

constexpr const char* only_curves = "only curves are read, and this has more than one parameter direction";

std::vector<Rational> read_doubles(const Json& value) { return read_list(value, read_double); }

/// Reads points, which must all have one dimension.
std::vector<Coordinates> read_rows(const Json& value) {
    std::vector<Coordinates> rows = read_list(value, read_doubles);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].size() == rows.front().size()) continue;
        throw Error(ErrorCode::mismatched_dimensions,
                    "control point " + std::to_string(i) + " has " + std::to_string(rows[i].size()) +
                        " coordinates; every point needs the same number, at least 1, and point 0 has " +
                        std::to_string(rows.front().size()),
                    Place{i});
    }
    return rows;
}

/// Weights are a list of numbers or of lists of one number each.
std::vector<Rational> read_weights(const Json& value) {
    return read_list(value, [](const Json& weight) {
        const Json::Array* list = weight.array();
        if (!list || list->size() != 1) return read_double(weight);
        return within(std::size_t{0}, [&] { return read_double(list->front()); });
    });
}

Place place_in_curve(const NumberPlaces& numbers, const Place& of_map) {
    if (of_map.begins_with(Part::degree)) return numbers.degree;
    if (of_map.begins_with(Part::knots)) return numbers.knots.around(of_map.inside(Part::knots));
    if (of_map.begins_with(Place{"weights"})) return numbers.weights.around(of_map.inside(Place{"weights"}));
    if (!of_map.begins_with(Part::control_points)) return of_map;
    if (!numbers.rows) return numbers.control_points;
    return numbers.control_points.around(of_map.inside(Part::control_points));
}

/// Errors: those of the engine, at the places of the document.
Map spline(std::size_t degree, std::vector<Rational> knots, std::vector<Coordinates> points,
           const std::optional<std::vector<Rational>>& weights, const NumberPlaces& places) {
    try {
        PointForm form{.scalar = false};
        if (weights) {
            form.rational = true;
            within("weights", [&] { require_weights(*weights, points.size()); });
            for (std::size_t i = 0; i < points.size(); ++i)
                points[i] = homogeneous_point(points[i], (*weights)[i]);
        }
        return {BSplineCurve(degree, std::move(knots), std::move(points)), form};
    } catch (const Error& error) {
        throw error.at(place_in_curve(places, error.place()));
    }
}

// tinyspline: {"degree", "dimension", "control_points": all coordinates in one list, "knots"}

const NumberPlaces tinyspline_numbers{Part::degree, Part::knots, Part::control_points, {}, false};

std::vector<Map> read_tinyspline(const Json& document, Floats, const Limits& limits) {
    Fields fields(document);
    const std::size_t degree =
        fields.required("degree", [&](const Json& value) { return read_count(value, limits); });
    const std::size_t dimension =
        fields.required("dimension", [&](const Json& value) { return read_count(value, limits); });
    std::vector<Rational> knots = fields.required("knots", read_doubles);
    std::vector<Coordinates> points = fields.required("control_points", [&](const Json& value) {
        const std::vector<Rational> all = read_doubles(value);
        if (dimension == 0 || all.empty() || all.size() % dimension != 0) {
            throw Error(ErrorCode::mismatched_dimensions,
                        std::to_string(all.size()) + " coordinates do not make points of dimension " +
                            std::to_string(dimension));
        }
        std::vector<Coordinates> rows;
        for (auto begin = all.begin(); begin != all.end(); begin += static_cast<std::ptrdiff_t>(dimension))
            rows.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(dimension));
        return rows;
    });
    return {spline(degree, std::move(knots), std::move(points), std::nullopt, tinyspline_numbers)};
}

/// The numbers of a bspline map that every format contains.
struct Parts {
    const BSplineCurve& curve;
    Json::Array knots;
    Json::Array points;
    Json::Array weights;  ///< empty unless there are weights
};

Json::Array doubles(std::span<const Rational> numbers) {
    Json::Array list;
    for (const Rational& number : numbers) list.emplace_back(double_number(number));
    return list;
}

Parts parts_of(const Map& map) {
    const auto& curve = std::get<BSplineCurve>(map.value);
    Parts parts{curve, doubles(curve.knots().knots()), {}, {}};
    for (Coordinates point : curve.control_points()) {
        if (map.form.separate_weights()) {
            const Rational weight = point.back();
            if (weight.is_zero()) throw Error(ErrorCode::zero_weight, "a control point has weight 0");
            point = projected(point);
            parts.weights.emplace_back(double_number(weight));
        }
        parts.points.emplace_back(doubles(point));
    }
    return parts;
}

std::size_t dimension_of_points(const Parts& parts) { return parts.points.front().array()->size(); }

Json write_tinyspline(const std::vector<Map>& splines) {
    if (splines.size() != 1) {
        throw Error(ErrorCode::wrong_arity,
                    "a file of tinyspline holds one spline, not " + std::to_string(splines.size()));
    }
    const Parts parts = parts_of(splines.front());
    if (!parts.weights.empty()) {
        throw Error(ErrorCode::wrong_kind,
                    "a file of tinyspline has no place for weights; with \"homogeneous\": true they are "
                    "coordinates");
    }
    Json::Array all;
    for (const Json& point : parts.points)
        all.insert(all.end(), point.array()->begin(), point.array()->end());
    return Json::Object{{"degree", parts.curve.degree()},
                        {"dimension", dimension_of_points(parts)},
                        {"control_points", std::move(all)},
                        {"knots", parts.knots}};
}

// geomdl: {"shape": {"type": "curve", "count", "data": [{"degree", "knotvector", "control_points": {"points",
// "weights"?}, ...}]}}; other members are not needed.

const NumberPlaces geomdl_numbers{
    Part::degree, {"knotvector"}, {"control_points", "points"}, {"control_points", "weights"}};

Map read_geomdl_curve(const Json& data, const Limits& limits) {
    Fields fields(data);
    const std::size_t degree =
        fields.required("degree", [&](const Json& value) { return read_count(value, limits); });
    std::vector<Rational> knots = fields.required("knotvector", read_doubles);
    std::optional<std::vector<Rational>> weights;
    auto points = fields.required("control_points", [&](const Json& value) {
        Fields inner(value);
        weights = inner.optional("weights", read_weights);
        return inner.required("points", read_rows);
    });
    return spline(degree, std::move(knots), std::move(points), weights, geomdl_numbers);
}

std::vector<Map> read_geomdl(const Json& document, Floats, const Limits& limits) {
    Fields fields(document);
    return fields.required("shape", [&](const Json& value) {
        Fields shape(value);
        shape.required("type", [](const Json& type) {
            if (read_text(type) != "curve") throw Error(ErrorCode::wrong_kind, only_curves);
            return true;
        });
        return shape.required("data", [&](const Json& data) {
            return read_list(data, [&](const Json& curve) { return read_geomdl_curve(curve, limits); });
        });
    });
}

Json write_geomdl(const std::vector<Map>& splines) {
    Json::Array data;
    for (const Map& map : splines) {
        const Parts parts = parts_of(map);
        Json control_points = Json::Object{{"points", parts.points}};
        if (!parts.weights.empty()) control_points["weights"] = parts.weights;
        data.emplace_back(Json::Object{{"type", "spline"},
                                       {"rational", !parts.weights.empty()},
                                       {"dimension", dimension_of_points(parts)},
                                       {"degree", parts.curve.degree()},
                                       {"knotvector", parts.knots},
                                       {"control_points", std::move(control_points)}});
    }
    return Json::Object{
        {"shape", Json::Object{{"type", "curve"}, {"count", splines.size()}, {"data", std::move(data)}}}};
}

// splinepy: {"Name", "NumberOfSplines", "Base64Encoding", "SplineList": [{"SplineType", "degrees": [n],
// "knot_vectors": [[...]], "control_points": [[...]], "weights"?: [[w], ...], "dim", "para_dim"}]}; the
// Bezier types have no knots.

const NumberPlaces splinepy_numbers{
    Place{"degrees"} / 0, Place{"knot_vectors"} / 0, {"control_points"}, {"weights"}};

Map read_splinepy_spline(const Json& data, const Limits& limits) {
    Fields fields(data);
    const auto degrees = fields.required("degrees", [&](const Json& value) {
        return read_list(value, [&](const Json& degree) { return read_count(degree, limits); });
    });
    if (degrees.size() != 1) throw Error(ErrorCode::wrong_kind, only_curves, Place{"degrees"});
    std::vector<Coordinates> points = fields.required("control_points", read_rows);
    const auto weights = fields.optional("weights", read_weights);
    const auto knots = fields.optional("knot_vectors", [](const Json& value) {
        auto vectors = read_list(value, read_doubles);
        if (vectors.size() != 1) throw Error(ErrorCode::wrong_kind, only_curves);
        return std::move(vectors.front());
    });
    if (knots) return spline(degrees.front(), *knots, std::move(points), weights, splinepy_numbers);
    const std::size_t order = degrees.front() + 1;
    if (points.size() != order) {
        throw Error(ErrorCode::wrong_arity,
                    "without knots, a curve of degree " + std::to_string(order - 1) + " has " +
                        std::to_string(order) + " control points, not " + std::to_string(points.size()),
                    Place{"control_points"});
    }
    std::vector<Rational> ends(order, Rational(0));
    ends.insert(ends.end(), order, Rational(1));
    return spline(degrees.front(), std::move(ends), std::move(points), weights, splinepy_numbers);
}

std::vector<Map> read_splinepy(const Json& document, Floats, const Limits& limits) {
    Fields fields(document);
    const bool encoded = fields.optional("Base64Encoding", read_boolean).value_or(false);
    if (encoded) {
        throw Error(ErrorCode::wrong_kind,
                    "the numbers are written in base 64; export them with base64encoding=False",
                    Place{"Base64Encoding"});
    }
    return fields.required("SplineList", [&](const Json& list) {
        return read_list(list, [&](const Json& data) { return read_splinepy_spline(data, limits); });
    });
}

Json write_splinepy(const std::vector<Map>& splines) {
    Json::Array list;
    for (const Map& map : splines) {
        const Parts parts = parts_of(map);
        Json data = Json::Object{{"degrees", Json::Array{parts.curve.degree()}},
                                 {"knot_vectors", Json::Array{Json(parts.knots)}},
                                 {"control_points", parts.points}};
        if (!parts.weights.empty()) {
            Json::Array rows;
            for (const Json& weight : parts.weights) rows.emplace_back(Json::Array{weight});
            data["weights"] = std::move(rows);
        }
        data["SplineType"] = parts.weights.empty() ? "BSpline" : "NURBS";
        data["dim"] = dimension_of_points(parts);
        data["para_dim"] = std::size_t{1};
        list.push_back(std::move(data));
    }
    return Json::Object{{"Name", "SplineGroup"},
                        {"NumberOfSplines", splines.size()},
                        {"Base64Encoding", false},
                        {"SplineList", std::move(list)}};
}

// The text of a path is as exact as it is written.

std::vector<Map> read_svg(const Json& document, Floats floats, const Limits& limits) {
    return svg_path_curves(read_text(document), floats, limits);
}

const NumberPlaces path_numbers{{}, {}, {}, {}, false};
const NumberPlaces fitpack_numbers{Place() / 2, Place() / 0, Place() / 1, {}};

const ForeignFormat formats[] = {
    {"tinyspline", read_tinyspline, write_tinyspline, {}, tinyspline_numbers},
    {"geomdl", read_geomdl, write_geomdl, Place{"shape", "data"} / 0, geomdl_numbers},
    {"splinepy", read_splinepy, write_splinepy, Place{"SplineList"} / 0, splinepy_numbers},
    {"fitpack", read_fitpack, write_fitpack, {}, fitpack_numbers, Floats::binary64, true},
    {"svg", read_svg, write_svg_path, {}, path_numbers, Floats::decimal, true},
};

/// The outermost knots, on which no point of the curve depends, are equal to their neighbours where these may
/// occur once more.
BSplineCurve textbook(const BSplineCurve& curve) {
    const KnotVector& own = curve.knots();
    if (own.convention() == KnotConvention::textbook) return curve;
    const std::vector<KnotMultiplicity> distinct = own.distinct();
    const auto room = [&](const KnotMultiplicity& end) { return end.multiplicity <= own.degree(); };
    std::vector<Rational> knots{distinct.front().knot - Rational(room(distinct.front()) ? 0 : 1)};
    knots.insert(knots.end(), own.knots().begin(), own.knots().end());
    knots.push_back(distinct.back().knot + Rational(room(distinct.back()) ? 0 : 1));
    return {curve.degree(), std::move(knots), curve.control_points()};
}

}  // namespace

std::vector<std::string_view> format_names() { return mapped(formats, &ForeignFormat::name); }

const ForeignFormat& read_format(const Json& name) {
    return formats[read_alternative(name, format_names(), "a format")];
}

bool may_be_text(const Json& format_name) {
    const std::string* name = format_name.text();
    return name && std::ranges::any_of(formats, [&](const ForeignFormat& format) {
               return format.name == *name && format.text;
           });
}

Place place_in_document(const ForeignFormat& format, const Place& of_map) {
    return format.first_curve.around(place_in_curve(format.numbers, of_map));
}

Map as_textbook_spline(const Map& map, const Limits& limits) {
    const auto of_polynomial = [&](const OnePolynomial auto& curve) {
        const BezierCurve bezier = control_points(polynomial_map(curve, limits), interval_of(curve), limits);
        return join(std::span(&bezier, 1), limits);
    };
    const auto of_spline = [](const BSplineCurve& curve) { return textbook(curve); };
    return {dispatch_on_kind<BSplineCurve>(map, Overloads{of_polynomial, of_spline}, Place()), map.form,
            map.variable};
}

}  // namespace blossom::protocol
