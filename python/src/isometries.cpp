// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"
#include "curve_arrays.h"
#include "places.h"

#include <CGAL/Intrinsic_simplification/isometry/Canonical_form.h>
#include <CGAL/Intrinsic_simplification/isometry/find_isometries.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Isometries of surfaces, and their hashes.

namespace python {

namespace {

// Forms store values that they compute, also those that several surfaces share.
std::mutex& mutex_of_forms() {
  static std::mutex mutex;
  return mutex;
}

IT::Isometry_options watched(Watch& watch) {
  IT::Isometry_options options;
  options.progress = [&watch](const IT::Isometry_progress& p) {
    return watch(IT::name_of(p.stage));
  };
  return options;
}

IT::Canonical_form form_of(Surface& s, Watch& watch) {
  return naming(s.name, [&] {
    return with_triangulation(s, watch, [&](const auto& t) {
      return s.cached<IT::Canonical_form>("canonical form", [&] {
        auto form = std::make_unique<IT::Canonical_form>(IT::canonical_form(t, watched(watch)));
        if (form->status() == IT::Status::cancelled) throw std::runtime_error(form->note());
        return form;
      });
    });
  });
}

// Calls a function alone, without the interpreter.
template <class Function>
auto with_forms(Watch& watch, const Function& function) {
  return without_interpreter(watch, [&] {
    const std::lock_guard<std::mutex> lock(mutex_of_forms());
    return function();
  });
}

std::uint64_t hash(Surface& s, Watch& watch) {
  const IT::Canonical_form form = form_of(s, watch);
  return with_forms(watch, [&] { return form.hash(watched(watch)); });
}

struct Found_isometries {
  IT::Canonical_form first, second;
  IT::Isometries found;
};

std::unique_ptr<Found_isometries> isometries(Surface& s, Surface& other, Watch& watch) {
  const IT::Canonical_form first = form_of(s, watch), second = form_of(other, watch);
  return with_forms(watch, [&] {
    return std::make_unique<Found_isometries>(
        Found_isometries{first, second, IT::find_isometries(first, second, watched(watch))});
  });
}

// The vertex of the other surface at each vertex, or -1 if the vertex is flat. Of several copies of
// a vertex on a cover, the first one counts.
py::array_t<std::int64_t> images_of_vertices(const Found_isometries& f, const IT::Isometry& map) {
  const IT::Input &from = f.first.input(), &to = f.second.input();
  std::vector<std::int64_t> images(from.number_of_rows(), -1);
  for (std::uint32_t v = 0; v < from.number_of_vertices(); ++v)
    if (const std::uint32_t w = map.image_of_vertex(v);
        w != IT::Canonical_form::none && images[from.names().row(v)] < 0)
      images[from.names().row(v)] = to.names().row(w);
  return array_of(std::move(images));
}

py::tuple images_of_points(const Found_isometries& f, const IT::Isometry& map, Surface& s,
                           const Place_arrays& arrays, Watch& watch) {
  std::vector<IT::Surface_point> points;
  for (const Place& p : places_of(s, arrays))
    points.push_back(IT::point_on_input(f.first.input(), p));
  points = with_forms(watch, [&] { return map.images_of(points); });
  const IT::Input& to = f.second.input();
  std::vector<std::int64_t> faces;
  Points weights;
  for (const IT::Surface_point& p : points) {
    const std::uint32_t face = to.face(p.halfedge), first = to.halfedge_of_face(face);
    const std::size_t shift = p.halfedge == first ? 0 : to.next(first) == p.halfedge ? 2 : 1;
    faces.push_back(to.names().polygon(face));
    weights.push_back({p.weights[shift], p.weights[(shift + 1) % 3], p.weights[(shift + 2) % 3]});
  }
  return py::make_tuple(array_of(std::move(faces)), array_of(std::move(weights)));
}

} // namespace

void bind_isometries(py::module_& m) {
  py::class_<IT::Isometry>(m, "Isometry")
      .def_property_readonly("reverses_orientation", &IT::Isometry::reverses_orientation);
  py::class_<Found_isometries>(m, "Isometries")
      .def_property_readonly(
          "answer", [](const Found_isometries& f) { return IT::name_of(f.found.answer()); })
      .def_property_readonly("count", [](const Found_isometries& f) { return f.found.count(); })
      .def_property_readonly("size", [](const Found_isometries& f) { return f.found.size(); })
      .def_property_readonly("note", [](const Found_isometries& f) { return f.found.note(); })
      .def_property_readonly("largest_difference",
                             [](const Found_isometries& f) { return f.found.largest_difference(); })
      .def("map", [](const Found_isometries& f, std::size_t i) { return f.found[i]; })
      .def("images_of_vertices", &images_of_vertices)
      .def("images_of_points", [](const Found_isometries& f, const IT::Isometry& map, Surface& s,
                                  const Place_arrays& points) {
        Watch watch;
        return images_of_points(f, map, s, points, watch);
      });
  m.def("isometries", isometries);
  m.def("hash", hash);
}

} // namespace python
