#include "patch.hpp"

#include <fmt/format.h>
#include <blossom/rational/error.hpp>

#include <numeric>

namespace blossom::protocol {

namespace {

[[noreturn]] void refuse_count(std::size_t given, std::size_t needed) {
    throw Error(ErrorCode::mismatched_dimensions, "there are " + std::to_string(given) +
                                                      " numbers here, and " + std::to_string(needed) +
                                                      " are needed");
}

}  // namespace

std::size_t Patch::parameters() const { return shape().dimension() + (is_barycentric() ? 1 : 0); }

std::vector<Rational> read_tuple(const Json& value, std::size_t count, const Limits& limits) {
    std::vector<Rational> numbers = read_numbers(value, limits);
    if (numbers.size() != count) refuse_count(numbers.size(), count);
    return numbers;
}

void require_sum(std::span<const Rational> numbers, const Rational& mass) {
    const Rational sum = std::accumulate(numbers.begin(), numbers.end(), Rational());
    if (sum == mass) return;
    throw Error(ErrorCode::not_affine, "barycentric coordinates of a " +
                                           std::string(mass.is_zero() ? "vector" : "point") +
                                           " have the sum " + to_string(mass) + ", not " + to_string(sum));
}

Coordinates engine_argument(const Patch& patch, std::size_t factor, std::span<const Rational> u,
                            const Rational& mass) {
    if (!patch.frames.empty()) return patch.frames[factor].of_argument(u, mass);
    Coordinates argument(u.begin(), u.end());
    if (patch.is_polynomial()) argument.insert(argument.begin(), mass);
    return argument;
}

PatchPoint engine_arguments(const Patch& patch, std::span<const Rational> numbers, const Rational& mass) {
    if (patch.is_barycentric()) require_sum(numbers, mass);
    PatchPoint arguments;
    for (std::size_t f = 0; f < patch.shape().factors(); ++f) {
        const std::size_t own = patch.shape()[f].dimension + (patch.is_barycentric() ? 1 : 0);
        arguments.push_back(engine_argument(patch, f, numbers.first(own), mass));
        numbers = numbers.subspan(own);
    }
    return arguments;
}

std::vector<std::size_t> degrees_of(const NetShape& shape) {
    std::vector<std::size_t> degrees;
    degrees.reserve(shape.factors());
    for (std::size_t f = 0; f < shape.factors(); ++f) degrees.push_back(shape[f].degree);
    return degrees;
}

void write_degrees(Json& map, const Patch& patch) {
    const std::vector<std::size_t> degrees = degrees_of(patch.shape());
    if (patch.tensor) {
        map["degrees"] = Json::Array(degrees.begin(), degrees.end());
    } else {
        map["degree"] = degrees.front();
    }
}

std::vector<BarycentricFrame> domain_or_standard(const Patch& patch) {
    if (!patch.frames.empty()) return patch.frames;
    std::vector<BarycentricFrame> frames;
    frames.reserve(patch.shape().factors());
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

BarycentricFrame read_vertices(const Json& value, std::size_t dimension, const Limits& limits) {
    BarycentricFrame frame = read_vertices(value, limits);
    if (frame.dimension() == dimension && frame.space_dimension() == dimension) return frame;
    throw Error(
        ErrorCode::mismatched_dimensions,
        fmt::format(
            "a simplex of dimension {} has {} vertices with {} coordinates each; given are {} with {}",
            dimension, dimension + 1, dimension, frame.dimension() + 1, frame.space_dimension()));
}

std::vector<BarycentricFrame> read_intervals(const Json& value, std::size_t directions,
                                             const Limits& limits) {
    return read_each_direction(value, directions, "intervals", [&](const Json& element) {
        const Interval interval = read_interval(element, limits);
        return BarycentricFrame({{interval.a()}, {interval.b()}});
    });
}

}  // namespace blossom::protocol
