#include <pybind11/pybind11.h>

#include <blossom/protocol/answer.hpp>
#include <blossom/protocol/description.hpp>
#include <blossom/rational/double_conversion.hpp>
#include <blossom/rational/number_text.hpp>
#include <blossom/rational/resource_budget.hpp>

#include <cmath>
#include <string>
#include <vector>

#include "interpreter.hpp"
#include "json/json_text.hpp"
#include "limit_table.hpp"
#include "map_object.hpp"
#include "maps/kind.hpp"
#include "numbers.hpp"
#include "operations/operation.hpp"
#include "responses.hpp"
#include "values.hpp"

namespace blossom::python {

namespace {

/// A dictionary from names of limits to their values; None stands for the default.
Limits limits_of(const py::object& given) {
    Limits limits;
    if (given.is_none()) return limits;
    for (const auto& [key, value] : py::cast<py::dict>(given)) {
        if (value.is_none()) continue;
        const std::string name = py::cast<std::string>(key);
        const auto table = protocol::limit_table();
        const auto entry = std::ranges::find(table, name, &protocol::LimitEntry::name);
        if (entry == table.end()) {
            throw Error(ErrorCode::unknown_field, "there is no limit " + quoted(name), Place{"limits"});
        }
        const protocol::Json written = json_of(value, Floats::refused, limits);
        const Rational number =
            protocol::within("limits", [&] { return protocol::read_number(written, limits); });
        const auto count = number.numerator().to_int64();
        const bool whole = number.is_integer() && count && *count >= 0;
        if (!whole || static_cast<std::size_t>(*count) > entry->greatest) {
            throw Error(ErrorCode::wrong_kind,
                        to_string(number) + " is not an integer from 0 to " + std::to_string(entry->greatest),
                        Place{"limits", name});
        }
        limits.*(entry->member) = static_cast<std::size_t>(*count);
    }
    return limits;
}

bool is_of_maps(std::string_view kind) {
    return kind == "map" || kind.find("maps") != std::string_view::npos;
}

/// The members of the result of one operation.
py::dict call_operation(const std::string& name, const py::dict& fields, const py::object& floats,
                        const py::object& given) {
    const Limits limits = limits_of(given);
    Json request = json_of(fields, floats_of(floats), limits);
    request.object()->emplace_back("op", name);
    const Json result = computed(limits, true, [&] { return protocol::find_answer(request, limits).result; });
    py::dict members;
    const protocol::Operation& operation = protocol::find_operation(name);
    const protocol::FieldList described = all_fields(operation.result);
    for (const auto& [member, value] : *result.object()) {
        const auto field = std::ranges::find(described, member, &protocol::Field::name);
        const bool maps = field != described.end() && is_of_maps(field->shape.text());
        members[py::str(member)] = object_of(value, maps ? Form::with_maps : Form::immutable);
    }
    return members;
}

py::object answer(const py::object& request, const py::object& given) {
    const Limits limits = limits_of(given);
    const Json read = json_of(request, Floats::kept, limits);
    const Json response = interruptible(true, [&] { return protocol::answer(read, limits); });
    return object_of(response, Form::plain);
}

/// The response to a request as text, as the program writes it.
std::string answer_text(const std::string& request, const py::object& given) {
    const Limits limits = limits_of(given);
    return interruptible(true, [&] { return protocol::answer(request, limits).text; });
}

/// The text for people that the program prints after the same request.
std::string shown(const std::string& name, const py::dict& fields, const py::object& floats, bool picture) {
    const Limits limits;
    Json request = json_of(fields, floats_of(floats), limits);
    request.object()->emplace_back("op", name);
    const protocol::Operation& operation = protocol::find_operation(name);
    return computed(limits, true, [&] {
        const protocol::Answer found = protocol::find_answer(request, limits);
        const protocol::Answered answered{request, found, limits, {}};
        if (picture) return operation.plot ? operation.plot(answered) : std::string();
        return operation.render(answered);
    });
}

/// The request of the example in the help of the operation, or None.
py::object example(const std::string& name) {
    const protocol::Operation& operation = protocol::find_operation(name);
    const auto named = [&](std::string_view option) {
        return std::ranges::find(operation.options, option, &protocol::Option::name);
    };
    const auto positional = std::ranges::find_if(
        operation.options, [](const protocol::Option& option) { return !option.name.starts_with("--"); });
    std::vector<std::vector<std::string>> values(operation.options.size());
    std::vector<bool> given(operation.options.size());
    for (std::size_t i = 1; i < operation.example.size(); ++i) {
        const std::string& word = operation.example[i];
        const bool is_name = word.starts_with("--");
        const auto option = is_name ? named(word) : positional;
        if (option == operation.options.end()) return py::none();
        const auto index = static_cast<std::size_t>(option - operation.options.begin());
        given[index] = true;
        const bool is_flag = option->value.empty();
        if (!is_name || !is_flag) values[index].push_back(is_name ? operation.example[++i] : word);
    }
    const Limits limits;
    Json request{Json::Object{}};
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (given[i]) operation.options[i].apply(request, values[i], limits);
    }
    return object_of(request, Form::plain);
}

py::list fields_list(const std::vector<protocol::FieldDescription>& fields) {
    py::list list;
    for (const protocol::FieldDescription& field : fields) {
        py::list alternatives;
        for (const std::string_view word : field.alternatives) alternatives.append(std::string(word));
        list.append(py::dict(py::arg("name") = field.name, py::arg("kind") = field.kind,
                             py::arg("alternatives") = py::tuple(alternatives),
                             py::arg("required") = field.required,
                             py::arg("documentation") = field.documentation));
    }
    return list;
}

py::list operations() {
    py::list list;
    for (const protocol::OperationDescription& operation : protocol::operation_descriptions()) {
        list.append(py::dict(py::arg("name") = operation.name, py::arg("summary") = operation.summary,
                             py::arg("documentation") = operation.documentation,
                             py::arg("fields") = fields_list(operation.fields),
                             py::arg("result") = fields_list(operation.result)));
    }
    return list;
}

py::list kinds() {
    py::list list;
    for (const protocol::Kind* kind : protocol::Kinds::all) {
        for (const protocol::KindWord& word : words_of(*kind)) {
            py::list fields;
            const protocol::Members members = word.members();
            for (const protocol::Field& field : all_fields(members)) {
                fields.append(py::dict(py::arg("name") = std::string(field.name),
                                       py::arg("kind") = field.shape.text(),
                                       py::arg("presence") = presence_text(members, field.name),
                                       py::arg("documentation") = field.documentation));
            }
            list.append(py::dict(py::arg("title") = protocol::title_of(word, " with "),
                                 py::arg("word") = std::string(word.word),
                                 py::arg("documentation") = std::string(word.documentation),
                                 py::arg("fields") = fields));
        }
    }
    return list;
}

py::list limits() {
    const Limits defaults;
    py::list list;
    for (const protocol::LimitEntry& entry : protocol::limit_table()) {
        list.append(py::dict(py::arg("name") = std::string(entry.name),
                             py::arg("help") = std::string(entry.help),
                             py::arg("default") = defaults.*(entry.member)));
    }
    return list;
}

Rational number_of(const py::handle& object, const py::object& floats) {
    const Limits defaults;
    return protocol::read_number(json_of(object, floats_of(floats), defaults), defaults);
}

py::object read_map(const py::object& fields, const py::object& floats) {
    return map_of(json_of(fields, floats_of(floats), Limits()));
}

std::string text_of_map(const py::object& map) {
    const Json* json = json_of_map(map.ptr());
    if (!json) throw py::type_error("expected a map");
    return to_text(*json);
}

py::object map_of_text(const std::string& text) { return map_of(protocol::parse_json(text, Limits())); }

}  // namespace

PYBIND11_MODULE(_engine, module) {
    // Numbers allocate as everything else does, so that the memory of a request is counted.
    allocate_numbers_with_new();
    prepare_numbers();
    prepare_values();
    py::register_exception_translator([](std::exception_ptr problem) {
        try {
            if (problem) std::rethrow_exception(problem);
        } catch (const Error&) {
            raise_handled();
        } catch (const std::bad_alloc&) {
            raise_handled();
        }
    });

    module.attr("__version__") = BLOSSOM_VERSION;
    module.attr("Map") = make_map_type();
    module.def("set_error_type", set_error_type);
    module.def("set_map_classes", set_map_classes);
    module.def("set_vector_type", set_vector_type);

    module.def("call", call_operation);
    module.def("answer", answer);
    module.def("answer_text", answer_text);
    module.def("shown", shown);
    module.def("example", example);
    module.def("operations", operations);
    module.def("kinds", kinds);
    module.def("limits", limits);

    module.def("read_map", read_map);
    module.def("text_of_map", text_of_map);
    module.def("map_of_text", map_of_text);
    module.def("description_of_map", description_of_map);
    module.def("values_of_map", values_of_map);

    module.def("fraction", [](const py::object& object, const py::object& floats) {
        return fraction_of(number_of(object, floats));
    });
    module.def("nearest_double",
               [](const py::object& object) { return nearest_double(number_of(object, py::none())); });
    module.def("unit_in_last_place", [](const py::object& object) {
        return fraction_of(unit_in_last_place(number_of(object, py::none())));
    });
}

}  // namespace blossom::python
