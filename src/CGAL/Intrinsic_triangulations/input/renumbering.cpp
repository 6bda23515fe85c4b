// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/input/Element_names.h>
#include <CGAL/Intrinsic_triangulations/input/renumbering.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

// A face takes about a hundred bytes, with its lengths: 2^17 of them fit in the cache of a
// processor, 64 in pages nearby. Edges that are numbered one after another are worked on one after
// another. If they touch few parts of memory, each part is in the cache from the second access on,
// however far the parts are from each other: as on a grid, whose rows touch the next ones.
bool is_badly_ordered(const Gluing_map& mesh) {
  if (mesh.number_of_faces() <= 1U << 17) return false;
  constexpr std::uint32_t windows = 32, width = 128; // standard error at an eighth: half a percent
  std::uint32_t parts = 0;
  for (std::uint32_t w = 0; w < windows; ++w) {
    const auto first = static_cast<std::uint32_t>(std::uint64_t{mesh.number_of_edges() - width} *
                                                  w / (windows - 1));
    std::array<std::uint32_t, 2 * width> touched; // border halfedges touch one part that is no face
    for (std::uint32_t i = 0; i < 2 * width; ++i)
      touched[i] = mesh.face({2 * first + i}).index / 64;
    std::sort(touched.begin(), touched.end());
    parts +=
        static_cast<std::uint32_t>(std::unique(touched.begin(), touched.end()) - touched.begin());
  }
  return 8 * parts > windows * width;
}

namespace internal {

// Stable counting sort: the place of each element in the order of its key, keys below `bound`.
static std::vector<std::uint32_t> places_by_key(const std::vector<std::uint32_t>& keys,
                                                std::uint32_t bound) {
  std::vector<std::uint32_t> start(bound + 1, 0), place(keys.size());
  for (const std::uint32_t k : keys) ++start[k + 1];
  for (std::uint32_t k = 0; k < bound; ++k) start[k + 1] += start[k];
  for (std::size_t i = 0; i < keys.size(); ++i) place[i] = start[keys[i]]++;
  return place;
}

static std::vector<std::uint32_t> inverse_permutation(const std::vector<std::uint32_t>& p) {
  std::vector<std::uint32_t> inverse(p.size());
  for (std::uint32_t i = 0; i < p.size(); ++i) inverse[p[i]] = i;
  return inverse;
}

// New numbers of the elements of a mesh, for `numbered_copy()`.
struct New_numbers {
  std::vector<std::uint32_t> vertices, edges, faces;

  std::uint32_t vertex(Gluing_map::Vertex v) const { return vertices[v.index]; }
  std::uint32_t halfedge(Gluing_map::Halfedge h) const {
    return 2 * edges[h.index / 2] + h.index % 2;
  }
  std::uint32_t face(Gluing_map::Face f) const { return faces[f.index]; }
  std::uint32_t vertex_capacity(const Gluing_map& m) const { return m.number_of_vertices(); }
  std::uint32_t edge_capacity(const Gluing_map& m) const { return m.number_of_edges(); }
  std::uint32_t face_capacity(const Gluing_map& m) const { return m.number_of_faces(); }
};

// Faces follow the least of their vertices, edges the first of their faces. All loops run through
// the mesh in memory order, so that cache misses overlap.
static New_numbers numbers_along(const Gluing_map& mesh, std::vector<std::uint32_t> vertex) {
  New_numbers result;
  result.vertices = std::move(vertex);
  std::vector<std::uint32_t> key(mesh.number_of_faces(), Gluing::none);
  for (std::uint32_t h = 0; h < mesh.number_of_halfedges(); ++h) {
    const std::uint32_t f = mesh.face({h}).index;
    if (f != Gluing::none) key[f] = std::min(key[f], result.vertices[mesh.target({h}).index]);
  }
  result.faces = places_by_key(key, mesh.number_of_vertices());
  key.resize(mesh.number_of_edges());
  const auto place = [&](std::uint32_t h) {
    const std::uint32_t f = mesh.face({h}).index;
    return f == Gluing::none ? f : result.faces[f];
  };
  for (std::uint32_t e = 0; e < key.size(); ++e) key[e] = std::min(place(2 * e), place(2 * e + 1));
  result.edges = places_by_key(key, mesh.number_of_faces());
  return result;
}

} // namespace internal

std::vector<std::uint32_t> morton_order(const std::vector<std::array<double, 3>>& points) {
  std::array<double, 3> low = points[0], high = points[0];
  for (const std::array<double, 3>& p : points)
    for (unsigned k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  // halves, so that differences do not overflow
  const double extent = std::max({high[0] / 2 - low[0] / 2, high[1] / 2 - low[1] / 2,
                                  high[2] / 2 - low[2] / 2, std::numeric_limits<double>::min()});
  const auto spread = [](std::uint64_t x) { // ...cba -> ...c00b00a, 10 bits
    x = (x | (x << 16)) & 0x030000FFULL;
    x = (x | (x << 8)) & 0x0300F00FULL;
    x = (x | (x << 4)) & 0x030C30C3ULL;
    return (x | (x << 2)) & 0x09249249ULL;
  };
  std::vector<std::uint64_t> keys(points.size());
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    std::uint64_t key = 0;
    for (unsigned k = 0; k < 3; ++k) {
      const double x = (points[v][k] / 2 - low[k] / 2) / extent;
      key |= spread(static_cast<std::uint64_t>(std::clamp(x * 1023, 0.0, 1023.0))) << k;
    }
    keys[v] = key << 32 | v;
  }
  boost::sort::spreadsort::integer_sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(keys.size());
  std::transform(keys.begin(), keys.end(), order.begin(),
                 [](std::uint64_t key) { return static_cast<std::uint32_t>(key); });
  return order;
}

Input_names renumber(Gluing_map& mesh, std::vector<std::array<double, 3>>& points) {
  std::vector<std::uint32_t> order = morton_order(points);
  internal::New_numbers number =
      internal::numbers_along(mesh, internal::inverse_permutation(order));
  mesh = internal::numbered_copy(mesh, number);
  std::vector<std::array<double, 3>> moved;
  moved.reserve(points.size());
  for (const std::uint32_t v : order) moved.push_back(points[v]);
  points = std::move(moved);
  const auto names = [](std::vector<std::uint32_t>& here) {
    std::vector<std::uint32_t> user = internal::inverse_permutation(here);
    return Element_names(std::move(user), std::move(here));
  };
  return {Element_names(std::move(order), std::move(number.vertices)),
          names(number.edges),
          names(number.faces),
          {},
          {},
          1};
}

} // namespace CGAL::Intrinsic_triangulations
