#include "numbers.hpp"

#include <structmember.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace blossom::python {

namespace {

constexpr std::size_t word_bits = 64;
constexpr std::size_t words_of_short_number = 64;

PyTypeObject* fraction_type = nullptr;
// Where a Fraction has its numerator and denominator; 0 if its class is not the one of CPython.
Py_ssize_t numerator_offset = 0;
Py_ssize_t denominator_offset = 0;

/// The offset of a member of __slots__, or 0.
Py_ssize_t offset_of_slot(const py::object& type, const char* name) {
    const py::object slot = py::getattr(type, name, py::none());
    if (Py_TYPE(slot.ptr()) != &PyMemberDescr_Type) return 0;
    const PyMemberDef* member = reinterpret_cast<PyMemberDescrObject*>(slot.ptr())->d_member;
    return member->type == T_OBJECT_EX ? member->offset : 0;
}

PyObject*& slot_at(PyObject* object, Py_ssize_t offset) {
    return *reinterpret_cast<PyObject**>(reinterpret_cast<char*>(object) + offset);
}

std::size_t bits_of(PyObject* number) {
    const std::size_t bits = _PyLong_NumBits(number);
    if (bits == static_cast<std::size_t>(-1) && PyErr_Occurred()) throw py::error_already_set();
    return bits;
}

/// The integer with room for its words in `words`.
Integer integer_in(PyObject* number, std::span<std::uint64_t> words) {
    auto* bytes = reinterpret_cast<unsigned char*>(words.data());
    auto* integer = reinterpret_cast<PyLongObject*>(number);
#if PY_VERSION_HEX >= 0x030D0000
    const int status = _PyLong_AsByteArray(integer, bytes, words.size_bytes(), 1, 1, 1);
#else
    const int status = _PyLong_AsByteArray(integer, bytes, words.size_bytes(), 1, 1);
#endif
    if (status != 0) throw py::error_already_set();
    return from_twos_complement(words);
}

std::optional<std::int64_t> word_of(PyObject* number) {
    int overflow = 0;
    const long long word = PyLong_AsLongLongAndOverflow(number, &overflow);
    return overflow == 0 ? std::optional<std::int64_t>(word) : std::nullopt;
}

bool read_short_integer(PyObject* number, Integer& value) {
    if (const auto word = word_of(number)) {
        value = *word;
        return true;
    }
    const std::size_t words = bits_of(number) / word_bits + 1;
    if (words > words_of_short_number) return false;
    std::array<std::uint64_t, words_of_short_number> digits;
    value = integer_in(number, std::span(digits).first(words));
    return true;
}

PyObject* object_of(const Integer& value) {
    if (value.is_word()) return PyLong_FromLongLong(value.word());
    std::vector<std::uint64_t> words(value.bit_length() / word_bits + 1);
    to_twos_complement(value, words);
    return _PyLong_FromByteArray(reinterpret_cast<const unsigned char*>(words.data()),
                                 words.size() * sizeof words.front(), 1, 1);
}

py::object owned(PyObject* object) {
    if (!object) throw py::error_already_set();
    return py::reinterpret_steal<py::object>(object);
}

}  // namespace

void prepare_numbers() {
    const py::object fraction = py::module_::import("fractions").attr("Fraction");
    numerator_offset = offset_of_slot(fraction, "_numerator");
    denominator_offset = offset_of_slot(fraction, "_denominator");
    fraction_type = reinterpret_cast<PyTypeObject*>(fraction.ptr());
    Py_INCREF(fraction_type);
}

bool read_short(PyObject* object, Rational& value) {
    if (PyLong_CheckExact(object)) {
        Integer integer;
        if (!read_short_integer(object, integer)) return false;
        value = std::move(integer);
        return true;
    }
    if (Py_TYPE(object) != fraction_type || numerator_offset == 0 || denominator_offset == 0) return false;
    PyObject* const above = slot_at(object, numerator_offset);
    PyObject* const below = slot_at(object, denominator_offset);
    Integer numerator;
    Integer denominator;
    if (!PyLong_CheckExact(above) || !PyLong_CheckExact(below) || !read_short_integer(above, numerator) ||
        !read_short_integer(below, denominator))
        return false;
    value = Rational(std::move(numerator), std::move(denominator));
    return true;
}

Integer integer_of(PyObject* number, const Limits& limits) {
    if (const auto word = word_of(number)) return *word;
    const std::size_t bits = bits_of(number);
    require_result_bits(bits, limits);
    std::vector<std::uint64_t> words(bits / word_bits + 1);
    return integer_in(number, words);
}

Rational ratio_of(py::handle number, const Limits& limits) {
    const auto part = [&](const char* name) {
        const py::object value = number.attr(name);
        return integer_of(owned(PyNumber_Index(value.ptr())).ptr(), limits);
    };
    return {part("numerator"), part("denominator")};
}

py::object fraction_of(const Rational& value) {
    py::object numerator = owned(object_of(value.numerator()));
    py::object denominator = owned(object_of(value.denominator()));
    if (numerator_offset == 0 || denominator_offset == 0) {
        return py::reinterpret_borrow<py::object>(reinterpret_cast<PyObject*>(fraction_type))(numerator,
                                                                                              denominator);
    }
    py::object fraction = owned(fraction_type->tp_alloc(fraction_type, 0));
    slot_at(fraction.ptr(), numerator_offset) = numerator.release().ptr();
    slot_at(fraction.ptr(), denominator_offset) = denominator.release().ptr();
    return fraction;
}

}  // namespace blossom::python
