// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes, files and elements of meshes where something else is needed: messages say what to do.

#include <CGAL/Intrinsic_conformal/angles/Prescribed_angles.h>
#include <CGAL/Intrinsic_conformal/layout/conformal_sphere.h>
#include <CGAL/Intrinsic_conformal/metric/conformal_metric.h>
#include <CGAL/Intrinsic_operators/distance/Heat_distance.h>
#include <CGAL/Intrinsic_operators/editing/interpolate_harmonically.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/parametrization/harmonic_map.h>
#include <CGAL/Intrinsic_operators/vectors/direction_field.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <cstdint>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace case_mesh_is_flipped {
// Meshes have no metric of their own. What is done with the result is wrong only because of that.
// error at once: build one of the mesh, Corresponding_triangulation t\(mesh\)
bool misuse(Mesh& mesh) {
  const auto result = IT::flip_to_delaunay(mesh);
  return result.status == IT::Status::done;
}
} // namespace case_mesh_is_flipped

namespace case_mesh_has_no_laplacian {
// Operators are those of a triangulation.
// error at once: build one of the mesh, Corresponding_triangulation t\(mesh\)
void misuse(const Mesh& mesh) { IT::cotangent_laplacian(mesh); }
} // namespace case_mesh_has_no_laplacian

namespace case_mesh_has_no_map {
// Maps are those of a triangulation.
// error at once: build one of the mesh, Corresponding_triangulation t\(mesh\)
void misuse(const Mesh& mesh) { IT::harmonic_map(mesh); }
} // namespace case_mesh_has_no_map

namespace case_mesh_has_no_direction_field {
// Fields are those of a triangulation.
// error at once: build one of the mesh, Corresponding_triangulation t\(
void misuse(const Mesh& mesh) { IT::smoothest_direction_field(mesh, 4); }
} // namespace case_mesh_has_no_direction_field

namespace case_mesh_is_not_interpolated {
// Values are interpolated on a triangulation.
// error at once: build one of the mesh, Corresponding_triangulation t\(mesh\)
void misuse(const Mesh& mesh) {
  IT::interpolate_harmonically(mesh, std::vector<std::uint32_t>{0}, Eigen::VectorXd::Zero(1));
}
} // namespace case_mesh_is_not_interpolated

namespace case_domain_is_no_input {
// error at once: for a Domain or Point_cloud pass its input
void misuse(IT::Domain& domain) { IT::Corresponding_triangulation t(domain); }
} // namespace case_domain_is_no_input

namespace case_file_is_no_mesh {
// Files are read first.
// error at once: read_triangle_soup\(name\)
void misuse() { IT::Corresponding_triangulation t("mesh.off"); }
} // namespace case_file_is_no_mesh

namespace case_forgotten_OpenMesh_adaptor {
// OpenMesh meshes are known to BGL by a header; a class without one stands for them here.
// error at once: include CGAL/Intrinsic_triangulations/connectivity/adaptors/OpenMesh_adaptor.h
struct OpenMesh_mesh {};
void misuse(const OpenMesh_mesh& mesh) { IT::Corresponding_triangulation t(mesh); }
} // namespace case_forgotten_OpenMesh_adaptor

namespace case_number_is_no_mesh {
// A triangulation owns a mesh; most own a Gluing_map.
// error at once: first argument of Intrinsic_triangulation is a mesh .* mostly Gluing_map
void misuse(IT::Intrinsic_triangulation<int>*);
} // namespace case_number_is_no_mesh

namespace case_owned_OpenMesh_without_adaptor {
// A class that BGL does not know stands for a mesh of OpenMesh without the header.
// error at once: for OpenMesh or a Polyhedron_3 with ids include OpenMesh_adaptor.h
struct OpenMesh_mesh {};
void misuse(IT::Intrinsic_triangulation<OpenMesh_mesh>*);
} // namespace case_owned_OpenMesh_without_adaptor

namespace case_forgotten_Polyhedron_3_adaptor {
// BGL knows a polyhedron, but its elements have no numbers without ids.
// error at once: for a Polyhedron_3 Polyhedron_3_adaptor.h
void misuse(const CGAL::Polyhedron_3<Kernel>& mesh) { IT::Corresponding_triangulation t(mesh); }
} // namespace case_forgotten_Polyhedron_3_adaptor

namespace case_map_of_mesh_edges {
// Edges of the mesh are not those of the triangulation.
// error at once: constrained_input_edges\(t, mesh, map\) makes one of a map from edges of your mesh
void misuse(Mesh& mesh) {
  IT::Corresponding_triangulation t(mesh);
  const auto map = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  IT::flip_to_delaunay(t, IT::parameters::edge_is_constrained_map(map));
}
} // namespace case_map_of_mesh_edges

namespace case_source_is_no_vertex_of_triangulation {
// Sources are on the triangulation, whose mesh is another one than the user's.
// error at once: a vertex of the user's mesh is vertex_on_intrinsic
void misuse(const IT::Corresponding_triangulation& t) {
  IT::Heat_distance(t).distances(Mesh::Vertex_index(0));
}
} // namespace case_source_is_no_vertex_of_triangulation

namespace case_conformal_sphere_of_euclidean_triangulation {
// Conformal maps scale horocycles, which triangulations with Euclid's metric do not have.
// error at once: build one of ideal_start\(t\), or call uniformize\(\)
void misuse(IT::Corresponding_triangulation& t) { IT::conformal_sphere(t); }
} // namespace case_conformal_sphere_of_euclidean_triangulation

namespace case_conformal_metric_of_mesh {
// error at once: build one of ideal_start\(t\), or call uniformize\(\)
void misuse(const Mesh& mesh) { IT::conformal_metric(mesh, IT::Prescribed_angles(0)); }
} // namespace case_conformal_metric_of_mesh
