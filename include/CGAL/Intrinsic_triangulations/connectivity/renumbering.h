// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_RENUMBERING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_RENUMBERING_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

/*!
\file
Numbering for locality. A mesh whose neighbouring faces are far apart in memory costs a cache miss
per access; numbering its faces along a space-filling curve makes flips several times faster.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief maps the numbering of a triangulation to that of its input; empty vectors are the identity.
*/
struct Renumbering {
  /// Number in the input of each vertex.
  std::vector<std::uint32_t> input_vertex;
  /// Number in the input of each face.
  std::vector<std::uint32_t> input_face;
};

/*!
\brief tells whether neighbouring faces lie so far apart in memory that renumbering pays.

True if the mesh does not fit a processor's cache (more than 2^17 faces) and more than an eighth of
a sample of its edges join faces more than 4096 apart.
\complexity constant
*/
inline bool is_badly_ordered(const Gluing_map& mesh) {
  if (mesh.number_of_faces() <= 1U << 17) return false;
  constexpr std::uint32_t samples = 4096;
  std::uint32_t far = 0;
  for (std::uint32_t i = 0; i < samples; ++i) {
    const auto e = static_cast<std::uint32_t>(std::uint64_t{mesh.number_of_edges()} * i / samples);
    const std::uint32_t f = mesh.face({2 * e}).index, g = mesh.face({2 * e + 1}).index;
    if (f != Gluing::none && g != Gluing::none && std::max(f, g) - std::min(f, g) > 4096) ++far;
  }
  return 8 * far > samples;
}

/*!
\brief orders the faces of a mesh along a Morton curve through their centroids.
\param mesh the connectivity, with at least one face
\param points one point per vertex
\return face numbers in the new order
\complexity linear: a radix sort
*/
inline std::vector<std::uint32_t>
morton_order_of_faces(const Gluing_map& mesh, const std::vector<std::array<double, 3>>& points) {
  std::array<double, 3> low = points[mesh.target({0}).index], high = low;
  for (std::uint32_t h = 0; h < mesh.number_of_halfedges(); h += 2)
    for (unsigned k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], points[mesh.target({h}).index][k]);
      high[k] = std::max(high[k], points[mesh.target({h}).index][k]);
    }
  const double extent = std::max({high[0] / 2 - low[0] / 2, high[1] / 2 - low[1] / 2,
                                  high[2] / 2 - low[2] / 2, std::numeric_limits<double>::min()});
  const auto spread = [](std::uint64_t x) { // ...cba -> ...c00b00a, 10 bits
    x = (x | (x << 16)) & 0x030000FFULL;
    x = (x | (x << 8)) & 0x0300F00FULL;
    x = (x | (x << 4)) & 0x030C30C3ULL;
    return (x | (x << 2)) & 0x09249249ULL;
  };
  std::vector<std::uint64_t> keys(mesh.number_of_faces());
  for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f) {
    std::uint64_t key = 0;
    const Gluing_map::Halfedge h = mesh.halfedge(Gluing_map::Face{f});
    const std::uint32_t corners[3] = {mesh.source(h).index, mesh.target(h).index,
                                      mesh.target(mesh.next(h)).index};
    for (unsigned k = 0; k < 3; ++k) {
      double x = 0;
      for (const std::uint32_t v : corners) x += (points[v][k] / 2 - low[k] / 2) / extent;
      key |= spread(static_cast<std::uint64_t>(std::clamp(x * (1023.0 / 3), 0.0, 1023.0))) << k;
    }
    keys[f] = key << 32 | f;
  }
  boost::sort::spreadsort::integer_sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(keys.size());
  std::transform(keys.begin(), keys.end(), order.begin(),
                 [](std::uint64_t key) { return static_cast<std::uint32_t>(key); });
  return order;
}

/*!
\brief renumbers the faces of a mesh in a given order, and its edges and vertices in the order in
which the faces meet them; isolated vertices come last.
\param mesh the connectivity, which is replaced
\param order face numbers in the new order
\return the way back to the numbers before
\pre `mesh.is_oriented()`
\complexity linear
*/
inline Renumbering renumber(Gluing_map& mesh, std::vector<std::uint32_t> order) {
  using Halfedge = Gluing_map::Halfedge;
  using Vertex = Gluing_map::Vertex;
  Renumbering back;
  std::vector<std::uint32_t> new_vertex(mesh.number_of_vertices(), Gluing::none);
  std::vector<std::uint32_t> new_halfedge(mesh.number_of_halfedges(), Gluing::none);
  back.input_vertex.reserve(mesh.number_of_vertices());
  std::uint32_t edges = 0;
  const auto number = [&](std::uint32_t v) {
    if (new_vertex[v] != Gluing::none) return;
    new_vertex[v] = static_cast<std::uint32_t>(back.input_vertex.size());
    back.input_vertex.push_back(v);
  };
  for (const std::uint32_t f : order) {
    Halfedge h = mesh.halfedge(Gluing_map::Face{f});
    for (int k = 0; k < 3; ++k, h = mesh.next(h)) {
      number(mesh.target(h).index);
      if (new_halfedge[h.index] != Gluing::none) continue;
      new_halfedge[h.index] = 2 * edges;
      new_halfedge[h.index ^ 1U] = 2 * edges++ + 1;
    }
  }
  for (std::uint32_t v = 0; v < mesh.number_of_vertices(); ++v) number(v);

  Gluing_map result(mesh.number_of_vertices(), edges, mesh.number_of_faces());
  const auto move = [&](Halfedge h, Gluing_map::Face f) {
    const Halfedge n{new_halfedge[h.index]};
    result.set_next(n, {new_halfedge[mesh.next(h).index]});
    result.set_target(n, {new_vertex[mesh.target(h).index]});
    result.set_face(n, f);
  };
  for (std::uint32_t f = 0; f < order.size(); ++f) {
    Halfedge h = mesh.halfedge(Gluing_map::Face{order[f]});
    result.set_halfedge(Gluing_map::Face{f}, {new_halfedge[h.index]});
    for (int k = 0; k < 3; ++k, h = mesh.next(h)) {
      move(h, {f});
      const Halfedge o = Gluing_map::opposite(h);
      if (mesh.face(o).index == Gluing::none) move(o, {});
    }
  }
  for (std::uint32_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const std::uint32_t h = mesh.halfedge(Vertex{v}).index;
    if (h != Gluing::none) result.set_halfedge(Vertex{new_vertex[v]}, {new_halfedge[h]});
  }
  mesh = std::move(result);
  back.input_face = std::move(order);
  return back;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_RENUMBERING_H
