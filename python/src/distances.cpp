// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"
#include "places.h"
#include "searches.h"

#include <CGAL/Intrinsic_operators/distance/Distances.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/connectivity/status_name.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

// Distances on surfaces: all on the Delaunay triangulation of a surface.

namespace python {

namespace {

using Method = IT::Distance_options;

// Calls a function with what finds the distances of a surface.
template <class Function>
auto with_distances(Surface& s, Method& method, std::size_t threads, const py::object& progress,
                    const Function& function) {
  Watch watch(progress);
  method.number_of_threads = threads;
  method.progress = [&watch](IT::Distance_step step, std::uint64_t done, std::uint64_t) {
    return watch(step == IT::Distance_step::windows    ? "windows"
                 : step == IT::Distance_step::matrices ? "matrices"
                                                       : "parts",
                 done);
  };
  return with_triangulation(s, watch, [&](const auto& t) { return function(distances_on(s, t)); });
}

py::tuple distance(Surface& s, const Place_arrays& sources,
                   const std::optional<Place_arrays>& targets, Method method,
                   const py::object& progress) {
  const std::vector<Place> from = places_of(s, sources);
  const std::vector<Place> to = targets ? places_of(s, *targets) : std::vector<Place>();
  IT::Found_distances found = with_distances(
      s, method, 0, progress, [&](auto& find) { return find.from(from, method, to); });
  return py::make_tuple(array_of(std::move(targets ? found.at_targets : found.by_row)),
                        IT::name_of(found.status));
}

template <class Number>
std::string fill(Surface& s, const std::vector<std::vector<Place>>& sets, Method& method,
                 std::size_t threads, py::array_t<Number> out, const py::object& progress) {
  if ((out.flags() & py::array::c_style) == 0 || !out.writeable())
    throw py::value_error("out must be a writable array in C order");
  const std::span<Number> numbers(out.mutable_data(), static_cast<std::size_t>(out.size()));
  return IT::name_of(with_distances(s, method, threads, progress, [&](auto& find) {
    return find.columns(sets, numbers, method);
  }));
}

std::string distances(Surface& s, const Place_arrays& sources, const std::vector<std::size_t>& ends,
                      Method method, std::size_t threads, const py::array& out,
                      const py::object& progress) {
  const std::vector<Place> all = places_of(s, sources);
  std::vector<std::vector<Place>> sets;
  auto from = all.begin();
  for (const std::size_t end : ends) {
    const auto to = all.begin() + static_cast<std::ptrdiff_t>(end);
    sets.emplace_back(from, to);
    from = to;
  }
  if (py::isinstance<py::array_t<double>>(out))
    return fill<double>(s, sets, method, threads, out, progress);
  if (py::isinstance<py::array_t<float>>(out))
    return fill<float>(s, sets, method, threads, out, progress);
  throw py::value_error("out must have the type float64 or float32");
}

py::array_t<double> pair_distances(Surface& s, const Place_arrays& first,
                                   const Place_arrays& second, Method method, std::size_t threads,
                                   const py::object& progress) {
  const std::vector<Place> from = places_of(s, first), to = places_of(s, second);
  return array_of(with_distances(s, method, threads, progress,
                                 [&](auto& find) { return find.of_pairs(from, to, method); }));
}

} // namespace

void bind_distances(py::module_& m) {
  py::class_<Method>(m, "DistanceMethod")
      .def(py::init([](bool is_exact, double maximum, double time_factor) {
        return Method{is_exact ? IT::Distance_method::exact : IT::Distance_method::heat, maximum,
                      time_factor};
      }));
  m.def("distance", distance);
  m.def("distances", distances);
  m.def("pair_distances", pair_distances);
  bind_cells(m);
}

} // namespace python
