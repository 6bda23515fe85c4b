// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../commands.h"
#include "../support/warnings.h"
#include "../view.h"
#include "application.h"

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_simplification/embedding/embed_convex.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cstddef>
#include <cstdint>
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
          {"stretch", c.stretch},
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

// Front and back of a polygon have points of their own, so that edges have two sides.
void write_page_of(std::ostream& out, const IT::Convex_polyhedron& found, const Options& options,
                   const Json& json) {
  std::vector<Point> points = found.points;
  std::vector<std::array<std::uint32_t, 3>> faces = found.faces;
  if (found.shape == IT::Convex_shape::doubly_covered_polygon) {
    const auto shift = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), found.points.begin(), found.points.end());
    for (auto& [i, j, k] : faces) {
      const Point &p = points[i], &q = points[j], &r = points[k];
      if ((q[0] - p[0]) * (r[1] - p[1]) > (q[1] - p[1]) * (r[0] - p[0])) continue;
      i += shift;
      j += shift;
      k += shift;
    }
  }
  const auto n = static_cast<std::uint32_t>(points.size());
  const IT::Corresponding_triangulation t(
      IT::Intrinsic_input(IT::Gluing_map(IT::gluing_from_triangles(n, faces)), points));
  const IT::Common_subdivision s = IT::common_subdivision(t);
  write_view(out, s, IT::positions(s, points, t.input()), options, json, {});
}

} // namespace

void run_embed(const Options& options) {
  run_application(options, [&](const auto& t, const Sources&, const Points&, Progress& progress) {
    IT::Embed_options asked;
    if (options.flat_within) asked.flat_within = *options.flat_within;
    asked.progress = [&progress](const IT::Embedding_progress& p) {
      return progress.show(IT::name_of(p.stage), std::to_string(p.steps) + " steps");
    };
    IT::Convex_polyhedron found = IT::embed_convex(t, asked);
    if (found.points.empty()) throw std::runtime_error(IT::reason_without_points(found));
    if (found.status != IT::Status::done)
      warn("the polyhedron is not convex, or lengths are not right, up to rounding; see its status "
           "and errors");
    Computed computed{"embed", json_of(found), {}};
    computed.write_page = [found, &options](std::ostream& out, const Json& json) {
      write_page_of(out, found, options, json);
    };
    computed.write = [found = std::move(found), is_obj = options.output.ends_with(".obj")](
                         std::ostream& out, Json&) { write_polyhedron(out, found, is_obj); };
    return computed;
  });
}

} // namespace program
