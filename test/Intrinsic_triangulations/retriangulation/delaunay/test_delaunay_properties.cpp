// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include "meshes.h"
#include "surface_mesh.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <random>
#include <string>
#include <utility>
#include <vector>

// What theorems say of Delaunay triangulations (§4.1.1 of the course), on meshes of CGAL's data set too. Distances on the
// surface are those of CGAL's exact algorithm for shortest paths (Xin and Wang 2009), which knows nothing of flips.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Exact = IT::Intrinsic_triangulation<>;
using Double = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>>;

Mesh surface_mesh(const meshes::Mesh& m) { return meshes::surface_mesh<Mesh>(m); }

std::vector<std::pair<std::string, Mesh>> all_meshes() {
  std::vector<std::pair<std::string, Mesh>> result{
      {"sphere", surface_mesh(meshes::sphere(2))},
      {"potato", surface_mesh(meshes::potato(2, 6))},
      {"rough grid", surface_mesh(meshes::rough_grid(8, 4))},
      {"sheared grid", surface_mesh(meshes::sheared_grid(5, 5, 7))},
      {"box", surface_mesh(meshes::box(2, 3, 4))}};
#ifdef INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR
  for (const std::string name : {"blob-closed", "double-torus-example", "dragknob", "eight",
                                 "joint", "part", "pipe", "tripod"}) {
    Mesh mesh;
    const std::string file = INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR "/" + name + ".off";
    if (CGAL::IO::read_polygon_mesh(file, mesh) && CGAL::is_triangle_mesh(mesh))
      result.emplace_back(name, std::move(mesh));
  }
#endif
  return result;
}

/// On the surface, from a vertex to all others.
std::vector<double> geodesic_distances(const Mesh& mesh, std::size_t from) {
  using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
  CGAL::Surface_mesh_shortest_path<Traits> paths(mesh);
  paths.add_source_point(*(vertices(mesh).begin() + static_cast<std::ptrdiff_t>(from)));
  std::vector<double> result;
  for (const auto v : vertices(mesh))
    result.push_back(paths.shortest_distance_to_source_points(v).first);
  return result;
}

/// Along the edges of a triangulation, from a vertex to all others, all in the numbering of the input.
template <class T>
std::vector<double> graph_distances(const T& t, std::size_t from) {
  std::vector<std::vector<std::pair<std::uint32_t, double>>> neighbours(t.number_of_vertices());
  for (const auto h : halfedges(t.mesh()))
    neighbours[t.input_vertex(source(h, t.mesh()))].emplace_back(
        t.input_vertex(target(h, t.mesh())), t.length(edge(h, t.mesh())));
  std::vector<double> distance(neighbours.size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  queue.push({distance[from] = 0, from});
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance[v]) continue;
    for (const auto& [w, length] : neighbours[v])
      if (d + length < distance[w]) queue.push({distance[w] = d + length, w});
  }
  return distance;
}

std::vector<std::size_t> some_vertices(const Mesh& mesh) {
  std::vector<std::size_t> result;
  const std::size_t n = num_vertices(mesh);
  for (std::size_t i = 0; i < n; i += 1 + n / 12) result.push_back(i);
  return result;
}

constexpr double rounding = 1e-7; // of distances that CGAL finds in doubles

template <class T>
void expect_spanner() {
  for (const auto& [name, mesh] : all_meshes()) {
    T t(mesh);
    IT::flip_to_delaunay(t);
    double worst = 0;
    for (const std::size_t v : some_vertices(mesh)) {
      const std::vector<double> on_surface = geodesic_distances(mesh, v),
                                along_edges = graph_distances(t, v);
      for (std::size_t w = 0; w < on_surface.size(); ++w) {
        if (w == v || !(on_surface[w] > 0)) continue; // in another component
        EXPECT_GE(along_edges[w], (1 - rounding) * on_surface[w]) << name << ' ' << v << ' ' << w;
        worst = std::max(worst, along_edges[w] / on_surface[w]);
      }
    }
    EXPECT_LE(worst, 1.998 + rounding) << name << ": the bound of Xia (2013)";
    EXPECT_GE(worst, 1) << name;
  }
}

TEST(Delaunay_properties, edges_are_a_spanner_of_distances_on_the_surface) {
  expect_spanner<Exact>();
  expect_spanner<Double>();
}

TEST(Delaunay_properties, edges_join_every_vertex_to_its_nearest_neighbour) {
  for (const auto& [name, mesh] : all_meshes()) {
    Exact t(mesh);
    IT::flip_to_delaunay(t);
    for (const std::size_t v : some_vertices(mesh)) {
      const std::vector<double> distances = geodesic_distances(mesh, v);
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t w = 0; w < distances.size(); ++w)
        if (w != v && distances[w] > 0) nearest = std::min(nearest, distances[w]);
      double shortest_edge = std::numeric_limits<double>::infinity(), shortest_loop = shortest_edge;
      std::size_t neighbour = v;
      for (const auto h : halfedges(t.mesh())) {
        if (t.input_vertex(source(h, t.mesh())) != v) continue;
        const std::size_t w = t.input_vertex(target(h, t.mesh()));
        const double length = t.length(edge(h, t.mesh()));
        if (w == v)
          shortest_loop = std::min(shortest_loop, length);
        else if (length < shortest_edge) {
          shortest_edge = length;
          neighbour = w;
        }
      }
      if (shortest_loop < (1 + rounding) * nearest) continue; // it is its own nearest neighbour
      EXPECT_NEAR(shortest_edge, nearest, rounding * nearest) << name << ' ' << v;
      EXPECT_NEAR(distances[neighbour], nearest, rounding * nearest) << name << ' ' << v;
    }
  }
}

/// All angles, the smallest one first, by the law of cosines.
template <class T>
std::vector<double> sorted_angles(const T& t) {
  std::vector<double> result;
  for (const auto f : faces(t.mesh())) {
    auto h = halfedge(f, t.mesh());
    std::array<double, 3> l;
    for (double& x : l) {
      x = t.length(edge(h, t.mesh()));
      h = next(h, t.mesh());
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const double a = l[k], b = l[(k + 1) % 3], c = l[(k + 2) % 3];
      result.push_back(std::acos(std::clamp((b * b + c * c - a * a) / (2 * b * c), -1., 1.)));
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

TEST(Delaunay_properties, no_triangulation_has_a_greater_least_angle) {
  for (const auto& [name, mesh] : all_meshes()) {
    Exact delaunay(mesh);
    EXPECT_GE(sorted_angles(delaunay).front(), 0);
    const double before = sorted_angles(delaunay).front();
    IT::flip_to_delaunay(delaunay);
    const double least = sorted_angles(delaunay).front();
    EXPECT_GE(least, before - 1e-9) << name;
    // others of the same surface: up to many flips away, and close by
    std::mt19937 random(5);
    for (int walk = 0; walk < 12; ++walk) {
      Exact t(delaunay);
      std::vector<Exact::edge_descriptor> all(edges(t.mesh()).begin(), edges(t.mesh()).end());
      for (int flips = 1 << walk / 2; flips > 0; --flips)
        t.flip_edge(halfedge(all[random() % all.size()], t.mesh()));
      EXPECT_LE(sorted_angles(t).front(), least + 1e-9) << name << ' ' << walk;
    }
  }
}

/// Sibson: each flip of an edge that is not Delaunay makes the sorted sequence of angles greater.
TEST(Delaunay_properties, flips_make_the_sorted_angles_greater_one_by_one) {
  const auto is_greater = [](const std::vector<double>& a, const std::vector<double>& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
      if (std::abs(a[i] - b[i]) > 1e-9) return a[i] > b[i];
    return false;
  };
  for (const meshes::Mesh& m :
       {meshes::sheared_grid(4, 4, 3), meshes::rough_grid(5, 4), meshes::potato(1, 6)}) {
    Exact t(m.input());
    std::mt19937 random(3);
    std::vector<Exact::edge_descriptor> all(edges(t.mesh()).begin(), edges(t.mesh()).end());
    for (int i = 0; i < 100; ++i) t.flip_edge(halfedge(all[random() % all.size()], t.mesh()));
    std::vector<double> angles = sorted_angles(t);
    int flips = 0;
    for (bool again = true; again;) {
      again = false;
      for (const auto e : all) {
        if (t.is_locally_delaunay(halfedge(e, t.mesh()))) continue;
        ASSERT_EQ(t.flip_edge(halfedge(e, t.mesh())), IT::Move_status::done);
        const std::vector<double> after = sorted_angles(t);
        EXPECT_TRUE(is_greater(after, angles)) << flips;
        angles = after;
        again = true;
        ++flips;
      }
    }
    EXPECT_GT(flips, 20);
  }
}

/// Brute force over integers: pairs of points whose closed diametral disk contains no third one.
std::vector<std::pair<std::uint32_t, std::uint32_t>>
gabriel_graph(const std::vector<meshes::Point>& points) {
  const auto is_in_disk = [&](std::uint32_t k, std::uint32_t i, std::uint32_t j) {
    const meshes::Point &p = points[k], &a = points[i], &b = points[j]; // exact: below 2^20
    return (a[0] - p[0]) * (b[0] - p[0]) + (a[1] - p[1]) * (b[1] - p[1]) <= 0;
  };
  const auto n = static_cast<std::uint32_t>(points.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> result;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = i + 1; j < n; ++j) {
      bool is_empty = true;
      for (std::uint32_t k = 0; k < n && is_empty; ++k)
        is_empty = k == i || k == j || !is_in_disk(k, i, j);
      if (is_empty) result.emplace_back(i, j);
    }
  return result;
}

TEST(Delaunay_properties, edges_contain_the_gabriel_graph) {
  for (unsigned seed = 1; seed <= 20; ++seed) { // small coordinates: ties and points in a row
    const meshes::Mesh m = meshes::random_planar(60, seed % 2 == 0 ? 12 : 1000, seed);
    Exact t(m.input());
    IT::flip_to_delaunay(t);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
    for (const auto e : edges(t.mesh()))
      all.push_back(std::minmax({t.input_vertex(source(halfedge(e, t.mesh()), t.mesh())),
                                 t.input_vertex(target(halfedge(e, t.mesh()), t.mesh()))}));
    std::sort(all.begin(), all.end());
    const auto gabriel = gabriel_graph(m.points);
    EXPECT_GE(gabriel.size(), m.points.size() - 1) << "connects all points";
    for (const auto& pair : gabriel)
      EXPECT_TRUE(std::binary_search(all.begin(), all.end(), pair))
          << "seed " << seed << ": " << pair.first << ' ' << pair.second;
  }
}

/// The weight of a minimum spanning tree, by Prim: `distance(i)` gives all distances from i.
template <class Distances>
double spanning_tree_weight(std::size_t n, Distances distance) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> to_tree(n, infinity);
  std::vector<char> is_in(n, 0);
  double weight = 0;
  std::size_t last = 0;
  for (std::size_t count = 1; count < n; ++count) {
    is_in[last] = 1;
    const std::vector<double> from_last = distance(last);
    for (std::size_t i = 0; i < n; ++i) to_tree[i] = std::min(to_tree[i], from_last[i]);
    last = n;
    for (std::size_t i = 0; i < n; ++i)
      if (!is_in[i] && (last == n || to_tree[i] < to_tree[last])) last = i;
    weight += to_tree[last];
  }
  return weight;
}

TEST(Delaunay_properties, edges_contain_a_minimum_spanning_tree_of_the_surface) {
  std::vector<Mesh> surfaces;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    surfaces.push_back(surface_mesh(meshes::rough_grid(6, seed)));
    surfaces.push_back(surface_mesh(meshes::potato(1, seed)));
    surfaces.push_back(surface_mesh(meshes::random_planar(60, 1000, seed)));
  }
  surfaces.push_back(surface_mesh(meshes::sheared_grid(5, 5, 7)));
  surfaces.push_back(surface_mesh(meshes::box(2, 3, 4)));
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    Exact t(surfaces[i]);
    IT::flip_to_delaunay(t);
    const std::size_t n = num_vertices(surfaces[i]);
    const double on_surface =
        spanning_tree_weight(n, [&](std::size_t v) { return geodesic_distances(surfaces[i], v); });
    const double along_edges = spanning_tree_weight(n, [&](std::size_t v) {
      std::vector<double> result(n, std::numeric_limits<double>::infinity());
      for (const auto h : halfedges(t.mesh()))
        if (t.input_vertex(source(h, t.mesh())) == v) {
          double& d = result[t.input_vertex(target(h, t.mesh()))];
          d = std::min(d, t.length(edge(h, t.mesh())));
        }
      return result;
    });
    EXPECT_NEAR(along_edges, on_surface, rounding * on_surface) << "surface " << i;
  }
}

} // namespace
