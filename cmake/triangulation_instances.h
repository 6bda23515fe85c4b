// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The triangulations that most tests and examples use, what most of them do with these, and how they read a mesh:
// compiled once, `triangulation_instances.cpp`.

#ifndef INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCES_H
#define INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCES_H

#include "exact_instances.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/metric/Euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/is_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <string>

#ifndef INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE
#define INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE extern template
#endif

#define INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCES(...)                                      \
  INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE class __VA_ARGS__;                               \
  INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE class Predicate_session<__VA_ARGS__>;            \
  INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE class Move_session<__VA_ARGS__>;                 \
  INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE class internal::Mover<__VA_ARGS__>;              \
  INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE Flip_to_delaunay_result flip_to_delaunay(        \
      __VA_ARGS__&, const parameters::Parameters<>&);                                              \
  INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE bool is_delaunay(const __VA_ARGS__&);            \
  INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE Delaunay_report<Gluing_map::Edge>                \
  check_delaunay(const __VA_ARGS__&);                                                              \
  INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE class internal::Delaunay_refiner<                \
      __VA_ARGS__, Refinement_visitor>;                                                            \
  INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE Refinement_result<Gluing_map::Face>              \
  delaunay_refine(__VA_ARGS__&, const parameters::Parameters<>&)

namespace CGAL::Intrinsic_triangulations {

INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCES(
    Intrinsic_triangulation<Gluing_map, Exact_euclidean_traits, No_correspondence>);
INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCES(
    Intrinsic_triangulation<Gluing_map, Exact_euclidean_traits, Integer_coordinates>);
INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCES(
    Intrinsic_triangulation<Gluing_map, Euclidean_traits<double>, No_correspondence>);

INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE Common_subdivision common_subdivision(
    const Intrinsic_triangulation<Gluing_map, Exact_euclidean_traits, Integer_coordinates>&);

} // namespace CGAL::Intrinsic_triangulations

namespace CGAL::IO {

INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE bool
read_polygon_mesh(const std::string&, Surface_mesh<Simple_cartesian<double>::Point_3>&,
                  const parameters::Default_named_parameters&);

} // namespace CGAL::IO

#endif // INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCES_H
