// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "load.h"

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

IT::Intrinsic_input read_mesh(const Options& options, Input_facts& facts,
                              std::vector<std::uint32_t>& polygon_of_triangle) {
  IT::Triangle_soup soup = IT::read_triangle_soup(options.input);
  try {
    IT::Gluing gluing =
        IT::gluing_from_triangles(static_cast<std::uint32_t>(soup.points.size()), soup.triangles);
    const std::size_t polygons = soup.input_faces, triangulated = soup.triangulated_polygons;
    std::vector<Point> points = std::move(soup.points);
    polygon_of_triangle = std::move(soup.polygon_of_triangle);
    soup = {}; // from here on peak memory counts
    IT::Gluing_map mesh(gluing);
    gluing = {};
    facts = facts_of(mesh);
    facts.polygons = polygons;
    facts.triangulated_polygons = triangulated;
    return {std::move(mesh), std::move(points), mollification_of(options)};
  } catch (const IT::Invalid_input& e) {
    const char* const note =
        soup.triangulated_polygons == 0 ? "" : " (faces are numbered after triangulating polygons)";
    throw IT::Invalid_input(e.kind(), e.index(), options.input + ": " + e.what() + note);
  }
}

std::string arithmetic_of(const Options& options) {
  if (!is_triangulation_file(options.input)) return options.arithmetic;
  std::string arithmetic = IT::read_intrinsic_triangulation_arithmetic(options.input);
  const auto fail = [&](const std::string& what) {
    throw IT::Invalid_input(IT::Element_kind::none, 0, options.input + ": " + what);
  };
  if (options.is_arithmetic_given && options.arithmetic != arithmetic)
    fail("the triangulation is stored in " + arithmetic +
         " arithmetic; leave --arithmetic out, or start from the mesh");
  if (options.is_mollification_given)
    fail("a stored triangulation cannot be mollified; leave --mollification out, or start from the "
         "mesh");
  return arithmetic;
}

} // namespace program
