#include <fmt/format.h>
#include <blossom/core/nurbs/rational_spline.hpp>
#include <blossom/core/patch/patch_contact.hpp>
#include <blossom/core/patch/tensor_bspline_contact.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/continuity.hpp>
#include <blossom/core/spline/periodic_spline.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include "blossom_arguments.hpp"
#include "contact_order.hpp"
#include "map_list.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "maps/parameters.hpp"
#include "patch_continuity.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

Json arguments_json(std::span<const Argument> arguments) {
    Json::Array list;
    for (const auto& [u, mass] : arguments) {
        list.push_back(mass == Rational(1) ? Json(u)
                                           : Json(Json::Object{{"homogeneous", Json::Array{u, mass}}}));
    }
    return list;
}

Json answer_of(const Contact& contact, const PointForm& form, const Rational& s) {
    return contact_json(contact, form, to_string(contact, s),
                        [](const auto& arguments) { return arguments_json(arguments); });
}

/// The contact of maps that are divided by their weights, by their derivatives.
Json answer_of(const ProjectedContact& contact, const PointForm& form, const Rational& s) {
    Json result = Json::Object{{"order", order_json(contact.order)}};
    if (!contact.order) {
        result["reason"] = "The curves are the same rational map at " + to_string(s);
        return result;
    }
    const PointForm of_points{.scalar = form.scalar};
    const Json left = to_json(contact.first_difference->first, of_points);
    const Json right = to_json(contact.first_difference->second, of_points);
    const auto differing = static_cast<std::size_t>(*contact.order + 1);
    result["first_difference"] = Json::Object{{"derivative", differing}, {"left", left}, {"right", right}};
    result["reason"] =
        fmt::format("{}: the derivatives of order {} are {} and {}", contact_text(*contact.order, s),
                    differing, point_text(left), point_text(right));
    return result;
}

/// A polynomial on one side of s.
struct OneSide {
    const Rational& s;
    bool left;
    const Limits& limits;

    PolynomialMap operator()(const OnePolynomial auto& curve) const { return polynomial_map(curve, limits); }
    PolynomialMap operator()(const BSplineCurve& curve) const {
        return within("at", [&] {
            const KnotVector& knots = curve.knots();
            return sablonniere(curve, left ? knots.span_before(s) : knots.span_at(s), limits);
        });
    }
};

Rational read_at(Fields& request, const Limits& limits) {
    const Rational s = request.required("at", [&](const Json& value) { return read_number(value, limits); });
    request.finish();
    return s;
}

Json continuity_of_curves(const std::vector<Map>& maps, const Rational& s, const Limits& limits) {
    const PointForm& form = maps.front().form;
    const auto left = dispatch_on_kind<PolynomialMap>(maps[0], OneSide{s, true, limits}, Place{"maps"} / 0);
    const auto right = dispatch_on_kind<PolynomialMap>(maps[1], OneSide{s, false, limits}, Place{"maps"} / 1);
    return within("at", [&] {
        return form.separate_weights() ? answer_of(projected_contact(left, right, s, limits), form, s)
                                       : answer_of(contact(left, right, s, limits), form, s);
    });
}

Json continuity_of_maps(Fields& request, const Limits& limits) {
    std::vector<Map> maps = read_maps_field(request, limits);
    const bool patches = std::ranges::any_of(maps, is_surface_map);
    if (patches) return continuity_of_patches(request, std::move(maps), limits);
    const Rational s = read_at(request, limits);
    require_two_sides(maps);
    make_form_common(maps, limits);
    return continuity_of_curves(maps, s, limits);
}

/// The continuity at a knot; in several directions "at" has null for the others.
struct AtKnot {
    Fields& request;
    const PointForm& form;
    const Limits& limits;

    Json operator()(const BSplineCurve& curve) const {
        const Json& at = *request.required("at", [](const Json& value) { return &value; });
        if (at.text() && *at.text() == "seam") return at_seam(curve);
        const Rational s = read_at(request, limits);
        return form.separate_weights() ? answer_of(projected_contact(curve, s, limits), form, s)
                                       : answer_of(contact(curve, s, limits), form, s);
    }
    Json operator()(const TensorBSpline& spline) const {
        const Json* entry = nullptr;
        const std::size_t direction = request.required("at", [&](const Json& value) {
            std::vector<std::size_t> given;
            read_each_direction(value, spline.directions(), "entries", [&](const Json& element) {
                const auto index = static_cast<std::size_t>(&element - value.array()->data());
                if (!element.is_null()) given.push_back(index);
                return 0;
            });
            if (given.size() != 1) {
                throw Error(ErrorCode::wrong_arity,
                            "a knot is a number in one direction, with null in the others");
            }
            entry = &(*value.array())[given.front()];
            return given.front();
        });
        request.finish();
        const bool divided = form.separate_weights();
        return within("at", [&] {
            return within(direction, [&] {
                if (entry->text() && *entry->text() == "seam") {
                    return answer_of(divided ? projected_seam_contact(spline, direction, limits)
                                             : seam_contact(spline, direction, limits),
                                     form, true);
                }
                const Rational s = read_number(*entry, limits);
                return as_parameter(Part::at, [&] {
                    return answer_of(divided ? projected_contact(spline, direction, s, limits)
                                             : contact(spline, direction, s, limits),
                                     form, true);
                });
            });
        });
    }

private:
    Json at_seam(const BSplineCurve& curve) const {
        request.finish();
        const Rational seam = curve.knots().domain().b();
        return form.separate_weights() ? answer_of(projected_seam_contact(curve, limits), form, seam)
                                       : answer_of(seam_contact(curve, limits), form, seam);
    }
};

Answer answer_continuity(Request& request, const Limits& limits) {
    if (request.has("maps")) return continuity_of_maps(request, limits);
    const Map& map = request.map(limits);
    return dispatch_on_kind<Json>(map, AtKnot{request, map.form, limits});
}

std::string render_continuity(const Answered& answered) {
    std::string text = answered.has_given() ? description(answered.given()) + "\n\n" : "";
    const auto add = [&](const char* what, const Json& contact) {
        text += fmt::format("{}: {}\n{}.\n", what, answered.style.bold(point_text(*contact.find("order"))),
                            *contact.find("reason")->text());
    };
    add("Order of contact", answered.result());
    if (const Json* geometric = answered.result().find("geometric"))
        add("\nOrder of geometric contact", *geometric);
    return text;
}

Members continuity_fields() {
    return {{},
            {{{map_field(),
               required("at",
                        Shape::one_of({ValueKind::number, Shape::words({"seam"}),
                                       Shape::list(Shape::one_of(
                                           {ValueKind::number, Shape::words({"seam"}), ValueKind::null}))}),
                        "the parameter, or seam where a map ends and begins again; in several directions one "
                        "of them in one and null in the others")},
              {maps_field("two curves, left and right, or two patches with a common face"),
               optional("at", ValueKind::number, "the parameter at which two curves meet"), faces_field(),
               geometric_field()}}}};
}

Members continuity_result() {
    const Field left = required("left", ValueKind::point, "the value on the left");
    const Field right = required("right", ValueKind::point, "the value on the right");
    const Members difference{
        {left, right},
        {{{arguments_field(Presence::required, "the arguments at which the blossoms differ")},
          {required("derivative", ValueKind::count, "the order of the derivatives that differ")}}}};
    return {
        {required("order", order_shape(),
                  "the order of contact; -1 where the sides do not meet, infinite for one map"),
         optional("face", Shape::list(Shape::list(ValueKind::number)),
                  "of boxes that meet along a part of a side, the ends of the common part in each direction; "
                  "the order is that along this part"),
         edges_member(), geometric_member(),
         optional("first_difference", Shape::object(difference), "the first values that differ"),
         required("reason", ValueKind::text, "the same as a sentence")}};
}

}  // namespace

Operation continuity_operation() {
    return {
        .summary =
            "Find the order of continuity of a spline at a knot, or of two curves or patches, with the "
            "reason",
        .documentation = "The order is the greatest k for which the derivatives of orders 0 to k agree.",
        .request = continuity_fields(),
        .result = continuity_result(),
        .example = {"continuity", "--control-points", "0; 1; 4; 5; 9", "--knots", "0,0,0,1,2,3,3,3",
                    "--degree", "2", "--at", "1"},
        .options = with_map_options({
            maps_option("--maps",
                        "instead of a spline: a list of two curves, left and right, as maps of the protocol, "
                        "or the output of 'subdivide --json'"),
            field_option("--at", "at", "T", plain_text, place_of_division,
                         "the parameter, or seam for the end and the beginning; in several directions a "
                         "number for one "
                         "and - for the others"),
            faces_option(),
            flag_option("--geometric", "geometric"),
        }),
        .answer = answer_continuity,
        .render = render_continuity,
    };
}

}  // namespace blossom::protocol
