#include "place.hpp"

#include "operations/patch_answers.hpp"

namespace blossom::protocol {

std::optional<SpacePoint> placed(Coordinates value, bool rational, const Coordinates& parameters) {
    if (rational) {
        const Rational weight = value.back();
        if (weight.is_zero()) return {};
        value.pop_back();
        for (Rational& coordinate : value) coordinate /= weight;
    }
    if (value.size() == 1) value.insert(value.begin(), parameters.begin(), parameters.end());
    value.resize(3);
    return SpacePoint{value[0], value[1], value[2]};
}

Coordinates parameters_of(const Patch& patch, const PatchPoint& point) {
    Coordinates numbers;
    const std::vector<BarycentricFrame> frames = domain_or_standard(patch);
    for (std::size_t f = 0; f < point.size(); ++f) {
        const Coordinates own = frames[f].combination(point[f]);
        numbers.insert(numbers.end(), own.begin(), own.end());
    }
    return numbers;
}

std::optional<SpacePoint> place_of_value(const Map& map, const Json& parameter, const Json& value,
                                         const Limits& limits) {
    Coordinates numbers = read_numbers(parameter, limits);
    const Patch* patch = patch_of(map);
    if (patch && patch->is_barycentric())
        numbers = parameters_of(*patch, engine_arguments(*patch, numbers, 1));
    // Only homogeneous values carry their weight.
    return placed(answered_point(value), map.form.homogeneous, numbers);
}

}  // namespace blossom::protocol
