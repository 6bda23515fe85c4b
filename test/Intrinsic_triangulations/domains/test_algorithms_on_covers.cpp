// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "copies.h"
#include "meshes.h"
#include "refusals.h"
#include "soups.h"
#include "straight_segments.h"

#include <CGAL/Integer_only_triangulation.h>
#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/queries/Geodesic_finder.h>
#include <CGAL/Intrinsic_geodesics/queries/add_geodesics.h>
#include <CGAL/Intrinsic_geodesics/shortening/certify_geodesic.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/subdivision_matrices.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/read_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/write_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent_field.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/delaunay_tessellation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// A cover is a surface like any other: only the rows of matrices depend on covers here.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Domain_kind;
using meshes::Mesh;
template <class Correspondence>
using Exact =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Correspondence>;
using Integer = Exact<IT::Integer_coordinates>;

std::vector<std::pair<std::string, Mesh>> soups_of_all_kinds() {
  return {{"fins", soups::three_fins()},
          {"Moebius strip", soups::moebius_strip()},
          {"Klein bottle", soups::klein_bottle()},
          {"projective plane", soups::projective_plane()},
          {"random soup", soups::random(9, 30, 5)},
          {"grid", meshes::grid(4, 3)}};
}

template <class Triangulation>
Triangulation delaunay(const Mesh& m, Domain_kind kind = Domain_kind::tufted_cover) {
  Triangulation t(IT::make_domain(soups::soup(m), kind).input);
  IT::flip_to_delaunay(t);
  return t;
}

template <class Triangulation>
bool is_isolated(const Triangulation& t, typename Triangulation::vertex_descriptor v) {
  return halfedge(v, t.mesh()).index == IT::Gluing::none;
}

using meshes::area;

template <class Triangulation>
void expect_subdivision(const Mesh& m, const std::string& name) {
  const auto t = delaunay<Triangulation>(m);
  const IT::Common_subdivision s = IT::common_subdivision(t);
  const std::vector<meshes::Point> points = IT::positions(s, std::span(m.points));
  double sum = 0;
  for (const double a : IT::subdivision_areas(t, s)) sum += a;
  EXPECT_NEAR(sum, 2 * area(m), 1e-9 * area(m)) << name;
  // each face lies in the face of the soup that it is said to lie in, on one side of it
  double in_space = 0;
  for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
    const auto& corners = m.triangles[t.input().names().polygon_of_triangle[s.input_face[f]]];
    Mesh cell{points, {}};
    const auto face = s.face(f);
    for (std::size_t k = 2; k < face.size(); ++k)
      cell.triangles.push_back({face[0], face[k - 1], face[k]});
    in_space += area(cell);
    for (const std::uint32_t v : face) {
      double parts = 0;
      for (unsigned k = 0; k < 3; ++k) {
        Mesh part{m.points, {{corners[k], corners[(k + 1) % 3], 0}}};
        part.points.push_back(points[v]);
        part.triangles[0][2] = static_cast<std::uint32_t>(m.points.size());
        parts += area(part);
      }
      const double whole = area({m.points, {corners}});
      EXPECT_NEAR(parts, whole, 1e-9 * area(m)) << name;
    }
  }
  EXPECT_NEAR(in_space, 2 * area(m), 1e-9 * area(m)) << name;
}

TEST(Cover, has_a_common_subdivision_over_both_sides_of_every_face) {
  for (const auto& [name, m] : soups_of_all_kinds()) {
    expect_subdivision<Integer>(m, name);
    expect_subdivision<Exact<IT::Explicit_crossings>>(m, name);
    expect_subdivision<Exact<IT::Signposts>>(m, name);
  }
}

using meshes::area_vector, meshes::dot;

// On its front a piece goes around as the user's face does, on its back the other way.
template <class Triangulation>
void expect_sheets(const Triangulation& t, const Mesh& m, const std::string& name) {
  const IT::Common_subdivision s = IT::common_subdivision(t);
  ASSERT_EQ(s.sheet.size(), s.number_of_faces()) << name;
  const std::vector<meshes::Point> points = IT::positions(s, std::span(m.points));
  for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
    const auto& corners = m.triangles[t.input().names().polygon_of_triangle[s.input_face[f]]];
    const meshes::Point whole = area_vector(m.points, corners),
                        piece = area_vector(points, s.face(f));
    if (std::sqrt(dot(piece, piece)) < 1e-9 * std::sqrt(dot(whole, whole))) continue;
    EXPECT_EQ(s.sheet[f], dot(piece, whole) > 0 ? 0 : 1) << name << " face " << f;
  }
}

TEST(Cover, tells_which_sheet_a_piece_of_the_subdivision_lies_on) {
  for (const auto& [name, m] : soups_of_all_kinds()) {
    expect_sheets(delaunay<Integer>(m), m, name);
    expect_sheets(delaunay<Exact<IT::Explicit_crossings>>(m), m, name);
    auto t = delaunay<Integer>(m);
    IT::delaunay_refine(t, IT::parameters::minimum_angle(25));
    expect_sheets(t, m, name);
  }
  const Mesh strip = soups::moebius_strip();
  expect_sheets(delaunay<Integer>(strip, Domain_kind::orientation_cover), strip, "one side");
  const auto one = delaunay<Integer>(meshes::grid(4, 3), Domain_kind::manifold);
  EXPECT_TRUE(IT::common_subdivision(one).sheet.empty());
}

TEST(Cover, has_its_sheets_in_files) {
  const Mesh m = soups::three_fins();
  const auto t = delaunay<Integer>(m);
  const IT::Common_subdivision s = IT::common_subdivision(t);
  const std::vector<meshes::Point> points = IT::positions(s, std::span(m.points));
  std::stringstream ply, vtp, one;
  IT::write_common_subdivision(ply, "ply", s, points, {}, IT::parameters::use_binary_mode(false));
  IT::write_common_subdivision(vtp, "vtp", s, points);
  EXPECT_NE(vtp.str().find("Name=\"sheet\""), std::string::npos);
  std::string line;
  std::size_t vertex = 0, face = 0;
  std::vector<std::string> properties;
  while (std::getline(ply, line) && line != "end_header")
    if (line.starts_with("property")) properties.push_back(line);
  EXPECT_EQ(std::ranges::count(properties, "property uchar sheet"), 1);
  while (vertex++ < s.number_of_vertices()) std::getline(ply, line);
  for (; face < s.number_of_faces(); ++face) {
    std::getline(ply, line);
    EXPECT_EQ(line.substr(line.rfind(' ') + 1), std::to_string(int{s.sheet[face]})) << line;
  }
  const Mesh grid = meshes::grid(2, 2);
  const IT::Common_subdivision plain =
      IT::common_subdivision(delaunay<Integer>(grid, Domain_kind::manifold));
  IT::write_common_subdivision(one, "ply", plain, IT::positions(plain, std::span(grid.points)));
  EXPECT_EQ(one.str().find("property uchar sheet"), std::string::npos);
}

TEST(Cover, has_mass_matrices_of_rows_by_way_of_its_subdivision) {
  for (const auto& [name, m] : soups_of_all_kinds()) {
    const auto t = delaunay<Integer>(m);
    const IT::Common_subdivision s = IT::common_subdivision(t);
    const Eigen::SparseMatrix<double> p = IT::interpolation_from_intrinsic(s);
    const Eigen::SparseMatrix<double> mass = IT::subdivision_mass_matrix(t, s),
                                      product = p.transpose() * mass * p;
    const Eigen::SparseMatrix<double> direct = IT::galerkin_mass_matrix(t);
    ASSERT_EQ(product.rows(), direct.rows()) << name;
    EXPECT_LE((product - direct).norm(), 1e-10 * direct.norm()) << name;
  }
}

// Those of all kinds, the triangles through the origin and two of the axes, and random ones.
std::vector<std::pair<std::string, Mesh>> soups_of_short_cuts() {
  Mesh axes{{{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, {}};
  for (std::uint32_t i = 1; i < 7; i += 2)
    for (std::uint32_t j = i + 2; j < 7; j += 2)
      for (std::uint32_t k = 0; k < 4; ++k) axes.triangles.push_back({0, i + k % 2, j + k / 2});
  auto soups = soups_of_all_kinds();
  soups.emplace_back("axes", axes);
  for (unsigned seed = 0; seed < 4; ++seed)
    soups.emplace_back("random " + std::to_string(seed),
                       soups::random_without_repetition(7, 12, seed));
  return soups;
}

// Between any copies of two vertices, and from one copy of a vertex to another on the way. Errors
// of sums of fewer than 100 lengths of doubles stay below 1e-12 of the sum; paths that pass from
// one copy to another gain 1e-12 at least.
TEST(Cover, has_shortest_paths_as_brute_force_tells) {
  const auto soups = soups_of_short_cuts();
  for (const auto& [name, m] : soups) {
    SCOPED_TRACE(name);
    for (const Domain_kind kind : {Domain_kind::automatic, Domain_kind::tufted_cover}) {
      auto t = delaunay<Integer>(m, kind);
      const straight_segments::Distances distance(t.input());
      const double unit = std::ldexp(1.0, -t.metric().scale_exponent());
      IT::Geodesic_finder<Integer> find(t);
      for (const auto v : vertices(t.mesh()))
        for (const auto w : vertices(t.mesh())) {
          if (t.input_vertex(v) >= t.input_vertex(w) || is_isolated(t, v) || is_isolated(t, w))
            continue;
          const auto path = find(v, w);
          const double d = unit * distance(t.input_vertex(v), t.input_vertex(w));
          ASSERT_EQ(path.status, d < 1e300 ? IT::Status::done : IT::Status::stalled);
          if (path.status == IT::Status::stalled) continue;
          EXPECT_NEAR(path.length, d, 1e-11 * d);
          const auto near = find(v, w, IT::parameters::shortest(false));
          EXPECT_TRUE(near.status == IT::Status::stalled || near.length > d * (1 - 1e-11));
        }
    }
    if (name != "axes") continue;
    auto t = delaunay<Integer>(m);
    for (std::uint32_t v = 1; v < 7; ++v) {
      const auto from = t.numbers().vertex_at(t.input().names().vertex(0)),
                 to = t.numbers().vertex_at(t.input().names().vertex(v));
      IT::Geodesic_finder<Integer> find(t);
      EXPECT_NEAR(find(from, to).length, 1, 1e-12);
      EXPECT_NEAR(find(from, to, IT::parameters::shortest(false)).length, 1, 1e-12);
    }
  }
}

// Curves that stay at their vertices are as long as the shortest paths between these, wherever they
// pass from one copy of a vertex to another; others are not longer.
TEST(Cover, has_curves_through_any_copies_of_vertices) {
  using Curve = IT::Curve_through_vertices<Integer>;
  std::mt19937 random(7);
  for (const auto& [name, m] : soups_of_short_cuts())
    for (const Domain_kind kind : {Domain_kind::automatic, Domain_kind::tufted_cover})
      for (int k = 0; k < 8; ++k) {
        auto t = delaunay<Integer>(m, kind);
        const straight_segments::Distances distance(t.input());
        Curve curve{{}, k % 4 == 3, k % 2 == 1};
        std::vector<std::uint32_t> rows;
        for (const auto v : vertices(t.mesh()))
          if (!is_isolated(t, v) && !std::count(rows.begin(), rows.end(), t.input_vertex(v)) &&
              distance(rows.empty() ? t.input_vertex(v) : rows[0], t.input_vertex(v)) < 1e300)
            rows.push_back(t.input_vertex(v));
        std::shuffle(rows.begin(), rows.end(), random);
        rows.resize(curve.is_loop ? 3 : 2 + random() % 3);
        for (const std::uint32_t r : rows) {
          const auto copies = copies_test::of_row(t, r);
          curve.vertices.push_back(copies[random() % copies.size()]);
        }
        SCOPED_TRACE(name + " " + ::testing::PrintToString(rows));
        double expected = 0;
        for (std::size_t i = 0; i + (curve.is_loop ? 0 : 1) < rows.size(); ++i)
          expected += std::ldexp(distance(rows[i], rows[(i + 1) % rows.size()]),
                                 -t.metric().scale_exponent());
        IT::Curve_network<Integer> network(t);
        const auto added = IT::add_geodesics(network, std::vector{curve});
        ASSERT_EQ(added.status, IT::Status::done);
        ASSERT_EQ(network.number_of_curves(), 1U);
        EXPECT_NEAR(added.initial[0].length, expected, 1e-11 * expected);
        if (curve.stays_at_vertices || rows.size() == 2)
          EXPECT_NEAR(network.length(), expected, 1e-11 * expected);
        else
          EXPECT_LE(network.length(), expected * (1 + 1e-11));
        EXPECT_TRUE(IT::certify_geodesic(network).is_geodesic());
      }
}

// A point inside of a face is on both sides of it: as if the face had a vertex there.
TEST(Cover, has_shortest_paths_between_points_of_faces_on_any_side) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0.1, 1);
  for (const auto& [name, m] : soups_of_short_cuts()) {
    if (name == "random soup")
      continue; // where faces coincide, the order around edges would change
    for (int k = 0; k < 4; ++k) {
      SCOPED_TRACE(name + " " + std::to_string(k));
      auto t = delaunay<Integer>(m);
      Mesh split = m; // with the points as vertices
      std::vector<IT::Surface_point> points;
      std::vector<std::uint32_t> f(m.triangles.size());
      std::iota(f.begin(), f.end(), 0U);
      std::shuffle(f.begin(), f.end(), random);
      f.resize(2);
      for (const std::uint32_t triangle : f) {
        std::array<double, 3> w{uniform(random), uniform(random), uniform(random)};
        const double sum = w[0] + w[1] + w[2];
        for (double& x : w) x /= sum;
        const IT::Surface_point p =
            IT::Place_finder(t).on_input(IT::Place::in_face(triangle, w))[random() % 2];
        points.push_back(p);
        const auto v = static_cast<std::uint32_t>(split.points.size());
        split.points.push_back(IT::point_in_space(t, p, m.points));
        const auto corners = m.triangles[triangle];
        split.triangles[triangle][2] = v;
        split.triangles.push_back({corners[1], corners[2], v});
        split.triangles.push_back({corners[2], corners[0], v});
      }
      const auto u = delaunay<Integer>(split);
      const straight_segments::Distances distance(u.input());
      const auto n = static_cast<std::uint32_t>(m.points.size());
      const double d = std::ldexp(distance(n, n + 1), -u.metric().scale_exponent());
      IT::Geodesic_finder<Integer> find(t);
      const auto path = find(points);
      ASSERT_EQ(path.status, d < 1e300 ? IT::Status::done : IT::Status::stalled);
      // exact traits round a point by 2^-45 or so of its face
      if (path.status == IT::Status::done) {
        EXPECT_NEAR(path.length, d, 1e-11 * (1 + d));
      }
      EXPECT_EQ(t.number_of_vertices(), m.points.size()); // they are removed again
    }
  }
}

// A vertex that no face has is named; with it, and without.
TEST(Cover, names_isolated_vertices_that_no_path_can_lead_to) {
  for (auto [name, m] : soups_of_all_kinds()) {
    SCOPED_TRACE(name);
    const auto isolated = static_cast<std::uint32_t>(m.points.size());
    m.points.push_back({9, 9, 9});
    auto t = delaunay<Integer>(m);
    const auto v = t.numbers().vertex_at(t.input().names().vertex(isolated)),
               w = t.numbers().vertex_at(t.input().names().vertex(0));
    const auto expect_named = [&](const auto& function) {
      refusals::expect_invalid(function, IT::Element_kind::vertex, isolated);
    };
    IT::Geodesic_finder<Integer> find(t);
    for (const bool is_shortest : {false, true})
      for (const auto& [from, to] : {std::pair(v, w), std::pair(w, v)}) {
        expect_named([&] { find(from, to, IT::parameters::shortest(is_shortest)); });
        expect_named([&] { insert_geodesic(t, from, to, IT::parameters::shortest(is_shortest)); });
        expect_named([&] {
          IT::Edge_path_finder<Integer> edges(t);
          edges(from, to);
        });
      }
  }
}

TEST(Cover, has_the_least_distance_of_all_copies_at_a_row) {
  // a square, tufted: from a point of both sides straight to its copies on either
  const Mesh m = meshes::grid(5, 4);
  const auto t = delaunay<Integer>(m);
  const IT::Input_names& names = t.input().names();
  const std::uint32_t from = 7;
  const IT::Polyhedral_distance d(t, t.numbers().vertex_at(names.vertex(from)));
  const std::vector<double> distances = d.distances();
  ASSERT_EQ(distances.size(), m.points.size());
  for (std::size_t v = 0; v < m.points.size(); ++v)
    EXPECT_NEAR(distances[v],
                std::hypot(m.points[v][0] - m.points[from][0], m.points[v][1] - m.points[from][1]),
                1e-12)
        << v;
  // rows without faces are not reached
  Mesh isolated = m;
  isolated.points.push_back({9, 9, 9});
  const auto u = delaunay<Integer>(isolated);
  const IT::Polyhedral_distance e(u, u.numbers().vertex_at(u.input().names().vertex(from)));
  EXPECT_EQ(e.distances().back(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(e.distances()[0], distances[0]);
}

TEST(Cover, of_every_soup_has_distances_by_rows_that_are_those_of_some_copy) {
  for (const auto& [name, m] : soups_of_all_kinds()) {
    const auto t = delaunay<Integer>(m);
    const IT::Polyhedral_distance d(t, t.numbers().vertex_at(t.input().names().vertex(0)));
    std::vector<double> least(m.points.size(), std::numeric_limits<double>::infinity());
    for (std::uint32_t v = 0; v < t.input().number_of_vertices(); ++v) {
      double& x = least[t.input().names().row(v)];
      x = std::min(x, d.distance(t.numbers().vertex_at(v)));
    }
    EXPECT_EQ(d.distances(), least) << name;
    EXPECT_EQ(least[0], 0) << name;
  }
}

TEST(Cover, has_a_delaunay_tessellation_with_a_vertex_per_copy) {
  // both sides of a grid of squares: a closed surface of twice as many squares
  const Mesh grid = meshes::grid(4, 3);
  const auto flat = delaunay<Integer>(grid);
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  const IT::Delaunay_tessellation d = IT::delaunay_tessellation(flat, mesh);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_TRUE(CGAL::is_quad_mesh(mesh));
  EXPECT_EQ(num_faces(mesh), 24U);
  EXPECT_EQ(num_vertices(mesh), 2 * 20U - 14U); // those on the border are on both sides
  ASSERT_EQ(d.row.size(), num_vertices(mesh));
  for (const auto f : faces(mesh)) { // a cell of the grid
    std::set<double> x, y;
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh)) {
      x.insert(grid.points[d.row[v]][0]);
      y.insert(grid.points[d.row[v]][1]);
    }
    EXPECT_TRUE(x.size() == 2 && y.size() == 2);
  }
  for (const auto& [name, m] : soups_of_all_kinds()) {
    auto t = delaunay<Integer>(m);
    IT::delaunay_refine(t, IT::parameters::minimum_angle(20));
    mesh.clear();
    const IT::Delaunay_tessellation c = IT::delaunay_tessellation(t, mesh);
    EXPECT_TRUE(CGAL::is_closed(mesh)) << name;
    std::vector<std::size_t> sides(num_vertices(mesh), 0); // all of a vertex are in one circle
    for (const auto h : halfedges(mesh)) ++sides[target(h, mesh)];
    for (const auto v : vertices(mesh))
      if (sides[v] > 0) {
        std::size_t around = 0;
        for (auto h = halfedge(v, mesh); around == 0 || h != halfedge(v, mesh);
             h = opposite(next(h, mesh), mesh)) {
          EXPECT_EQ(target(h, mesh), v) << name;
          ++around;
        }
        EXPECT_EQ(around, sides[v]) << name;
      }
    EXPECT_EQ(num_vertices(mesh), num_vertices(t.mesh())) << name;
    EXPECT_EQ(std::set<std::uint32_t>(c.row.begin(), c.row.end()).size(), t.number_of_vertices())
        << name;
    for (const auto e :
         edges(mesh)) { // ends of an intrinsic edge are those of the edge of the mesh
      const auto h = t.numbers().halfedge_at(2 * c.intrinsic_edge[e.idx()]);
      EXPECT_EQ(c.row[source(halfedge(e, mesh), mesh)], t.input_vertex(source(h, t.mesh())));
      EXPECT_EQ(c.row[target(halfedge(e, mesh), mesh)], t.input_vertex(target(h, t.mesh())));
    }
  }
}

TEST(Cover, has_tangent_fields_with_a_vector_per_copy_that_come_back) {
  for (const auto& [name, m] : soups_of_all_kinds()) {
    auto t = delaunay<Integer>(m);
    IT::delaunay_refine(t, IT::parameters::minimum_angle(20));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1, 1);
    IT::Tangent_field field(t.input().number_of_vertices());
    for (std::complex<double>& z : field) z = {number(random), number(random)};
    const IT::Tangent_field there = IT::tangent_field_to_intrinsic(t, field);
    EXPECT_EQ(there.size(), num_vertices(t.mesh())) << name;
    const IT::Tangent_field back = IT::tangent_field_to_input(t, there);
    ASSERT_EQ(back.size(), field.size()) << name;
    for (std::uint32_t v = 0; v < t.input().number_of_vertices(); ++v) {
      const std::uint32_t copy = t.input().names().vertices.user(v);
      const auto h = halfedge(t.numbers().vertex_at(v), t.mesh());
      if (h == boost::graph_traits<IT::Gluing_map>::null_halfedge()) continue;
      EXPECT_LE(std::abs(back[copy] - field[copy]), 1e-9) << name;
      EXPECT_NEAR(std::abs(there[copy]), std::abs(field[copy]), 1e-12) << name;
    }
  }
}

TEST(Cover, keeps_a_constant_field_of_a_flat_soup_on_both_sheets) {
  // the same direction in space everywhere, which the back sees mirrored
  const Mesh m = meshes::grid(5, 4);
  auto t = delaunay<Integer>(m);
  const IT::Input& input = t.input();
  const double direction = 0.7;
  const auto at = [&](std::uint32_t v) { return m.points[input.names().row(v)]; };
  const auto polar = [&](std::uint32_t v, const meshes::Point& end, double sign) {
    const double axis = std::atan2(end[1] - at(v)[1], end[0] - at(v)[0]);
    return std::polar(1., sign * (direction - axis));
  };
  // inner vertices of the grid have flat stars on their sheet: polar angles are angles
  IT::Tangent_field field(input.number_of_vertices(), 0);
  std::vector<char> is_inner(input.number_of_vertices(), 1);
  std::vector<double> sign(input.number_of_vertices(), 1);
  const auto is_on_border = [&](const meshes::Point& p) {
    return p[0] == 0 || p[1] == 0 || p[0] == m.points.back()[0] || p[1] == m.points.back()[1];
  };
  for (std::uint32_t v = 0; v < input.number_of_vertices(); ++v) {
    if (is_on_border(at(v))) {
      is_inner[v] = 0;
      continue;
    }
    const std::uint32_t h = input.outgoing_halfedge(v);
    const std::uint32_t face = input.face(h);
    sign[v] = input.names().faces.user(face) % 2 == 0 ? 1 : -1;
    field[input.names().vertices.user(v)] = polar(v, at(input.target(h)), sign[v]);
  }
  const IT::Tangent_field there = IT::tangent_field_to_intrinsic(t, field);
  std::size_t fronts = 0, backs = 0;
  for (std::uint32_t v = 0; v < input.number_of_vertices(); ++v) {
    if (!is_inner[v]) continue;
    (sign[v] > 0 ? fronts : backs) += 1;
    const auto h = opposite(halfedge(t.numbers().vertex_at(v), t.mesh()), t.mesh());
    const meshes::Point end = m.points[t.input_vertex(target(h, t.mesh()))];
    EXPECT_LE(std::abs(there[input.names().vertices.user(v)] - polar(v, end, sign[v])), 1e-9);
  }
  EXPECT_EQ(fronts, 4U * 3U);
  EXPECT_EQ(backs, 4U * 3U);
}

TEST(Cover, is_stored_with_its_rows) {
  for (const auto& [name, m] : soups_of_all_kinds()) {
    auto t = delaunay<IT::Intrinsic_triangulation<>>(m);
    std::ostringstream out;
    IT::write_intrinsic_triangulation(out, t);
    std::istringstream in(out.str());
    const auto back = IT::read_intrinsic_triangulation<IT::Intrinsic_triangulation<>>(in, "file");
    EXPECT_EQ(back.input().names().sheets, 2U) << name;
    EXPECT_EQ(back.number_of_vertices(), m.points.size()) << name;
    std::ostringstream again; // before anything is asked that makes intervals narrower
    IT::write_intrinsic_triangulation(again, back);
    EXPECT_EQ(again.str(), out.str()) << name;
    const Eigen::SparseMatrix<double> difference =
        IT::cotangent_laplacian(t) - IT::cotangent_laplacian(back);
    EXPECT_EQ(difference.norm(), 0) << name;
  }
}

TEST(Cover, is_renumbered_and_keeps_its_rows) {
  const Mesh tidy = meshes::rough_grid(200, 5);
  const Mesh m = meshes::permuted(tidy, meshes::permutation(tidy.points.size(), 11), 12);
  const auto t = delaunay<IT::Intrinsic_triangulation<>>(m);
  ASSERT_TRUE(t.report().renumbered);
  IT::Domain d = IT::make_domain(soups::soup(m), Domain_kind::tufted_cover);
  d.input.may_renumber = false;
  IT::Intrinsic_triangulation<> u(std::move(d.input));
  IT::flip_to_delaunay(u);
  const Eigen::SparseMatrix<double> l = IT::cotangent_laplacian(t);
  const Eigen::SparseMatrix<double> difference = l - IT::cotangent_laplacian(u);
  EXPECT_LE(difference.norm(), 1e-11 * l.norm());
}

} // namespace
