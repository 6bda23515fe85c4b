// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "properties.h"
#include "stress_families.h"

#include <CGAL/Integer_only_triangulation.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Exact = IT::Intrinsic_triangulation<>;
using Point = std::array<double, 3>;

Exact triangulation(const stress::Mesh& m) {
  return Exact(meshes::Mesh{m.points, m.faces}.input());
}

std::uint64_t flips(const std::string& spec) {
  Exact t = triangulation(stress::make(spec));
  const IT::Flip_to_delaunay_result result = IT::flip_to_delaunay(t);
  EXPECT_TRUE(IT::is_delaunay(t)) << spec;
  return result.flips;
}

// FNV-1a of all coordinates and corners.
std::uint64_t checksum(const stress::Mesh& m) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  const auto add = [&hash](std::uint64_t x) {
    for (int byte = 0; byte < 8; ++byte, x >>= 8U) hash = (hash ^ (x & 0xffU)) * 0x100000001b3U;
  };
  for (const Point& p : m.points)
    for (const double x : p) add(std::bit_cast<std::uint64_t>(x));
  for (const auto& f : m.faces)
    for (const std::uint32_t v : f) add(v);
  return hash;
}

double total_area(const stress::Mesh& m) { return properties::total_area(triangulation(m)); }

// ---- all of them

TEST(Stress_families, all_standard_meshes_are_finite_oriented_and_manifold) {
  for (const std::string& spec : stress::standard_specs()) {
    const stress::Mesh m = stress::make(spec);
    for (const Point& p : m.points)
      for (const double x : p) EXPECT_TRUE(std::isfinite(x)) << spec;
    std::set<std::pair<std::uint32_t, std::uint32_t>> halfedges;
    for (const auto& f : m.faces)
      for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_LT(f[k], m.points.size()) << spec;
        EXPECT_NE(f[k], f[(k + 1) % 3]) << spec;
        EXPECT_TRUE(halfedges.emplace(f[k], f[(k + 1) % 3]).second) << spec;
      }
    const Exact t = triangulation(m);
    for (const std::uint32_t n : IT::umbrellas(t.mesh())) EXPECT_EQ(n, 1U) << spec;
    EXPECT_EQ(IT::connected_components(t.mesh()).count, 1U) << spec;
    EXPECT_EQ(t.report().degenerate_faces, 0U) << spec;
  }
}

TEST(Stress_families, standard_specs_are_different_and_about_sixty) {
  const std::vector<std::string> specs = stress::standard_specs();
  std::set<std::uint64_t> different;
  for (const std::string& spec : specs) different.insert(checksum(stress::make(spec)));
  EXPECT_EQ(different.size(), specs.size());
  EXPECT_GT(specs.size(), 50U);
  EXPECT_LT(specs.size(), 75U);
}

TEST(Stress_families, exact_flips_make_all_standard_meshes_Delaunay_with_or_without_a_metric) {
  for (const std::string& spec : stress::standard_specs()) {
    const stress::Mesh m = stress::make(spec);
    Exact t = triangulation(m);
    EXPECT_EQ(IT::flip_to_delaunay(t).status, IT::Status::done) << spec;
    EXPECT_EQ(IT::check_delaunay(t).non_delaunay_edges, 0U) << spec;
    EXPECT_EQ(t.metric().statistics().probable_zero, 0U) << spec;
    IT::Integer_only_triangulation<> integers(meshes::Mesh{m.points, m.faces}.input());
    EXPECT_EQ(IT::flip_to_delaunay(integers).status, IT::Status::done) << spec;
    // lengths tell exact traits the order of flips, on which the diagonals of ties depend
    EXPECT_EQ(properties::edges_without_ties(integers), properties::edges_without_ties(t)) << spec;
  }
}

TEST(Stress_families, sizes_are_about_what_was_asked) {
  for (const char* const family : {"parabola", "grid-plane", "grid-folded", "grid-cylinder",
                                   "splits", "ulps", "offset", "caps", "needles", "grid-cube",
                                   "wound-torus", "wound-cylinder", "wound-sphere", "stretched"}) {
    const std::size_t faces =
        stress::make("stress:" + std::string(family) + ":size=5000").faces.size();
    // spheres of 8 * 4^k faces are at worst twice too large or too small
    const bool doubles = std::string(family) == "stretched";
    EXPECT_GE(static_cast<double>(faces), doubles ? 2500 : 4500) << family;
    EXPECT_LE(static_cast<double>(faces), doubles ? 10000 : 5500) << family;
  }
}

// ---- one by one

// U^m L^m against an alternating word: m (m - 1) / 2 exchanges of neighbours, whatever the order.
TEST(Stress_families, flips_on_the_parabola_are_quadratic) {
  for (const std::uint64_t m : {2U, 5U, 16U, 45U})
    for (const char* const amount : {"0.25", "1e-12", "0.9"})
      EXPECT_EQ(flips("stress:parabola:size=" + std::to_string(2 * m) + ":amount=" + amount),
                m * (m - 1) / 2)
          << amount;
}

// Tests that the interior edges that `selects` are ties, and that there are some.
template <class Selection>
std::size_t count_ties(Exact& t, const Selection& selects) {
  std::set<std::uint32_t> ties;
  for (const Exact::edge_descriptor e : IT::check_delaunay(t).cocircular_edges)
    ties.insert(t.index(e));
  std::size_t count = 0;
  for (const Exact::halfedge_descriptor h : properties::flippable_by_connectivity(t)) {
    if (!selects(h)) continue;
    EXPECT_TRUE(ties.contains(t.index(edge(h, t.mesh()))));
    ++count;
  }
  return count;
}

// The number of edges whose ends differ in z and in x or y (or, in the plane, in x and y).
std::size_t count_diagonal_ties(const std::string& spec) {
  const stress::Mesh m = stress::make(spec);
  Exact t = triangulation(m);
  bool is_planar = true;
  for (const Point& p : m.points) is_planar = is_planar && p[2] == m.points[0][2];
  return count_ties(t, [&](Exact::halfedge_descriptor h) {
    const Point& p = m.points[t.input_vertex(source(h, t.mesh()))];
    const Point& q = m.points[t.input_vertex(target(h, t.mesh()))];
    const bool x = p[0] != q[0], y = p[1] != q[1], z = p[2] != q[2];
    return is_planar ? x && y : z && (x || y);
  });
}

TEST(Stress_families, diagonals_of_grids_are_exact_ties) {
  EXPECT_EQ(count_diagonal_ties("stress:grid-plane:size=200"), 100U);
  EXPECT_EQ(count_diagonal_ties("stress:grid-plane:size=200:seed=7"), 100U);
  EXPECT_EQ(count_diagonal_ties("stress:grid-cylinder:size=200"), 100U);
  EXPECT_EQ(count_diagonal_ties("stress:grid-cylinder:size=1000:seed=3"), 22U * 22U);
}

TEST(Stress_families, squares_folded_over_the_edges_of_a_cube_are_exact_ties) {
  const std::uint32_t n = 4;
  const stress::Mesh m = stress::make("stress:grid-cube:size=" + std::to_string(24 * n * n));
  Exact t = triangulation(m);
  const auto is_unit = [&t](Exact::halfedge_descriptor h) {
    return t.squared_length(edge(h, t.mesh())) == 1;
  };
  const auto is_on_cube_edge = [&](Exact::halfedge_descriptor h) {
    int fixed = 0; // coordinates in which the whole edge is on the border of [0, n]
    for (std::size_t k = 0; k < 3; ++k) {
      const double p = m.points[t.input_vertex(source(h, t.mesh()))][k];
      const double q = m.points[t.input_vertex(target(h, t.mesh()))][k];
      fixed += p == q && (p == 0 || p == n) ? 1 : 0;
    }
    return is_unit(h) && fixed == 2;
  };
  EXPECT_EQ(count_ties(t, is_unit), 12U * n * n); // each of 6 n^2 squares has four, shared by two
  EXPECT_EQ(count_ties(t, is_on_cube_edge), 12U * n);
}

TEST(Stress_families, sheared_lattices_become_squares_with_exact_ties) {
  const std::pair<const char*, int> lattices[] = {
      {"stress:grid-plane:amount=3", 2}, // squared length of diagonals
      {"stress:grid-folded", 100},
      {"stress:grid-folded:amount=2", 100},
  };
  for (const auto& [spec, diagonal] : lattices) {
    Exact t = triangulation(stress::make(spec));
    EXPECT_GT(IT::flip_to_delaunay(t).flips, 100U) << spec;
    // exact values are those of the metric, which is scaled by a power of two
    const CGAL::Gmpq expected(std::ldexp(diagonal, 2 * t.metric().scale_exponent()));
    std::size_t diagonals = 0;
    for (const Exact::edge_descriptor e : IT::check_delaunay(t).cocircular_edges) {
      const auto length = properties::rational_squared_length(t, halfedge(e, t.mesh()));
      diagonals += length == expected ? 1 : 0;
    }
    EXPECT_GT(diagonals, 150U) << spec;
  }
  // each of 16 sides, and 16 rectangles on each, wherever their diagonals were at first
  Exact t = triangulation(stress::make("stress:grid-cylinder:amount=4"));
  EXPECT_GT(IT::flip_to_delaunay(t).flips, 500U);
  EXPECT_EQ(IT::check_delaunay(t).cocircular_edges.size(), 256U);
}

TEST(Stress_families, a_stretched_cube_flips_over_its_edges) {
  Exact t = triangulation(stress::make("stress:grid-cube:size=600:amount=2"));
  // the long sides of cells have angles of 2 atan 2 > 90 degrees on both sides; there are
  // 5 along each of 20 columns around the cube
  EXPECT_EQ(IT::check_delaunay(t).non_delaunay_edges, 100U);
}

// Calls `check(a, b, apex)` for the faces in a vertical plane over a side a b in an even row of the grid.
template <class Check>
std::size_t for_each_upright_face(const stress::Mesh& m, const Check& check) {
  std::size_t count = 0;
  for (const auto& f : m.faces)
    for (std::size_t k = 0; k < 3; ++k) {
      const Point &a = m.points[f[k]], &b = m.points[f[(k + 1) % 3]], &c = m.points[f[(k + 2) % 3]];
      if (a[2] != 0 || b[2] != 0 || c[2] == 0 || a[1] != b[1] || a[1] != c[1]) continue;
      check(a, b, c);
      ++count;
    }
  return count;
}

// Made by one product; divided here: two roundings.
constexpr double two_roundings = 0x1p-52;

TEST(Stress_families, caps_have_the_height_that_was_asked) {
  for (const char* const text : {"1e-1", "1e-4", "1e-8", "1e-15", "1e-100"}) {
    const double h = std::strtod(text, nullptr);
    const stress::Mesh m = stress::make("stress:caps:size=600:amount=" + std::string(text));
    const auto is_cap = [h](const Point& a, const Point& b, const Point& c) {
      EXPECT_NEAR(c[2] / (b[0] - a[0]), h, two_roundings * h);
      EXPECT_LT(a[0], c[0]);
      EXPECT_LT(c[0], b[0]);
    };
    EXPECT_EQ(for_each_upright_face(m, is_cap), 5U * 10U) << text; // on every other of 10 rows
  }
}

TEST(Stress_families, needles_have_the_width_that_was_asked) {
  for (const char* const text : {"1e-1", "1e-4", "1e-8", "1e-15", "1e-100"}) {
    const double h = std::strtod(text, nullptr);
    const stress::Mesh m = stress::make("stress:needles:size=605:amount=" + std::string(text));
    const auto is_needle = [h](const Point& a, const Point& b, const Point& c) {
      EXPECT_NEAR(c[2] / (b[0] - a[0]), h, two_roundings * h);
      EXPECT_EQ(c[0], a[0]);
    };
    EXPECT_EQ(for_each_upright_face(m, is_needle), 6U * 11U) << text; // on every other of 11 rows
  }
}

TEST(Stress_families, bad_shapes_are_worked_on) {
  for (const char* const family : {"caps", "needles", "splits", "stretched", "offset"})
    EXPECT_GT(flips("stress:" + std::string(family)), 100U) << family;
}

TEST(Stress_families, perturbed_coordinates_are_off_by_one_unit_in_the_last_place) {
  const stress::Mesh m = stress::make("stress:ulps:size=512"),
                     four = stress::make("stress:ulps:size=512:amount=4");
  std::set<double> seen;
  ASSERT_EQ(m.points.size(), 17U * 17U);
  for (std::size_t v = 0; v < m.points.size(); ++v) {
    const double column = static_cast<double>(v % 17), row = static_cast<double>(v / 17);
    const Point exact = {1 + (column + 1) / 32, 1 + (row + 1) / 32, 0};
    for (std::size_t k = 0; k < 2; ++k) {
      const double x = m.points[v][k];
      EXPECT_TRUE(x == exact[k] || x == std::nextafter(exact[k], 0) ||
                  x == std::nextafter(exact[k], 2))
          << x << " near " << exact[k];
      EXPECT_EQ(four.points[v][k] - exact[k], 4 * (x - exact[k]));
      seen.insert(x - exact[k]);
    }
    EXPECT_EQ(m.points[v][2], 0);
  }
  EXPECT_EQ(seen.size(), 3U);
}

TEST(Stress_families, meshes_far_away_are_rounded_to_what_doubles_can_hold) {
  const meshes::Mesh near = meshes::rough_grid(16, 1, 0.1);
  const std::pair<const char*, double> offsets[] = {{"0", 0}, {"1e6", 1e6}, {"1e15", 1e15}};
  for (const auto& [text, d] : offsets) {
    const stress::Mesh far = stress::make("stress:offset:size=512:amount=" + std::string(text));
    ASSERT_EQ(far.points.size(), near.points.size());
    const CGAL::Gmpq half_ulp = (CGAL::Gmpq(std::nextafter(2 * d, 1e300)) - CGAL::Gmpq(2 * d)) / 2;
    for (std::size_t v = 0; v < near.points.size(); ++v)
      for (std::size_t k = 0; k < 3; ++k) {
        const CGAL::Gmpq error = CGAL::Gmpq(far.points[v][k]) - CGAL::Gmpq(d) - near.points[v][k];
        EXPECT_LE(CGAL::abs(error), half_ulp) << text;
      }
  }
}

TEST(Stress_families, stretching_changes_x_only) {
  const stress::Mesh m = stress::make("stress:stretched:amount=1");
  const stress::Mesh wide = stress::make("stress:stretched:amount=1e6");
  EXPECT_EQ(m.faces, wide.faces);
  for (std::size_t v = 0; v < m.points.size(); ++v)
    EXPECT_EQ(wide.points[v], (Point{1e6 * m.points[v][0], m.points[v][1], m.points[v][2]}));
}

TEST(Stress_families, split_edges_stay_on_the_surface) {
  const meshes::Mesh sphere = meshes::sphere(2);
  const double area = total_area({sphere.points, sphere.triangles});
  for (const char* const amount : {"0.5", "0.1", "0.01", "0"}) {
    const stress::Mesh m = stress::make("stress:splits:size=3001:amount=" + std::string(amount));
    EXPECT_GE(m.faces.size(), 3001U);
    EXPECT_LE(m.faces.size(), 3002U); // a split adds two
    // a new point is off its edge by a rounding error of coordinates below 1, that is by 1e-16 or
    // so, which changes the area of a face by its sides, below 1, times that
    EXPECT_NEAR(total_area(m), area, 3002 * 1e-15) << amount;
    EXPECT_EQ(properties::euler_characteristic(triangulation(m)), 2);
  }
}

TEST(Stress_families, wound_surfaces_have_their_topology_and_unwind) {
  const auto check = [](const std::string& family, std::ptrdiff_t euler, std::size_t loops) {
    std::uint64_t last = 0;
    for (const char* const amount : {"2", "5", "10"}) {
      const std::string spec = "stress:" + family + ":amount=" + amount;
      const Exact t = triangulation(stress::make(spec));
      EXPECT_EQ(properties::euler_characteristic(t), euler) << spec;
      EXPECT_EQ(IT::boundary_loops(t.mesh()).size(), loops) << spec;
      const std::uint64_t n = flips(spec);
      EXPECT_GE(n, 2 * last) << spec; // each step further on takes about a flip per vertex
      last = n;
    }
    EXPECT_GT(last, 3000U) << family; // of about 500 vertices
  };
  check("wound-sphere", 2, 0);
  check("wound-torus", 0, 0);
  check("wound-cylinder", 0, 2);
}

// ---- repeatable

// Without sines and cosines, and without anything that a fused multiplication and addition changes.
TEST(Stress_families, meshes_are_the_same_everywhere) {
  const std::pair<const char*, std::uint64_t> sums[] = {
      {"stress:parabola:size=64", 0x00a01aed5d4aa0b5U},
      {"stress:grid-plane:seed=5:amount=3", 0x54d52ca293bdde2bU},
      {"stress:grid-cube", 0x4af9b9458e6979fdU},
      {"stress:grid-folded:amount=2", 0x52c7ef659aa3f122U},
      {"stress:needles:amount=1e-9", 0x03b54bc9933f209eU},
      {"stress:caps:amount=1e-9:seed=3", 0x68cf5a3691e69834U},
      {"stress:ulps", 0x3765cb2020c47a75U},
  };
  for (const auto& [spec, sum] : sums) EXPECT_EQ(checksum(stress::make(spec)), sum) << spec;
}

TEST(Stress_families, keys_come_in_any_order_and_have_defaults) {
  const std::uint64_t sum = checksum(stress::make("stress:caps:size=600:seed=1:amount=1e-3"));
  EXPECT_EQ(checksum(stress::make("stress:caps:amount=0.001:seed=1:size=600")), sum);
  EXPECT_EQ(checksum(stress::make("stress:caps")), sum);
}

TEST(Stress_families, seeds_draw_or_renumber) {
  for (const char* const family : {"splits", "needles", "caps", "ulps", "offset", "stretched"}) {
    const std::string spec = "stress:" + std::string(family) + ":seed=";
    EXPECT_NE(stress::make(spec + "1").points, stress::make(spec + "2").points) << family;
  }
  for (const char* const family :
       {"parabola", "grid-plane", "grid-cube", "grid-folded", "grid-cylinder", "wound-sphere",
        "wound-torus", "wound-cylinder"}) {
    const std::string spec = "stress:" + std::string(family);
    std::vector<Point> a = stress::make(spec).points, b = stress::make(spec + ":seed=1").points;
    EXPECT_NE(a, b) << family;
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    EXPECT_EQ(a, b) << family;
  }
}

// ---- errors

TEST(Stress_families, bad_specs_are_refused_with_what_is_known) {
  const std::pair<const char*, const char*> wrong[] = {
      {"", "stress:FAMILY"},
      {"caps", "stress:FAMILY"},
      {"stress", "parabola, grid-plane"},
      {"stress:kaps", "`kaps` is not a family; known are parabola"},
      {"stress:caps:height=1", "`height` is not a key; known are size, seed, amount"},
      {"stress:caps:size", "`size` has no value"},
      {"stress:caps::size=3", "`` has no value"},
      {"stress:caps:size=", "`size` is ``"},
      {"stress:caps:size=0", "from 1 to 1"},
      {"stress:caps:size=-3", "`size` is `-3`"},
      {"stress:caps:size=3.5", "`size` is `3.5`"},
      {"stress:caps:size=99999999999", "`size` is"},
      {"stress:caps:size=99999999999999999999999", "`size` is"},
      {"stress:caps:seed=4294967296", "`seed` is"},
      {"stress:caps:seed=1:seed=2", "`seed` is given twice"},
      {"stress:caps:amount=0", "`amount` is `0`"},
      {"stress:caps:amount=nan", "`amount` is `nan`"},
      {"stress:caps:amount=inf", "`amount` is `inf`"},
      {"stress:caps:amount=1e-3x", "`amount` is `1e-3x`"},
      {"stress:parabola:amount=1", "to 0.99"},
      {"stress:ulps:amount=1.5", "give an integer"},
  };
  for (const auto& [spec, message] : wrong) {
    try {
      stress::make(spec);
      ADD_FAILURE() << spec << " is accepted";
    } catch (const std::invalid_argument& e) {
      EXPECT_EQ(std::string(e.what()).find(spec), 0U) << e.what();
      EXPECT_NE(std::string(e.what()).find(message), std::string::npos) << e.what();
    }
  }
}

} // namespace
