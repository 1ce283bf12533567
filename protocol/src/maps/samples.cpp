#include "samples.hpp"

#include <fmt/format.h>
#include <blossom/rational/number_text.hpp>

#include "kind.hpp"

namespace blossom::protocol {

namespace {

struct Sample {
    Rational parameter;
    Json point;
};

Sample read_sample(const Json& value, const Limits& limits) {
    const Json::Array& pair = read_array(value);
    if (pair.size() != 2) {
        throw Error(ErrorCode::wrong_arity,
                    "a sample is a pair [parameter, point], not " + std::to_string(pair.size()) + " values");
    }
    return {within(std::size_t{0}, [&] { return read_number(pair[0], limits); }), pair[1]};
}

/// {"kind": "samples", "degree", "interval"?, "values": [[t, point], ...]}
Map read_samples(Fields& fields, const Limits& limits) {
    const std::size_t degree =
        fields.required("degree", [&](const Json& value) { return read_count(value, limits); });
    const auto interval =
        fields.optional("interval", [&](const Json& value) { return read_interval(value, limits); });
    Samples samples{degree, interval.value_or(Interval()), {}};
    PointForm form;
    fields.required("values", [&](const Json& value) {
        const auto list = read_list(value, [&](const Json& pair) { return read_sample(pair, limits); });
        if (list.empty()) throw Error(ErrorCode::missing_sample, "at least one sample is needed");
        form.scalar = !list.front().point.array();
        const std::size_t dimension = form.scalar ? 1 : list.front().point.array()->size();
        for (std::size_t i = 0; i < list.size(); ++i) {
            within(i, [&] {
                Coordinates point = within(
                    std::size_t{1}, [&] { return read_point(list[i].point, form, dimension, limits); });
                if (samples.values.emplace(list[i].parameter, std::move(point)).second) return;
                throw Error(ErrorCode::wrong_arity,
                            "the parameter " + to_string(list[i].parameter) + " occurs twice",
                            Place{std::size_t{0}});
            });
        }
        return true;
    });
    return {std::move(samples), form};
}

Json write(const Samples& samples, const PointForm& form) {
    Json::Array values;
    for (const auto& [parameter, point] : samples.values) {
        values.emplace_back(Json::Array{parameter, to_json(point, form)});
    }
    return Json::Object{{"kind", "samples"},
                        {"degree", samples.degree},
                        {"interval", to_json(samples.interval)},
                        {"values", std::move(values)}};
}

std::string formula(const Samples& samples, const Map&, std::string_view name) {
    return fmt::format("{}: {} samples of a map for degree {} on [{}, {}]", name, samples.values.size(),
                       samples.degree, to_string(samples.interval.a()), to_string(samples.interval.b()));
}

Members samples_members() {
    return {{required("degree", ValueKind::count, "the degree of the curve to compute"),
             optional("interval", ValueKind::interval, "the interval, by default `[0, 1]`"),
             required("values", Shape::list(ValueKind::sample, 1),
                      "parameters and points: degree + 1 of them, which the curve interpolates; if there are "
                      "others, the values at the nodes of the [inverse formula](#inverse-formula) are "
                      "required, and the rest is ignored")}};
}

}  // namespace

constinit const Kind samples_kind{
    .name = "samples",
    .words = {{{"samples", read_samples, samples_members, "A map that is known only by values."}}},
    .write = write_value<Samples, write>,
    .formula = formula_of_value<Samples, formula>,
};

}  // namespace blossom::protocol
