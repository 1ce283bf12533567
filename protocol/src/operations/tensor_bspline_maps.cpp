// Tensor products of B-splines made of others: parts, refinement, degree raising, Bezier patches.

#include <fmt/format.h>
#include <blossom/core/patch/patch_elevation.hpp>
#include <blossom/core/patch/tensor_bspline_change.hpp>

#include "patch_answers.hpp"

namespace blossom::protocol {

namespace {

/// One entry a direction. Errors: `wrong_arity`.
template <class Read>
auto read_each_direction(const Json& value, const TensorBSpline& spline, const std::string& what,
                         const Read& read) {
    auto list = read_list(value, read);
    if (list.size() == spline.directions()) return list;
    throw Error(ErrorCode::wrong_arity,
                fmt::format("{} {} for {} directions", list.size(), what, spline.directions()));
}

/// The errors of rows, whose fields are those of a curve, are about an element of the request.
template <class Action>
auto at_own_place(const Action& action) {
    try {
        return action();
    } catch (const Error& error) {
        throw Error(error.code(), error.message());
    }
}

/// Of B-splines in all directions: one Bezier patch where there is only one box, otherwise the spline.
AnyMap bezier_or_spline(const TensorBSpline& spline, const Limits& limits) {
    std::vector<std::size_t> spans;
    for (const KnotVector& knots : spline.knots()) {
        const auto own = knots.spans();
        if (own.size() > 1) return spline;
        spans.push_back(own.front());
    }
    return segment_patch(spline, spans, limits);
}

TensorBSpline elevated_to(TensorBSpline spline, const std::vector<std::size_t>& degrees,
                          const Limits& limits) {
    for (std::size_t d = 0; d < degrees.size(); ++d) {
        const std::size_t own = spline.knots(d).degree();
        if (degrees[d] < own) {
            throw Error(
                ErrorCode::degree_too_low,
                fmt::format("the B-splines of direction {} have degree {}, above {}", d, own, degrees[d]),
                Place{"degrees"} / d);
        }
        spline = elevate(spline, d, degrees[d] - own, limits);
    }
    return spline;
}

}  // namespace

Answer control_net_of_tensor_bspline(Fields& request, const Map& map, const Limits& limits) {
    TensorBSpline part = *tensor_bspline_of(map);
    const auto intervals = request.optional("intervals", [&](const Json& value) {
        return read_each_direction(value, part, "intervals",
                                   [&](const Json& element) { return read_interval(element, limits); });
    });
    const auto degrees = request.optional("degrees", [&](const Json& value) {
        return read_each_direction(value, part, "degrees",
                                   [&](const Json& element) { return read_count(element, limits); });
    });
    request.finish();
    for (std::size_t d = 0; intervals && d < intervals->size(); ++d) {
        within("intervals", [&] {
            within(d, [&] {
                part = at_own_place([&] { return restricted(part, d, (*intervals)[d], limits); });
            });
        });
    }
    if (degrees) part = elevated_to(std::move(part), *degrees, limits);
    return answer_of(like(map, bezier_or_spline(part, limits)));
}

Answer insert_knots_of_tensor_bspline(Fields& request, const Map& map, const Limits& limits) {
    TensorBSpline refined = *tensor_bspline_of(map);
    const auto knots = request.required("knots", [&](const Json& value) {
        return read_each_direction(value, refined, "lists of knots",
                                   [&](const Json& element) { return read_numbers(element, limits); });
    });
    request.finish();
    for (std::size_t d = 0; d < knots.size(); ++d) {
        within("knots", [&] {
            within(d, [&] {
                if (knots[d].empty()) return;
                as_parameter(Part::knots, [&] { refined = insert_knots(refined, d, knots[d], limits); });
            });
        });
    }
    return answer_of(like(map, std::move(refined)));
}

Answer segments_of_tensor_bspline(Fields& request, const Map& map, const Limits& limits) {
    const TensorBSpline& spline = *tensor_bspline_of(map);
    request.finish();
    std::vector<Map> maps;
    for (const auto& spans : boxes_of(spline, limits))
        maps.push_back(like(map, segment_patch(spline, spans, limits)));
    return answer_of(std::move(maps));
}

Answer subdivide_tensor_bspline(Fields& request, const Map& map, const Limits& limits) {
    const TensorBSpline& spline = *tensor_bspline_of(map);
    const auto at = request.required("at", [&](const Json& value) {
        return read_each_direction(value, spline, "entries", [&](const Json& element) {
            return element.is_null() ? std::nullopt : std::optional(read_number(element, limits));
        });
    });
    request.finish();
    std::vector<TensorBSpline> parts{spline};
    for (std::size_t d = 0; d < at.size(); ++d) {
        if (!at[d]) continue;
        std::vector<TensorBSpline> finer;
        for (const TensorBSpline& part : parts) {
            auto [left, right] = within("at", [&] {
                return within(d,
                              [&] { return at_own_place([&] { return split(part, d, *at[d], limits); }); });
            });
            finer.push_back(std::move(left));
            finer.push_back(std::move(right));
        }
        parts = std::move(finer);
    }
    std::vector<Map> maps;
    maps.reserve(parts.size());
    for (TensorBSpline& part : parts) maps.push_back(like(map, std::move(part)));
    return answer_of(std::move(maps), "at");
}

Answer convert_tensor_bspline(Fields& request, const Map& map, const Limits& limits) {
    const auto to = request.optional("to", [](const Json& value) { return value; });
    const std::string* word = to ? to->text() : nullptr;
    if (!request.has("segment") && word && *word == "bspline") {
        request.finish();
        return answer_of(map);
    }
    return convert_patch(request, chosen_segment(request, map, limits), limits);
}

Answer elevate_tensor_bspline(Fields& request, const Map& map, const Limits& limits) {
    TensorBSpline raised = *tensor_bspline_of(map);
    const auto by = request.required("by", [&](const Json& value) {
        const auto read = [&](const Json& element) { return read_count(element, limits); };
        if (!value.array()) return std::vector<std::size_t>(raised.directions(), read(value));
        return read_each_direction(value, raised, "numbers", read);
    });
    request.finish();
    for (std::size_t d = 0; d < by.size(); ++d) raised = elevate(raised, d, by[d], limits);
    return answer_of(like(map, std::move(raised)));
}

}  // namespace blossom::protocol
