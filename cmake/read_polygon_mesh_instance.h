// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How most tests and examples read a mesh: compiled once, `read_polygon_mesh_instance.cpp`.

#ifndef INTRINSIC_TRIANGULATIONS_READ_POLYGON_MESH_INSTANCE_H
#define INTRINSIC_TRIANGULATIONS_READ_POLYGON_MESH_INSTANCE_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <string>

#ifndef INTRINSIC_TRIANGULATIONS_READ_POLYGON_MESH_INSTANCE
#define INTRINSIC_TRIANGULATIONS_READ_POLYGON_MESH_INSTANCE extern template
#endif

namespace CGAL::IO {

INTRINSIC_TRIANGULATIONS_READ_POLYGON_MESH_INSTANCE bool
read_polygon_mesh(const std::string&, Surface_mesh<Simple_cartesian<double>::Point_3>&,
                  const parameters::Default_named_parameters&);

} // namespace CGAL::IO

#endif // INTRINSIC_TRIANGULATIONS_READ_POLYGON_MESH_INSTANCE_H
