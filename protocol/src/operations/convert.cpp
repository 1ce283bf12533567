#include <blossom/core/spline/de_boor.hpp>
#include <blossom/rational/lists.hpp>

#include <algorithm>
#include <iterator>

#include "json/nearest_name.hpp"
#include "listing.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "patch_answers.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "segment.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

/// The kinds to which curves are converted.
std::vector<const Kind*> target_kinds() {
    std::vector<const Kind*> targets;
    std::ranges::copy_if(Kinds::all, std::back_inserter(targets),
                         [](const Kind* kind) { return !kind->target.word.empty(); });
    return targets;
}

std::vector<std::string_view> target_words() {
    return mapped(target_kinds(), [](const Kind* kind) { return kind->target.word; });
}

const Kind& read_target(const Json& value) {
    return *target_kinds()[read_alternative(value, target_words(), "a basis")];
}

struct Conversion {
    Target::Convert convert;
    std::optional<std::size_t> span;
    bool keeps_splines;
    const Limits& limits;

    AnyMap operator()(const OnePolynomial auto& curve) const {
        return convert(polynomial_map(curve, limits), interval_of(curve), limits);
    }
    AnyMap operator()(const Samples& samples) const { return (*this)(curve_of_samples(samples, limits)); }
    AnyMap operator()(const BSplineCurve& curve) const {
        if (keeps_splines) return curve;
        return (*this)(segment(curve, chosen_span(curve, span)));
    }
};

Answer convert_curve(Fields& request, const Map& map, const Limits& limits) {
    const Kind& to = request.required("to", read_target);
    Target::Convert convert = to.target.read(request, limits);
    const auto span = read_span(request, map, limits);
    request.finish();
    const bool keeps_splines = &to == &kind_of(map) && !span && !request.has("interval");
    const Conversion conversion{std::move(convert), span, keeps_splines, limits};
    return answer_of(like(map, dispatch_on_kind<AnyMap>(map, conversion)));
}

/// Of each target its own fields.
Members request() {
    const std::string basis = "the new basis; tensor and simplex are forms of patches";
    Choice targets;
    for (const Kind* kind : target_kinds()) {
        const Target& target = kind->target;
        FieldList fields{required("to", Shape::words({target.word}), basis)};
        if (target.over_interval) {
            fields.push_back(optional("interval", ValueKind::interval,
                                      "for a curve: the interval; by default that of the map"));
        }
        if (!target.field.name.empty()) {
            fields.push_back(
                optional(target.field.name,
                         target.field.is_list ? Shape::list(ValueKind::count, 2, 2) : ValueKind::number,
                         std::string(target.field.help)));
        }
        targets.push_back(std::move(fields));
    }
    targets.push_back(
        {required("to", Shape::words(net_form_names), basis), vertices_field(), intervals_field(),
         optional("degree", ValueKind::count, "for a simplex: the new formal degree"), degrees_field()});
    return {{map_field(), segment_field()}, {std::move(targets)}};
}

std::vector<Option> options() {
    std::vector<Option> all{
        word_option("--to", "to"),
        own_interval_option(
            "the interval of the given control points, or else of the new ones; by default 0,1"),
        field_option("--over", "interval", "A,B", number_list, "the interval of the new control points")};
    for (const Kind* kind : target_kinds()) {
        const TargetField& field = kind->target.field;
        if (field.name.empty()) continue;
        const std::string name(field.name);
        all.push_back(field_option("--" + name, name, std::string(field.value),
                                   field.is_list ? number_list : plain_text));
    }
    std::ranges::move(std::vector{field_option("--vertices", "vertices", "P0;P1;...", tuple_list),
                                  field_option("--intervals", "intervals", "A,B;C,D;...", tuple_list),
                                  wanted_degrees_option(), segment_option()},
                      std::back_inserter(all));
    return with_map_options(std::move(all));
}

}  // namespace

Operation convert_operation() {
    return {
        .name = "convert",
        .summary = "Convert a map to another basis or form",
        .documentation = "A spline is converted segment by segment.",
        .request = request(),
        .result = {{map_member("the same map in the new basis")}},
        .example = {"convert", "--control-points", "1; 5/3; 11/3; 6", "--to", "monomial"},
        .options = options(),
        .answer = answer_by_shape<convert_curve, convert_patch, convert_tensor_bspline>,
        .render = described_listing,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
