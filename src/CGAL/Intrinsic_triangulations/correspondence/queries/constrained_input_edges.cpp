// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Curve_queries.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/constrained_input_edges.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <boost/property_map/property_map.hpp>

#include <cstdint>
#include <string>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

std::uint32_t edge_of_name(const Input_definition& input, std::uint32_t name) {
  const std::uint32_t here = input.names().edges.here(name);
  if (here == Gluing::none)
    throw Invalid_input(Element_kind::edge, name,
                        "edge " + std::to_string(name) +
                            " is not one of those that the triangulation was built from");
  return here;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
