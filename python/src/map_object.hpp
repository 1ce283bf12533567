#pragma once

#include <pybind11/pybind11.h>

#include <blossom/protocol/json.hpp>

/// The class of maps, which cannot be changed: `Map` of the module, from which Python derives one class per
/// kind.

namespace blossom::python {

namespace py = pybind11;

/// Makes the class. Called once.
py::object make_map_type();

/// The classes of maps by the kinds of the protocol: "bspline", "bspline with degrees", and after a word and
/// " rational" those for points with weights.
void set_map_classes(py::dict classes);
/// The classes of the arguments of a blossom that are vectors, with an attribute `value`.
void set_vector_type(py::object type);

/// The map that JSON describes. Errors: those of `read_map`.
py::object map_of(const protocol::Json& value);

/// The description of a map if the object is one, otherwise nullptr.
const protocol::Json* json_of_map(PyObject* object);

/// "P(t) = 1 + 2t".
std::string description_of_map(py::handle map);

/// The values at a list of parameters, or None if they are not all short exact numbers.
py::object values_of_map(py::handle map, py::handle parameters);

}  // namespace blossom::python
