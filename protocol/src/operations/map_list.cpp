#include "map_list.hpp"

#include <algorithm>

#include "given_answers.hpp"
#include "json/json_text.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"

namespace blossom::protocol {

namespace {

/// The same points with the weight 1.
struct WithWeight {
    const Limits& limits;

    AnyMap operator()(const PolynomialCurve& curve) const {
        std::vector<Polynomial> coordinates = coordinates_of(curve);
        coordinates.emplace_back(1);
        return PolynomialCurve(coordinates, curve.degree());
    }
    AnyMap operator()(const BezierCurve& curve) const {
        return BezierCurve(weighted(curve.control_points().to_points()), curve.interval());
    }
    AnyMap operator()(const OnePolynomial auto& curve) const {
        return std::visit(*this, polynomial_map(curve, limits));
    }
    AnyMap operator()(const ProgressiveCurve& curve) const {
        return ProgressiveCurve(curve.knots(), weighted(curve.control_points().to_points()));
    }
    AnyMap operator()(const BSplineCurve& curve) const {
        return BSplineCurve(curve.knots(), weighted(curve.control_points()));
    }

    AnyMap operator()(const TensorBSpline& spline) const {
        return TensorBSpline(spline.knots(), weighted(spline.control_points()));
    }
    AnyMap operator()(const Patch& patch) const {
        const auto* net = std::get_if<BezierPatch>(&patch.map);
        Patch result = patch;
        if (net) {
            result.map = BezierPatch(net->shape(), weighted(net->control_net().to_points()));
            return result;
        }
        // The polynomial 1 has its only coefficient in front.
        const auto& polynomial = std::get<PolynomialPatch>(patch.map);
        std::vector<Coordinates> coefficients = polynomial.coefficients().to_points();
        for (Coordinates& coefficient : coefficients) coefficient.emplace_back(0);
        coefficients.front().back() = 1;
        result.map = PolynomialPatch(polynomial.shape(), PointArray(coefficients));
        return result;
    }

private:
    static std::vector<Coordinates> weighted(std::vector<Coordinates> points) {
        for (Coordinates& point : points) point.emplace_back(1);
        return points;
    }
};

/// What begins with neither bracket of JSON.
bool is_polynomial_text(std::string_view text) {
    const std::string_view written = trimmed(text);
    return !written.empty() && written.front() != '{' && written.front() != '[';
}

}  // namespace

std::vector<Map> read_maps_field(Fields& request, const Limits& limits) {
    return request.required("maps", [&](const Json& value) {
        return read_list(value, [&](const Json& map) { return read_map(map, limits); });
    });
}

std::vector<Rational> read_each_map(const Json& value, std::size_t maps, std::string_view what,
                                    const Limits& limits) {
    std::vector<Rational> numbers = read_numbers(value, limits);
    if (numbers.size() == maps) return numbers;
    throw Error(ErrorCode::wrong_arity, std::to_string(numbers.size()) + " " + std::string(what) + " for " +
                                            std::to_string(maps) + " maps");
}

void make_form_common(std::vector<Map>& maps, const Limits& limits) {
    const bool rational = std::ranges::any_of(maps, [](const Map& map) { return map.form.rational; });
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const Place place = Place{"maps"} / i;
        const Map& first = maps.front();
        if (point_dimension(first) == 1 && point_dimension(maps[i]) == 1)
            maps[i].form.scalar = first.form.scalar;  // x and [x] are one
        if (maps[i].form.scalar != first.form.scalar || point_dimension(maps[i]) != point_dimension(first) ||
            maps[i].form.homogeneous != first.form.homogeneous) {
            throw Error(ErrorCode::mismatched_dimensions,
                        "the points of map " + std::to_string(i) + " are not of the form of those of map 0",
                        place);
        }
    }
    for (std::size_t i = 0; i < maps.size(); ++i) {
        if (!rational || maps[i].form.rational) continue;
        maps[i].value = dispatch_on_kind<AnyMap>(maps[i], WithWeight{limits}, Place{"maps"} / i);
        maps[i].form.rational = true;
    }
}

Option maps_option(std::string name, std::string help) {
    const auto apply = [](Json& request, const std::vector<std::string>& values, const Limits& limits) {
        Json::Array maps;
        for (const std::string& value : values) {
            if (is_polynomial_text(value)) {
                maps.push_back(Json::Object{{"kind", "polynomial"}, {"text", polynomial_texts({value})}});
            } else {
                std::ranges::move(maps_in(parse_json(value, limits)), std::back_inserter(maps));
            }
        }
        request["maps"] = std::move(maps);
    };
    return {std::move(name), {"maps"}, "JSON", std::move(help), apply};
}

}  // namespace blossom::protocol
