#include "patch_continuity.hpp"

#include <fmt/format.h>
#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/core/patch/edge_contact.hpp>
#include <blossom/core/patch/tangent_contact.hpp>
#include <blossom/core/patch/tensor_bspline_change.hpp>
#include <blossom/rational/number_text.hpp>

#include <optional>
#include <span>

#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "shared_fields.hpp"

namespace blossom::protocol {

namespace {

/// The arguments as points; one list for a simplex.
Json points_json(const PatchArguments& arguments, bool tensor) {
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

PlacedPatch required_net(const Map& map, std::size_t i) {
    const auto* patch = std::get_if<Patch>(&map.value);
    if (patch && !patch->frames.empty()) return {std::get<BezierPatch>(patch->map), patch->frames};
    throw Error(
        ErrorCode::wrong_kind,
        R"(two tensor or two simplex maps are needed, these with "vertices": their domains say where they meet)",
        Place{"maps"} / i);
}

/// A map in polynomial pieces, and its domain.
struct Surface {
    std::vector<PlacedPatch> pieces;
    std::vector<BarycentricFrame> domain;
    bool is_spline = false;

    bool is_box() const {
        return std::ranges::all_of(domain, [](const BarycentricFrame& frame) {
            return frame.dimension() == 1 && frame.space_dimension() == 1;
        });
    }
    bool is_plane() const {
        return is_box()
                   ? domain.size() == 2
                   : domain.size() == 1 && domain[0].dimension() == 2 && domain[0].space_dimension() == 2;
    }
};

Surface surface_of(const Map& map, std::size_t i, const Limits& limits) {
    const auto* spline = std::get_if<TensorBSpline>(&map.value);
    if (!spline) {
        const PlacedPatch patch = required_net(map, i);
        return {{patch}, patch.frames, false};
    }
    Surface surface{{}, {}, true};
    for (const auto& spans : boxes_of(*spline, limits))
        surface.pieces.push_back(placed_segment(*spline, spans, limits));
    for (const KnotVector& knots : spline->knots()) {
        const Interval own = knots.domain();
        surface.domain.emplace_back(std::vector<Coordinates>{{own.a()}, {own.b()}});
    }
    return surface;
}

/// The least of several contacts.
struct LeastContact {
    std::optional<PatchContact> least;

    void add(PatchContact found) {
        if (!least || (found.order && (!least->order || *found.order < *least->order)))
            least = std::move(found);
    }
};

/// Two maps that are compared.
struct SurfacePair {
    Surface left;
    Surface right;
    PointForm form;
    const Limits& limits;

    bool projected() const { return form.separate_weights(); }

    /// Along the common part of domains that are products of the same simplices.
    Json along_shared_face(bool tensor) const {
        const auto [face, common, is_partial] = shared_face(left.domain, right.domain);
        LeastContact contacts;
        if (!left.is_spline && !right.is_spline) {
            contacts.add(contact_of(left.pieces[0], right.pieces[0], face));
        } else {
            require_pairs(1);
            const std::size_t dimension = meeting_dimension(left.domain, right.domain);
            for (const PlacedPatch& one : left.pieces) {
                for (const PlacedPatch& other : right.pieces) {
                    if (!meet(one, other) || meeting_dimension(one.frames, other.frames) != dimension)
                        continue;
                    contacts.add(contact_of(one, other, shared_face(one.frames, other.frames).face));
                }
            }
        }
        Json result = answer_of(contacts.least.value_or(PatchContact()), form, tensor);
        if (is_partial || left.is_spline || right.is_spline) result["face"] = points_json(common, tensor);
        return result;
    }

    Json along_joints(const std::vector<Joint>& found) const {
        LeastContact contacts;
        for (const Joint& joint : found)
            contacts.add(joint_contact(left.pieces, right.pieces, joint, projected(), limits));
        Json result = answer_of(*contacts.least, form, false);
        Json::Array edges;
        for (const Joint& joint : found) edges.push_back(edge_json(joint));
        result["edges"] = std::move(edges);
        return result;
    }

    Json geometric(const std::vector<Joint>& found) const;

    /// Errors: `limit_exceeded` for too many pairs of pieces.
    void require_pairs(std::size_t each) const {
        require_product_within({left.pieces.size(), right.pieces.size(), each, 1000}, limits.expansion_work,
                               "expansion_work", "the work of comparing pairs of pieces");
    }

    static Json edge_json(const Joint& joint) {
        return Json::Object{{"left", segment_json(joint.left_segment())},
                            {"right", segment_json(joint.right_segment())}};
    }
    static Json segment_json(const PlaneSegment& segment) {
        return lists_json(std::vector<Coordinates>{segment.begin, segment.end});
    }

private:
    PatchContact contact_of(const PlacedPatch& one, const PlacedPatch& other, const Face& face) const {
        return projected() ? projected_contact(one, other, face, limits) : contact(one, other, face, limits);
    }
    static bool meet(const PlacedPatch& one, const PlacedPatch& other) {
        for (std::size_t f = 0; f < one.frames.size(); ++f) {
            const auto [a, b] = std::ranges::minmax(one.frames[f].vertices());
            const auto [c, d] = std::ranges::minmax(other.frames[f].vertices());
            if (b < c || d < a) return false;
        }
        return true;
    }
    /// In how many directions two boxes have more than a point in common.
    static std::size_t meeting_dimension(std::span<const BarycentricFrame> one,
                                         std::span<const BarycentricFrame> other) {
        std::size_t dimension = 0;
        for (std::size_t f = 0; f < one.size(); ++f) {
            const auto [a, b] = std::ranges::minmax(one[f].vertices());
            const auto [c, d] = std::ranges::minmax(other[f].vertices());
            if (std::max(a, c) < std::min(b, d)) ++dimension;
        }
        return dimension;
    }
};

std::string_view name_of_kind(TangentContact::Kind kind) {
    switch (kind) {
        case TangentContact::Kind::apart:
            return "apart";
        case TangentContact::Kind::bent:
            return "bent";
        case TangentContact::Kind::singular:
            return "singular";
        case TangentContact::Kind::folded:
            return "folded";
        case TangentContact::Kind::smooth:
            return "smooth";
    }
    return "";
}

constexpr std::string_view kind_names[] = {"apart", "bent", "singular", "folded", "smooth"};
constexpr std::string_view function_names[] = {"alpha", "beta", "gamma", "delta"};

std::string text_of_vector(const Coordinates& vector) {
    return point_text(Json::Array(vector.begin(), vector.end()));
}

std::string reason_of(const TangentContact& contact, const Joint& joint) {
    const std::string along = fmt::format("along the edge from {} to {} of the left domain",
                                          text_of_vector(joint.left[0]), text_of_vector(joint.left[1]));
    switch (contact.kind) {
        case TangentContact::Kind::apart:
            return "The surfaces do not meet " + along;
        case TangentContact::Kind::bent:
            return fmt::format(
                "The tangent planes differ {}: at the parameter {} the derivatives {} and {} across it and "
                "{} along "
                "it are independent",
                along, to_string(*contact.parameter), text_of_vector(contact.vectors[0]),
                text_of_vector(contact.vectors[1]), text_of_vector(contact.vectors[2]));
        case TangentContact::Kind::singular:
            return "The derivatives are in one plane " + along +
                   ", but those of one surface alone do not span it everywhere";
        case TangentContact::Kind::folded:
            return "The surfaces have the same tangent planes " + along + ", but lie on the same side of it";
        case TangentContact::Kind::smooth:
            return "The surfaces have the same tangent planes " + along;
    }
    return "";
}

int order_of(const TangentContact& contact) {
    if (contact.kind == TangentContact::Kind::apart) return -1;
    return contact.kind == TangentContact::Kind::smooth ? 1 : 0;
}

Json vector_json(const Coordinates& vector) { return Json::Array(vector.begin(), vector.end()); }

Json SurfacePair::geometric(const std::vector<Joint>& found) const {
    int order = 1;
    std::string reason;
    Json::Array edges;
    for (const Joint& joint : found) {
        const TangentContact contact = tangent_contact(left.pieces, right.pieces, joint, projected(), limits);
        Json edge = edge_json(joint);
        const auto vectors = across(left.pieces, right.pieces, joint);
        edge["across"] = lists_json(vectors);
        edge["kind"] = name_of_kind(contact.kind);
        for (std::size_t j = 0; j < contact.functions.size(); ++j)
            edge[function_names[j]] = to_text(contact.functions[j]);
        if (contact.parameter) {
            edge["parameter"] = *contact.parameter;
            edge["vectors"] = Json::Array{vector_json(contact.vectors[0]), vector_json(contact.vectors[1]),
                                          vector_json(contact.vectors[2])};
        }
        if (contact.kind == TangentContact::Kind::singular) {
            Json::Array parameters;
            for (const Root& root : contact.singular) {
                parameters.push_back(root.is_rational() ? Json(root.lower)
                                                        : Json(Json::Array{root.lower, root.upper}));
            }
            edge["singular"] = std::move(parameters);
        }
        edges.push_back(std::move(edge));
        if (reason.empty() || order_of(contact) < order) reason = reason_of(contact, joint);
        order = std::min(order, order_of(contact));
    }
    return Json::Object{{"order", Json(Json::Number{std::to_string(order)})},
                        {"edges", std::move(edges)},
                        {"reason", std::move(reason)}};
}

/// A segment by its ends, and perhaps a point off it.
NamedEdge read_edge(const Json& value, const Limits& limits) {
    const auto points = read_list(value, [&](const Json& point) { return read_tuple(point, 2, limits); });
    if (points.size() != 2 && points.size() != 3) {
        throw Error(ErrorCode::wrong_arity, "an edge is given by its two ends, and perhaps a point off it; " +
                                                std::to_string(points.size()) + " points are given");
    }
    NamedEdge edge{{points[0], points[1]}, {}};
    if (points.size() == 3) edge.off = points[2];
    return edge;
}

/// The joints of the field "faces".
std::vector<Joint> read_joints(const Json& value, const SurfacePair& maps, const Limits& limits) {
    if (value.text()) {
        constexpr std::string_view words[] = {"found"};
        read_alternative(value, words, "a choice of faces");
        maps.require_pairs(100);
        std::vector<Joint> found = matching_joints(maps.left.pieces, maps.right.pieces, limits);
        if (!found.empty()) return found;
        throw Error(ErrorCode::not_adjacent,
                    "no edge of one map is a part of one of the other with its parameter changed affinely");
    }
    const auto edges = read_list(value, [&](const Json& edge) { return read_edge(edge, limits); });
    if (edges.size() != 2) {
        throw Error(ErrorCode::wrong_arity, "an edge of each of the two maps is needed; " +
                                                std::to_string(edges.size()) + " are given");
    }
    if (edges[0].off.has_value() != edges[1].off.has_value()) {
        throw Error(ErrorCode::wrong_arity, "a point off the edge is given for both maps or for none");
    }
    try {
        return joints(maps.left.pieces, maps.right.pieces, edges[0], edges[1]);
    } catch (const Error& error) {
        if (error.place() == Place(Part::left)) throw error.at(Place{std::size_t{0}});
        if (error.place() == Place(Part::right)) throw error.at(Place{std::size_t{1}});
        throw;
    }
}

/// The joints of domains in one plane. Errors: `not_adjacent`.
std::vector<Joint> joints_in_plane(const SurfacePair& maps) {
    maps.require_pairs(1);
    std::vector<Joint> found = joints(maps.left.pieces, maps.right.pieces);
    if (!found.empty()) return found;
    throw Error(ErrorCode::not_adjacent, "the domains have no part of an edge in common");
}

FieldList edge_members() {
    return {required("left", Shape::list(numbers_shape(), 2, 2), "the ends in the left domain"),
            required("right", Shape::list(numbers_shape(), 2, 2), "the ends in the right domain")};
}

void require_plane(const Surface& surface, std::size_t i) {
    if (surface.is_plane()) return;
    throw Error(ErrorCode::wrong_kind,
                "a map over a triangle of the plane or over a rectangle is needed to compare along edges",
                Place{"maps"} / i);
}

}  // namespace

Json answer_of(const PatchContact& contact, const PointForm& form, bool tensor) {
    const bool divided = form.separate_weights();
    return contact_json(contact, divided ? PointForm{.scalar = form.scalar} : form,
                        divided ? projected_contact_text(contact) : to_string(contact),
                        [&](const auto& arguments) { return points_json(arguments, tensor); });
}

void require_two_sides(const std::vector<Map>& maps) {
    if (maps.size() == 2) return;
    throw Error(ErrorCode::wrong_arity,
                "there are two sides, left and right, not " + std::to_string(maps.size()), Place{"maps"});
}

bool is_surface_map(const Map& map) {
    return std::holds_alternative<Patch>(map.value) || std::holds_alternative<TensorBSpline>(map.value);
}

Json continuity_of_patches(Fields& request, std::vector<Map> maps, const Limits& limits) {
    require_two_sides(maps);
    for (std::size_t i = 0; i < maps.size(); ++i) surface_of(maps[i], i, limits);
    make_form_common(maps, limits);
    const SurfacePair compared{surface_of(maps[0], 0, limits), surface_of(maps[1], 1, limits), maps[0].form,
                               limits};
    const auto require_planes = [&] {
        require_plane(compared.left, 0);
        require_plane(compared.right, 1);
    };
    if (request.has("faces")) require_planes();
    const auto named =
        request.optional("faces", [&](const Json& value) { return read_joints(value, compared, limits); });
    const bool geometric = request.optional("geometric", read_boolean).value_or(false);
    request.finish();

    const bool same_factors = compared.left.is_box() == compared.right.is_box() &&
                              compared.left.domain.size() == compared.right.domain.size();
    const auto shared = [&] { return compared.along_shared_face(compared.left.is_box()); };
    std::optional<std::vector<Joint>> found = named;
    const auto in_plane = [&]() -> const std::vector<Joint>& {
        if (!found) {
            require_planes();
            found = joints_in_plane(compared);
        }
        return *found;
    };
    const auto compare = [&] {
        Json result;
        if (named || !same_factors) {
            result = compared.along_joints(in_plane());
        } else {
            try {
                result = shared();
            } catch (const Error& error) {
                const bool plane = compared.left.is_plane() && compared.right.is_plane();
                if (error.code() != ErrorCode::not_adjacent || !plane || compared.left.is_box()) throw;
                result = compared.along_joints(in_plane());
            }
        }
        if (geometric) result["geometric"] = compared.geometric(in_plane());
        return result;
    };
    return named ? within("faces", compare) : within("maps", compare);
}

Field faces_field() {
    const Shape edge = Shape::list(numbers_shape(), 2, 3);
    return optional("faces", Shape::one_of({Shape::words({"found"}), Shape::list(edge, 2, 2)}),
                    "of two surfaces: for each an edge of its domain, by its two ends, which correspond, and "
                    "perhaps a point off it; or found, for all edges whose curves are the same");
}

Field geometric_field() {
    return optional("geometric", ValueKind::boolean,
                    "of two surfaces: whether their tangent planes are compared too");
}

Option faces_option() {
    const auto read = [](std::string_view text) -> Json {
        if (text == "found") return text;
        Json::Array faces;
        for (const std::string& edge : split(text, '|')) faces.push_back(tuple_list(edge));
        return faces;
    };
    return field_option("--faces", "faces", "A;B|C;D", read);
}

Field edges_member() {
    return optional("edges", Shape::list(Shape::object({edge_members()})),
                    "of surfaces: the segments of the two domains along which they are compared");
}

Field geometric_member() {
    const Field alpha =
        optional("alpha", ValueKind::text, "the factor of the derivative of the left surface");
    const Field singular =
        optional("singular", Shape::list(Shape::one_of({ValueKind::number, ValueKind::interval})),
                 "where the derivatives of one surface alone do not span the plane, each isolated by an "
                 "interval unless it is rational; empty where that is everywhere");
    FieldList members = edge_members();
    for (Field& member : FieldList{
             required("across", Shape::list(numbers_shape(), 2, 2),
                      "the vectors into the two domains in which the derivatives are taken"),
             required("kind", Shape::words(kind_names),
                      "smooth: one tangent plane everywhere; folded: likewise, but on the same side of the "
                      "edge; singular; bent: different planes at `parameter`; apart: the edges differ"),
             alpha, optional("beta", ValueKind::text, "the factor of that of the right surface"),
             optional("gamma", ValueKind::text, "the factor of the derivative along the edge"),
             optional("delta", ValueKind::text, "of homogeneous points: the factor of the point"),
             optional("parameter", ValueKind::number,
                      "where the derivatives are independent, from 0 to 1 along the edge"),
             optional("vectors", tuples_shape(), "the three derivatives there"), singular}) {
        members.push_back(std::move(member));
    }
    return optional(
        "geometric",
        Shape::object(
            {{required("order", ValueKind::integer,
                       "1 where the surfaces have the same tangent planes and go on in them, 0 where "
                       "they only meet, else -1"),
              required("edges", Shape::list(Shape::object({members})),
                       "the segments, with polynomials in t, from 0 to 1 along each, for which alpha X "
                       "+ beta Y + gamma Z = 0 with the derivatives X and Y across the edge and Z "
                       "along it"),
              required("reason", ValueKind::text, "the same as a sentence")}}),
        "with `geometric`: the contact of the tangent planes");
}

}  // namespace blossom::protocol
