// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/cuts/cut_open.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_round_disk.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include "gallery.h"
#include "meshes.h"
#include "refined_meshes.h"
#include "surface_to_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Oracles: the topology of the opened surface, by counts; ranks over Z/2; shortest loops of tori;
// shortest cuts of small surfaces, by trying all.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Gluing;
using Double_triangulation =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>>;

IT::Surface_to_cut surface_of(const gallery::Surface& s) {
  IT::Surface_to_cut result{s.gluing, {}};
  for (const double l : s.squared_length_of_side) result.length.push_back(std::sqrt(l));
  return result;
}

double distance(const meshes::Point& p, const meshes::Point& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

IT::Surface_to_cut surface_of(const meshes::Mesh& m) {
  IT::Surface_to_cut s{
      IT::gluing_from_triangles(static_cast<std::uint32_t>(m.points.size()), m.triangles), {}};
  for (const auto& f : m.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      s.length.push_back(distance(m.points[f[k]], m.points[f[(k + 1) % 3]]));
  return s;
}

// A torus in space of n x m cells.
meshes::Mesh torus(std::uint32_t n, std::uint32_t m, double tube = 1) {
  meshes::Mesh s;
  for (std::uint32_t v = 0; v < n * m; ++v) {
    const double a = 2 * std::numbers::pi * (v % n) / n, b = 2 * std::numbers::pi * (v / n) / m;
    const double out = 3 + tube * std::cos(b);
    s.points.push_back({out * std::cos(a), out * std::sin(a), tube * std::sin(b)});
    const std::uint32_t right = v - v % n + (v + 1) % n, up = n * m;
    s.triangles.push_back({v, right, (right + n) % up});
    s.triangles.push_back({v, (right + n) % up, (v + n) % up});
  }
  return s;
}

// Without some faces at random: more borders, components and pinched vertices.
meshes::Mesh with_holes(meshes::Mesh m, double part, unsigned seed) {
  std::mt19937 random(seed);
  std::bernoulli_distribution removed(part);
  std::erase_if(m.triangles, [&](const auto&) { return removed(random); });
  return m;
}

std::vector<char> no_marks(const Gluing& g) { return std::vector<char>(g.origin.size(), 0); }

// Each component is a disk; the cut passes through vertices, and nothing dangles.
void expect_disks(const IT::Surface_to_cut& s, const std::vector<char>& is_cut,
                  const std::vector<std::uint32_t>& through) {
  const IT::Opened_surface fans = IT::cut_open(s.gluing, no_marks(s.gluing));
  const IT::Opened_surface opened = IT::cut_open(s.gluing, is_cut);
  const IT::Gluing_map before(fans.gluing), after(opened.gluing);
  const std::uint32_t components = IT::connected_components(before).count;
  EXPECT_EQ(IT::connected_components(after).count, components);
  std::ptrdiff_t isolated = after.number_of_vertices();
  for (const std::uint32_t n : IT::umbrellas(after)) {
    EXPECT_LE(n, 1U);
    isolated -= n;
  }
  EXPECT_EQ(IT::euler_characteristic(after), std::ptrdiff_t{components} + isolated);
  EXPECT_EQ(IT::boundary_loops(after).size(), components);
  // the border of the opened surface is its cut: corners at it
  std::set<std::uint32_t> on_cut;
  std::vector<int> degree(fans.gluing.number_of_vertices, 0);
  for (std::uint32_t h = 0; h < s.gluing.origin.size(); ++h) {
    const std::uint32_t p = Gluing::partner(s.gluing.glue[h]);
    if (is_cut[h] == 0 && p != Gluing::none) continue;
    EXPECT_TRUE(p == Gluing::none || is_cut[p] != 0);
    for (const std::uint32_t c : {h, Gluing::next(h)}) {
      on_cut.insert(s.gluing.origin[c]);
      degree[fans.gluing.origin[c]] += p == Gluing::none ? 2 : 1;
    }
  }
  for (const std::uint32_t v : through) EXPECT_TRUE(on_cut.contains(v)) << v;
  for (std::size_t v = 0; v < degree.size(); ++v) { // an edge counts at both of its sides
    const bool is_end = degree[v] == 2;             // given, or that of a path on a sphere
    EXPECT_TRUE(!is_end || std::ranges::count(through, fans.original_vertex[v]) != 0 ||
                components > 1 || IT::genus(before).value_or(1) == 0);
  }
}

double length_of(const IT::Surface_to_cut& s, const std::vector<char>& is_cut) {
  double sum = 0;
  for (std::size_t h = 0; h < is_cut.size(); ++h)
    if (is_cut[h] != 0) sum += s.length[h] / 2;
  return sum;
}

std::vector<std::uint32_t> random_vertices(const Gluing& g, std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::uint32_t> result;
  for (std::size_t i = 0; i < n; ++i) result.push_back(g.origin[random() % g.origin.size()]);
  return result;
}

// Rank over Z/2 of rows of sets of numbers.
std::size_t rank(std::vector<std::vector<char>> rows) {
  std::size_t r = 0;
  const std::size_t columns = rows.empty() ? 0 : rows[0].size();
  for (std::size_t c = 0; c < columns && r < rows.size(); ++c) {
    std::size_t p = r;
    while (p < rows.size() && rows[p][c] == 0) ++p;
    if (p == rows.size()) continue;
    std::swap(rows[p], rows[r]);
    for (std::size_t i = r + 1; i < rows.size(); ++i)
      if (rows[i][c] != 0)
        for (std::size_t k = c; k < columns; ++k) rows[i][k] ^= rows[r][k];
    ++r;
  }
  return r;
}

// The loops are closed, as many as homology has dimensions, and independent of boundaries of faces.
void expect_generators(const IT::Surface_to_cut& s,
                       const std::vector<std::vector<std::uint32_t>>& loops) {
  const Gluing g = IT::cut_open(s.gluing, no_marks(s.gluing)).gluing;
  const IT::Gluing_map m(g);
  std::vector<std::uint32_t> edge(g.origin.size(), 0);
  std::uint32_t edges = 0;
  for (std::uint32_t h = 0; h < edge.size(); ++h) {
    const std::uint32_t p = Gluing::partner(g.glue[h]);
    edge[h] = p != Gluing::none && p < h ? edge[p] : edges++;
  }
  std::vector<std::vector<char>> rows(g.number_of_faces(), std::vector<char>(edges, 0));
  for (std::uint32_t h = 0; h < edge.size(); ++h) rows[h / 3][edge[h]] ^= 1;
  const std::size_t boundaries = rank(rows);
  // dimension of cycles - of boundaries
  std::size_t vertices = 0;
  for (const std::uint32_t n : IT::umbrellas(m)) vertices += n;
  const std::size_t dimension = edges + IT::connected_components(m).count - vertices - boundaries;
  EXPECT_EQ(loops.size(), dimension);
  for (const std::vector<std::uint32_t>& loop : loops) {
    rows.emplace_back(edges, 0);
    const auto end = [&](std::uint32_t entry, bool is_last) {
      const std::uint32_t h = Gluing::partner(entry);
      return g.origin[Gluing::is_reversed(entry) == is_last ? h : Gluing::next(h)];
    };
    ASSERT_FALSE(loop.empty());
    for (std::size_t i = 0; i < loop.size(); ++i) {
      EXPECT_EQ(end(loop[i], true), end(loop[(i + 1) % loop.size()], false));
      EXPECT_TRUE(loop.size() == 1 ||
                  Gluing::partner(loop[i]) != Gluing::partner(loop[(i + 1) % loop.size()]));
      rows.back()[edge[Gluing::partner(loop[i])]] ^= 1;
    }
  }
  EXPECT_EQ(rank(rows), boundaries + loops.size());
}

std::vector<meshes::Mesh> some_meshes() {
  std::vector<meshes::Mesh> result{meshes::sphere(2), meshes::box(2, 3, 1), torus(8, 5),
                                   meshes::rough_grid(6, 1),
                                   meshes::walls({{0, 0}, {3, 0}, {0, 3}}, 3)};
  for (unsigned seed = 0; seed < 6; ++seed) {
    result.push_back(with_holes(torus(9, 7), 0.05 + 0.05 * seed, seed));
    result.push_back(with_holes(meshes::sphere(2), 0.05 + 0.05 * seed, seed));
  }
  return result;
}

} // namespace

TEST(Cut_to_disk, Each_surface_of_the_gallery_becomes_disks) {
  for (const gallery::Surface& g : gallery::all()) {
    SCOPED_TRACE(g.name);
    const IT::Surface_to_cut s = surface_of(g);
    for (const std::size_t roots : {0U, 1U, 8U}) expect_disks(s, IT::cut_to_disk(s, {}, roots), {});
    for (unsigned seed = 0; seed < 5; ++seed) {
      const std::vector<std::uint32_t> through = random_vertices(s.gluing, 1 + seed, seed);
      expect_disks(s, IT::cut_to_disk(s, through), through);
    }
  }
}

TEST(Cut_to_disk, Meshes_with_holes_components_and_pinched_vertices_become_disks) {
  for (const meshes::Mesh& m : some_meshes()) {
    const IT::Surface_to_cut s = surface_of(m);
    expect_disks(s, IT::cut_to_disk(s), {});
    for (unsigned seed = 0; seed < 4; ++seed) {
      const std::vector<std::uint32_t> through = random_vertices(s.gluing, 1U << (2 * seed), seed);
      expect_disks(s, IT::cut_to_disk(s, through), through);
    }
  }
}

TEST(Cut_to_disk, A_disk_needs_no_cut_and_a_sphere_a_path_of_two_edges) {
  const auto count = [](const std::vector<char>& marks) {
    return std::ranges::count(marks, 1) / 2;
  };
  EXPECT_EQ(count(IT::cut_to_disk(surface_of(meshes::grid(4, 4)))), 0);
  EXPECT_EQ(count(IT::cut_to_disk(surface_of(gallery::tetrahedron()))), 2);
  EXPECT_EQ(count(IT::cut_to_disk(surface_of(gallery::tetrahedron()), std::vector{0U, 1U})), 1);
  const IT::Surface_to_cut sphere = surface_of(meshes::sphere(3)); // a great circle of 32 edges
  EXPECT_EQ(count(IT::cut_to_disk(sphere)), 16);
}

TEST(Cut_to_disk, A_cylinder_is_cut_along_a_ruling_and_a_torus_along_its_shortest_loops) {
  const IT::Surface_to_cut walls = surface_of(meshes::walls({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 5));
  EXPECT_DOUBLE_EQ(length_of(walls, IT::cut_to_disk(walls)), 5);
  const meshes::Mesh m = torus(24, 10);
  const IT::Surface_to_cut s = surface_of(m);
  const double inner = 24 * distance(m.points[5 * 24], m.points[5 * 24 + 1]),
               tube = 10 * distance(m.points[0], m.points[24]);
  EXPECT_NEAR(length_of(s, IT::cut_to_disk(s, {}, 16)), inner + tube, 1e-9);
}

// The shortest cut of a torus of few faces, by trying all sets of edges.
TEST(Cut_to_disk, Is_at_most_a_little_longer_than_the_shortest_cut) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    IT::Surface_to_cut s = surface_of(gallery::flat_torus(2, 2));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> length(1, 2);
    std::vector<std::uint32_t> first;
    for (std::uint32_t h = 0; h < s.length.size(); ++h)
      if (s.gluing.glue[h] > h) {
        s.length[h] = s.length[s.gluing.glue[h]] = length(random);
        first.push_back(h);
      }
    double shortest = std::numeric_limits<double>::infinity();
    for (std::uint32_t set = 0; set < 1U << first.size(); ++set) {
      std::vector<char> is_cut = no_marks(s.gluing);
      for (std::size_t i = 0; i < first.size(); ++i)
        if ((set >> i & 1U) != 0) is_cut[first[i]] = is_cut[s.gluing.glue[first[i]]] = 1;
      if (length_of(s, is_cut) >= shortest) continue;
      const IT::Gluing_map opened(IT::cut_open(s.gluing, is_cut).gluing);
      if (IT::euler_characteristic(opened) == 1 && IT::connected_components(opened).count == 1)
        shortest = length_of(s, is_cut);
    }
    const double found = length_of(s, IT::cut_to_disk(s));
    EXPECT_GE(found, shortest * (1 - 1e-12));
    EXPECT_LE(found, shortest * 1.2) << seed;
  }
}

TEST(Cut_to_disk, Kept_sides_stay_whole) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const meshes::Mesh m = with_holes(torus(9, 7), seed % 2 == 0 ? 0 : 0.1, seed);
    IT::Surface_to_cut s = surface_of(m);
    s.is_kept = no_marks(s.gluing);
    for (std::uint32_t h = 2; h < s.is_kept.size(); h += 6) s.is_kept[h] = 1; // diagonals
    if (seed % 2 != 0) s.is_kept.assign(s.is_kept.size(), 0);
    const std::vector<std::uint32_t> through = random_vertices(s.gluing, seed, seed);
    const std::vector<char> is_cut = IT::cut_to_disk(s, through);
    expect_disks(s, is_cut, through);
    for (std::uint32_t h = 0; h < is_cut.size(); ++h)
      EXPECT_TRUE(s.is_kept[h] == 0 || is_cut[h] == 0);
  }
}

TEST(Cut_to_disk, A_surface_that_is_a_point_becomes_a_disk) {
  IT::Surface_to_cut s = surface_of(gallery::tetrahedron());
  s.length.assign(s.length.size(), 0.0);
  expect_disks(s, IT::cut_to_disk(s), {});
}

TEST(Cut_to_disk, Refuses_what_it_cannot_cut) {
  IT::Surface_to_cut s = surface_of(gallery::tetrahedron());
  EXPECT_THROW(IT::cut_to_disk(s, std::vector{4U}), IT::Invalid_input);
  s.is_kept.assign(12, 1);
  EXPECT_THROW(IT::cut_to_disk(s), IT::Invalid_input);
  s.is_kept.assign(11, 0);
  EXPECT_THROW(IT::cut_to_disk(s), IT::Invalid_input);
  s.is_kept.clear();
  for (const double x :
       {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    s.length[7] = x;
    EXPECT_THROW(IT::cut_to_disk(s), IT::Invalid_input);
    EXPECT_THROW(IT::homology_generators(s), IT::Invalid_input);
  }
  IT::Surface_to_cut isolated = surface_of(gallery::two_fans_and_an_isolated_vertex());
  std::uint32_t v = 0;
  while (std::ranges::count(isolated.gluing.origin, v) != 0) ++v;
  EXPECT_THROW(IT::cut_to_disk(isolated, std::vector{v}), IT::Invalid_input);
  EXPECT_TRUE(IT::cut_to_disk(IT::Surface_to_cut()).empty());
  EXPECT_TRUE(IT::homology_generators(IT::Surface_to_cut()).empty());
}

// Disks again; spheres need two vertices. Ways from the centre are as short as they can be.
TEST(Cut_to_round_disk, Surfaces_become_disks) {
  std::vector<IT::Surface_to_cut> all;
  for (const gallery::Surface& g : gallery::all()) all.push_back(surface_of(g));
  for (const meshes::Mesh& m : some_meshes()) all.push_back(surface_of(m));
  for (const IT::Surface_to_cut& s : all)
    for (unsigned seed = 0; seed < 4; ++seed) {
      std::vector<std::uint32_t> through = random_vertices(s.gluing, 2 * seed, seed);
      try {
        expect_disks(s, IT::cut_to_round_disk(s, through, 1 + seed), through);
      } catch (const IT::Invalid_input& e) {
        EXPECT_NE(std::string(e.what()).find("sphere"), std::string::npos);
      }
    }
}

TEST(Cut_to_round_disk, Has_a_small_radius) {
  const IT::Surface_to_cut s = surface_of(torus(24, 10));
  const auto radius = [&s](const std::vector<char>& is_cut) { // in faces
    const Gluing g = IT::cut_open(s.gluing, is_cut).gluing;
    int least = 1 << 30;
    for (std::uint32_t root = 0; root < g.number_of_faces(); ++root) {
      std::vector<int> steps(g.number_of_faces(), -1);
      std::vector<std::uint32_t> order{root};
      steps[root] = 0;
      for (std::size_t n = 0; n < order.size(); ++n)
        for (std::uint32_t h = 3 * order[n]; h < 3 * order[n] + 3; ++h)
          if (g.glue[h] != Gluing::none && steps[g.glue[h] / 3] < 0) {
            steps[g.glue[h] / 3] = steps[order[n]] + 1;
            order.push_back(g.glue[h] / 3);
          }
      least = std::min(least, steps[order.back()]);
    }
    return least;
  };
  // a torus of 24 times 10 cells of two triangles; ways along the circle of length 24 go half
  // around
  EXPECT_LE(radius(IT::cut_to_round_disk(s)), 24 + 10 / 2);
  EXPECT_GE(radius(IT::cut_to_round_disk(s)), 24);
}

TEST(Cut_to_round_disk, Refuses_what_it_cannot_cut) {
  IT::Surface_to_cut s = surface_of(gallery::tetrahedron());
  EXPECT_THROW(IT::cut_to_round_disk(s), IT::Invalid_input);
  EXPECT_THROW(IT::cut_to_round_disk(s, std::vector{1U}), IT::Invalid_input);
  EXPECT_THROW(IT::cut_to_round_disk(s, std::vector{4U}), IT::Invalid_input);
  s.length.pop_back();
  EXPECT_THROW(IT::cut_to_round_disk(s), IT::Invalid_input);
  EXPECT_TRUE(IT::cut_to_round_disk(IT::Surface_to_cut()).empty());
}

TEST(Homology_generators, Are_a_basis_over_Z2) {
  for (const gallery::Surface& g : gallery::all()) {
    SCOPED_TRACE(g.name);
    const IT::Surface_to_cut s = surface_of(g);
    expect_generators(s, IT::homology_generators(s));
  }
  for (const meshes::Mesh& m : some_meshes()) {
    const IT::Surface_to_cut s = surface_of(m);
    expect_generators(s, IT::homology_generators(s));
  }
}

#ifdef INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR
TEST(Cut_to_disk, All_meshes_of_CGAL_become_disks) {
  for (const auto& file : refined::files(3'000'000)) {
    SCOPED_TRACE(file.string());
    IT::Intrinsic_input in;
    try {
      in = IT::make_domain(IT::read_triangle_soup(file)).input;
    } catch (const std::exception&) {
      continue; // no surface
    }
    const IT::Surface_to_cut s = surface_to_cut(Double_triangulation(std::move(in)));
    expect_disks(s, IT::cut_to_disk(s, {}, 2), {});
    const std::vector<std::uint32_t> through = random_vertices(s.gluing, 5, 1);
    expect_disks(s, IT::cut_to_disk(s, through, 2), through);
  }
}
#endif
