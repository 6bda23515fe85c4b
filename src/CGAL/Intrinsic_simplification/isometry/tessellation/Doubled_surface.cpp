// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/tessellation/Doubled_surface.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// A mirrored face has the same first side; the other two change places.
constexpr std::uint32_t mirrored_slot(std::uint32_t slot) { return (3 - slot) % 3; }

} // namespace

std::vector<std::uint32_t> components_of_vertices(const Gluing_map& mesh) {
  return joined_sets(mesh.number_of_vertices(), [&](const auto& join) {
    for (std::uint32_t h = 0; h < mesh.number_of_halfedges(); h += 2)
      join(mesh.source(Gluing_map::Halfedge{h}).index, mesh.target(Gluing_map::Halfedge{h}).index);
  });
}

std::vector<Gluing_map::Halfedge> loops_without_corner(const Gluing_map& mesh,
                                                       const std::vector<char>& is_flat) {
  std::vector<Gluing_map::Halfedge> result;
  std::vector<char> is_done(mesh.number_of_halfedges(), 0);
  for (std::uint32_t first = 0; first < is_done.size(); ++first) {
    if (is_done[first] != 0 || mesh.face(Gluing_map::Halfedge{first}).index != Gluing::none)
      continue;
    bool has_corner = false;
    Gluing_map::Halfedge h{first};
    do {
      is_done[h.index] = 1;
      has_corner = has_corner || is_flat[mesh.target(h).index] == 0;
      h = mesh.next(h);
    } while (h.index != first);
    if (!has_corner) result.push_back(h);
  }
  return result;
}

Doubled_surface::Doubled_surface(std::shared_ptr<const Input> surface,
                                 const std::vector<char>& is_flat)
    : surface_(std::move(surface)), input_(surface_) {
  const Gluing_map& mesh = surface_->mesh();
  const std::vector<Gluing_map::Halfedge> loops = loops_without_corner(mesh, is_flat);
  if (loops.empty()) return;
  const std::vector<std::uint32_t> component = components_of_vertices(mesh);
  std::vector<char> has_vertex(component.size(), 0);
  for (std::uint32_t v = 0; v < component.size(); ++v)
    if (is_flat[v] == 0) has_vertex[component[v]] = 1;
  // Where fans of faces meet in a vertex and nowhere else, each is a component of its own.
  const std::vector<std::uint32_t> part =
      joined_sets(mesh.number_of_faces(), [&](const auto& join) {
        for (std::uint32_t h = 0; h < mesh.number_of_halfedges(); h += 2)
          if (const Gluing_map::Halfedge a{h}, b{h + 1};
              mesh.face(a).index != Gluing::none && mesh.face(b).index != Gluing::none)
            join(mesh.face(a).index, mesh.face(b).index);
      });
  std::vector<char> is_glued(mesh.number_of_halfedges(), 0), is_doubled(part.size(), 0);
  for (const Gluing_map::Halfedge first : loops) {
    if (has_vertex[component[mesh.target(first).index]] == 0) continue;
    is_doubled[part[mesh.face(Gluing_map::opposite(first)).index]] = 1;
    Gluing_map::Halfedge h = first;
    do {
      is_glued[Gluing_map::opposite(h).index] = 1;
      h = mesh.next(h);
    } while (h != first);
  }
  for (std::uint32_t f = 0; f < part.size(); ++f)
    if (is_doubled[part[f]] != 0) original_.push_back(f);
  if (!original_.empty()) glue_copies(is_glued);
}

// \param is_glued of each halfedge, whether it is glued to its copy
void Doubled_surface::glue_copies(const std::vector<char>& is_glued) {
  const Gluing_map& mesh = surface_->mesh();
  Gluing g = gluing_from_map(mesh);
  const std::uint32_t vertices = g.number_of_vertices, faces = g.number_of_faces();
  std::vector<std::uint32_t> copy(faces, Gluing::none), copy_of_vertex(vertices);
  for (std::uint32_t n = 0; n < original_.size(); ++n) copy[original_[n]] = faces + n;
  std::iota(copy_of_vertex.begin(), copy_of_vertex.end(), vertices);
  for (std::uint32_t h = 0; h < is_glued.size(); ++h)
    if (const std::uint32_t v = mesh.target(Gluing_map::Halfedge{h}).index; is_glued[h] != 0)
      copy_of_vertex[v] = v;
  g.number_of_vertices = 2 * vertices; // some are isolated
  for (const std::uint32_t f : original_)
    for (std::uint32_t slot = 0; slot < 3; ++slot) {
      const std::uint32_t side = 3 * f + mirrored_slot(slot), other = g.glue[side];
      g.origin.push_back(copy_of_vertex[g.origin[Gluing::next(side)]]);
      if (is_glued[mesh.sides({f})[side % 3].index] != 0) {
        g.glue[side] = static_cast<std::uint32_t>(g.glue.size());
        g.glue.push_back(side);
      } else {
        g.glue.push_back(other == Gluing::none ? other
                                               : 3 * copy[other / 3] + mirrored_slot(other % 3));
      }
    }
  Gluing_map doubled(g);
  Input_metric lengths = metric(doubled);
  input_ = std::make_shared<const Input>(std::move(doubled), std::move(lengths));
}

Input_metric Doubled_surface::metric(const Gluing_map& mesh) const {
  const Input_metric& m = surface_->metric();
  std::vector<double> lengths(m.is_embedded() ? 0 : mesh.number_of_edges());
  std::vector<std::array<double, 3>> excess(mesh.number_of_faces());
  for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f)
    for (std::uint32_t slot = 0; slot < 3; ++slot) {
      const Face_side s = side_of_surface({f, slot});
      excess[f][slot] = m.excess(s.face, s.slot);
      if (!m.is_embedded())
        lengths[mesh.sides({f})[slot].index / 2] = m.squared_lengths()[m.sides(s.face)[s.slot]];
    }
  std::vector<Input_metric::Point> points = m.points();
  points.insert(points.end(), m.points().begin(), m.points().end());
  Input_metric result =
      m.is_embedded()
          ? Input_metric::from_points(mesh, std::move(points), m.scale_exponent())
          : Input_metric::from_squared_lengths(mesh, std::move(lengths), m.scale_exponent());
  result.set_delta(m.delta());
  if (std::any_of(excess.begin(), excess.end(), [](const auto& e) {
        return e != std::array<double, 3>{0, 0, 0};
      }))
    result.set_excess(std::move(excess));
  return result;
}

Face_side Doubled_surface::side_of_surface(const Face_side& s) const {
  const std::uint32_t faces = surface_->number_of_faces();
  if (s.face < faces) return s;
  return {original_[s.face - faces], mirrored_slot(s.slot)};
}

Surface_point Doubled_surface::from_surface(const Surface_point& p) const {
  const Face_side s = input_side(*surface_, p.halfedge);
  return {input_->mesh().sides({s.face})[s.slot].index, p.weights};
}

Surface_point Doubled_surface::on_surface(const Surface_point& p) const {
  const Face_side s = input_side(*input_, p.halfedge), own = side_of_surface(s);
  const std::uint32_t h = surface_->mesh().sides({own.face})[own.slot].index;
  const auto& [source, target, apex] = p.weights;
  if (own.face == s.face) return {h, p.weights};
  return {h, {target, source, apex}}; // the side runs the other way
}

} // namespace CGAL::Intrinsic_triangulations::internal
