#include <fmt/format.h>
#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/degree_reduction.hpp>
#include <blossom/core/patch/patch_reduction.hpp>
#include <blossom/core/spline/spline_reduction.hpp>
#include <blossom/rational/lists.hpp>

#include "control_nets.hpp"
#include "listing.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "maps/parameters.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

constexpr ReductionMethod all_methods[] = {ReductionMethod::inverse_formula, ReductionMethod::least_squares,
                                           ReductionMethod::least_squares_endpoints,
                                           ReductionMethod::uniform};

std::vector<std::string_view> reduction_method_names() { return mapped(all_methods, reduction_method_name); }

ReductionMethod read_method(const Json& value) {
    return all_methods[read_alternative(value, reduction_method_names(), "a method")];
}

struct Reduced {
    AnyMap map;
    bool exact;
    Rational l2_squared;
    Coordinates maximum;
};

/// Runs `action`, in which only the method can be of a wrong kind.
template <class Action>
auto with_method(const Action& action) {
    try {
        return action();
    } catch (const Error& error) {
        if (error.code() != ErrorCode::wrong_kind) throw;
        throw error.at(Place{"method"});
    }
}

struct Reduce {
    std::span<const std::size_t> degrees;  ///< one number per factor
    ReductionMethod method = ReductionMethod::least_squares;
    std::optional<Interval> interval;
    const Limits& limits;

    Reduced operator()(const OnePolynomial auto& curve) const {
        const Interval where = interval.value_or(interval_of(curve));
        Reduction reduction =
            reduce(control_points(polynomial_map(curve, limits), where, limits), degrees[0], method, limits);
        return {reduction.curve, reduction.exact, reduction.l2_squared, std::move(reduction.maximum)};
    }
    Reduced operator()(const BSplineCurve& curve) const {
        require_own_domain("a spline");
        SplineReduction reduction = reduce(curve, degrees[0], method, limits);
        return {reduction.curve, reduction.exact, reduction.l2_squared, std::move(reduction.maximum)};
    }
    Reduced operator()(const Patch& patch) const {
        require_own_domain("a patch");
        Patch net = as_net(patch, limits);
        PatchReduction reduction = with_method(
            [&] { return reduce(std::get<BezierPatch>(net.map), net.frames, degrees, method, limits); });
        const bool exact = reduction.exact();
        net.map = std::move(reduction.patch);
        return {std::move(net), exact, std::move(reduction.l2_squared), {}};
    }
    Reduced operator()(const TensorBSpline& spline) const {
        require_own_domain("a spline");
        TensorReduction reduction = with_method([&] { return reduce(spline, degrees, method, limits); });
        const bool exact = reduction.l2_squared.is_zero();
        return {std::move(reduction.spline), exact, std::move(reduction.l2_squared), {}};
    }

private:
    void require_own_domain(const std::string& what) const {
        if (!interval) return;
        throw Error(ErrorCode::unknown_field, what + " is reduced over its whole domain", Place{"interval"});
    }
};

/// A number, or one per direction.
std::vector<std::size_t> read_lower_degrees(const Json& value, const ParameterForm& form,
                                            const Limits& limits) {
    const auto read = [&](const Json& element) { return read_count(element, limits); };
    if (form.scalar || !value.array()) return std::vector(form.factors, read(value));
    return read_each_direction(value, form.factors, "degrees", read);
}

Json lower_degrees(std::string_view text, const Json&) {
    return text.find(',') == std::string_view::npos ? count(text) : number_list(text);
}

Answer answer_reduce(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const auto degrees = request.required(
        "to", [&](const Json& value) { return read_lower_degrees(value, parameter_form(map), limits); });
    const auto method = request.optional("method", read_method).value_or(ReductionMethod::least_squares);
    const auto interval =
        request.optional("interval", [&](const Json& value) { return read_interval(value, limits); });
    request.finish();
    const auto reduced = dispatch_on_kind<Reduced>(map, Reduce{degrees, method, interval, limits});
    Json error;
    // The error is that of the coordinates that were reduced, weights included.
    const PointForm form{.scalar = map.form.scalar && !map.form.rational};
    if (!reduced.maximum.empty()) error["maximum"] = to_json(reduced.maximum, form);
    error["l2_squared"] = reduced.l2_squared;
    Answer answer = answer_of(like(map, reduced.map));
    answer.result["exact"] = reduced.exact;
    answer.result["error"] = std::move(error);
    return answer;
}

std::string render_reduce(const Answered& answered) {
    std::string text = described_listing(answered) + "\n";
    if (*answered.result().find("exact")->boolean())
        return text + answered.style.good("Nothing was lost: this is the same map.") + "\n";
    const Json& error = *answered.result().find("error");
    text += fmt::format("Integral of the squared error: {}\n", member_text(error, "l2_squared"));
    if (error.find("maximum")) text += fmt::format("Greatest error: {}\n", member_text(error, "maximum"));
    return text;
}

}  // namespace

Operation reduce_operation() {
    return {
        .summary = "Approximate a curve or patch by one of lower degree, with the exact error",
        .documentation = "The segments of a spline are reduced one by one.",
        .request = {{map_field(),
                     required("to", Shape::one_of({ValueKind::count, counts_shape()}),
                              "the new degree; for a tensor product it may be one number per direction"),
                     optional("method", Shape::words(reduction_method_names()),
                              "the method; by default least-squares"),
                     optional("interval", ValueKind::interval,
                              "where the error is measured; by default the interval of the map, or [0, 1]")}},
        .result = {{map_member("the map of lower degree"),
                    required("exact", ValueKind::boolean, "whether it is the same map"),
                    required(
                        "error",
                        Shape::object({{required("l2_squared", ValueKind::number,
                                                 "the integral of the squared distance"),
                                        optional("maximum", ValueKind::point,
                                                 "for uniform: the greatest distance in each coordinate")}}),
                        "the distance of the two, with weights as coordinates")}},
        .example = {"reduce", "t^3", "--to", "2", "--method", "uniform"},
        .options = with_map_options({
            field_option("--to", "to", "M", count, lower_degrees),
            word_option("--method", "method"),
            own_interval_option(
                "the interval of the given control points, or else that of the error; by default 0,1"),
            field_option("--over", "interval", "A,B", number_list, "the interval of the error"),
        }),
        .answer = answer_reduce,
        .render = render_reduce,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
