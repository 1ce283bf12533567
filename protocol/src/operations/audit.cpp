#include <fmt/format.h>
#include <blossom/rational/double_conversion.hpp>

#include <algorithm>
#include <map>
#include <utility>

#include "evaluator.hpp"
#include "foreign_options.hpp"
#include "formats/doubles.hpp"
#include "formats/formats.hpp"
#include "json/json_text.hpp"
#include "map_options.hpp"
#include "maps/net_fields.hpp"
#include "maps/points.hpp"
#include "patch_answers.hpp"
#include "rounding.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

/// The members that hold the numbers of a map, in the order of the answer.
constexpr std::string_view audited[] = {"knots",          "interval",    "intervals",   "vertices", "center",
                                        "control_points", "control_net", "weights",     "left",     "right",
                                        "coefficients",   "terms",       "denominator", "values"};

/// Those that are multiplied by weights, or divided by a denominator.
constexpr std::string_view divided[] = {"control_points", "control_net",  "left",
                                        "right",          "coefficients", "terms"};

/// What is found of a number, or of an array or object of them, in the same shape.
struct Difference {
    Json error;  ///< computed - exact
    Json ulps;   ///< its size in units in the last place of the exact value
};

std::string size_text(const Json& value) {
    const Json::Array* list = value.array();
    return list ? std::to_string(list->size()) + " values" : value.object() ? "an object" : "one number";
}

[[noreturn]] void refuse_size(const Json& exact, const Json& computed) {
    throw Error(ErrorCode::mismatched_dimensions,
                "there are " + size_text(computed) + ", and " + size_text(exact) + " in the exact map");
}

/// Whether a value is a list of pairs of an index, or exponents, and a number or point.
bool is_indexed(const Json& value) {
    const Json::Array* entries = value.array();
    const Json::Array* pair = entries && !entries->empty() ? entries->front().array() : nullptr;
    const Json::Array* index = pair && pair->size() == 2 ? pair->front().array() : nullptr;
    return index && std::ranges::all_of(*index, [](const Json& entry) { return entry.number() != nullptr; });
}

/// The same shape with zeros.
Json zeros_like(const Json& value) {
    const Json::Array* elements = value.array();
    return elements ? Json(Json::Array(elements->size(), Rational(0))) : Json(Rational(0));
}

/// Compares values of one shape, and counts what it finds.
class Comparison {
public:
    /// With `sparse`, an index that only one of two lists has stands for a zero in the other.
    Comparison(bool sparse, const Limits& limits) : sparse_(sparse), limits_(limits) {}

    /// Errors: those of `read_double`; `mismatched_dimensions` for values of another shape; `incomplete_net`;
    /// `overflow` for an exact number beyond the doubles; at their place in `computed`.
    Difference operator()(const Json& exact, const Json& computed) {
        if (exact.object()) return of_members(exact, computed);
        if (!exact.array()) return of_numbers(exact, computed);
        if (!computed.array()) {
            if (computed.number() || computed.text() || computed.exact()) refuse_size(exact, computed);
            read_array(computed);
        }
        return is_indexed(exact) ? of_entries(exact, computed) : of_elements(exact, computed);
    }

    const Rational& greatest() const { return greatest_; }
    std::size_t count() const { return count_; }
    std::size_t wrong() const { return wrong_; }

private:
    Difference of_numbers(const Json& exact, const Json& computed) {
        if (computed.array()) refuse_size(exact, computed);
        const Rational& expected = *exact.exact();
        const Rational found = computed.exact() ? *computed.exact() : read_double(computed);
        const Rational nearest = exact_rational(nearest_double(expected));
        const Rational error = found - expected;
        const Rational ulps = abs(error) / unit_in_last_place(expected);
        greatest_ = std::max(greatest_, ulps);
        if (found != nearest) ++wrong_;
        ++count_;
        return {error, ulps};
    }

    Difference of_elements(const Json& exact, const Json& computed) {
        const Json::Array& expected = *exact.array();
        const Json::Array& found = *computed.array();
        if (expected.size() != found.size()) refuse_size(exact, computed);
        Json::Array errors, ulps;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            Difference difference = within(i, [&] { return (*this)(expected[i], found[i]); });
            errors.push_back(std::move(difference.error));
            ulps.push_back(std::move(difference.ulps));
        }
        return {std::move(errors), std::move(ulps)};
    }

    Difference of_members(const Json& exact, const Json& computed) {
        Fields fields(computed);
        Difference all;
        for (const auto& [name, expected] : *exact.object()) {
            Difference difference =
                fields.required(name, [&](const Json& found) { return (*this)(expected, found); });
            all.error[name] = std::move(difference.error);
            all.ulps[name] = std::move(difference.ulps);
        }
        fields.finish();
        return all;
    }

    /// The entries of both lists by their index: those of the exact one in its order, and then the others.
    Difference of_entries(const Json& exact, const Json& computed) {
        const Json::Array& found = *computed.array();
        std::vector<std::size_t> places = places_of_entries(exact, found);
        const Json zeros = zeros_like((*exact.array()->front().array())[1]);
        Json::Array errors, ulps;
        const auto append = [&](const Json& index, const Difference& difference) {
            errors.emplace_back(Json::Array{index, difference.error});
            ulps.emplace_back(Json::Array{index, difference.ulps});
        };
        const auto value_at = [&](std::size_t place, const Json& expected) {
            return within(place, [&] {
                return within(std::size_t{1}, [&] { return (*this)(expected, (*found[place].array())[1]); });
            });
        };
        for (const Json& entry : *exact.array()) {
            const Json::Array& pair = *entry.array();
            const std::size_t place = places[errors.size()];
            append(pair[0], place < found.size() ? value_at(place, pair[1]) : (*this)(pair[1], zeros));
        }
        for (std::size_t i = errors.size(); i < places.size(); ++i) {
            append((*found[places[i]].array())[0], value_at(places[i], zeros));
        }
        return {std::move(errors), std::move(ulps)};
    }

    /// Where the computed list has the entry of each index of the exact one, or its size for none, and then
    /// the entries of other indices.
    std::vector<std::size_t> places_of_entries(const Json& exact, const Json::Array& found) const {
        std::map<std::vector<std::size_t>, std::size_t> known;
        for (const Json& entry : *exact.array())
            known.emplace(read_index_of((*entry.array())[0]), known.size());
        std::vector<std::size_t> places(known.size(), found.size());
        const std::size_t length = known.begin()->first.size();
        for (std::size_t i = 0; i < found.size(); ++i) {
            within(i, [&] {
                const Json::Array& pair = read_array(found[i]);
                if (pair.size() != 2) refuse_net("an entry is a pair of an index and a value");
                within(std::size_t{0}, [&] {
                    const auto [place, added] = known.emplace(read_index_of(pair[0]), known.size());
                    if (added && (!sparse_ || place->first.size() != length))
                        refuse_net("the exact map has no such index");
                    if (added) {
                        places.push_back(i);
                    } else if (std::exchange(places[place->second], i) != found.size()) {
                        refuse_net("the index occurs twice");
                    }
                });
            });
        }
        if (!sparse_ && std::ranges::find(places, found.size()) != places.end())
            refuse_net("there are " + std::to_string(found.size()) + " entries, and " +
                       std::to_string(places.size()) + " in the exact map");
        return places;
    }

    std::vector<std::size_t> read_index_of(const Json& value) const {
        return read_list(value, [&](const Json& entry) { return read_count(entry, limits_); });
    }

    bool sparse_;
    const Limits& limits_;
    Rational greatest_;
    std::size_t wrong_ = 0;
    std::size_t count_ = 0;
};

Answer values_of_curve(Fields& request, const Map& map, const Limits& limits) {
    const auto parameters =
        request.required("at", [&](const Json& value) { return read_numbers(value, limits); });
    return Json::Object{{"values", values_at(value_evaluator(map, parameters.size(), limits), parameters,
                                             map.form, dimension_of(map), limits)}};
}

/// The values of the map at the parameters "at".
Json values_of(const Map& map, const Json& at, const Limits& limits) {
    const Json parameters = Json::Object{{"at", at}};
    Fields fields(parameters);
    Answer answer =
        answer_about<values_of_curve, evaluate_patch, evaluate_tensor_bspline>(fields, map, limits);
    return std::move(answer.result["values"]);
}

/// What is compared with what.
struct Sides {
    Json exact;
    Json computed;                          ///< members with numbers
    const ForeignFormat* format = nullptr;  ///< of the document that they come from
    std::string_view without_weights = "";  ///< the side whose weights are taken to be 1

    /// Where the request has what lies at `of_numbers` of the computed side.
    Place place(const Place& of_numbers) const {
        if (!format) return Place{"computed"}.around(of_numbers);
        return Place{"document"}.around(place_in_document(*format, of_numbers));
    }
};

/// Errors: `missing_field` for points without the weights or the denominator of the exact map, and for
/// values without parameters or the other way round.
void require_complete(const Sides& sides, bool has_parameters) {
    const Json& computed = sides.computed;
    for (const std::string_view rest : {"weights", "denominator"}) {
        if (!sides.exact.find(rest) || computed.find(rest)) continue;
        for (const std::string_view field : divided) {
            if (!computed.find(field)) continue;
            throw Error(ErrorCode::missing_field,
                        fmt::format(R"(the map is rational: its "{}" are compared together with its "{}")",
                                    field, rest),
                        sides.place({std::string(rest)}));
        }
    }
    if (has_parameters && !computed.find("values")) {
        throw Error(ErrorCode::missing_field, R"(the "values" at the parameters "at" are missing)",
                    sides.place({"values"}));
    }
    if (computed.find("values") && !sides.exact.find("values")) {
        throw Error(ErrorCode::missing_field, R"(the parameters of "values" are missing)", Place{"at"});
    }
}

/// The members of field "computed", which is a map or a part of it.
Sides read_computed(Request& request, const Map& map, const Limits& limits) {
    Sides sides{to_json(map), {}};
    const auto at = request.optional("at", [](const Json& value) { return value; });
    request.required("computed", [&](const Json& value) {
        Fields fields(value);
        for (const std::string_view field : audited) {
            if (auto numbers = fields.optional(field, [](const Json& given) { return given; }))
                sides.computed[field] = *std::move(numbers);
        }
        fields.finish();
        if (sides.computed.is_null()) fields.missing("control_points");
        return true;
    });
    if (at) sides.exact["values"] = values_of(map, *at, limits);
    require_complete(sides, at.has_value());
    return sides;
}

/// The weights 1 of a curve without weights.
Json weights_of_one(const Json& curve) {
    return Json::Array(curve.find("control_points")->array()->size(), Rational(1));
}

/// The curve in field "document", which is compared as a whole.
Sides read_document(Request& request, const Map& map, const Limits& limits) {
    const ForeignFormat& format = request.required(
        "format", [](const Json& value) -> const ForeignFormat& { return read_format(value); });
    Json computed = request.required("document", [&](const Json& value) {
        const std::vector<Map> maps = format.read(value, limits);
        if (maps.size() == 1) return to_json(maps.front());
        throw Error(ErrorCode::wrong_arity, "one curve is compared, not " + std::to_string(maps.size()));
    });
    Sides sides{within("map", [&] { return to_json(as_textbook_spline(map, limits)); }), std::move(computed),
                &format};
    if (*sides.exact.find("degree") != *sides.computed.find("degree")) {
        throw Error(ErrorCode::mismatched_dimensions,
                    "the degree is " + to_text(*sides.computed.find("degree")) + ", and " +
                        to_text(*sides.exact.find("degree")) + " in the exact map",
                    sides.place(Part::degree));
    }
    const bool weighted = sides.computed.find("weights") != nullptr;
    if (map.form.homogeneous || weighted == map.form.rational) return sides;
    sides.without_weights = weighted ? "map" : "document";
    Json& lacking = weighted ? sides.exact : sides.computed;
    lacking["weights"] = weights_of_one(lacking);
    return sides;
}

Answer answer(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const Sides sides =
        request.has("document") ? read_document(request, map, limits) : read_computed(request, map, limits);
    request.finish();
    const Patch* patch = patch_of(map);
    Comparison compare(patch && patch->is_polynomial(), limits);
    Difference found;
    for (const std::string_view field : audited) {
        const Json* computed = sides.computed.find(field);
        if (!computed) continue;
        const Json* exact = sides.exact.find(field);
        try {
            within(field, [&] {
                if (!exact) throw Error(ErrorCode::wrong_kind, "the exact map has no such numbers");
                Difference difference = compare(*exact, *computed);
                found.error[field] = std::move(difference.error);
                found.ulps[field] = std::move(difference.ulps);
            });
        } catch (const Error& error) {
            throw error.at(sides.place(error.place()));
        }
    }
    Json::Object result{{"errors", std::move(found.error)},
                        {"ulps", std::move(found.ulps)},
                        {"greatest_ulps", compare.greatest()},
                        {"numbers", compare.count()},
                        {"not_nearest", compare.wrong()}};
    if (!sides.without_weights.empty()) result.emplace_back("without_weights", sides.without_weights);
    return result;
}

std::string ulps_text(const Json& ulps) {
    const Json::Array* list = ulps.array();
    if (!list) return fmt::format("{:.3g}", nearest_double(*ulps.exact()));
    std::string text;
    for (const Json& element : *list) text += (text.empty() ? "" : ", ") + ulps_text(element);
    return "(" + text + ")";
}

/// One line per number or point.
std::string lines_of(const std::string& name, const Json& errors, const Json& ulps) {
    std::string text;
    if (const Json::Object* members = errors.object()) {
        for (const auto& [end, member] : *members) {
            if (!is_rounded_twin(end)) text += lines_of(name + " " + end, member, *ulps.find(end));
        }
        return text;
    }
    const auto line = [](const std::string& place, const Json& error, const Json& in_ulps) {
        return fmt::format("  {}: error {}, {} ulp\n", place, point_text(error), ulps_text(in_ulps));
    };
    const Json::Array* list = errors.array();
    if (!list) return line(name, errors, ulps);
    const bool indexed = is_indexed(errors);
    for (std::size_t i = 0; i < list->size(); ++i) {
        const Json& error = (*list)[i];
        const Json& in_ulps = (*ulps.array())[i];
        text += indexed ? line(name + " " + point_text((*error.array())[0]), (*error.array())[1],
                               (*in_ulps.array())[1])
                        : line(fmt::format("{} {}", name, i), error, in_ulps);
    }
    return text;
}

std::string render(const Answered& answered) {
    const Json& result = answered.result();
    std::string text = description(answered.given()) + "\n\n";
    for (const auto& [field, errors] : *result.find("errors")->object()) {
        if (!is_rounded_twin(field)) text += lines_of(field, errors, *result.find("ulps")->find(field));
    }
    if (const Json* side = result.find("without_weights"))
        text += fmt::format("\nThe {} has no weights; they count as 1.\n", *side->text());
    return text +
           fmt::format("\n{} of {} numbers are not the nearest double; the greatest error is {} ulp.\n",
                       point_text(*result.find("not_nearest")), point_text(*result.find("numbers")),
                       answered.style.bold(ulps_text(*result.find("greatest_ulps"))));
}

void apply_computed(Json& request, const std::vector<std::string>& values, const Limits& limits) {
    request["computed"] = parse_json(values.front(), limits);
}

}  // namespace

Operation audit_operation() {
    return {
        .name = "audit",
        .summary =
            "Measure the error of doubles computed by another program, against the exact numbers of a map",
        .example = {"audit", "--control-points", "0; 1/3; 1/10", "--computed",
                    R"({"control_points": [0, 0.333, 0.1]})"},
        .options = with_map_options({
            {"--computed",
             {"computed"},
             "JSON",
             R"(the numbers of the other program: "control_points", "weights", "knots", "coefficients", )"
             R"(or the "values" at the parameters --at)",
             apply_computed},
            field_option("--at", "at", "T1,T2,...", R"(the parameters of "values")", number_list),
            format_option(),
            document_option(
                R"(instead of --computed: a file of another library, "@NAME" or "-", or its text)"),
        }),
        .answer = answer,
        .render = render,
    };
}

}  // namespace blossom::protocol
