#include "interpreter.hpp"

#include <chrono>
#include <new>
#include <string>
#include <variant>

namespace blossom::python {

namespace {

using Clock = std::chrono::steady_clock;

/// How long a signal may wait.
constexpr std::chrono::milliseconds between_signals{10};

thread_local PyThreadState* released_thread = nullptr;  ///< null while this thread holds the lock
thread_local Clock::time_point next_look{};

/// Runs the signal handlers of the interpreter; true if one raised an exception, which stays set.
bool has_raised() {
    const bool unlocked = released_thread != nullptr;
    if (unlocked) PyEval_RestoreThread(std::exchange(released_thread, nullptr));
    const bool raised = PyErr_Occurred() || PyErr_CheckSignals() != 0;
    if (unlocked) released_thread = PyEval_SaveThread();
    return raised;
}

thread_local bool raised = false;

bool is_interrupted() {
    if (raised) return true;
    const Clock::time_point now = Clock::now();
    if (now < next_look) return false;
    raised = has_raised();
    next_look = Clock::now() + between_signals;
    return raised;
}

py::object* error_type = nullptr;

py::tuple place_of(const Error& error) {
    py::list steps;
    for (const Place::Step& step : error.place().steps()) {
        if (const auto* index = std::get_if<std::size_t>(&step)) {
            steps.append(*index);
        } else if (const auto* part = std::get_if<Part>(&step)) {
            steps.append(std::string(part_name(*part)));
        } else {
            steps.append(std::get<std::string>(step));
        }
    }
    return py::tuple(steps);
}

void raise(const Error& error) {
    const py::object exception = (*error_type)(std::string(error_name(error.code())), error.message(),
                                               place_of(error), std::string(error.limit()));
    PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(exception.ptr())), exception.ptr());
}

}  // namespace

Computation::Computation(bool unlocked) : outer_question_(is_stopped), outer_thread_(released_thread) {
    raised = false;
    is_stopped = is_interrupted;
    if (unlocked) {
        released_thread = PyEval_SaveThread();
    } else {
        released_thread = nullptr;
    }
}

Computation::~Computation() {
    if (released_thread) PyEval_RestoreThread(released_thread);
    released_thread = outer_thread_;
    is_stopped = outer_question_;
    raised = false;
}

// It lives as long as the process, so that it is not destroyed after the interpreter.
void set_error_type(py::object type) { error_type = new py::object(std::move(type)); }

void raise_handled() {
    try {
        try {
            throw;
        } catch (py::error_already_set& error) {
            error.restore();
        } catch (const Error& error) {
            raise(error);
        } catch (const std::bad_alloc& problem) {
            raise(resource_error(problem));
        } catch (const std::exception& problem) {
            raise({ErrorCode::internal, std::string("an error of the program: ") + problem.what()});
        }
    } catch (py::error_already_set& error) {
        error.restore();
    }
}

}  // namespace blossom::python
