#include <fmt/format.h>
#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/core/blossom/agreement.hpp>

#include <set>

#include "blossom_arguments.hpp"
#include "construction_results.hpp"
#include "map_options.hpp"
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

Json degrees_of(const OnePolynomial auto& curve) { return Json::Object{{"degree", curve.degree()}}; }
Json degrees_of(const Patch& patch) {
    Json member;
    write_degrees(member, patch);
    return member;
}

/// The names of the symbolic arguments, argument by argument in each factor: x1, y1, x2, y2 for variables x
/// and y; u1, u2, v1 for the directions of a tensor product; v1, w1, ... for barycentric coordinates behind
/// the first. `separator` stands before the numbers.
std::vector<std::string> numbered_symbols(const Patch& patch, std::string_view separator) {
    const NetShape& shape = patch.shape();
    const std::string_view letters = patch.tensor ? "uvwxyz" : "vwxyz";
    const auto letter = [&](std::size_t variable) {
        if (patch.is_polynomial()) return patch.variables[variable];
        return variable < letters.size() ? std::string(1, letters[variable]) : fmt::format("c{}_", variable);
    };
    std::vector<std::string> names;
    std::size_t first = 0;
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        for (std::size_t i = 1; i <= shape[f].degree; ++i) {
            for (std::size_t k = 0; k < shape[f].dimension; ++k)
                names.push_back(fmt::format("{}{}{}", letter(first + k), separator, i));
        }
        first += shape[f].dimension;
    }
    return names;
}

/// These names, which differ: with variables x and x1 they are x_1, x_2, ..., x1_1, ...
std::vector<std::string> symbol_names(const Patch& patch) {
    std::vector<std::string> names = numbered_symbols(patch, "");
    const std::set<std::string_view> different(names.begin(), names.end());
    return different.size() == names.size() ? names : numbered_symbols(patch, "_");
}

struct Agree {
    Fields& request;
    const PointForm& form;
    const Limits& limits;

    Json operator()(const OnePolynomial auto& curve) const {
        return answer(curve, polynomial_map(curve, limits), [&](const PolynomialMap& map) {
            Json::Object members = *degrees_of(curve).object();
            const auto names = numbered_names("e", curve.degree());
            members.emplace_back("elementary",
                                 expansion_texts(elementary_symmetric_form(map, limits), form, names));
            return std::pair(std::move(members), numbered_names("u", curve.degree()));
        });
    }
    Json operator()(const Patch& patch) const {
        return answer(patch, patch.map, [&](const PatchMap&) {
            return std::pair(*degrees_of(patch).object(), symbol_names(patch));
        });
    }

private:
    /// `expanded` holds the members before the expansion and the names of its symbolic arguments.
    Json answer(const auto& value, const auto& map, const auto& expanded) const {
        const auto arguments = request.optional(
            "arguments", [&](const Json& written) { return read_arguments(written, value, form, limits); });
        request.finish();
        if (arguments) {
            const auto found = at_arguments(value, [&] { return agreement(map, *arguments, limits); });
            return agreement_at_arguments(found, *degrees_of(value).object(), form);
        }
        const auto found = within("map", [&] { return agreement_for_all_arguments(map, limits); });
        auto [members, names] = expanded(map);
        return agreement_for_all(found, std::move(members), form, names);
    }
};

Answer answer_agree(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    return dispatch_on_kind<Json>(map, Agree{request, map.form, limits});
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

std::string patch_expansion_text(const Answered& answered, const Patch& patch) {
    const Json& expansion = *answered.result().find("expansion");
    std::string text =
        fmt::format("  p({}) = {}\n", fmt::join(symbol_names(patch), ", "), point_text(expansion));
    if (patch.is_polynomial()) return text;
    return text + (patch.tensor
                       ? "where each argument runs from 0 to 1 over its interval.\n"
                       : "where the first barycentric coordinate of each argument is 1 less the others.\n");
}

std::string expansion_text(const Answered& answered) {
    if (const auto* patch = std::get_if<Patch>(&answered.given().value))
        return patch_expansion_text(answered, *patch);
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

std::string render_agree(const Answered& answered) {
    const Json* arguments = answered.request.find("arguments");
    return fmt::format(
        "{}\n\n{}\n{}", description(answered.given()),
        arguments ? values_text(answered, arguments_text(*arguments)) : expansion_text(answered),
        verdict(answered));
}

Members agree_result() {
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
        .summary = "Build the blossom by three constructions and check that they agree exactly",
        .documentation =
            "Without arguments the constructions are compared as polynomials in symbols for them.",
        .request = {{map_field(),
                     arguments_field(Presence::optional,
                                     "the arguments; without them agreement is decided for all")}},
        .result = agree_result(),
        .example = {"agree", "1 + 2t + 4t^2 - t^3", "--at", "1,2,3"},
        .options = with_map_options({arguments_option("the arguments: T, vector:V, delta, pair:U:MASS; by "
                                                      "default agreement is proved for all arguments")}),
        .answer = answer_agree,
        .render = render_agree,
    };
}

}  // namespace blossom::protocol
