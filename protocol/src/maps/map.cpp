#include "map.hpp"

#include <blossom/rational/number_text.hpp>

#include "dispatch_on_kind.hpp"
#include "json/nearest_name.hpp"
#include "kinds.hpp"

namespace blossom::protocol {

namespace {

struct Kind {
    std::string_view name;
    Map (*read)(Fields& fields, const Limits& limits);
};

constexpr Kind kinds[] = {
    {"polynomial", read_polynomial}, {"bezier", read_bezier},           {"taylor", read_taylor},
    {"bspline", read_bspline},       {"progressive", read_progressive}, {"samples", read_samples},
    {"tensor", read_tensor},         {"simplex", read_simplex},
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

}  // namespace

std::size_t dimension_of(const Map& map) {
    return std::visit(Overloads{[](const TaylorCurve& curve) { return curve.coefficients.dimension(); },
                                [](const auto& value) { return value.dimension(); }},
                      map.value);
}

Map read_map(const Json& value, const Limits& limits) {
    Fields fields(value);
    const Kind& kind = fields.required("kind", read_kind);
    Map map = kind.read(fields, limits);
    fields.finish();
    return map;
}

Json to_json(const Map& map) {
    return std::visit([&](const auto& value) { return write(value, map.form); }, map.value);
}

std::string formula(const Map& map, std::string_view name) {
    return std::visit([&](const auto& value) { return formula(value, map, name); }, map.value);
}

std::string description(const Map& map) {
    const auto degree = Overloads{
        [](const PolynomialCurve& curve) { return ", formal degree " + std::to_string(curve.degree()); },
        [](const BezierCurve& curve) { return ", degree " + std::to_string(curve.degree()); },
        [](const Patch& patch) { return patch.is_polynomial() ? ", " + degree_text(patch) : ""; },
        [](const auto&) { return std::string(); }};
    return formula(map, "P") + std::visit(degree, map.value) +
           (map.form.homogeneous ? ", points with their weight last" : "");
}

}  // namespace blossom::protocol
