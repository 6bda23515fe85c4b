// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_SURFACE_H
#define INTRINSIC_PYTHON_SURFACE_H

#include "Watch.h"
#include "arrays.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/build_surface.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_surface.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace python {

/// The triangulation of a surface with exact arithmetic.
using Exact = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                          IT::Integer_coordinates>;
/// The triangulation of a surface with doubles.
using Double = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>,
                                           IT::Integer_coordinates>;

/*!
\brief is the object behind `intrinsic.Surface`: a triangulation that is never changed, and what was
computed of it.

Predicates of exact triangulations sharpen what is stored, so that reading needs the lock, too: see
`with_triangulation()`.
*/
struct Surface {
  /// takes a triangulation and what is known of its input.
  template <IT::NumberedTriangulation Triangulation>
  Surface(IT::Built_surface<Triangulation> built, std::string its_name)
      : triangulation(std::make_unique<Triangulation>(std::move(built.triangulation))),
        facts(std::move(built.facts)), points(std::move(built.points)),
        is_in_space(!points.empty()), name(std::move(its_name)) {}

  /// It does not change but for improvements.
  std::variant<std::unique_ptr<Exact>, std::unique_ptr<Double>> triangulation;
  /// What is known of the input.
  IT::Surface_facts facts;
  /// A point per vertex of the user's, in its units; empty for an abstract metric.
  std::vector<Point> points;
  /// Whether the points define the metric; else they are for pictures only, if there are any.
  bool is_in_space;
  /// What messages and statistics call the surface: its file, if it has one.
  std::string name;
  /// Whether edges were flipped until they are Delaunay, but for those that are kept.
  bool is_flipped = false;

  /// Held by whoever uses the triangulation or the cache.
  std::mutex mutex;
  /// The thread that does.
  std::atomic<std::thread::id> user{};
  /// That of the call that holds the lock; methods in the cache ask it whether to go on. Only valid
  /// while the lock is held.
  Watch* watch = nullptr;
  /// What was computed of the triangulation, such as factorizations, by the names of the methods
  /// and their parameters.
  std::map<std::string, std::shared_ptr<void>> cache;

  /// \throws std::runtime_error if this thread works on the surface
  void expect_free() const {
    if (user.load() == std::this_thread::get_id())
      throw std::runtime_error("a function that is called while a surface works must not use that "
                               "surface; copy it before");
  }

  /// returns what is in the cache; `make()` computes it if it is not yet. \pre the lock is held
  template <class Value, class Make>
  Value& cached(const std::string& key, const Make& make) {
    std::shared_ptr<void>& value = cache[key];
    if (!value) {
      try {
        value = std::shared_ptr<Value>(make());
      } catch (...) {
        cache.erase(key);
        throw;
      }
    }
    return *static_cast<Value*>(value.get());
  }
};

/// calls a function, and puts the name of what is wrong before its errors, which become
/// `Invalid_input`.
template <class Function>
auto naming(const std::string& name, const Function& function) {
  try {
    return function();
  } catch (const IT::Invalid_input& e) {
    throw IT::Invalid_input(e.kind(), e.index(), name + ": " + e.what());
  } catch (const std::invalid_argument& e) {
    throw IT::Invalid_input(IT::Element_kind::none, 0, name + ": " + e.what());
  }
}

/// Holds the lock of a surface without that of the interpreter.
class Surface_lock {
public:
  /// waits for the lock. \throws std::runtime_error if this thread has it
  Surface_lock(Surface& s, Watch& watch) : surface_(s) {
    s.expect_free();
    s.mutex.lock();
    s.watch = &watch;
    s.user.store(std::this_thread::get_id());
  }
  Surface_lock(const Surface_lock&) = delete;
  Surface_lock& operator=(const Surface_lock&) = delete;
  /// gives it back.
  ~Surface_lock() {
    surface_.watch = nullptr;
    surface_.user.store({});
    surface_.mutex.unlock();
  }

private:
  Surface& surface_;
};

/*!
\brief calls a function without the interpreter's lock, and throws what the watch has seen.
\tparam Function called without arguments; its result must hold no object of Python
*/
template <class Function>
auto without_interpreter(Watch& watch, const Function& function) {
  using Result = std::invoke_result_t<const Function&>;
  try {
    if constexpr (std::is_void_v<Result>) {
      {
        const py::gil_scoped_release release;
        function();
      }
      watch.rethrow();
    } else {
      Result result = [&]() -> Result {
        const py::gil_scoped_release release;
        return function();
      }();
      watch.rethrow();
      return result;
    }
  } catch (...) {
    watch.rethrow(); // which is why the work failed, if it has anything
    throw;
  }
}

/*!
\brief calls a function with the triangulation of a surface, without the interpreter's lock and with
that of the surface.
\tparam Function called with `Exact&` or `Double&`; it returns the same type for both, which holds
  no object of Python
\param s the surface
\param watch what visitors ask whether to go on
\param function the function
\throws what the watch has seen, such as `KeyboardInterrupt`, else what the function throws
*/
template <class Function>
auto with_triangulation(Surface& s, Watch& watch, const Function& function) {
  return without_interpreter(watch, [&] {
    const Surface_lock lock(s, watch);
    return std::visit([&](auto& t) { return function(*t); }, s.triangulation);
  });
}

/// calls a function that does not take long.
template <class Function>
auto with_triangulation(Surface& s, const Function& function) {
  Watch watch;
  return with_triangulation(s, watch, function);
}

/// returns a surface of glued triangles. \param name what messages call it
std::shared_ptr<Surface> surface_of_triangles(IT::Intrinsic_input input, const std::string& name,
                                              bool is_exact);

/// adds the functions that make surfaces of arrays and files.
void bind_surface(py::module_& m);
/// adds those that flip, refine and measure.
void bind_improve(py::module_& m);
/// adds those that read triangulations, and their matrices.
void bind_queries(py::module_& m);
/// adds those on common subdivisions.
void bind_subdivision(py::module_& m);
/// adds those on distances.
void bind_distances(py::module_& m);
/// adds those on curves.
void bind_curves(py::module_& m);
/// adds those on vectors.
void bind_fields(py::module_& m);
/// adds those on maps.
void bind_maps(py::module_& m);
/// adds those that make surfaces coarse.
void bind_simplify(py::module_& m);
/// adds those on isometries.
void bind_isometries(py::module_& m);
/// adds what writes pages.
void bind_pages(py::module_& m);
/// adds what writes files of other programs.
void bind_files(py::module_& m);

} // namespace python

#endif // INTRINSIC_PYTHON_SURFACE_H
