#pragma once

#include <pybind11/pybind11.h>

#include <blossom/rational/limits.hpp>
#include <blossom/rational/rational.hpp>

/// Exact numbers between Python and the library, without text in between.

namespace blossom::python {

namespace py = pybind11;

/// Finds the class fractions.Fraction. Called once, before anything else here.
void prepare_numbers();

/// Sets `value` to an int or a Fraction of moderate size. False for any other object.
bool read_short(PyObject* object, Rational& value);

/// An int. Errors: `limit_exceeded`.
Integer integer_of(PyObject* number, const Limits& limits);
/// The value of an object that has a numerator and a denominator. Errors: `limit_exceeded`,
/// `zero_denominator`.
Rational ratio_of(py::handle number, const Limits& limits);

/// A Fraction. Errors: throws what the interpreter has raised.
py::object fraction_of(const Rational& value);

}  // namespace blossom::python
