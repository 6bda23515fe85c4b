// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_mesh.h"
#include "progress.h"

#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>

#include <utility>

namespace program {

Input_facts facts_of(const IT::Gluing_map& mesh) {
  Input_facts facts;
  facts.vertices = mesh.number_of_vertices();
  facts.edges = mesh.number_of_edges();
  facts.faces = mesh.number_of_faces();
  for (std::uint32_t h = 0; h < mesh.number_of_halfedges(); ++h)
    if (mesh.face({h}).index == IT::Gluing::none) ++facts.boundary_edges;
  facts.components = IT::connected_components(mesh).count;
  facts.boundary_loops = IT::boundary_loops(mesh).size();
  std::size_t umbrellas = 0;
  for (const std::uint32_t n : IT::umbrellas(mesh)) {
    umbrellas += n;
    facts.isolated_vertices += n == 0 ? 1 : 0;
    facts.nonmanifold_vertices += n > 1 ? 1 : 0;
  }
  // as IT::genus() does, which would count all of this again
  if (IT::is_orientable(mesh))
    facts.genus =
        (2 * facts.components + facts.edges - umbrellas - facts.faces - facts.boundary_loops) / 2;
  return facts;
}

Mesh_file read_mesh(const std::string& path, IT::Mollification mollification,
                    IT::Domain_kind domain, IT::Nonplanar_polygons kind) {
  Stopwatch watch;
  IT::Triangle_soup soup = IT::read_triangle_soup(path, kind);
  const double seconds = watch.lap();
  const std::size_t polygons = soup.input_faces, triangulated = soup.triangulated_polygons;
  try {
    IT::Domain made = IT::make_domain(std::move(soup), domain, mollification);
    std::vector<std::uint32_t> polygon_of_triangle =
        made.input.planar_polygons.empty() ? std::move(made.input.names.polygon_of_triangle)
                                           : made.input.names.polygon_of_triangle;
    return {std::move(made.input), std::move(polygon_of_triangle), polygons, triangulated, seconds,
            std::move(made.report)};
  } catch (const IT::Invalid_input& e) {
    const char* const note =
        triangulated == 0 ? "" : " (faces are numbered after triangulating polygons)";
    throw IT::Invalid_input(e.kind(), e.index(), path + ": " + e.what() + note);
  }
}

} // namespace program
