// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../../src/intrinsic/status_name.h"
#include "Surface.h"
#include "kept_heat.h"
#include "places.h"
#include "searches.h"

#include <CGAL/Intrinsic_geodesics/compiled.h>
#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/distance/batches.h>
#include <CGAL/Intrinsic_operators/distance/heat_distances.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Twin_points.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

// Distances on surfaces: all on the Delaunay triangulation of a surface.

namespace python {

namespace {

struct Batch_visitor {
  Watch* watch;
  bool progress(std::size_t done, std::size_t) { return (*watch)("parts", done); }
};

// Distances by rows, or at targets; and how the search ended.
struct Found_distances {
  std::vector<double> values;
  IT::Status status = IT::Status::done;
  double reached = infinity;
};

template <class T>
Found_distances exact_distances(Surface& s, const T& t, const std::vector<Place>& sources,
                                const std::vector<Place>* targets, double maximum, Watch& watch) {
  Place_finder<T> find(t);
  auto& search = search_of(s, t);
  const auto at = targets == nullptr ? std::vector<IT::Surface_point>() : find.points(*targets);
  Search_visitor visitor{&watch};
  Found_distances found;
  found.status = search.search(
      find.points(sources),
      IT::parameters::maximum_distance(maximum).targets(at).visitor(std::ref(visitor)));
  found.reached = search.reached_distance();
  if (targets == nullptr) {
    found.values = search.distances();
    IT::Twin_points(t).copy(found.values);
    return found;
  }
  for (const Place& p : *targets) {
    double least = infinity;
    for (const IT::Surface_point& q : find.points(p)) least = std::min(least, search.distance(q));
    found.values.push_back(least);
  }
  if (!std::ranges::all_of(*targets, &Place::is_vertex)) s.cache.erase(exact_tables);
  return found;
}

// linear in the face of each target
template <class T>
std::vector<double> values_at(const T& t, const Eigen::VectorXd& rows,
                              const std::vector<Place>& targets) {
  Place_finder<T> find(t);
  std::vector<double> result;
  for (const Place& p : targets) {
    const IT::Surface_point q = find.points(p).front();
    auto h = t.numbers().halfedge_at(q.halfedge);
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k, h = next(h, t.mesh()))
      if (q.weights[k] != 0) sum += q.weights[k] * rows[t.input_vertex(source(h, t.mesh()))];
    result.push_back(sum);
  }
  return result;
}

template <class T>
Found_distances heat_distances(Surface& s, const T& t, const std::vector<Place>& sources,
                               const std::vector<Place>* targets, double time_factor,
                               Watch& watch) {
  const auto points = Place_finder<T>(t).points(sources);
  const Eigen::VectorXd rows = with_heat<IT::Heat_distance<T>>(
      s, t, time_factor, watch, [&](auto& heat) { return heat.distances(points); });
  if (rows.size() == 0) return {}; // the watch has ended it
  if (targets != nullptr) return {values_at(t, rows, *targets)};
  Found_distances found{std::vector<double>(rows.begin(), rows.end())};
  IT::Twin_points(t).copy(found.values);
  return found;
}

// How distances are computed.
struct Method {
  bool is_exact = true;
  double maximum = infinity, time_factor = 1;
};

py::tuple distance(Surface& s, const Place_arrays& sources,
                   const std::optional<Place_arrays>& targets, const Method& method,
                   const py::object& progress) {
  const std::vector<Place> from = places_of(s, sources);
  expect_sources(from);
  const std::vector<Place> to = targets ? places_of(s, *targets) : std::vector<Place>();
  const std::vector<Place>* const asked = targets ? &to : nullptr;
  Watch watch(progress);
  Found_distances found = with_triangulation(s, watch, [&](const auto& t) {
    return method.is_exact ? exact_distances(s, t, from, asked, method.maximum, watch)
                           : heat_distances(s, t, from, asked, method.time_factor, watch);
  });
  return py::make_tuple(array_of(std::move(found.values)), program::name(found.status),
                        found.reached);
}

template <class T, class Number>
IT::Status fill(Surface& s, const T& t, const std::vector<std::vector<Place>>& sets,
                const Method& method, std::size_t threads, std::span<Number> out, Watch& watch) {
  const auto finish = [&](IT::Status status) {
    const IT::Twin_points twins(t);
    const std::size_t rows = t.number_of_vertices();
    for (std::size_t i = 0; i < sets.size(); ++i) {
      const std::span<Number> column = out.subspan(i * rows, rows);
      twins.copy(column);
    }
    return status;
  };
  std::vector<std::vector<IT::Surface_point>> points;
  Place_finder<T> find(t);
  for (const std::vector<Place>& set : sets) points.push_back(find.points(set));
  Batch_visitor visitor{&watch};
  const auto options = IT::parameters::number_of_threads(threads).visitor(std::ref(visitor));
  if (method.is_exact)
    return finish(
        IT::polyhedral_distances(t, points, out, options.maximum_distance(method.maximum)));
  return finish(
      with_heat<IT::Heat_distance<T>>(s, t, method.time_factor, watch, [&](const auto& heat) {
        return IT::heat_distances(heat, points, out, options);
      }));
}

template <class Number>
std::string fill_array(Surface& s, const std::vector<std::vector<Place>>& sets,
                       const Method& method, std::size_t threads, py::array_t<Number> out,
                       const py::object& progress) {
  if ((out.flags() & py::array::c_style) == 0 || !out.writeable())
    throw py::value_error("out must be a writable array in C order");
  const std::span<Number> numbers(out.mutable_data(), static_cast<std::size_t>(out.size()));
  Watch watch(progress);
  return program::name(with_triangulation(
      s, watch, [&](const auto& t) { return fill(s, t, sets, method, threads, numbers, watch); }));
}

std::string distances(Surface& s, const Place_arrays& sources, const std::vector<std::size_t>& ends,
                      const Method& method, std::size_t threads, const py::array& out,
                      const py::object& progress) {
  const std::vector<Place> all = places_of(s, sources);
  std::vector<std::vector<Place>> sets;
  auto from = all.begin();
  for (const std::size_t end : ends) {
    const auto to = all.begin() + static_cast<std::ptrdiff_t>(end);
    sets.emplace_back(from, to);
    expect_sources(sets.back());
    from = to;
  }
  if (py::isinstance<py::array_t<double>>(out))
    return fill_array<double>(s, sets, method, threads, out, progress);
  if (py::isinstance<py::array_t<float>>(out))
    return fill_array<float>(s, sets, method, threads, out, progress);
  throw py::value_error("out must have the type float64 or float32");
}

py::array_t<double> pair_distances(Surface& s, const Place_arrays& first,
                                   const Place_arrays& second, std::size_t threads,
                                   const py::object& progress) {
  const std::vector<Place> from = places_of(s, first), to = places_of(s, second);
  Watch watch(progress);
  return array_of(with_triangulation(s, watch, [&](const auto& t) {
    Place_finder find(t);
    std::vector<IT::Surface_point> starts, ends; // on a cover, of each pair all copies
    std::vector<std::size_t> pair;
    const auto places = [&find](const Place& p) {
      std::vector<IT::Surface_point> points = find.points(p);
      if (p.is_vertex()) points.resize(1); // copies of a vertex are one point for distances
      return points;
    };
    for (std::size_t i = 0; i < from.size(); ++i)
      for (const IT::Surface_point& p : places(from[i]))
        for (const IT::Surface_point& q : places(to[i])) {
          starts.push_back(p);
          ends.push_back(q);
          pair.push_back(i);
        }
    Batch_visitor visitor{&watch};
    const std::vector<double> all = IT::pair_distances(
        t, starts, ends, IT::parameters::number_of_threads(threads).visitor(std::ref(visitor)));
    std::vector<double> result(from.size(), infinity);
    for (std::size_t k = 0; k < all.size(); ++k)
      result[pair[k]] = std::min(result[pair[k]], all[k]);
    return result;
  }));
}

} // namespace

void bind_distances(py::module_& m) {
  py::class_<Method>(m, "DistanceMethod")
      .def(py::init<bool, double, double>(), py::arg("is_exact"), py::arg("maximum"),
           py::arg("time_factor"));
  m.def("distance", distance);
  m.def("distances", distances);
  m.def("pair_distances", pair_distances);
  bind_cells(m);
}

} // namespace python
