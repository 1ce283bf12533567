#pragma once

#include <blossom/core/blossom/contact.hpp>
#include <blossom/core/maps/barycentric_frame.hpp>
#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace blossom {

/// A patch with the vertices of its simplices.
struct PlacedPatch {
    BezierPatch patch;
    std::vector<BarycentricFrame> frames;
};

/// The control net over other simplices, one per factor. Errors: those of `with_frame`.
BezierPatch over_frames(const PlacedPatch& patch, std::span<const BarycentricFrame> frames,
                        const Limits& limits = {});

/// The contact of two patches; its first difference is at k + 1 vertices off the face and at vertices of the
/// face, all of the left patch.
using PatchContact = ContactAt<PatchArguments>;
using PatchDifference = DifferenceAt<PatchArguments>;

/// A face of a product of simplices: for each factor, the vertices that span it.
using Face = std::vector<std::vector<std::size_t>>;

/// Where two domains meet.
struct SharedFace {
    Face face;  ///< of the left domain
    /// For each factor the vertices of the common part: for a segment, one or two points.
    std::vector<std::vector<Coordinates>> common;
    bool is_partial = false;  ///< the common part is less than a face of each domain
};

/// The face of the left domain on which the common part lies. In a factor that is a segment this is the
/// intersection of two intervals: the whole segment where they have more than a point in common, so that
/// boxes may meet along a part of a side. In other factors it is spanned by the vertices of the left simplex
/// that are vertices of the right one too. Errors: `mismatched_dimensions` for different factors;
/// `not_adjacent` for intervals without a common point, and for simplices without a common vertex.
SharedFace shared_face(std::span<const BarycentricFrame> left, std::span<const BarycentricFrame> right);

/// The contact of two patches along a face of the left domain, decided by their blossoms: it has order k or
/// more if and only if f and g agree with at most k arguments anywhere and the others on the face. Since
/// blossoms are affine in each argument, it suffices to compare the control points of both maps over the left
/// domain with at most k vertices off the face.
///
/// The degrees are raised to the greater ones. Cost: that of the net of the right patch over the simplices of
/// the left one. Errors: `mismatched_dimensions`, `wrong_arity`; `limit_exceeded`. Source: DeRose, theorem 2
/// and section 5. Statement: derose-thm3.
PatchContact contact(const PlacedPatch& left, const PlacedPatch& right, const Face& face,
                     const Limits& limits = {});

/// The contact of the projected maps A/w and B/v, whose weights are the last coordinates. It is the contact
/// of the polynomial maps A v and B w: their difference vanishes on the face to the same order, since neither
/// weight vanishes on the whole face. The first difference is one of blossom values of A v and B w.
///
/// Cost: the products of nets, and a contact in the sums of the degrees. Errors: `zero_weight` if a weight
/// vanishes on the whole face; as for `contact`. Source: DeRose, theorem 2 and section 5.
PatchContact projected_contact(const PlacedPatch& left, const PlacedPatch& right, const Face& face,
                               const Limits& limits = {});

/// A contact and its reason as a sentence.
std::string to_string(const PatchContact& contact);
/// The same for projected maps.
std::string projected_contact_text(const PatchContact& contact);

}  // namespace blossom
