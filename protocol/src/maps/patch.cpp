#include "patch.hpp"

#include <blossom/rational/error.hpp>

#include <numeric>

namespace blossom::protocol {

namespace {

[[noreturn]] void refuse_count(std::size_t given, std::size_t needed) {
    throw Error(ErrorCode::mismatched_dimensions, "there are " + std::to_string(given) +
                                                      " numbers here, and " + std::to_string(needed) +
                                                      " are needed");
}

void require_sum(std::span<const Rational> numbers, const Rational& mass) {
    const Rational sum = std::accumulate(numbers.begin(), numbers.end(), Rational());
    if (sum == mass) return;
    throw Error(ErrorCode::not_affine, "barycentric coordinates of a " +
                                           std::string(mass.is_zero() ? "vector" : "point") +
                                           " have the sum " + to_string(mass) + ", not " + to_string(sum));
}

void require_mass(const Rational& mass, const PointForm& form) {
    if (!mass.is_zero() || !form.separate_weights()) return;
    throw Error(ErrorCode::zero_weight,
                "the argument has mass 0, and so has the value, which for a rational map is no point; "
                "\"homogeneous\": true gives it with its weight");
}

/// (u, mass) in one factor.
Coordinates factor_argument(const Patch& patch, std::size_t factor, std::span<const Rational> u,
                            const Rational& mass) {
    if (!patch.frames.empty()) return patch.frames[factor].of_argument(u, mass);
    Coordinates argument(u.begin(), u.end());
    if (patch.is_polynomial()) argument.insert(argument.begin(), mass);
    return argument;
}

Coordinates read_simplex_argument(const Json& value, const Patch& patch, const PointForm& form,
                                  const Limits& limits) {
    const std::size_t count = patch.parameters();
    const auto made = [&](const std::vector<Rational>& numbers, const Rational& mass) {
        require_mass(mass, form);
        if (patch.is_barycentric()) require_sum(numbers, mass);
        return factor_argument(patch, 0, numbers, mass);
    };
    if (!value.object()) return made(read_tuple(value, count, limits), 1);
    Fields fields(value);
    const auto vector =
        fields.optional("vector", [&](const Json& member) { return read_tuple(member, count, limits); });
    if (vector) {
        fields.finish();
        return made(*vector, 0);
    }
    if (!fields.has("homogeneous")) {
        fields.finish();
        fields.missing("vector");
    }
    // Barycentric coordinates have their mass in them.
    const bool sum_is_mass = patch.is_barycentric();
    auto numbers = fields.required("homogeneous", [&](const Json& member) {
        return read_tuple(member, count + (sum_is_mass ? 0 : 1), limits);
    });
    fields.finish();
    Rational mass = std::accumulate(numbers.begin(), numbers.end(), Rational());
    if (!sum_is_mass) {
        mass = numbers.back();
        numbers.pop_back();
    }
    return made(numbers, mass);
}

Coordinates read_direction_argument(const Json& value, const Patch& patch, std::size_t factor,
                                    const PointForm& form, const Limits& limits) {
    const Argument argument = read_argument(value, limits);
    require_mass(argument.mass, form);
    return factor_argument(patch, factor, std::span(&argument.u, 1), argument.mass);
}

}  // namespace

const NetShape& Patch::shape() const {
    return std::visit([](const auto& one) -> const NetShape& { return one.shape(); }, map);
}

std::size_t Patch::dimension() const {
    return std::visit([](const auto& one) { return one.dimension(); }, map);
}

std::size_t Patch::parameters() const { return shape().dimension() + (is_barycentric() ? 1 : 0); }

std::vector<Rational> read_tuple(const Json& value, std::size_t count, const Limits& limits) {
    std::vector<Rational> numbers = read_numbers(value, limits);
    if (numbers.size() != count) refuse_count(numbers.size(), count);
    return numbers;
}

PatchPoint engine_arguments(const Patch& patch, std::span<const Rational> numbers, const Rational& mass) {
    if (patch.is_barycentric()) require_sum(numbers, mass);
    PatchPoint arguments;
    for (std::size_t f = 0; f < patch.shape().factors(); ++f) {
        const std::size_t own = patch.shape()[f].dimension + (patch.is_barycentric() ? 1 : 0);
        arguments.push_back(factor_argument(patch, f, numbers.first(own), mass));
        numbers = numbers.subspan(own);
    }
    return arguments;
}

PatchArguments read_patch_arguments(const Json& value, const Patch& patch, const PointForm& form,
                                    const Limits& limits) {
    if (!patch.tensor) {
        return {read_list(
            value, [&](const Json& element) { return read_simplex_argument(element, patch, form, limits); })};
    }
    const std::size_t factors = patch.shape().factors();
    const Json::Array& lists = read_array(value);
    if (lists.size() != factors) {
        throw Error(ErrorCode::wrong_arity, "the arguments come as " + std::to_string(factors) +
                                                " lists, one a direction, not " +
                                                std::to_string(lists.size()));
    }
    PatchArguments arguments;
    for (std::size_t f = 0; f < factors; ++f) {
        arguments.push_back(within(f, [&] {
            return read_list(lists[f], [&](const Json& element) {
                return read_direction_argument(element, patch, f, form, limits);
            });
        }));
    }
    return arguments;
}

Json patch_arguments_json(const PatchArguments& arguments, bool tensor) {
    Json::Array lists;
    for (const auto& list : arguments) {
        Json::Array written;
        for (const Coordinates& point : list) {
            written.push_back(tensor ? Json(point.front()) : Json(Json::Array(point.begin(), point.end())));
        }
        if (!tensor) return written;
        lists.emplace_back(std::move(written));
    }
    return lists;
}

std::vector<BarycentricFrame> domain_or_standard(const Patch& patch) {
    if (!patch.frames.empty()) return patch.frames;
    std::vector<BarycentricFrame> frames;
    for (std::size_t f = 0; f < patch.shape().factors(); ++f) {
        frames.push_back(BarycentricFrame::standard(patch.shape()[f].dimension));
    }
    return frames;
}

BarycentricFrame read_vertices(const Json& value, const Limits& limits) {
    auto vertices = read_list(value, [&](const Json& vertex) { return read_numbers(vertex, limits); });
    // Gauss's elimination takes the cube of their number.
    require_within(vertices.size(), 200, "numbers", "the number of vertices of a simplex");
    return as_parameter(Part::vertices, [&] { return BarycentricFrame(std::move(vertices)); });
}

std::vector<BarycentricFrame> read_intervals(const Json& value, const Limits& limits) {
    return read_list(value, [&](const Json& element) {
        const Interval interval = read_interval(element, limits);
        return BarycentricFrame({{interval.a()}, {interval.b()}});
    });
}

}  // namespace blossom::protocol
