// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_frames.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent_field.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

Vertex_frames<Input> input_frames(const Input& input) {
  Vertex_frames<Input> frames(input, input.number_of_vertices(), input.number_of_halfedges());
  for (std::uint32_t v = 0; v < input.number_of_vertices(); ++v)
    if (input.mesh().halfedge(Gluing_map::Vertex{v}).index != Gluing::none) frames.measure(v);
  return frames;
}

std::vector<std::uint32_t> axes_of_input(const Input& input) {
  std::vector<std::uint32_t> axes(input.number_of_vertices(), Gluing::none);
  for (std::uint32_t v = 0; v < axes.size(); ++v)
    if (input.mesh().halfedge(Gluing_map::Vertex{v}).index != Gluing::none)
      axes[v] = input.outgoing_halfedge(v);
  return axes;
}

void expect_size(const Tangent_field& field, std::size_t size) {
  if (field.size() != size)
    throw std::invalid_argument("the field must have a vector per vertex: " + std::to_string(size) +
                                ", not " + std::to_string(field.size()));
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
