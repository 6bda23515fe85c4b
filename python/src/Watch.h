// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_WATCH_H
#define INTRINSIC_PYTHON_WATCH_H

#include <pybind11/pybind11.h>

#include <chrono>
#include <concepts>
#include <cstdint>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace python {

/*!
\brief watches long work, which runs without the interpreter's lock: ten times in a second it lets
Python handle signals, so that Ctrl-C ends the work, and calls the user's function, which hears of
the first step, too, however short the work is.

Visitors of the library call it and end the work if it returns false. After that, `rethrow()` throws
what Python raised: `with_triangulation()` does so.
*/
class Watch {
public:
  /// \param progress called with the name of a stage, how far that is, a whole number, and how far
  ///   it will be, a whole number or `None`; or `None` in place of a function
  explicit Watch(pybind11::object progress = pybind11::none())
      : progress_(std::move(progress)), is_new_(!progress_.is_none()) {}

  /*!
  \brief returns whether to go on. It is called without the interpreter's lock.
  \param stage what is being done, such as "flips", of which there are
  \param count so many
  \param total of so many in all; 0 if that is unknown
  */
  bool operator()(const char* stage, std::uint64_t count = 0, std::uint64_t total = 0) {
    if (error_) return false;
    const auto now = std::chrono::steady_clock::now();
    if (!is_new_ && now - last_ < std::chrono::milliseconds(100)) return true;
    is_new_ = false;
    const pybind11::gil_scoped_acquire lock;
    try {
      if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
      if (!progress_.is_none()) call(stage, count, total);
    } catch (...) {
      error_ = std::current_exception();
    }
    last_ = std::chrono::steady_clock::now(); // the function takes its time, too
    return !error_;
  }

  /*!
  \brief asks between two stages whether to go on.
  \param stage the one that begins
  \throws std::runtime_error if the work ends, in place of which `rethrow()` throws the reason
  */
  void begin(const char* stage) {
    if (!(*this)(stage)) throw std::runtime_error("the work has been ended");
  }

  /*!
  \brief asks Python for a number; what is raised there ends the work. It is called without the
  interpreter's lock.
  \param otherwise what it returns if the work has ended
  \param ask called with the lock
  */
  template <class Number, class Function>
  Number ask(Number otherwise, const Function& ask) {
    if (error_) return otherwise;
    const pybind11::gil_scoped_acquire lock;
    try {
      return ask();
    } catch (...) {
      error_ = std::current_exception();
      return otherwise;
    }
  }

  /// keeps a message until the work ends.
  void warn(const std::string& message) { warnings_.push_back(message); }

  /// throws what ended the work, if anything did, and gives warnings. It is called with the
  /// interpreter's lock.
  void rethrow() {
    if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
    for (const std::string& w : std::exchange(warnings_, {}))
      if (PyErr_WarnEx(PyExc_RuntimeWarning, w.c_str(), 1) != 0)
        throw pybind11::error_already_set();
  }

private:
  void call(const char* stage, std::uint64_t count, std::uint64_t total) {
    if (total == 0)
      progress_(stage, count, pybind11::none());
    else
      progress_(stage, count, total);
  }

  pybind11::object progress_;
  bool is_new_; // whether the user's function has heard of nothing yet
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  std::exception_ptr error_;
  std::vector<std::string> warnings_;
};

/// Asks whether to go on, for visitors of the library: says what is being done, and how much of it
/// if they count that.
struct Watching {
  Watch* watch;            ///< what is asked
  const char* stage;       ///< what is being done
  std::uint64_t total = 0; ///< how much there is to do; 0 if that is unknown
  /// is called after each step.
  template <class Step, class... More>
  bool progress(const Step& step, const More&...) {
    if constexpr (std::integral<Step>)
      return (*watch)(stage, step, total);
    else if constexpr (requires { step.flips; })
      return (*watch)(stage, step.flips);
    else if constexpr (requires { step.rounds; })
      return (*watch)(stage, step.rounds, total);
    else
      return (*watch)(stage);
  }
};

} // namespace python

/// \cond
namespace pybind11::detail {

// Functions take the user's function, or `None`, as what watches the call.
template <>
struct type_caster<python::Watch> {
  PYBIND11_TYPE_CASTER(python::Watch, const_name("object"));
  bool load(handle progress, bool) {
    if (!progress.is_none() && PyCallable_Check(progress.ptr()) == 0)
      throw value_error("progress is " +
                        str(module_::import("reprlib").attr("repr")(progress)).cast<std::string>() +
                        "; give a function, or None");
    value = python::Watch(reinterpret_borrow<object>(progress));
    return true;
  }
};

} // namespace pybind11::detail
/// \endcond

#endif // INTRINSIC_PYTHON_WATCH_H
