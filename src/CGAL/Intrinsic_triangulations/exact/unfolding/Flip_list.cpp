// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_list.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <cstdint>
#include <stdexcept>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

// those on the border, which do not depend on flips
void choose_halfedges_of_vertices(Gluing_map& mesh) {
  for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f)
    for (const Gluing_map::Halfedge h : mesh.sides({f})) mesh.set_halfedge(mesh.target(h), h);
  for (std::uint32_t h = 0; h < mesh.number_of_halfedges(); ++h)
    if (mesh.face({h}).index == Gluing::none) mesh.set_halfedge(mesh.target({h}), {h});
}

} // namespace

} // namespace internal

Gluing_map Flip_list::input_mesh(Gluing_map mesh, const Input_definition& input) const {
  mesh = undone(std::move(mesh), [](auto&&...) {});
  for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f)
    mesh.set_halfedge(Gluing_map::Face{f}, first_side(mesh, {f}, input));
  internal::choose_halfedges_of_vertices(mesh);
  return mesh;
}

Gluing_map::Halfedge Flip_list::first_side(const Gluing_map& mesh, Gluing_map::Face f,
                                           const Input_definition& input) {
  if (input.surface() != nullptr) return {input.surface()->halfedge_of_face(f.index)};
  const Input_metric& metric = input.metric();
  const auto name = [&](Gluing_map::Halfedge h) {
    return metric.name(mesh.source(h).index, h.index / 2);
  };
  for (const Gluing_map::Halfedge h : mesh.sides(f)) {
    const Gluing_map::Halfedge n = mesh.next(h);
    if (metric.slot(f.index, {name(h), name(n), name(mesh.next(n))}) == 0U) return h;
  }
  throw std::logic_error("flips that were taken back do not lead to the input");
}

} // namespace CGAL::Intrinsic_triangulations
