#pragma once

#include <pybind11/pybind11.h>

#include <blossom/rational/error.hpp>
#include <blossom/rational/limits.hpp>
#include <blossom/rational/resource_budget.hpp>

#include <exception>
#include <utility>

/// What the module shares with the interpreter: its lock, its signals and its exceptions.

namespace blossom::python {

namespace py = pybind11;

/// Lets the checks of a budget look for signals of the interpreter, such as an interrupt from the keyboard,
/// and gives the lock of the interpreter to other threads if `unlocked`.
class Computation {
public:
    explicit Computation(bool unlocked);
    Computation(const Computation&) = delete;
    Computation& operator=(const Computation&) = delete;
    Computation(Computation&&) = delete;
    Computation& operator=(Computation&&) = delete;
    ~Computation();

private:
    StopQuestion outer_question_;
    PyThreadState* outer_thread_;
};

/// compute(), which has a budget of its own. An exception of a signal handler that ran meanwhile is thrown
/// instead of any result.
template <class Compute>
auto interruptible(bool unlocked, const Compute& compute) {
    const auto refuse_pending = [] {
        if (PyErr_Occurred()) throw py::error_already_set();
    };
    try {
        auto result = [&] {
            const Computation computation(unlocked);
            return compute();
        }();
        refuse_pending();
        return result;
    } catch (const std::exception&) {
        refuse_pending();
        throw;
    }
}

/// The same within a budget.
template <class Compute>
auto computed(const Limits& limits, bool unlocked, const Compute& compute) {
    return interruptible(unlocked, [&] {
        const ResourceBudget budget(limits);
        return compute();
    });
}

/// The exception that is thrown for an `Error`: type(code, message, place, limit).
void set_error_type(py::object type);

/// Sets the exception of the interpreter that stands for the exception that is being handled.
void raise_handled();

/// function() for the interpreter: nullptr or -1, `failed`, with an exception set if it throws.
template <class Result, class Function>
Result guarded(Result failed, const Function& function) noexcept {
    try {
        return function();
    } catch (...) {
        raise_handled();
        return failed;
    }
}

}  // namespace blossom::python
