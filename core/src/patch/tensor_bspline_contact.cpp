#include <blossom/core/patch/tensor_bspline_change.hpp>
#include <blossom/core/patch/tensor_bspline_contact.hpp>
#include <blossom/core/spline/continuity.hpp>

#include <utility>

namespace blossom {

namespace {

using Compare = PatchContact (*)(const PlacedPatch& left, const PlacedPatch& right, const Face& face,
                                 const Limits& limits);

/// The contact of least order at the boxes along the parameter; the first one if there are several.
PatchContact least_contact(const TensorBSpline& spline, std::size_t direction, const Rational& parameter,
                           const Limits& limits, Compare compare) {
    const auto [before, behind] = sides(spline.knots(direction), parameter);
    PatchContact least;
    if (before == behind) return least;
    // The left end of the box behind is the right end of the box before.
    Face face(spline.directions(), {0, 1});
    face[direction] = {1};
    for (auto& spans : boxes_of(spline, limits)) {
        if (spans[direction] != before) continue;
        const PlacedPatch left = placed_segment(spline, spans, limits);
        spans[direction] = behind;
        PatchContact found = compare(left, placed_segment(spline, spans, limits), face, limits);
        if (found.order && (!least.order || *found.order < *least.order)) least = std::move(found);
    }
    return least;
}

}  // namespace

PatchContact contact(const TensorBSpline& spline, std::size_t direction, const Rational& parameter,
                     const Limits& limits) {
    return least_contact(spline, direction, parameter, limits, contact);
}

PatchContact projected_contact(const TensorBSpline& spline, std::size_t direction, const Rational& parameter,
                               const Limits& limits) {
    return least_contact(spline, direction, parameter, limits, projected_contact);
}

}  // namespace blossom
