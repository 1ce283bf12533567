#include <fmt/format.h>
#include <blossom/core/nurbs/rational_spline.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/continuity.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include "blossom_arguments.hpp"
#include "map_list.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "patch_answers.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

Json order_json(const std::optional<std::ptrdiff_t>& order) {
    return order ? Json(Json::Number{std::to_string(*order)}) : Json("infinite");
}

Json to_json(const Argument& argument) {
    if (argument.mass == Rational(1)) return argument.u;
    return Json::Object{{"homogeneous", Json::Array{argument.u, argument.mass}}};
}

Json answer_of(const Contact& contact, const PointForm& form, const Rational& s) {
    Json result = Json::Object{{"order", order_json(contact.order)}};
    if (const auto& difference = contact.first_difference) {
        Json::Array arguments;
        for (const Argument& argument : difference->arguments) arguments.push_back(to_json(argument));
        result["first_difference"] = Json::Object{{"arguments", std::move(arguments)},
                                                  {"left", protocol::to_json(difference->left, form)},
                                                  {"right", protocol::to_json(difference->right, form)}};
    }
    result["reason"] = to_string(contact, s);
    return result;
}

/// Of maps that are divided by their weights. Blossom values of these are not compared, but derivatives.
Json answer_of(const ProjectedContact& contact, const PointForm& form, const Rational& s) {
    Json result = Json::Object{{"order", order_json(contact.order)}};
    if (!contact.order) {
        result["reason"] = "The curves are the same rational map at " + to_string(s);
        return result;
    }
    const PointForm of_points{.scalar = form.scalar};
    const Json left = protocol::to_json(contact.first_difference->first, of_points);
    const Json right = protocol::to_json(contact.first_difference->second, of_points);
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

Json continuity_of_maps(std::vector<Map> maps, const Rational& s, const Limits& limits) {
    if (maps.size() != 2) {
        throw Error(ErrorCode::wrong_arity,
                    "there are two sides, left and right, not " + std::to_string(maps.size()), Place{"maps"});
    }
    make_form_common(maps, limits);
    const PointForm& form = maps.front().form;
    const auto left = dispatch_on_kind<PolynomialMap>(maps[0], OneSide{s, true, limits}, Place{"maps"} / 0);
    const auto right = dispatch_on_kind<PolynomialMap>(maps[1], OneSide{s, false, limits}, Place{"maps"} / 1);
    return within("at", [&] {
        return form.separate_weights() ? answer_of(projected_contact(left, right, s, limits), form, s)
                                       : answer_of(contact(left, right, s, limits), form, s);
    });
}

Json continuity_of_spline(const Map& map, const Rational& s, const Limits& limits) {
    return dispatch_on_kind<Json>(map, [&](const BSplineCurve& curve) {
        return map.form.separate_weights() ? answer_of(projected_contact(curve, s, limits), map.form, s)
                                           : answer_of(contact(curve, s, limits), map.form, s);
    });
}

Answer answer(Request& request, const Limits& limits) {
    const auto read_at = [&] {
        const Rational s =
            request.required("at", [&](const Json& value) { return read_number(value, limits); });
        request.finish();
        return s;
    };
    if (!request.has("maps")) {
        const Map& map = request.map(limits);
        return tensor_bspline_of(map) ? continuity_of_tensor_bspline(request, map, limits)
                                      : continuity_of_spline(map, read_at(), limits);
    }
    std::vector<Map> maps = read_maps_field(request, limits);
    if (std::ranges::any_of(maps, patch_of)) return continuity_of_patches(request, std::move(maps), limits);
    const Rational s = read_at();
    return continuity_of_maps(std::move(maps), s, limits);
}

std::string render(const Answered& answered) {
    std::string text = answered.has_given() ? description(answered.given()) + "\n\n" : "";
    return text + fmt::format("Order of contact: {}\n{}.\n",
                              answered.style.bold(point_text(*answered.result().find("order"))),
                              *answered.result().find("reason")->text());
}

Members request() {
    return {{},
            {{{map_field(),
               required("at", Shape::one_of({ValueKind::number, cut_shape()}),
                        "the parameter; in several directions a number in one and null in the others")},
              {maps_field("two curves, left and right, or two patches with a common face"),
               optional("at", ValueKind::number, "the parameter at which two curves meet")}}}};
}

Members result() {
    const Field left = required("left", ValueKind::point, "the value on the left");
    const Field right = required("right", ValueKind::point, "the value on the right");
    const Members difference{
        {left, right},
        {{{arguments_field(Presence::required, "the arguments at which the blossoms differ")},
          {required("derivative", ValueKind::count, "the order of the derivatives that differ")}}}};
    return {{required("order", Shape::one_of({ValueKind::integer, Shape::words({"infinite"})}),
                      "the order of contact; -1 where the sides do not meet, infinite for one map"),
             optional("first_difference", Shape::object(difference), "the first values that differ"),
             required("reason", ValueKind::text, "the same as a sentence")}};
}

}  // namespace

Operation continuity_operation() {
    return {
        .name = "continuity",
        .summary =
            "Find the order of continuity of a spline at a knot, or of two curves or patches, with the "
            "reason",
        .documentation = "The order is the greatest k for which the derivatives of orders 0 to k agree.",
        .request = request(),
        .result = result(),
        .example = {"continuity", "--control-points", "0; 1; 4; 5; 9", "--knots", "0,0,0,1,2,3,3,3",
                    "--degree", "2", "--at", "1"},
        .options = with_map_options({
            maps_option("--maps",
                        "instead of a spline: a list of two curves, left and right, as maps of the protocol, "
                        "or the output of 'subdivide --json'"),
            field_option("--at", "at", "T", plain_text, place_of_division,
                         "the parameter; in several directions a number for one and - for the others"),
        }),
        .answer = answer,
        .render = render,
    };
}

}  // namespace blossom::protocol
