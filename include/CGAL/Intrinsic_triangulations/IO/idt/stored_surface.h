// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_STORED_SURFACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_STORED_SURFACE_H

#include <CGAL/Intrinsic_triangulations/IO/idt/read_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/build_surface.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_surface.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/covers/restore_input_edges.h>
#include <CGAL/Intrinsic_triangulations/support/Stopwatch.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/*!
\file
What is known of triangulations that were stored.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief returns the arithmetic of a stored triangulation, see
`read_intrinsic_triangulation_arithmetic()`, and refuses options that contradict the file.
\param path the file
\param arithmetic what was asked for, or nothing
\param is_mollified whether mollification was asked for
\param options which surface was asked for
\throws Invalid_input naming the file and the option, by its name in the program
*/
std::string stored_arithmetic(const std::string& path, const std::optional<std::string>& arithmetic,
                              bool is_mollified, const Surface_options& options);

/*!
\brief finds out what is known of a triangulation that was stored: its file has the input.
\tparam Triangulation an `Intrinsic_triangulation`
\param stored the result of `read_intrinsic_triangulation()`
\return the triangulation, the point of each row, and what is known of the surface
\complexity linear
*/
template <NumberedTriangulation Triangulation>
Built_surface<Triangulation> stored_surface(Triangulation stored) {
  Built_surface<Triangulation> built{std::move(stored)};
  const Triangulation& t = built.triangulation;
  if (const auto& scaled = t.input().metric().points(); !scaled.empty())
    built.points = internal::points_by_rows(scaled.size(), t.input().names(), [&](std::uint32_t v) {
      std::array<double, 3> p = scaled[v];
      for (double& x : p) x = std::ldexp(x, -t.metric().scale_exponent());
      return p;
    });
  built.facts.polygons = number_of_polygons(t.input());
  built.facts.triangulated_polygons = t.report().triangulated_polygons;
  internal::count_elements_of(built);
  return built;
}

/*!
\brief reads a triangulation from its file, and finds out what is known of it.
\tparam Triangulation an `Intrinsic_triangulation`
\param path the file
\return what `stored_surface()` does, and how long it took to read
\throws Invalid_input see `read_intrinsic_triangulation()`
\complexity that of `read_intrinsic_triangulation()`
*/
template <NumberedTriangulation Triangulation>
Built_surface<Triangulation> read_stored_surface(const std::string& path) {
  Stopwatch watch;
  auto t = read_intrinsic_triangulation<Triangulation>(std::filesystem::path(path));
  const double seconds = watch.lap();
  Built_surface<Triangulation> built = stored_surface(std::move(t));
  built.facts.seconds_of_reading = seconds;
  return built;
}

/*!
\brief restores edges of the input that are kept from now on, see `restore_input_edges()`.
\tparam Triangulation see `restore_input_edges()`
\param t the triangulation
\param is_kept nonzero for each of them, by its number in `t.input()`
\return which one cannot be restored, in words; empty: all are edges again
\complexity that of `restore_input_edges()`
*/
template <NumberedTriangulation Triangulation>
  requires CurveCoordinates<typename Triangulation::Correspondence> std::string
  restore_kept_edges(Triangulation& t, const std::vector<char>& is_kept) {
    const std::uint32_t e = restore_input_edges(t, is_kept).missing;
    if (e == Gluing::none) return {};
    const auto row = [&](std::uint32_t v) { return std::to_string(t.input().names().row(v)); };
    return "the edge between vertices " + row(t.input().source(2 * e)) + " and " +
           row(t.input().target(2 * e)) +
           " of the input, which is to be kept, has been flipped away and does not come back; "
           "start from the mesh";
  }

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_STORED_SURFACE_H
