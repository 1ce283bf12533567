#include <fmt/format.h>
#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/core/blossom/agreement.hpp>

#include "blossom_arguments.hpp"
#include "construction_results.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "patch_answers.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

std::string_view readable_name(std::string_view construction) {
    if (construction == construction_name(Construction::symmetric)) return "symmetric functions";
    if (construction == construction_name(Construction::regrouped_polarization))
        return "regrouped polarization";
    if (construction == construction_name(Construction::casteljau)) return "de Casteljau";
    return construction;
}

std::size_t degree_of(const PolynomialMap& map) {
    return std::visit([](const auto& curve) { return curve.degree(); }, map);
}

Json agree_for_all_arguments(const PolynomialMap& map, const PointForm& form, const Limits& limits) {
    const std::size_t degree = degree_of(map);
    const auto agreement = within("map", [&] { return agreement_for_all_arguments(map, limits); });
    const Json elementary =
        expansion_texts(elementary_symmetric_form(map, limits), form, numbered_names("e", degree));
    return agreement_for_all(agreement, {{"degree", degree}, {"elementary", elementary}}, form,
                             numbered_names("u", degree));
}

Answer agree_on_curve(Fields& request, const Map& map, const Limits& limits) {
    const auto arguments = request.optional(
        "arguments", [&](const Json& value) { return read_arguments(value, map.form, limits); });
    request.finish();
    const PolynomialMap curve = one_polynomial(map, limits);
    if (!arguments) return agree_for_all_arguments(curve, map.form, limits);
    return agreement_at_arguments(agreement(curve, *arguments, limits), {{"degree", degree_of(curve)}},
                                  map.form);
}

/// The names of the constructions that have a value.
std::vector<std::string_view> names_of_those_run(const Json& values) {
    std::vector<std::string_view> names;
    for (const Construction construction : all_constructions) {
        const std::string_view name = construction_name(construction);
        if (values.find(name)) names.push_back(name);
    }
    return names;
}

std::string values_text(const Answered& answered, const std::string& arguments) {
    std::string text;
    const Json& values = *answered.result().find("values");
    const std::vector<std::string_view> names = names_of_those_run(values);
    std::size_t width = 21;
    for (const std::string_view name : names) width = std::max(width, readable_name(name).size());
    for (const std::string_view name : names) {
        text += fmt::format("  {:<{}} p({}) = {}\n", readable_name(name), width, arguments,
                            answered.style.bold(member_text(values, name)));
    }
    return text;
}

std::string expression_text(const Json& expressions) {
    if (const std::string* text = expressions.text()) return *text;
    return point_text(expressions);
}

std::string expansion_text(const Answered& answered) {
    const std::size_t degree = read_count(*answered.result().find("degree"), answered.limits);
    std::string arguments;
    for (const std::string& name : numbered_names("u", degree))
        arguments += (arguments.empty() ? "" : ", ") + name;
    const std::string left = fmt::format("  p({})", arguments);
    const std::string below(left.size(), ' ');
    std::string text =
        fmt::format("{} = {}\n{} = {}\n", left, expression_text(*answered.result().find("elementary")), below,
                    expression_text(*answered.result().find("expansion")));
    if (const Json* expansions = answered.result().find("expansions")) {
        for (const auto& [construction, expansion] : *expansions->object()) {
            text += fmt::format("  {:<21} {}\n", readable_name(construction), expression_text(expansion));
        }
    }
    if (degree > 0) text += "where e1, e2, ... are the elementary symmetric functions of the arguments.\n";
    return text;
}

/// "The three constructions agree exactly, for all arguments."
std::string verdict(const Answered& answered) {
    const bool agree = *answered.result().find("agree")->boolean();
    const bool for_all = answered.result().find("for_all_arguments") != nullptr;
    std::string text;
    for (const Json& entry : *answered.result().find("skipped")->array()) {
        text += fmt::format("Skipped: {}: {}.\n", readable_name(*entry.find("construction")->text()),
                            *entry.find("reason")->text());
    }
    if (!agree) {
        return text + answered.style.bad("The constructions DISAGREE.") +
               "\nThis is an error of the program. To reproduce it, as one line of a batch:\n" +
               to_text(answered.request) + "\n";
    }
    const Json* values = answered.result().find("values");
    const std::string_view who = text.empty() ? "The three constructions agree exactly"
                                 : values != nullptr && names_of_those_run(*values).size() > 2
                                     ? "The three constructions that were run agree exactly"
                                     : "The two constructions that were run agree exactly";
    return text + answered.style.good(fmt::format("{}{}.", who, for_all ? ", for all arguments" : "")) + "\n";
}

std::string render(const Answered& answered) {
    const Json* arguments = answered.request.find("arguments");
    return fmt::format("{}\n\n{}\n{}", description(answered.given()),
                       arguments                     ? values_text(answered, arguments_text(*arguments))
                       : has_patch(answered.request) ? patch_expansion_text(answered)
                                                     : expansion_text(answered),
                       verdict(answered));
}

Members result() {
    const Shape texts = Shape::one_of({ValueKind::text, Shape::list(ValueKind::text, 1)});
    FieldList values;
    for (const std::string_view name : construction_names())
        values.push_back(optional(name, ValueKind::point, "the value by this construction"));
    const Field skipped = required(
        "skipped",
        Shape::list(Shape::object({{required("construction", construction_shape(), "the construction"),
                                    required("reason", ValueKind::text, "why it did not run")}})),
        "the constructions that did not run");
    return {
        {required("agree", ValueKind::boolean,
                  "whether at least two constructions ran and all that ran gave the same result"),
         degree_member(), degrees_member(), skipped},
        {{{required("values", Shape::object({values}), "with `arguments`: the value by each construction")},
          {required("for_all_arguments", ValueKind::boolean,
                    "without `arguments`: whether the constructions agree as polynomials"),
           required("expansion", texts,
                    "this polynomial in the symbols for the arguments, one per coordinate"),
           optional("elementary", texts, "the same in the elementary symmetric functions, of a curve"),
           optional("expansions", Shape::names(texts),
                    "where they do not agree: the polynomial by each construction")}}}};
}

}  // namespace

Operation agree_operation() {
    return {
        .name = "agree",
        .summary = "Build the blossom by three constructions and check that they agree exactly",
        .documentation =
            "Without arguments the constructions are compared as polynomials in symbols for them.",
        .request = {{map_field(),
                     arguments_field(Presence::optional,
                                     "the arguments; without them agreement is decided for all")}},
        .result = result(),
        .example = {"agree", "1 + 2t + 4t^2 - t^3", "--at", "1,2,3"},
        .options = with_map_options({arguments_option("the arguments: T, vector:V, delta, pair:U:MASS; by "
                                                      "default agreement is proved for all arguments")}),
        .answer = answer_by_shape<agree_on_curve, agree_on_patch, nullptr>,
        .render = render,
    };
}

}  // namespace blossom::protocol
