// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_mesh.h"
#include "naming_file.h"
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

Surface_choice surface_named(const std::string& word) {
  Surface_choice choice;
  choice.is_points = word == "points";
  if (word == "manifold") choice.kind = IT::Domain_kind::manifold;
  if (word == "orientation-cover") choice.kind = IT::Domain_kind::orientation_cover;
  if (word == "tufted") choice.kind = IT::Domain_kind::tufted_cover;
  if (word == "closed") choice.kind = IT::Domain_kind::closed;
  return choice;
}

namespace {

constexpr std::size_t usual_neighbors = 30;

IT::File_faces faces_for(const Surface_choice& choice) {
  if (choice.is_points) return IT::File_faces::ignored;
  return choice.kind == IT::Domain_kind::automatic ? IT::File_faces::optional
                                                   : IT::File_faces::needed;
}

Mesh_file mesh_of_points(const IT::Triangle_soup& soup, const Surface_choice& choice) {
  IT::Point_cloud made = IT::make_point_cloud(
      soup.points, choice.neighbors.value_or(usual_neighbors), choice.mollification);
  Mesh_file file;
  file.input = std::move(made.input);
  file.domain = std::move(made.report);
  file.cloud = std::move(made.points);
  return file;
}

Mesh_file mesh_of_faces(IT::Triangle_soup soup, const Surface_choice& choice) {
  if (choice.neighbors)
    throw IT::Invalid_input(IT::Element_kind::none, 0,
                            "--neighbors is for files without faces, and this file has faces; "
                            "leave it out, or ignore faces with --domain points");
  Mesh_file file;
  file.polygons = soup.input_faces;
  file.triangulated_polygons = soup.triangulated_polygons;
  file.faces_with_repeated_vertices = soup.faces_with_repeated_vertices;
  IT::Domain made = IT::make_domain(std::move(soup), choice.kind, choice.mollification);
  file.input = std::move(made.input);
  file.domain = std::move(made.report);
  return file;
}

} // namespace

Mesh_file mesh_of(IT::Triangle_soup soup, const Surface_choice& choice) {
  return soup.triangles.empty() ? mesh_of_points(soup, choice)
                                : mesh_of_faces(std::move(soup), choice);
}

Mesh_file read_mesh(const std::string& path, const Surface_choice& choice) {
  Stopwatch watch;
  IT::Triangle_soup soup = IT::read_triangle_soup(path, choice.polygons, faces_for(choice));
  const double seconds = watch.lap();
  return naming_file(path, [&] {
    Mesh_file file = mesh_of(std::move(soup), choice);
    file.seconds = seconds;
    return file;
  });
}

} // namespace program
