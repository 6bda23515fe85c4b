// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Integer_only_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/read_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/write_intrinsic_triangulation.h>

#include "gallery.h"
#include "mesh_types.h"
#include "meshes.h"
#include "properties.h"
#include "refusals.h"
#include "subdivision_oracle.h"

#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

// Geometry that is rebuilt from integers and the input must be that which exact moves have made: the two share
// no value that a move makes.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Move_status;
using subdivision_oracle::Exact;
using Map = IT::Gluing_map;

static_assert(IT::IntrinsicTriangulation<IT::Integer_only_triangulation<>>);

template <class T>
std::vector<std::array<std::uint32_t, 4>> state(const T& t) {
  const IT::Intrinsic_view<T> view(t);
  std::vector<std::array<std::uint32_t, 4>> s;
  for (const auto h : halfedges(t.mesh())) {
    const std::uint32_t n = t.numbers().halfedge(h);
    s.push_back({n, view.next(n), t.correspondence().roundabout(n),
                 static_cast<std::uint32_t>(t.correspondence().normal_coordinate(n / 2))});
  }
  return s;
}

template <class T>
std::vector<typename T::halfedge_descriptor> inner_halfedges(const T& t) {
  std::vector<typename T::halfedge_descriptor> result;
  const auto null = boost::graph_traits<typename T::Mesh>::null_face();
  for (const auto h : halfedges(t.mesh())) {
    const auto f = face(h, t.mesh()), g = face(opposite(h, t.mesh()), t.mesh());
    if (f != null && g != null && f != g) result.push_back(h);
  }
  return result;
}

bool overlap(const CGAL::Interval_nt<false>& a, const CGAL::Interval_nt<false>& b) {
  return a.inf() <= b.sup() && b.inf() <= a.sup();
}

bool overlap(const IT::Diamond_values<CGAL::Interval_nt<false>>& a, const Exact& t,
             Map::Halfedge h) {
  const IT::Diamond d = t.diamond(h);
  const auto& m = t.metric();
  return overlap(a.ij, m.squared_length(d.ij)) && overlap(a.jk, m.squared_length(d.jk)) &&
         overlap(a.ki, m.squared_length(d.ki)) && overlap(a.im, m.squared_length(d.im)) &&
         overlap(a.mj, m.squared_length(d.mj)) && overlap(a.area_f, m.quadruple_area(d.f)) &&
         overlap(a.area_g, m.quadruple_area(d.g));
}

// For every edge: intervals that meet, narrow ones, the same signs and the same answer to a flip.
void expect_same_geometry(Exact& t) {
  IT::Integer_only_triangulation<> integers(t);
  Exact::Session exact(t);
  IT::Integer_only_triangulation<>::Session rebuilt(integers);
  for (const Map::Halfedge h : inner_halfedges(t)) {
    const auto values = integers.decider().values(integers.diamond(h));
    ASSERT_TRUE(overlap(values, t, h)) << h.index;
    // some dozen operations in triangles that are not thin
    ASSERT_LT(values.ij.sup() - values.ij.inf(), 1e-10 * values.ij.sup()) << h.index;
    ASSERT_EQ(rebuilt.delaunay_sign(h), exact.delaunay_sign(h)) << h.index;
    ASSERT_EQ(rebuilt.is_locally_delaunay(h), exact.is_locally_delaunay(h)) << h.index;
    ASSERT_EQ(rebuilt.flip_status(h), exact.flip_status(h)) << h.index;
    ASSERT_EQ(rebuilt.orientation(h), CGAL::POSITIVE) << h.index;
  }
}

void flip_at_random(Exact& t, unsigned flips, unsigned seed) {
  std::mt19937 random(seed);
  const std::vector<Map::Halfedge> inner = inner_halfedges(t);
  if (inner.empty()) return;
  Exact::Session session(t);
  for (unsigned i = 0; i < flips; ++i) session.flip_edge(inner[random() % inner.size()]);
}

std::vector<meshes::Mesh> shapes() {
  return {
      meshes::box(3, 2, 2), meshes::sheared_grid(5, 6, 3),   meshes::rough_grid(6, 1),
      meshes::potato(2, 2), meshes::folded_lattice(4, 4, 1), meshes::integer_terrain(60, 20, 3)};
}

TEST(Integer_only_triangulation, has_the_geometry_that_random_flips_have_made) {
  for (const meshes::Mesh& m : shapes())
    for (const unsigned flips : {0U, 1U, 30U, 300U}) {
      Exact t(m.input());
      flip_at_random(t, flips, flips);
      expect_same_geometry(t);
    }
}

TEST(Integer_only_triangulation, has_the_geometry_of_Delta_complexes) {
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name);
    for (const unsigned flips : {0U, 5U, 25U}) {
      Exact t(gallery::input(s));
      flip_at_random(t, flips, flips + 1);
      expect_same_geometry(t);
    }
  }
}

// Points in input faces and on input edges are the same points in both: weights are multiples of 2^-52 there.
TEST(Integer_only_triangulation,
     has_the_geometry_around_vertices_that_were_inserted_into_the_input) {
  for (const meshes::Mesh& m : shapes()) {
    Exact t(m.input());
    const std::vector<Exact::face_descriptor> input_faces(faces(t.mesh()).begin(),
                                                          faces(t.mesh()).end());
    for (std::size_t f = 0; f < input_faces.size(); f += 3)
      ASSERT_EQ(t.insert_vertex(halfedge(input_faces[f], t.mesh()), {0.25, 0.5, 0.25}).status,
                Move_status::done);
    expect_same_geometry(t);
    flip_at_random(t, 200, 7);
    expect_same_geometry(t);
  }
}

TEST(Integer_only_triangulation, has_the_geometry_around_vertices_on_input_edges) {
  for (const meshes::Mesh& m : shapes()) {
    Exact t(m.input());
    for (std::uint32_t e = 0, n = t.mesh().number_of_edges(); e < n; e += 4)
      ASSERT_EQ(t.split_edge({2 * e}, 0.375).status, Move_status::done);
    expect_same_geometry(t);
    flip_at_random(t, 200, 8);
    expect_same_geometry(t);
  }
}

// Lengths tell exact traits the order of flips.
TEST(Integer_only_triangulation, flips_to_the_same_tessellation_as_exact_traits) {
  for (const meshes::Mesh& m : shapes()) {
    Exact expected(m.input());
    IT::Integer_only_triangulation<> t(m.input());
    const auto r = IT::flip_to_delaunay(expected);
    const auto s = IT::flip_to_delaunay(t);
    EXPECT_EQ(s.status, r.status);
    EXPECT_TRUE(IT::is_delaunay(t));
    EXPECT_EQ(properties::edges_without_ties(t), properties::edges_without_ties(expected));
    EXPECT_EQ(t.metric().statistics().probable_zero, 0U);
    EXPECT_EQ(IT::check_delaunay(t).cocircular_edges.size(),
              IT::check_delaunay(expected).cocircular_edges.size());
  }
}

TEST(Integer_only_triangulation, takes_over_where_another_arithmetic_stopped) {
  for (const meshes::Mesh& m : shapes()) {
    subdivision_oracle::Rounded rounded(m.input());
    IT::flip_to_delaunay(rounded, CGAL::parameters::maximum_number(10U));
    IT::Integer_only_triangulation<> t(rounded);
    EXPECT_EQ(state(t), state(rounded));
    EXPECT_EQ(IT::flip_to_delaunay(t).status, IT::Status::done);
    EXPECT_TRUE(IT::is_delaunay(t));
  }
}

// Flips on all mesh types are the same with exact traits: one type, which does not number its
// elements, is enough here.
TEST(Integer_only_triangulation, is_the_same_on_another_type_of_mesh_as_on_a_gluing_map) {
  for (const meshes::Mesh& m : shapes()) {
    IT::Integer_only_triangulation<> expected(m.input());
    IT::Integer_only_triangulation<Polyhedron> t(m.input());
    EXPECT_EQ(IT::flip_to_delaunay(t).flips, IT::flip_to_delaunay(expected).flips);
    EXPECT_EQ(state(t), state(expected));
    const IT::Integer_only_triangulation<Polyhedron> copy(t);
    EXPECT_EQ(state(copy), state(t));
  }
}

TEST(Integer_only_triangulation, refuses_flips_of_other_edges_as_exact_traits_do) {
  IT::Integer_only_triangulation<> t(meshes::rough_grid(2, 1).input());
  IT::Integer_only_triangulation<>::Session session(t);
  const auto before = state(t);
  int refused = 0;
  for (const Map::Halfedge h : halfedges(t.mesh()))
    if (t.mesh().face(h).index == IT::Gluing::none) {
      EXPECT_EQ(session.flip_edge(h), Move_status::border);
      ++refused;
    }
  EXPECT_EQ(refused, 8);
  EXPECT_EQ(state(t), before);
}

TEST(Integer_only_triangulation, names_a_face_with_a_side_without_length) {
  meshes::Mesh m = meshes::grid(2, 2);
  m.points[4] = m.points[5];
  IT::Intrinsic_input input = m.input();
  input.mollification = IT::Mollification::none;
  refusals::expect_invalid([&] { IT::Integer_only_triangulation<>{input}; }, IT::Element_kind::face,
                           {}, {"mollification"});
  input.mollification = IT::Mollification::automatic;
  IT::Integer_only_triangulation<> t(input);
  EXPECT_EQ(IT::flip_to_delaunay(t).status, IT::Status::done);
}

TEST(Integer_only_triangulation, takes_what_was_read_from_a_file_after_flips) {
  Exact t(meshes::rough_grid(2, 1).input());
  const auto copy = [&t] {
    std::stringstream file;
    IT::write_intrinsic_triangulation(file, t);
    return IT::read_intrinsic_triangulation<Exact>(file, "file");
  };
  EXPECT_EQ(state(IT::Integer_only_triangulation<>{copy()}), state(t));
  ASSERT_GT(IT::flip_to_delaunay(t).flips, 0U);
  EXPECT_EQ(state(IT::Integer_only_triangulation<>{copy()}), state(t));
}

} // namespace
