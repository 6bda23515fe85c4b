// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "maps.h"

#include <CGAL/Intrinsic_simplification/embedding/embed_convex.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <stdexcept>
#include <utility>

// Convex polyhedra of metrics.

namespace python {

namespace {

using namespace py::literals;

py::dict embed(Surface& s, double flat_within, Watch& watch) {
  IT::Embed_options options;
  options.flat_within = flat_within;
  options.progress = [&watch](const IT::Embedding_progress& p) {
    return watch(IT::name_of(p.stage), p.steps);
  };
  IT::Convex_polyhedron found =
      with_triangulation(s, watch, [&](auto& t) { return IT::embed_convex(t, options); });
  if (found.points.empty()) throw std::runtime_error(IT::reason_without_points(found));
  const IT::Convexity_certificate& c = found.certificate;
  const py::dict certificate("proven"_a = c.is_proven, "within"_a = c.within,
                             "stretch"_a = c.stretch, "convex_edges"_a = c.convex_edges,
                             "flat_edges"_a = c.flat_edges, "concave_edges"_a = c.concave_edges);
  const bool is_polygon = found.shape == IT::Convex_shape::doubly_covered_polygon;
  return py::dict(
      "points"_a = array_of(std::move(found.points)), "faces"_a = array_of(std::move(found.faces)),
      "flat_vertices"_a = whole(found.flat_vertices), "status"_a = IT::name_of(found.status),
      "is_polygon"_a = is_polygon, "error"_a = found.largest_error, "steps"_a = found.steps,
      "certificate"_a = certificate);
}

} // namespace

void bind_embed(py::module_& m) { m.def("embed", &embed); }

} // namespace python
