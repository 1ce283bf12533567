#include "values.hpp"

#include <blossom/rational/double_conversion.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include "json/fields.hpp"
#include "map_object.hpp"
#include "numbers.hpp"

namespace blossom::python {

namespace {

py::object* decimal_type = nullptr;

/// Fields that hold what another program has computed, in doubles.
constexpr std::string_view computed_by_others[] = {"computed", "document"};

std::string text_of(py::handle object) { return py::cast<std::string>(py::str(object)); }

std::string type_name(py::handle object) { return Py_TYPE(object.ptr())->tp_name; }

struct Reader {
    Floats floats;
    const Limits& limits;

    Json read(py::handle object, std::size_t depth) const {
        PyObject* const pointer = object.ptr();
        const bool kept = floats == Floats::kept && PyLong_CheckExact(pointer);
        if (Rational number; !kept && read_short(pointer, number)) return number;
        if (object.is_none()) return {};
        if (PyBool_Check(pointer)) return pointer == Py_True;
        if (PyUnicode_Check(pointer)) return py::cast<std::string>(object);
        if (PyLong_Check(pointer)) return of_integer(pointer);
        if (PyFloat_Check(pointer)) return of_float(object);
        if (const Json* map = json_of_map(pointer)) return *map;
        if (depth > limits.nesting) {
            throw limit_error("the depth of nested lists exceeds", "nesting", limits.nesting);
        }
        if (PyList_Check(pointer) || PyTuple_Check(pointer)) return list(object, depth);
        if (PyDict_Check(pointer)) return members(py::reinterpret_borrow<py::dict>(object), depth);
        return other(object, depth);
    }

private:
    /// A number of JSON, which is returned as it is given, or an exact number.
    Json of_integer(PyObject* object) const {
        Integer integer = integer_of(object, limits);
        if (floats == Floats::kept) return Json::Number{to_string(integer)};
        return Rational(std::move(integer));
    }

    Json list(py::handle sequence, std::size_t depth) const {
        Json::Array elements;
        elements.reserve(py::len(sequence));
        std::size_t i = 0;
        for (const py::handle element : sequence) {
            elements.push_back(protocol::within(i, [&] { return read(element, depth + 1); }));
            ++i;
        }
        return elements;
    }

    Json members(const py::dict& object, std::size_t depth) const {
        Json::Object result;
        result.reserve(object.size());
        for (const auto& [key, value] : object) {
            if (!PyUnicode_Check(key.ptr())) {
                throw Error(ErrorCode::wrong_kind,
                            "the name of a member must be a text, not " + type_name(key));
            }
            const std::string name = py::cast<std::string>(key);
            protocol::within(name, [&] {
                const bool kept = std::ranges::find(computed_by_others, name) != std::end(computed_by_others);
                const Reader reader{kept ? Floats::kept : floats, limits};
                result.emplace_back(name, reader.read(value, depth + 1));
            });
        }
        return result;
    }

    Json of_float(py::handle object) const {
        const double value = PyFloat_AS_DOUBLE(object.ptr());
        if (!std::isfinite(value)) {
            throw Error(ErrorCode::not_a_number, "the float " + text_of(py::repr(object)) + " is no number");
        }
        switch (floats) {
            case Floats::kept:
                return Json::Number{text_of(py::float_(value).attr("__repr__")())};
            case Floats::decimal:
                return parse_rational(text_of(py::float_(value).attr("__repr__")()), limits);
            case Floats::binary64:
                return exact_rational(value);
            case Floats::refused:
                break;
        }
        throw Error(ErrorCode::inexact_number,
                    "the float " + text_of(py::float_(value)) +
                        " is not exact; give an int, a Fraction or a text, or say with floats=\"double\" or "
                        "\"decimal\" what floats stand for");
    }

    Json other(py::handle object, std::size_t depth) const {
        const auto has = [&](const char* name) { return py::hasattr(object, name); };
        if (has("__blossom__")) return read(object.attr("__blossom__")(), depth + 1);
        if (has("numerator") && has("denominator") &&
            !PyCallable_Check(py::object(object.attr("numerator")).ptr()))
            return ratio_of(object, limits);
        if (py::isinstance(object, *decimal_type)) return of_decimal(object);
        if (has("as_integer_ratio")) return of_other_float(object);
        if (has("tolist")) return read(object.attr("tolist")(), depth + 1);
        if (has("keys")) return members(py::dict(py::reinterpret_borrow<py::object>(object)), depth);
        if (has("__iter__")) return list(py::list(py::reinterpret_borrow<py::object>(object)), depth);
        throw Error(ErrorCode::not_a_number,
                    "expected a number, found an object of type " + type_name(object));
    }

    Json of_decimal(py::handle object) const {
        if (!py::cast<bool>(object.attr("is_finite")())) {
            throw Error(ErrorCode::not_a_number, "the decimal " + text_of(object) + " is no number");
        }
        return parse_rational(text_of(py::str("{:e}").attr("format")(object)), limits);
    }

    /// A float of another type: of numpy, with fewer digits than a double.
    Json of_other_float(py::handle object) const {
        if (floats == Floats::decimal) return parse_rational(text_of(object), limits);
        const py::float_ value(py::reinterpret_borrow<py::object>(object));
        if (!value.equal(object)) {
            throw Error(ErrorCode::inexact_number,
                        text_of(object) + " of type " + type_name(object) + " is not a double");
        }
        return of_float(value);
    }
};

py::object number_of(const std::string& text) {
    const bool whole = text.find_first_of(".eEnN") == std::string::npos;
    if (whole) {
        PyObject* const number = PyLong_FromString(text.c_str(), nullptr, 10);
        if (!number) throw py::error_already_set();
        return py::reinterpret_steal<py::object>(number);
    }
    return py::float_(py::str(text));
}

}  // namespace

void prepare_values() { decimal_type = new py::object(py::module_::import("decimal").attr("Decimal")); }

Floats floats_of(py::handle word) {
    if (word.is_none()) return Floats::refused;
    const std::string text = text_of(word);
    if (text == "decimal") return Floats::decimal;
    if (text == "double") return Floats::binary64;
    throw Error(ErrorCode::wrong_kind, "floats is " + quoted(text) + "; it may be \"decimal\" or \"double\"",
                Place{"floats"});
}

Json json_of(py::handle object, Floats floats, const Limits& limits) {
    return Reader{floats, limits}.read(object, 0);
}

py::object object_of(const Json& value, Form form) {
    if (const Rational* number = value.exact()) return fraction_of(*number);
    if (const std::string* text = value.text()) return py::str(*text);
    if (const Json::Number* number = value.number()) return number_of(number->text);
    if (const bool* truth = value.boolean()) return py::bool_(*truth);
    if (const Json::Array* elements = value.array()) {
        const auto fill = [&](auto list) -> py::object {
            for (std::size_t i = 0; i < elements->size(); ++i) list[i] = object_of((*elements)[i], form);
            return list;
        };
        if (form == Form::plain) return fill(py::list(elements->size()));
        return fill(py::tuple(elements->size()));
    }
    const Json::Object* members = value.object();
    if (!members) return py::none();
    if (form == Form::with_maps && value.find("kind")) return map_of(value);
    py::dict result;
    for (const auto& [name, member] : *members) result[py::str(name)] = object_of(member, form);
    return result;
}

}  // namespace blossom::python
