#include "map_object.hpp"

#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/nurbs/rational_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "interpreter.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "maps/parameters.hpp"
#include "numbers.hpp"
#include "operations/values.hpp"
#include "values.hpp"

namespace blossom::python {

namespace {

using protocol::Map;
using protocol::ParameterForm;

const Limits default_limits;

/// Computations beyond these run without the lock of the interpreter, which takes a tenth of a microsecond.
constexpr std::size_t most_locked_degree = 24;
constexpr std::size_t most_locked_values = 16;

/// A map with what is prepared of it.
struct State {
    Map map;
    Json json;
    ParameterForm form = parameter_form(map);
    std::optional<Blossom> blossom = {};  ///< of a polynomial without weights
    std::size_t degree = 0;
    Py_hash_t hash = -1;
};

struct MapObject {
    PyObject_HEAD State* state;
};

PyTypeObject* map_type = nullptr;
py::dict* map_classes = nullptr;
PyTypeObject* vector_type = nullptr;

State& state_of(PyObject* object) { return *reinterpret_cast<MapObject*>(object)->state; }

struct Prepare {
    State& state;

    void operator()(const OnePolynomial auto& curve) const {
        state.degree = curve.degree();
        if (!state.map.form.separate_weights()) state.blossom.emplace(polynomial_map(curve, default_limits));
    }
    void operator()(const auto&) const {}
};

std::unique_ptr<State> new_state(const Json& value) {
    auto state = computed(default_limits, true, [&] {
        Map map = protocol::read_map(value, default_limits);
        Json json = to_json(map);
        auto made = std::make_unique<State>(State{std::move(map), std::move(json)});
        std::visit(Prepare{*made}, made->map.value);
        return made;
    });
    return state;
}

PyObject* new_object(PyTypeObject* type, const Json& value) {
    auto state = new_state(value);
    PyObject* const object = type->tp_alloc(type, 0);
    if (!object) throw py::error_already_set();
    reinterpret_cast<MapObject*>(object)->state = state.release();
    return object;
}

py::object point_of(const Coordinates& point, const protocol::PointForm& form) {
    if (form.separate_weights()) {
        return object_of(protocol::to_json(point, form), Form::immutable);
    }
    if (form.scalar) return fraction_of(point.front());
    py::tuple coordinates(point.size());
    for (std::size_t i = 0; i < point.size(); ++i) coordinates[i] = fraction_of(point[i]);
    return coordinates;
}

/// The values, with errors below the field "at".
py::object points_of(const State& state, const protocol::Parameters& parameters) {
    const bool unlocked = state.degree > most_locked_degree || parameters.size() > most_locked_values;
    const auto values =
        computed(default_limits, unlocked, [&] { return values_at(state.map, parameters, default_limits); });
    py::tuple points(values.size());
    protocol::within("at", [&] {
        for (std::size_t i = 0; i < values.size(); ++i)
            points[i] = protocol::within(i, [&] { return point_of(values[i], state.map.form); });
    });
    return points;
}

/// Appends the numbers of one parameter: a number for a curve, otherwise a list of numbers.
bool read_parameter(PyObject* object, const ParameterForm& form, std::vector<Rational>& numbers) {
    if (form.scalar) return read_short(object, numbers.emplace_back());
    if (!PyTuple_Check(object) && !PyList_Check(object)) return false;
    PyObject** const items = PySequence_Fast_ITEMS(object);
    const std::span elements(items, static_cast<std::size_t>(PySequence_Fast_GET_SIZE(object)));
    if (elements.size() != form.numbers || form.barycentric) return false;
    for (PyObject* const element : elements) {
        if (!read_short(element, numbers.emplace_back())) return false;
    }
    return true;
}

PyObject* slow_method(PyObject* self, const char* name, PyObject* arguments, PyObject* keywords) {
    const py::object method = py::reinterpret_borrow<py::object>(self).attr(name);
    PyObject* const result = PyObject_Call(method.ptr(), arguments, keywords);
    if (!result) throw py::error_already_set();
    return result;
}

/// p(t), of a patch p(u, v).
PyObject* call(PyObject* self, PyObject* arguments, PyObject* keywords) {
    return guarded<PyObject*>(nullptr, [&] {
        const State& state = state_of(self);
        if (!keywords || PyDict_Size(keywords) == 0) {
            const bool one = state.form.scalar && PyTuple_GET_SIZE(arguments) == 1;
            protocol::Parameters parameters{{}, state.form.numbers};
            PyObject* const parameter = one ? PyTuple_GET_ITEM(arguments, 0) : arguments;
            if (one == state.form.scalar && read_parameter(parameter, state.form, parameters.numbers)) {
                const py::tuple points = points_of(state, parameters);
                return py::object(points[0]).release().ptr();
            }
        }
        return slow_method(self, "_evaluated", arguments, keywords);
    });
}

bool read_argument(PyObject* object, std::vector<Argument>& arguments) {
    Rational number;
    if (read_short(object, number)) {
        arguments.emplace_back(Parameter(std::move(number)));
        return true;
    }
    if (Py_TYPE(object) != vector_type) return false;
    const py::object value = py::handle(object).attr("value");
    if (!read_short(value.ptr(), number)) return false;
    arguments.emplace_back(Direction(std::move(number)));
    return true;
}

/// p[u, v, w], the blossom.
PyObject* subscript(PyObject* self, PyObject* key) {
    return guarded<PyObject*>(nullptr, [&] {
        const State& state = state_of(self);
        py::tuple written =
            PyTuple_Check(key) ? py::reinterpret_borrow<py::tuple>(key) : py::make_tuple(py::handle(key));
        if (state.blossom) {
            std::vector<Argument> arguments;
            arguments.reserve(written.size());
            bool all = true;
            for (const py::handle argument : written) all = all && read_argument(argument.ptr(), arguments);
            if (all) {
                const Coordinates value = computed(default_limits, state.degree > most_locked_degree, [&] {
                    return (*state.blossom)(std::span<const Argument>(arguments));
                });
                return point_of(value, state.map.form).release().ptr();
            }
        }
        return slow_method(self, "blossom", written.ptr(), nullptr);
    });
}

PyObject* new_map(PyTypeObject* type, PyObject* arguments, PyObject* keywords) {
    return guarded<PyObject*>(nullptr, [&] {
        PyObject* fields = nullptr;
        PyObject* floats = Py_None;
        const char* names[] = {"", "floats", nullptr};
        if (!PyArg_ParseTupleAndKeywords(arguments, keywords, "O|O", const_cast<char**>(names), &fields,
                                         &floats))
            throw py::error_already_set();
        return new_object(type, json_of(fields, floats_of(floats), default_limits));
    });
}

void delete_map(PyObject* object) {
    PyTypeObject* const type = Py_TYPE(object);
    delete reinterpret_cast<MapObject*>(object)->state;
    type->tp_free(object);
    Py_DECREF(type);
}

PyObject* compare(PyObject* one, PyObject* other, int operation) {
    if ((operation != Py_EQ && operation != Py_NE) || !PyObject_TypeCheck(other, map_type))
        Py_RETURN_NOTIMPLEMENTED;
    const bool equal = one == other || state_of(one).json == state_of(other).json;
    return PyBool_FromLong(equal == (operation == Py_EQ));
}

Py_hash_t hash(PyObject* self) {
    return guarded<Py_hash_t>(-1, [&] {
        State& state = state_of(self);
        if (state.hash == -1) state.hash = py::hash(py::str(to_text(state.json)));
        return state.hash;
    });
}

PyObject* fields_of(PyObject* self, void*) {
    return guarded<PyObject*>(
        nullptr, [&] { return object_of(state_of(self).json, Form::immutable).release().ptr(); });
}

}  // namespace

py::object make_map_type() {
    static PyGetSetDef properties[] = {
        {"_fields", fields_of, nullptr, "All fields of the map, as the protocol has them.", nullptr}, {}};
    static PyType_Slot slots[] = {
        {Py_tp_new, reinterpret_cast<void*>(new_map)},
        {Py_tp_dealloc, reinterpret_cast<void*>(delete_map)},
        {Py_tp_call, reinterpret_cast<void*>(call)},
        {Py_mp_subscript, reinterpret_cast<void*>(subscript)},
        {Py_tp_richcompare, reinterpret_cast<void*>(compare)},
        {Py_tp_hash, reinterpret_cast<void*>(hash)},
        {Py_tp_getset, properties},
        {0, nullptr},
    };
    static PyType_Spec spec = {"blossom._engine.Map", sizeof(MapObject), 0,
                               Py_TPFLAGS_DEFAULT | Py_TPFLAGS_BASETYPE, slots};
    PyObject* const type = PyType_FromSpec(&spec);
    if (!type) throw py::error_already_set();
    map_type = reinterpret_cast<PyTypeObject*>(type);
    return py::reinterpret_borrow<py::object>(type);
}

void set_map_classes(py::dict classes) { map_classes = new py::dict(std::move(classes)); }

void set_vector_type(py::object type) { vector_type = reinterpret_cast<PyTypeObject*>(type.release().ptr()); }

py::object map_of(const Json& value) {
    const protocol::Fields fields(value);
    const Json* kind = value.find("kind");
    if (!kind) fields.missing("kind");
    std::string name = protocol::title_of(
        protocol::within("kind", [&]() -> const protocol::KindWord& { return word_of(fields, *kind); }),
        " with ");
    if (value.find("weights") || value.find("homogeneous") || value.find("denominator")) {
        if (map_classes->contains(name + " rational")) name += " rational";
    }
    const py::object type = (*map_classes)[py::str(name)];
    return py::reinterpret_steal<py::object>(new_object(reinterpret_cast<PyTypeObject*>(type.ptr()), value));
}

const Json* json_of_map(PyObject* object) {
    return PyObject_TypeCheck(object, map_type) ? &state_of(object).json : nullptr;
}

std::string description_of_map(py::handle map) { return description(state_of(map.ptr()).map); }

py::object values_of_map(py::handle map, py::handle parameters) {
    const State& state = state_of(map.ptr());
    const py::object list =
        py::reinterpret_steal<py::object>(PySequence_Fast(parameters.ptr(), "expected a list"));
    if (!list) throw py::error_already_set();
    protocol::Parameters read{{}, state.form.numbers};
    const std::span elements(PySequence_Fast_ITEMS(list.ptr()),
                             static_cast<std::size_t>(PySequence_Fast_GET_SIZE(list.ptr())));
    read.numbers.reserve(elements.size() * state.form.numbers);
    for (PyObject* const element : elements) {
        if (!read_parameter(element, state.form, read.numbers)) return py::none();
    }
    return points_of(state, read);
}

}  // namespace blossom::python
