#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <blossom/core/patch/patch_contact.hpp>

#include "contact_order.hpp"
#include "map_list.hpp"

/// The continuity of patches along a common face.

namespace blossom::protocol {

/// A contact of polynomials; write(arguments) gives those of the first difference.
template <class Write>
Json contact_json(const auto& contact, const PointForm& form, std::string reason, const Write& write) {
    Json result = Json::Object{{"order", order_json(contact.order)}};
    if (const auto& difference = contact.first_difference) {
        result["first_difference"] = Json::Object{{"arguments", write(difference->arguments)},
                                                  {"left", to_json(difference->left, form)},
                                                  {"right", to_json(difference->right, form)}};
    }
    result["reason"] = std::move(reason);
    return result;
}

/// Errors: `wrong_arity` unless there are two maps.
void require_two_sides(const std::vector<Map>& maps);
/// Whether it is a patch or a tensor product of splines.
bool is_surface_map(const Map& map);

/// The contact of patches as a result. Of maps that are divided by their weights where the form says so: then
/// the values of the first difference are points multiplied by weights.
Json answer_of(const PatchContact& contact, const PointForm& form, bool tensor);

/// The result for two patches or tensor products; reads the fields "faces" and "geometric", and finishes the
/// request.
Json continuity_of_patches(Fields& request, std::vector<Map> maps, const Limits& limits);

Field faces_field();
Field geometric_field();
Option faces_option();
Field edges_member();
Field geometric_member();

}  // namespace blossom::protocol
