// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The mesh type of most tests and examples, how they read it, and what a triangulation takes from it:
// compiled once, `read_polygon_mesh_instance.cpp`.

#ifndef INTRINSIC_TRIANGULATIONS_READ_POLYGON_MESH_INSTANCE_H
#define INTRINSIC_TRIANGULATIONS_READ_POLYGON_MESH_INSTANCE_H

#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#ifndef INTRINSIC_TRIANGULATIONS_MESH_INSTANCE
#define INTRINSIC_TRIANGULATIONS_MESH_INSTANCE extern template
#endif

namespace CGAL {

INTRINSIC_TRIANGULATIONS_MESH_INSTANCE
Surface_mesh<Simple_cartesian<double>::Point_3>::Surface_mesh();
INTRINSIC_TRIANGULATIONS_MESH_INSTANCE
Surface_mesh<Simple_cartesian<double>::Point_3>::Surface_mesh(const Surface_mesh&);
INTRINSIC_TRIANGULATIONS_MESH_INSTANCE Surface_mesh<Simple_cartesian<double>::Point_3>&
Surface_mesh<Simple_cartesian<double>::Point_3>::operator=(const Surface_mesh&);

namespace Properties {

INTRINSIC_TRIANGULATIONS_MESH_INSTANCE class Property_array<Simple_cartesian<double>::Point_3>;
INTRINSIC_TRIANGULATIONS_MESH_INSTANCE class Property_array<
    Surface_mesh<Simple_cartesian<double>::Point_3>::Vertex_connectivity>;
INTRINSIC_TRIANGULATIONS_MESH_INSTANCE class Property_array<
    Surface_mesh<Simple_cartesian<double>::Point_3>::Halfedge_connectivity>;
INTRINSIC_TRIANGULATIONS_MESH_INSTANCE class Property_array<
    Surface_mesh<Simple_cartesian<double>::Point_3>::Face_connectivity>;

} // namespace Properties

namespace IO {

INTRINSIC_TRIANGULATIONS_MESH_INSTANCE bool
read_polygon_mesh(const std::string&, Surface_mesh<Simple_cartesian<double>::Point_3>&,
                  const parameters::Default_named_parameters&);

} // namespace IO

namespace Intrinsic_triangulations {

INTRINSIC_TRIANGULATIONS_MESH_INSTANCE Gluing_map
gluing_map_unless_polygonal(const Surface_mesh<Simple_cartesian<double>::Point_3>&, std::uint32_t&);
INTRINSIC_TRIANGULATIONS_MESH_INSTANCE Gluing_map
gluing_map_from_polygons(const Surface_mesh<Simple_cartesian<double>::Point_3>&,
                         const std::vector<std::array<double, 3>>&, Nonplanar_polygons,
                         std::size_t&, Input_names&, Planar_polygons&);
INTRINSIC_TRIANGULATIONS_MESH_INSTANCE
Intrinsic_input::Intrinsic_input(const Surface_mesh<Simple_cartesian<double>::Point_3>&,
                                 Mollification, Nonplanar_polygons);

} // namespace Intrinsic_triangulations

} // namespace CGAL

#endif // INTRINSIC_TRIANGULATIONS_READ_POLYGON_MESH_INSTANCE_H
