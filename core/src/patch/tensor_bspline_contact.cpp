#include <blossom/core/patch/tensor_bspline_change.hpp>
#include <blossom/core/patch/tensor_bspline_contact.hpp>
#include <blossom/core/spline/continuity.hpp>

#include <utility>
#include <vector>

namespace blossom {

namespace {

using Compare = PatchContact (*)(const PlacedPatch& left, const PlacedPatch& right, const Face& face,
                                 const Limits& limits);

/// Two sides of a parameter of one direction: the spans before and behind it, and by how much the box behind
/// is moved.
struct Sides {
    std::size_t before;
    std::size_t behind;
    Rational distance;
};

PlacedPatch moved(PlacedPatch patch, std::size_t direction, const Rational& distance) {
    std::vector<Coordinates> ends = patch.frames[direction].vertices();
    for (Coordinates& end : ends) end.front() += distance;
    patch.frames[direction] = BarycentricFrame(std::move(ends));
    return patch;
}

/// The contact of least order at the boxes along the parameter; the first one if there are several.
PatchContact least_contact(const TensorBSpline& spline, std::size_t direction, const Sides& at,
                           const Limits& limits, Compare compare) {
    // The left end of the box behind is the right end of the box before.
    Face face(spline.directions(), {0, 1});
    face[direction] = {1};
    PatchContact least;
    for (auto& spans : boxes_of(spline, limits)) {
        if (spans[direction] != at.before) continue;
        const PlacedPatch left = placed_segment(spline, spans, limits);
        spans[direction] = at.behind;
        const PlacedPatch right = moved(placed_segment(spline, spans, limits), direction, at.distance);
        PatchContact found = compare(left, right, face, limits);
        if (found.order && (!least.order || *found.order < *least.order)) least = std::move(found);
    }
    return least;
}

PatchContact contact_at(const TensorBSpline& spline, std::size_t direction, const Rational& parameter,
                        const Limits& limits, Compare compare) {
    const auto [before, behind] = sides(spline.knots(direction), parameter);
    if (before == behind) return {};
    return least_contact(spline, direction, {before, behind, 0}, limits, compare);
}

PatchContact contact_at_seam(const TensorBSpline& spline, std::size_t direction, const Limits& limits,
                             Compare compare) {
    const KnotVector& knots = spline.knots(direction);
    const Interval domain = knots.domain();
    return least_contact(spline, direction,
                         {knots.span_before(domain.b()), knots.span_at(domain.a()), domain.b() - domain.a()},
                         limits, compare);
}

}  // namespace

PatchContact contact(const TensorBSpline& spline, std::size_t direction, const Rational& parameter,
                     const Limits& limits) {
    return contact_at(spline, direction, parameter, limits, contact);
}

PatchContact projected_contact(const TensorBSpline& spline, std::size_t direction, const Rational& parameter,
                               const Limits& limits) {
    return contact_at(spline, direction, parameter, limits, projected_contact);
}

PatchContact seam_contact(const TensorBSpline& spline, std::size_t direction, const Limits& limits) {
    return contact_at_seam(spline, direction, limits, contact);
}

PatchContact projected_seam_contact(const TensorBSpline& spline, std::size_t direction,
                                    const Limits& limits) {
    return contact_at_seam(spline, direction, limits, projected_contact);
}

}  // namespace blossom
