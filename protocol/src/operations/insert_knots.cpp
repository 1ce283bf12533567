#include <blossom/core/spline/knot_insertion.hpp>

#include <algorithm>

#include "along_direction.hpp"
#include "listing.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

using Insertion = BSplineCurve (*)(const BSplineCurve& curve, std::span<const Rational> knots,
                                   const Limits& limits);

constexpr std::string_view insertion_method_names[] = {"boehm", "oslo"};
constexpr Insertion insertion_methods[] = {insert_knots_boehm, insert_knots_oslo};

/// Inserts the knots of one direction after the other.
struct InsertKnots {
    Fields& request;
    const Map& map;
    const Limits& limits;

    AnyMap operator()(const BSplineCurve& curve) const {
        const auto knots =
            request.required("knots", [&](const Json& value) { return read_numbers(value, limits); });
        const auto method = read_method();
        const auto multiplicity = read_multiplicity(curve.degree());
        request.finish();
        return inserted(curve, knots, multiplicity, method);
    }
    AnyMap operator()(TensorBSpline spline) const {
        const auto direction = read_direction(request, map, limits);
        const auto read = [&](const Json& list) { return read_numbers(list, limits); };
        const auto knots = request.required("knots", [&](const Json& value) {
            if (!direction) return read_each_direction(value, spline.directions(), "lists of knots", read);
            std::vector<std::vector<Rational>> lists(spline.directions());
            lists[*direction] = read(value);
            return lists;
        });
        std::size_t least_degree = limits.degree;
        for (std::size_t d = 0; d < knots.size(); ++d) {
            if (!knots[d].empty()) least_degree = std::min(least_degree, spline.knots(d).degree());
        }
        const auto method = read_method();
        const auto multiplicity = read_multiplicity(least_degree);
        request.finish();
        within("knots", [&] {
            for (std::size_t d = 0; d < knots.size(); ++d) {
                if (knots[d].empty()) continue;
                const auto insert = [&] {
                    as_parameter(Part::knots, [&] {
                        spline = changed_along(spline, d, [&](const BSplineCurve& rows) {
                            return inserted(rows, knots[d], multiplicity, method);
                        });
                    });
                };
                if (direction) {
                    insert();
                } else {
                    within(d, insert);
                }
            }
        });
        return spline;
    }

private:
    std::optional<std::size_t> read_method() const {
        return request.optional("method", [](const Json& value) {
            return read_alternative(value, insertion_method_names, "a method");
        });
    }
    std::optional<std::size_t> read_multiplicity(std::size_t degree) const {
        return request.optional("multiplicity", [&](const Json& value) {
            const std::size_t multiplicity = read_count(value, limits);
            as_parameter(Part::times, [&] { require_multiplicity(multiplicity, degree); });
            return multiplicity;
        });
    }
    /// With the knots themselves, or with what they need to be there as often as was asked for.
    BSplineCurve inserted(const BSplineCurve& curve, const std::vector<Rational>& knots,
                          const std::optional<std::size_t>& multiplicity,
                          const std::optional<std::size_t>& method) const {
        const std::vector<Rational>& all =
            multiplicity ? missing_knots(curve.knots(), knots, *multiplicity) : knots;
        return method ? insertion_methods[*method](curve, all, limits) : insert_knots(curve, all, limits);
    }
};

Answer answer_insert_knots(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    return answer_of(like(map, dispatch_on_kind<AnyMap>(map, InsertKnots{request, map, limits})));
}

/// "1/2; 1,3": one list per direction, which may be empty, or the only one.
Json lists_of_knots(std::string_view text, const Json& map) {
    const bool several = read_array(*map.find("degrees")).size() > 1;
    if (several && text.find(';') == std::string_view::npos) return number_list(text);
    Json::Array lists;
    for (const std::string& list : split(text, ';')) lists.push_back(number_list(list));
    return lists;
}

}  // namespace

Operation insert_knots_operation() {
    return {
        .summary = "Insert knots into a B-spline without changing the curve",
        .documentation = "The curve stays the same.",
        .request = {{map_field(),
                     required("knots", parameters_shape(),
                              "the knots to insert, in any order, each as often as it is listed; in several "
                              "directions one list each"),
                     optional("multiplicity", ValueKind::count,
                              "how often each of them is there afterwards, at least; by default each is "
                              "inserted once more"),
                     optional("method", Shape::words(insertion_method_names),
                              "the algorithm; by default the faster one"),
                     direction_field(
                         "of a tensor product: the direction of all `knots`, which are one list")}},
        .result = {{map_member("the same B-spline with the knots")}},
        .example = {"insert-knots", "--control-points", "0,0; 1,2; 3,3; 5,1", "--knots", "0,1,2,3,4,5",
                    "--degree", "3", "--insert", "5/2"},
        .options = with_map_options({
            field_option("--insert", "knots", "X1,X2,...", number_list, lists_of_knots,
                         "the knots to insert, in any order, repeated for a higher multiplicity; in several "
                         "directions one list each, separated by ';', or the list of --direction"),
            field_option("--multiplicity", "multiplicity", "M", count),
            word_option("--method", "method"),
            direction_option(),
        }),
        .answer = answer_insert_knots,
        .render = described_listing,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
