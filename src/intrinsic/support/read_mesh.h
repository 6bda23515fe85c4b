// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUPPORT_READ_MESH_H
#define INTRINSIC_SUPPORT_READ_MESH_H

#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/domains/Point_cloud.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace program {

namespace IT = CGAL::Intrinsic_triangulations;

/// Coordinates of a vertex.
using Point = std::array<double, 3>;

/// Facts about the input before the first move.
struct Input_facts {
  std::size_t vertices = 0, edges = 0, faces = 0, boundary_edges = 0, components = 0;
  std::optional<std::size_t> genus;
  std::size_t boundary_loops = 0, isolated_vertices = 0, nonmanifold_vertices = 0;
  /// 0 for an intrinsic triangulation
  std::size_t polygons = 0, triangulated_polygons = 0, faces_with_repeated_vertices = 0;
};

/// counts the elements of a mesh.
Input_facts facts_of(const IT::Gluing_map& mesh);

/// Which surface is made of a file.
struct Surface_choice {
  IT::Mollification mollification = IT::Mollification::automatic;
  IT::Domain_kind kind = IT::Domain_kind::automatic;   ///< of faces
  bool is_points = false;                              ///< whether faces are ignored
  std::optional<std::size_t> neighbors = std::nullopt; ///< of each point
  IT::Nonplanar_polygons polygons = IT::Nonplanar_polygons::fan;
};

/// returns the surface that one of `surface_words` names.
Surface_choice surface_named(const std::string& word);

/// What a mesh file contains.
struct Mesh_file {
  IT::Intrinsic_input input;
  std::size_t polygons = 0, triangulated_polygons = 0, faces_with_repeated_vertices = 0;
  double seconds = 0; ///< that reading took, without matching edges
  IT::Domain_report domain;
  std::optional<IT::Point_cloud_report> cloud = std::nullopt; ///< if the surface was made of points

  /// returns the vertex of the file that a vertex of the mesh is, or is a copy of.
  std::uint32_t vertex(IT::Gluing_map::Vertex v) const { return input.names.row(v.index); }
};

/// makes the chosen surface of triangles, or of points if there are none.
/// \throws Invalid_input naming the element and the remedy
Mesh_file mesh_of(IT::Triangle_soup soup, const Surface_choice& choice);

/// reads a file of a mesh or of points, and makes the chosen surface.
/// \throws Invalid_input naming the file, the element and the remedy
Mesh_file read_mesh(const std::string& path, const Surface_choice& choice);

} // namespace program

#endif // INTRINSIC_SUPPORT_READ_MESH_H
