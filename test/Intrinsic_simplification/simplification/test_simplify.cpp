// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_simplification/simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/simplification/remove_flat_vertices.h>
#include <CGAL/Intrinsic_simplification/simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/points_of_rows.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>

#include "coarse_meshes.h"
#include "expect_coarse.h"
#include "gallery.h"
#include "operator_test_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace operator_test;
using T = IT::Corresponding_triangulation;

TEST(Simplify, keeps_distances_within_the_proven_bounds) {
  for (const Shape& shape : {rough_torus(10, .3, 1), rough_grid(9, .3, .6, 4)}) {
    const T fine = delaunay(shape);
    for (const std::size_t vertices : {60, 25, 12}) {
      const IT::Simplification s = IT::simplify(fine, to(vertices));
      EXPECT_EQ(s.status, IT::Status::done);
      EXPECT_EQ(s.kept.size(), vertices);
      EXPECT_LT(s.stretch.lower, s.stretch.mean_lower);
      EXPECT_LT(s.stretch.mean_lower, s.stretch.mean_upper);
      EXPECT_LT(s.stretch.mean_upper, s.stretch.upper);
      expect_surface(fine, s);
      expect_distances_within(fine, s);
    }
  }
}

// Vertices are ranked by their costs, and by their numbers where these are equal.
TEST(Simplify, removes_the_cheapest_vertices_first) {
  const T fine = delaunay(rough_torus(12, .2, 1));
  std::vector<std::pair<double, std::uint32_t>> ranked;
  std::mt19937 random(1);
  for (std::uint32_t v = 0; v < 144; ++v) ranked.emplace_back(random() % 20, v);
  const auto sorted = [&ranked] {
    auto result = ranked;
    std::ranges::sort(result);
    return result;
  }();
  for (const std::size_t vertices : {100, 40, 20}) {
    const IT::Simplification s = IT::simplify(
        fine, to(vertices), [&](const IT::Removal_candidate& c) { return ranked[c.vertex].first; });
    std::vector<std::uint32_t> expected;
    for (std::size_t n = 144 - vertices; n < 144; ++n) expected.push_back(sorted[n].second);
    std::ranges::sort(expected);
    EXPECT_EQ(s.kept, expected);
  }
}

TEST(Simplify, stops_where_the_stretch_would_leave_its_bound) {
  const T fine = delaunay(rough_torus(10, .3, 1));
  std::size_t before = num_vertices(fine.mesh());
  for (const double most : {1.05, 1.2, 2.}) {
    IT::Simplify_options options;
    options.stretch = most;
    const IT::Simplification s = IT::simplify(fine, options);
    EXPECT_EQ(s.status, IT::Status::stalled);
    EXPECT_LE(s.stretch.upper, most);
    EXPECT_GE(s.stretch.lower, 1 / most);
    EXPECT_GT(s.kept_by_bound, 0U);
    EXPECT_LT(s.kept.size(), before);
    before = s.kept.size();
    expect_surface(fine, s);
    expect_distances_within(fine, s);
  }
}

TEST(Simplify, removes_flat_vertices_if_no_stretch_is_allowed) {
  IT::Simplify_options options;
  options.stretch = 1;
  const T fine = delaunay(cube_of_grids(4));
  const IT::Simplification s = IT::simplify(fine, options);
  EXPECT_EQ(s.kept.size(), 8U);
  EXPECT_LE(s.stretch.upper, 1 + 1e-9);
  EXPECT_GE(s.stretch.lower, 1 - 1e-9);
  expect_distances_within(fine, s);
  const T rough = delaunay(rough_torus(6, .3, 1));
  EXPECT_EQ(IT::simplify(rough, options).removed, 0U);
}

// A double cone over a polygon: the apex at the top has its vertices in any order of numbers around
// it, and is as flat as a plane; removal is not quadratic in the degree.
TEST(Simplify, removes_a_vertex_of_high_degree) {
  constexpr std::uint32_t n = 20000;
  Shape shape;
  for (std::uint32_t k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * k / n, r = 1 + .2 * std::sin(5 * angle);
    shape.points.push_back({r * std::cos(angle), r * std::sin(angle), 0});
  }
  shape.points.push_back({0, 0, .01});
  shape.points.push_back({0, 0, -2});
  for (std::uint32_t k = 0; k < n; ++k) {
    shape.triangles.push_back({k, (k + 1) % n, n});
    shape.triangles.push_back({(k + 1) % n, k, n + 1});
  }
  IT::Simplify_options options = to(n + 1);
  for (std::uint32_t v = 0; v <= n + 1; ++v)
    if (v != n) options.kept_vertices.push_back(v);
  // not Delaunay: edges that the apex needs would be flipped
  const T fine(shape.input());
  const IT::Simplification s = IT::simplify(fine, options);
  EXPECT_EQ(s.removed, 1U);
  EXPECT_EQ(s.kept.size(), n + 1);
}

// The same surface with vertex v named `name[v]`, faces in another order, and moved points.
template <class Move>
Shape renamed(const Shape& shape, const std::vector<std::uint32_t>& name, const Move& move) {
  Shape result;
  result.points.resize(shape.points.size());
  for (std::uint32_t v = 0; v < name.size(); ++v) result.points[name[v]] = move(shape.points[v]);
  for (auto t = shape.triangles.rbegin(); t != shape.triangles.rend(); ++t)
    result.triangles.push_back({name[(*t)[1]], name[(*t)[2]], name[(*t)[0]]});
  return result;
}

// Up to rounding, since costs order the vertices; this surface has no ties.
TEST(Simplify, gives_the_same_for_turned_renumbered_and_scaled_surfaces) {
  const Shape shape = rough_torus(14, .3, 5);
  const auto n = static_cast<std::uint32_t>(shape.points.size());
  const auto place = [](const std::array<double, 3>& p) { return p; };
  const auto turned = [](const std::array<double, 3>& p) {
    return std::array<double, 3>{.6 * p[0] - .8 * p[1], .8 * p[0] + .6 * p[1], p[2]};
  };
  const auto large = [&](const std::array<double, 3>& p) {
    return std::array<double, 3>{3e20 * p[0], 3e20 * p[1], 3e20 * p[2]};
  };
  std::vector<std::uint32_t> same(n), other(n);
  for (std::uint32_t v = 0; v < n; ++v) {
    same[v] = v;
    other[v] = (v * 101 + 7) % n; // 101 and n = 196 have no common divisor
  }
  const IT::Simplification first = IT::simplify(delaunay(shape), to(20));
  const auto expect_same = [&](const Shape& s, const std::vector<std::uint32_t>& name,
                               double scale) {
    const IT::Simplification found = IT::simplify(delaunay(s), to(20));
    std::vector<std::uint32_t> names;
    for (const std::uint32_t v : first.kept) names.push_back(name[v]);
    std::vector<std::uint32_t> kept = found.kept;
    std::ranges::sort(names);
    std::ranges::sort(kept);
    EXPECT_EQ(kept, names);
    EXPECT_NEAR(found.stretch.lower, first.stretch.lower, 1e-7);
    EXPECT_NEAR(found.stretch.upper, first.stretch.upper, 1e-7);
    EXPECT_NEAR(found.stretch.mean_upper, first.stretch.mean_upper, 1e-7);
    std::vector<double> a = first.surface.squared_lengths, b = found.surface.squared_lengths;
    std::ranges::sort(a);
    std::ranges::sort(b);
    for (std::size_t e = 0; e < a.size(); ++e) EXPECT_NEAR(b[e] / (a[e] * scale * scale), 1, 1e-7);
  };
  expect_same(renamed(shape, other, place), other, 1);
  expect_same(renamed(shape, same, turned), same, 1);
  expect_same(renamed(shape, same, large), same, 3e20);
  expect_same(renamed(shape, other, turned), other, 1);
}

// Distances from kept vertices to the place of each vertex, on both surfaces by the exact search.
TEST(Simplify, knows_the_places_of_vertices_that_are_gone) {
  const auto distances_at = [](const T& coarse, const IT::Simplification& s, std::uint32_t from) {
    IT::Polyhedral_distance<T> d(coarse);
    d.search(IT::vertex_of_row(coarse, from));
    std::vector<double> result;
    for (const IT::Place& p : s.places)
      result.push_back(d.distance(IT::point_on_input(coarse.input(), p)));
    return result;
  };
  { // vertices in the sides of a cube, and on its edges: nothing changes
    const T fine = delaunay(cube_of_grids(4));
    const IT::Simplification s = IT::remove_flat_vertices(fine);
    const T coarse(s.surface);
    IT::Polyhedral_distance<T> on_fine(fine);
    for (const std::uint32_t c : {0U, 3U, 6U}) {
      on_fine.search(IT::vertex_of_row(fine, s.kept[c]));
      const std::vector<double> expected = on_fine.distances(), found = distances_at(coarse, s, c);
      for (std::size_t v = 0; v < expected.size(); ++v) EXPECT_NEAR(found[v], expected[v], 1e-9);
    }
  }
  const T fine = delaunay(rough_torus(16, .05, 1));
  IT::Simplify_options options;
  options.stretch = 1.05;
  const IT::Simplification s = IT::simplify(fine, options);
  ASSERT_GT(s.removed, 50U);
  const T coarse(s.surface);
  IT::Polyhedral_distance<T> on_fine(fine);
  for (const std::uint32_t c : {0U, 7U, 20U}) {
    on_fine.search(IT::vertex_of_row(fine, s.kept[c]));
    const std::vector<double> expected = on_fine.distances(), found = distances_at(coarse, s, c);
    for (std::size_t v = 0; v < expected.size(); ++v) {
      EXPECT_GE(found[v], expected[v] * s.stretch.lower * (1 - 1e-12));
      EXPECT_LE(found[v], expected[v] * s.stretch.upper * (1 + 1e-12));
    }
  }
}

// Inside disks, two vertices are left: one of them on the border, as Gauss and Bonnet ask for; or
// three on the border. Border edges take the lengths that let others become flat.
TEST(Simplify, is_not_blocked_by_borders) {
  Shape open_cube = cube();
  std::erase_if(open_cube.triangles, [&](const auto& t) {
    return std::ranges::all_of(t, [&](std::uint32_t v) { return open_cube.points[v][2] == 1; });
  });
  Shape star = grid(6); // with deep bays, whose vertices have angles above pi
  std::erase_if(star.triangles, [&](const auto& t) {
    double x = 0, y = 0;
    for (const std::uint32_t v : t) {
      x += star.points[v][0] / 3;
      y += star.points[v][1] / 3;
    }
    return (x < 2 && y > 2 && y < 4) || (y < 2 && x > 3 && x < 4) || (x > 4 && y > 3 && y < 4);
  });
  for (std::size_t v = 0; v < star.points.size(); ++v)
    star.points[v][2] = .7 * std::sin(static_cast<double>(7 * v));
  for (const Shape& shape : {open_cube, star, rough_grid(9, .3, .6, 4)}) {
    const T fine = delaunay(shape);
    const IT::Simplification least = IT::simplify(fine, to(1));
    EXPECT_EQ(least.blocked_by_border, 0U);
    EXPECT_EQ(least.not_flattened, 0U);
    EXPECT_LE(least.kept.size(), 3U + (fine.number_of_vertices() - num_vertices(fine.mesh())));
    for (const std::size_t vertices : {4, 7}) {
      const IT::Simplification s = IT::simplify(fine, to(vertices));
      EXPECT_EQ(s.kept.size(), vertices);
      expect_distances_within(fine, s);
    }
  }
}

TEST(Simplify, takes_a_part_of_the_vertices) {
  const T fine = delaunay(rough_torus(10, .3, 1));
  IT::Simplify_options options;
  EXPECT_EQ(IT::simplify(fine, options).kept.size(), 10U);
  options.part = .37;
  EXPECT_EQ(IT::simplify(fine, options).kept.size(), 37U);
  options.vertices = 50; // the first that is reached
  EXPECT_EQ(IT::simplify(fine, options).kept.size(), 50U);
  for (const double part : {0., -1., 1.5, std::numeric_limits<double>::quiet_NaN()}) {
    options.part = part;
    EXPECT_THROW(IT::simplify(fine, options), IT::Invalid_input);
  }
}

TEST(Simplify, reproduces_linear_functions_on_a_flat_surface) {
  const Shape shape = rough_grid(12, .3, 0, 2);
  const T fine = delaunay(shape);
  const auto flat = [&](const std::vector<std::uint32_t>& kept) { // the border stays
    IT::Simplify_options options = to(50);
    options.kept_vertices = kept;
    return options;
  };
  std::vector<std::uint32_t> border;
  for (const auto h : halfedges(fine.mesh()))
    if (CGAL::is_border(h, fine.mesh()))
      border.push_back(fine.input_vertex(target(h, fine.mesh())));
  const IT::Simplification s = IT::simplify(fine, flat(border));
  ASSERT_EQ(s.kept.size(), 50U);
  EXPECT_NEAR(s.stretch.lower, 1, 2e-12);
  EXPECT_NEAR(s.stretch.upper, 1, 2e-12);
  EXPECT_LE(s.stretch.lower, 1);
  EXPECT_GE(s.stretch.upper, 1);
  const Eigen::SparseMatrix<double> p = IT::prolongation(s);
  ASSERT_EQ(p.rows(), 169);
  ASSERT_EQ(p.cols(), 50);
  EXPECT_GE(p.coeffs().minCoeff(), 0);
  Eigen::VectorXd coarse(50);
  for (Eigen::Index i = 0; i < 50; ++i) {
    const auto q = shape.points[s.kept[static_cast<std::size_t>(i)]];
    coarse[i] = 3 * q[0] - 2 * q[1] + 1;
  }
  const Eigen::VectorXd found = p * coarse;
  for (std::size_t v = 0; v < shape.points.size(); ++v)
    EXPECT_NEAR(found[static_cast<Eigen::Index>(v)],
                3 * shape.points[v][0] - 2 * shape.points[v][1] + 1, 1e-10);
}

TEST(Simplify, ends_on_every_oriented_surface) {
  for (const gallery::Surface& surface : gallery::oriented()) {
    SCOPED_TRACE(surface.name);
    T fine(gallery::input(surface));
    IT::flip_to_delaunay(fine);
    const IT::Simplification s = IT::simplify(fine, to(1));
    if (surface.expected.nonmanifold_vertices > 0) {
      EXPECT_EQ(IT::euler_characteristic(T(s.surface).mesh()) +
                    static_cast<std::ptrdiff_t>(surface.expected.isolated_vertices),
                IT::euler_characteristic(fine.mesh()));
      continue;
    }
    EXPECT_EQ(s.not_flattened, 0U);
    if (surface.expected.isolated_vertices == 0) expect_surface(fine, s);
    // without border, one more than the Euler characteristic stay, and at least one
    if (surface.expected.boundary_loops == 0 && surface.expected.components == 1) {
      EXPECT_EQ(static_cast<std::ptrdiff_t>(s.kept.size()),
                std::max<std::ptrdiff_t>(1, surface.euler_characteristic() + 1));
    }
  }
}

// Rows of the vertices of a triangulation, and how many vertices each has.
std::map<std::uint32_t, std::size_t> copies_of_rows(const T& t) {
  std::map<std::uint32_t, std::size_t> result;
  for (const auto v : vertices(t.mesh())) ++result[t.input_vertex(v)];
  return result;
}

// A surface that is doubled along its border, and one of three pages that meet at a spine.
TEST(Simplify, removes_all_copies_of_a_vertex_together) {
  Shape pages = rough_grid(8, .3, .4, 4);
  for (std::uint32_t y = 0; y < 8; ++y) {
    pages.points.push_back({4, y + .5, 3});
    pages.triangles.push_back(
        {9 * y + 4, 9 * y + 13, static_cast<std::uint32_t>(pages.points.size()) - 1});
  }
  const std::array inputs{
      IT::make_domain(rough_grid(9, .3, .6, 4).input(), IT::Domain_kind::closed).input,
      IT::make_domain(IT::triangle_soup(pages.points, pages.triangles)).input};
  for (const IT::Intrinsic_input& in : inputs) {
    const T fine = delaunay(in);
    const std::map<std::uint32_t, std::size_t> copies = copies_of_rows(fine);
    ASSERT_GT(num_vertices(fine.mesh()), copies.size());
    const auto expect_together = [&](const IT::Simplification& s) {
      std::map<std::uint32_t, std::size_t> kept;
      for (const std::uint32_t row : s.kept) ++kept[row];
      for (const auto& [row, number] : kept) EXPECT_EQ(number, copies.at(row));
    };
    for (const std::size_t wanted : {80, 40, 20}) {
      const IT::Simplification s = IT::simplify(fine, to(wanted));
      EXPECT_EQ(s.status, IT::Status::done);
      EXPECT_LE(s.kept.size(), wanted);
      expect_together(s);
      expect_together(IT::simplify(fine, to(wanted), IT::curvature_cost(fine)));
    }
  }
}

TEST(Simplify, keeps_a_vertex_that_no_triangles_make_flat) {
  const Shape shape{{{-5, 0, 0}, {5, 0, 0}, {0, 1, 0}, {0, -12, 30}},
                    {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  IT::Simplify_options options = to(1);
  options.kept_vertices = {0, 1, 2};
  IT::Simplification s = IT::simplify(delaunay(shape), options);
  EXPECT_EQ(s.status, IT::Status::stalled);
  EXPECT_EQ(s.kept.size(), 4U);
  EXPECT_EQ(s.blocked_by_border, 1U);
  EXPECT_EQ(s.not_flattened, 0U);
  // Without a vertex of the border, the others make room.
  s = IT::simplify(delaunay(shape), to(1));
  EXPECT_LT(s.kept.size(), 4U);
  EXPECT_EQ(s.not_flattened, 0U);
}

TEST(Simplify, keeps_vertices_and_edges_that_shall_stay) {
  const Shape shape = rough_torus(8, .3, 2);
  const T fine = delaunay(shape);
  IT::Simplify_options options = to(12);
  options.kept_vertices = {3, 17};
  const auto e = *std::next(edges(fine.mesh()).begin(), 40);
  options.kept_edges = {fine.index(e)};
  const std::uint32_t a = fine.input_vertex(source(e, fine.mesh())),
                      b = fine.input_vertex(target(e, fine.mesh()));
  const IT::Simplification s = IT::simplify(fine, options);
  EXPECT_EQ(s.kept.size(), 12U);
  for (const std::uint32_t v : {3U, 17U, a, b}) EXPECT_EQ(std::ranges::count(s.kept, v), 1);
  const T coarse(s.surface);
  double length = 0;
  for (const auto d : edges(coarse.mesh())) {
    const std::uint32_t x = s.kept[coarse.input_vertex(source(d, coarse.mesh()))],
                        y = s.kept[coarse.input_vertex(target(d, coarse.mesh()))];
    if (std::minmax(x, y) == std::minmax(a, b) &&
        std::abs(coarse.length(d) - fine.length(e)) < 1e-12)
      length = coarse.length(d);
  }
  EXPECT_NEAR(length, fine.length(e), 1e-12);
  expect_distances_within(fine, s);
  options.kept_vertices = {64};
  EXPECT_THROW(IT::simplify(fine, options), IT::Invalid_input);
  options.kept_vertices = {};
  options.kept_edges = {192};
  EXPECT_THROW(IT::simplify(fine, options), IT::Invalid_input);
  options.kept_edges = {};
  options.stretch = 0.5;
  EXPECT_THROW(IT::simplify(fine, options), IT::Invalid_input);
}

TEST(Simplify, keeps_distances_within_the_bounds_in_any_order) {
  const T fine = delaunay(rough_torus(8, .3, 2));
  for (const IT::Transported_mass& cost : {IT::curvature_cost(fine), IT::area_cost(fine)}) {
    IT::Simplify_options options = to(20);
    const IT::Simplification s = IT::simplify(fine, options, cost);
    EXPECT_EQ(s.kept.size(), 20U);
    expect_surface(fine, s);
    expect_distances_within(fine, s);
    options.cost = 0.05;
    options.vertices = 1;
    EXPECT_GT(IT::simplify(fine, options, cost).kept_by_bound, 0U);
  }
}

TEST(Simplify, takes_costs_of_the_user_and_stops_when_asked) {
  const T fine = delaunay(rough_torus(24, .3, 2));
  IT::Simplify_options options = to(100);
  // Vertices with high numbers go first; the first 50 stay.
  const auto cost = [](const IT::Removal_candidate& c) {
    return c.vertex < 50 ? std::numeric_limits<double>::infinity() : -static_cast<double>(c.vertex);
  };
  IT::Simplification s = IT::simplify(fine, options, cost);
  ASSERT_EQ(s.kept.size(), 100U);
  // but for those whose removal cannot be proven
  EXPECT_LE(std::ranges::count_if(s.kept, [](std::uint32_t v) { return v >= 110; }),
            static_cast<std::ptrdiff_t>(s.not_flattened));
  options.vertices = 1;
  s = IT::simplify(fine, options, cost); // in this order some removals cannot be proven
  EXPECT_EQ(s.kept.size(), 50U + s.not_flattened);
  std::size_t calls = 0;
  options.progress = [&](const IT::Simplify_progress& p) {
    ++calls;
    EXPECT_EQ(p.removed, 255U); // before the 256th
    EXPECT_EQ(p.left, 321U);
    return false;
  };
  s = IT::simplify(fine, options, cost);
  EXPECT_EQ(s.status, IT::Status::cancelled);
  EXPECT_EQ(s.kept.size(), 321U);
  EXPECT_EQ(calls, 1U);
  expect_surface(fine, s);
}

// Rounded lengths of a thin face may be those of no triangle.
TEST(Simplify, names_faces_that_are_too_thin_for_doubles) {
  std::size_t refused = 0;
  for (int k = 1; k <= 20; ++k) {
    const double offset = 1e-10, z = .1 + .01 * k;
    const Shape shape{{{0, 0, 0}, {1, .3, z}, {.4 + offset, .12 - offset, .4 * z}, {0, 1, 0}},
                      {{1, 0, 2}, {0, 1, 3}}};
    const IT::Corresponding_triangulation t(shape.input());
    IT::Simplify_options options = to(4);
    options.kept_edges = {0, 1, 2, 3, 4};
    try {
      IT::simplify(t, options);
    } catch (const IT::Invalid_input& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find("too thin for doubles"), std::string::npos) << message;
      EXPECT_NE(message.find("kept edges of it: "), std::string::npos) << message;
      ++refused;
    }
  }
  EXPECT_GT(refused, 0U);
}

} // namespace
