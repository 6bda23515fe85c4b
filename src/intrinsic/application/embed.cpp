// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../commands.h"
#include "../support/warnings.h"
#include "application.h"

#include <CGAL/Intrinsic_simplification/embedding/embed_convex.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace program {

namespace {

Json json_of(const IT::Convex_polyhedron& found) {
  const IT::Convexity_certificate& c = found.certificate;
  const bool is_polygon = found.shape == IT::Convex_shape::doubly_covered_polygon;
  return {{"status", IT::name_of(found.status)},
          {"shape", is_polygon ? "doubly covered polygon" : "polyhedron"},
          {"steps", found.steps},
          {"largest_error", found.largest_error},
          {"faces", found.faces.size()},
          {"flat_vertices", found.flat_vertices.size()},
          {"proven", c.is_proven},
          {"within", c.within},
          {"edges",
           {{"convex", c.convex_edges}, {"flat", c.flat_edges}, {"concave", c.concave_edges}}}};
}

void write_polyhedron(std::ostream& out, const IT::Convex_polyhedron& found, bool is_obj) {
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  for (const auto& p : found.points) points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::vector<std::size_t>> faces;
  for (const auto& [i, j, k] : found.faces) faces.push_back({i, j, k});
  const auto precision = CGAL::parameters::stream_precision(17);
  if (!(is_obj ? CGAL::IO::write_OBJ(out, points, faces, precision)
               : CGAL::IO::write_OFF(out, points, faces, precision)))
    throw std::runtime_error("the polyhedron cannot be written");
}

} // namespace

void run_embed(const Options& options) {
  run_application(options, [&](const auto& t, const Sources&, const Points&, Progress& progress) {
    IT::Embed_options asked;
    asked.progress = [&progress](const IT::Embedding_progress& p) {
      return progress.show(IT::name_of(p.stage), std::to_string(p.steps) + " steps");
    };
    IT::Convex_polyhedron found = IT::embed_convex(t, asked);
    if (found.points.empty()) throw std::runtime_error(IT::reason_without_points(found));
    if (found.status != IT::Status::done)
      warn("the polyhedron is not convex, or lengths are not right, up to rounding; see its status "
           "and errors");
    Computed computed{"embed", json_of(found), {}};
    computed.write = [found = std::move(found), is_obj = options.output.ends_with(".obj")](
                         std::ostream& out, Json&) { write_polyhedron(out, found, is_obj); };
    return computed;
  });
}

} // namespace program
