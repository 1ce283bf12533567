#pragma once

#include <pybind11/pybind11.h>

#include <blossom/protocol/json.hpp>
#include <blossom/rational/limits.hpp>

#include <string_view>

/// Requests and answers as values of Python.

namespace blossom::python {

namespace py = pybind11;
using protocol::Json;

/// What floats in a request stand for.
enum class Floats {
    refused,
    kept,      ///< numbers of JSON, which the protocol reads
    decimal,   ///< the shortest decimals that give them
    binary64,  ///< their exact values
};

/// Finds the classes of the standard library whose objects are numbers.
void prepare_values();

/// None, "decimal", "double". Errors: `wrong_kind`.
Floats floats_of(py::handle word);

/// An object as JSON with exact numbers. It may be None, a truth value, a text, a number, a map, a mapping,
/// or anything that can be iterated; what has a method __blossom__ is replaced by what this returns.
///
/// Errors: `inexact_number` for a refused float, `not_a_number` for NaN and infinities, `wrong_kind`,
/// `limit_exceeded`, each with its place.
Json json_of(py::handle object, Floats floats, const Limits& limits);

/// How lists of JSON become lists of Python, and maps objects.
enum class Form {
    plain,      ///< lists and dictionaries
    immutable,  ///< tuples
    with_maps,  ///< tuples, and a `Map` where an object has the member "kind"
};

/// Numbers become Fractions; counts become ints and rounded numbers floats.
py::object object_of(const Json& value, Form form);

}  // namespace blossom::python
