// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A user's correspondence: the results of all queries come from its own functions.

#include <CGAL/Intrinsic_triangulations/IO/idt/read_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/write_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/constrained_input_edges.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_edge.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/certify_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <CGAL/Intrinsic_triangulation.h>

#include "meshes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace own {

namespace IT = CGAL::Intrinsic_triangulations;

/// Counts the reported moves. All other data come from its coordinates.
class Counted {
public:
  static constexpr const char* name = "counted";

  template <class Triangulation>
  void start(const Triangulation& t) {
    coordinates_.start(t);
  }
  template <class Triangulation>
  void restore(const Triangulation& t, const IT::Integer_coordinates& coordinates) {
    coordinates_.restore(t, coordinates);
  }
  template <class Triangulation, class Move>
  bool before(const Triangulation& t, const Move& move) const {
    return coordinates_.before(t, move);
  }
  template <class Triangulation, class Move>
  void make_room(const Triangulation& t, const Move& move) {
    coordinates_.make_room(t, move);
  }
  template <class Triangulation, class Move>
  void after(const Triangulation& t, const Move& move) noexcept {
    ++moves_;
    coordinates_.after(t, move);
  }

  const IT::Input& input() const { return coordinates_.input(); }
  template <class Triangulation>
  auto queries(const Triangulation& t) const {
    return IT::Curve_queries(t, coordinates_);
  }

  std::size_t moves() const { return moves_; }

protected:
  IT::Integer_coordinates coordinates_;

private:
  std::size_t moves_ = 0;
};

/// Lets an exact metric use its coordinates.
class Shared : public Counted {
public:
  const IT::Integer_coordinates& integer_coordinates() const { return coordinates_; }
};

} // namespace own

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

template <class Correspondence>
using With =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Correspondence>;

template <class T>
T refined() {
  T t(meshes::rough_grid(8, 3).input());
  IT::delaunay_refine(t);
  return t;
}

bool are_equal(const IT::Surface_point& p, const IT::Surface_point& q) {
  return p.halfedge == q.halfedge && p.weights == q.weights;
}

template <class T>
std::string text(const T& t) {
  std::ostringstream out;
  IT::write_intrinsic_triangulation(out, t);
  return out.str();
}

template <class T>
class Own_correspondence : public testing::Test {};

using Types = testing::Types<With<own::Counted>, With<own::Shared>>;
TYPED_TEST_SUITE(Own_correspondence, Types);

TYPED_TEST(Own_correspondence, Opens_all_queries) {
  const TypeParam t = refined<TypeParam>();
  const auto known = refined<With<IT::Integer_coordinates>>();
  ASSERT_GT(t.correspondence().moves(), 0U);
  ASSERT_EQ(num_vertices(t.mesh()), num_vertices(known.mesh()));
  for (const auto f : faces(t.mesh())) {
    const IT::Surface_point p{halfedge(f, t.mesh()).index, {0.5, 0.25, 0.25}};
    const auto q = IT::locate_on_input(t, p);
    ASSERT_TRUE(q && are_equal(*q, *IT::locate_on_input(known, p)));
    const auto back = IT::locate_on_intrinsic(t, *q);
    ASSERT_TRUE(back && are_equal(*back, *IT::locate_on_intrinsic(known, *q)));
    const auto v = IT::tangent_to_input(t, {p, {1, 0}}),
               w = IT::tangent_to_input(known, {p, {1, 0}});
    ASSERT_TRUE(v && v->vector == w->vector);
    const auto u = IT::tangent_to_intrinsic(t, *v), x = IT::tangent_to_intrinsic(known, *v);
    ASSERT_TRUE(u && u->vector == x->vector);
    EXPECT_EQ(IT::trace_geodesic_on_input(t, *q, {1, 0}, 0.5).points.size(),
              IT::trace_geodesic_on_input(known, *q, {1, 0}, 0.5).points.size());
  }
  for (const auto e : edges(t.mesh()))
    EXPECT_EQ(IT::trace_edge(t, e).points.size(), IT::trace_edge(known, e).points.size());
  for (std::uint32_t x = 0; x < t.input().number_of_halfedges(); ++x)
    EXPECT_EQ(IT::trace_input_edge(t, x).points.size(),
              IT::trace_input_edge(known, x).points.size());
  EXPECT_EQ(IT::common_subdivision(t).number_of_faces(),
            IT::common_subdivision(known).number_of_faces());
  const std::vector<char> all(t.input().number_of_edges(), 1);
  const auto a = IT::constrained_input_edges(t, all), b = IT::constrained_input_edges(known, all);
  for (const auto e : edges(t.mesh())) EXPECT_EQ(get(a, e), get(b, e));
  const IT::Delaunay_certificate c = IT::certify_delaunay(t), d = IT::certify_delaunay(known);
  EXPECT_EQ(c.is_delaunay(), d.is_delaunay());
  EXPECT_EQ(c.ties, d.ties);
}

TEST(Own_correspondence_of_files, Is_restored_and_written_if_it_takes_and_has_coordinates) {
  const auto known = refined<With<IT::Integer_coordinates>>();
  const std::string file = text(known);
  std::istringstream in(file);
  const auto t = IT::read_intrinsic_triangulation<With<own::Shared>>(in, "file");
  EXPECT_EQ(text(t), file);
  for (const auto e : edges(t.mesh()))
    EXPECT_EQ(IT::trace_edge(t, e).points.size(), IT::trace_edge(known, e).points.size());
}

} // namespace
