// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_mesh.h"

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
  facts.genus = IT::genus(mesh);
  facts.boundary_loops = IT::boundary_loops(mesh).size();
  for (const std::uint32_t umbrellas : IT::umbrellas(mesh)) {
    facts.isolated_vertices += umbrellas == 0 ? 1 : 0;
    facts.nonmanifold_vertices += umbrellas > 1 ? 1 : 0;
  }
  return facts;
}

Mesh_file read_mesh(const std::string& path, IT::Mollification mollification) {
  IT::Triangle_soup soup = IT::read_triangle_soup(path);
  const bool has_polygons = soup.triangulated_polygons > 0;
  try {
    const std::size_t polygons = soup.input_faces;
    IT::Intrinsic_input input(std::move(soup), mollification);
    Input_facts facts = facts_of(input.mesh);
    facts.polygons = polygons;
    facts.triangulated_polygons = input.triangulated_polygons;
    std::vector<std::uint32_t> polygon_of_triangle = std::move(input.names.polygon_of_triangle);
    return {std::move(input), facts, std::move(polygon_of_triangle)};
  } catch (const IT::Invalid_input& e) {
    const char* const note =
        !has_polygons ? "" : " (faces are numbered after triangulating polygons)";
    throw IT::Invalid_input(e.kind(), e.index(), path + ": " + e.what() + note);
  }
}

} // namespace program
