#include <blossom/core/blossom/patch_values.hpp>
#include <blossom/rational/error.hpp>

#include <numeric>

#include "maps/on_threads.hpp"
#include "maps/patch_kernel.hpp"
#include "maps/result_room.hpp"

namespace blossom {

PatchValues::PatchValues(const NetShape& shape, const PointArray& form, const Integer& greatest, Frame frame,
                         const Limits& limits)
    : forms_(net_sums(shape, form, greatest)),
      frame_(frame),
      limits_(limits),
      words_are_within_limits_(words_are_within(forms_, limits)) {}

PatchValues::PatchValues(const BezierPatch& patch, const Limits& limits)
    : PatchValues(patch.shape(), form_of(patch), greatest_magnitude(patch.control_net()), Frame::vertices,
                  limits) {}

PatchValues::PatchValues(const PolynomialPatch& patch, const Limits& limits)
    : PatchValues(patch.shape(), form_of(patch), greatest_magnitude(patch.coefficients()), Frame::origin,
                  limits) {}

void PatchValues::evaluate(const PatchPoint& point, std::span<Rational> value) const {
    const std::span<const SimplexFactor> shape = forms_.shape();
    if (!words_are_within_limits_ || point.size() != shape.size()) return evaluate_any(point, value);
    WordTuples tuples;
    for (std::size_t f = 0; f < shape.size(); ++f) {
        if (point[f].size() != shape[f].dimension + 1 || !tuples.add(point[f]))
            return evaluate_any(point, value);
        const auto& [entries, scale] = tuples.last();
        std::int64_t mass = entries.front();
        if (frame_ == Frame::vertices) {
            for (const std::int64_t entry : entries.subspan(1)) {
                if (__builtin_add_overflow(mass, entry, &mass)) return evaluate_any(point, value);
            }
        }
        if (mass != scale) return evaluate_any(point, value);
    }
    forms_.values(tuples.arguments(), value);
}

void PatchValues::evaluate_any(const PatchPoint& point, std::span<Rational> value) const {
    const std::span<const SimplexFactor> shape = forms_.shape();
    require_point(shape, point);
    IntegerTuples tuples;
    for (std::size_t f = 0; f < shape.size(); ++f) {
        tuples.add(point[f], shape[f].degree);
        const auto& [entries, scale] = tuples.last();
        Integer mass = entries.front();
        if (frame_ == Frame::vertices) mass = std::accumulate(entries.begin() + 1, entries.end(), mass);
        if (mass != scale) {
            within(f, [&] {
                (frame_ == Frame::vertices ? require_mass : require_first)(point[f], 1, "a point");
            });
        }
        require_result_bits(forms_.sum_bits(0) + tuples.bits(), limits_);
    }
    forms_.values(tuples.arguments(), value);
}

Coordinates PatchValues::operator()(const PatchPoint& point) const {
    return written(dimension(), [&](std::span<Rational> value) { evaluate(point, value); });
}

std::vector<Rational> PatchValues::at(std::span<const PatchPoint> points, std::size_t jobs) const {
    return written(points.size() * dimension(),
                   [&](std::span<Rational> results) { at(points, results, jobs); });
}

void PatchValues::at(std::span<const PatchPoint> points, std::span<Rational> results,
                     std::size_t jobs) const {
    require_room(points.size(), "points", dimension(), results.size());
    on_threads(points.size(), jobs, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            within(Part::at, [&] {
                within(i, [&] { evaluate(points[i], results.subspan(i * dimension(), dimension())); });
            });
        }
    });
}

}  // namespace blossom
