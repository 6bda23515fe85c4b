// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include "meshes.h"
#include "properties.h"

#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;
using IT::Move_status;

template <class FT, class Correspondence = IT::No_correspondence>
using Triangulation =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<FT>, Correspondence>;

/// Positions in the plane, kept beside a triangulation of it.
template <class T>
class Plane {
public:
  using FT = typename T::FT;
  using Vertex = typename T::vertex_descriptor;
  using Halfedge = typename T::halfedge_descriptor;

  explicit Plane(const meshes::Mesh& m) : t(input(m)) {
    for (const auto v : vertices(t.mesh()))
      at_[t.index(v)] = {FT(m.points[t.input_vertex(v)][0]), FT(m.points[t.input_vertex(v)][1])};
  }

  Vertex insert(Halfedge h, const std::array<double, 3>& w) {
    const std::array<FT, 2> p = combination(h, w);
    const auto n = t.insert_vertex(h, w);
    EXPECT_EQ(n.status, Move_status::done);
    at_[t.index(n.vertex)] = p;
    return n.vertex;
  }
  typename T::Insertion reposition(Vertex v, Halfedge h, const std::array<double, 3>& w) {
    const std::array<FT, 2> p = combination(h, w);
    const auto n = t.reposition_vertex(v, h, w);
    if (n.status == Move_status::done) at_[t.index(n.vertex)] = p;
    return n;
  }

  // what all edges and faces have to be, in the units of the metric
  void expect_values(double tolerance) {
    const double unit = std::ldexp(1, 2 * t.metric().scale_exponent());
    const auto expect_near = [&](const FT& x, const FT& y) {
      EXPECT_LE(std::abs(CGAL::to_double(FT(x - y))), tolerance * (1 + CGAL::to_double(y)));
    };
    for (const auto e : edges(t.mesh())) {
      const auto h = halfedge(e, t.mesh());
      const auto d = vector(h);
      expect_near(t.metric().squared_length(t.index(e)), FT(unit) * (d[0] * d[0] + d[1] * d[1]));
    }
    for (const auto f : faces(t.mesh())) {
      const auto h = halfedge(f, t.mesh());
      const auto a = vector(h), b = vector(next(h, t.mesh()));
      expect_near(t.metric().quadruple_area(t.index(f)),
                  FT(2 * unit) * (a[0] * b[1] - a[1] * b[0]));
    }
  }

  T t;

private:
  static IT::Intrinsic_input input(const meshes::Mesh& m) {
    IT::Intrinsic_input i = m.input();
    i.may_renumber = false;
    return i;
  }
  std::array<FT, 2> vector(Halfedge h) {
    const auto &a = at_[t.index(source(h, t.mesh()))], &b = at_[t.index(target(h, t.mesh()))];
    return {b[0] - a[0], b[1] - a[1]};
  }
  std::array<FT, 2> combination(Halfedge h, const std::array<double, 3>& w) {
    std::array<FT, 2> p{FT(0), FT(0)};
    for (const double x : w) {
      const auto& q = at_[t.index(source(h, t.mesh()))];
      for (std::size_t k = 0; k < 2; ++k) p[k] = p[k] + FT(x) * q[k];
      h = next(h, t.mesh());
    }
    return p;
  }

  std::map<std::uint32_t, std::array<FT, 2>> at_;
};

/// Moves inserted vertices of a mesh in the plane at random within their faces; returns how many stayed themselves.
template <class T>
std::size_t move_at_random(Plane<T>& plane, unsigned seed, double tolerance, int moves) {
  T& t = plane.t;
  std::mt19937 random(seed);
  const auto draw = [&] { return static_cast<double>(random() % 1024) / 1024; };
  std::vector<typename T::vertex_descriptor> inserted;
  std::vector<typename T::halfedge_descriptor> starts;
  for (const auto f : faces(t.mesh())) starts.push_back(halfedge(f, t.mesh()));
  for (const auto h : starts) inserted.push_back(plane.insert(h, {0.25, 0.25, 0.5}));
  IT::flip_to_delaunay(t);
  std::size_t same = 0;
  for (int i = 0; i < moves; ++i) {
    auto& v = inserted[random() % inserted.size()];
    auto h = halfedge(v, t.mesh());
    for (unsigned k = random() % 8; k > 0; --k) h = opposite(next(h, t.mesh()), t.mesh());
    const double a = draw() / 2, b = draw() / 2;
    const std::size_t before = num_vertices(t.mesh());
    const auto n = plane.reposition(v, h, {1 - a - b, a, b});
    if (n.status != Move_status::done) continue;
    if (n.vertex == v) {
      EXPECT_EQ(num_vertices(t.mesh()), before);
      ++same;
    }
    // a removal takes angles for straight that are so to seven digits
    if (n.vertex != v && tolerance > 0) tolerance = 1e-7;
    v = n.vertex;
    plane.expect_values(tolerance);
  }
  return same;
}

TEST(Reposition_in_star, gives_the_lengths_and_areas_of_the_plane_exactly_in_rational_numbers) {
  Plane<Triangulation<Gmpq>> plane(meshes::grid(3, 3));
  EXPECT_GT(move_at_random(plane, 1, 0, 40), 15U);
}

TEST(Reposition_in_star, gives_the_lengths_and_areas_of_the_plane_in_doubles) {
  // rounding adds up over moves, and more of it on slivers
  for (const auto& [m, tolerance] :
       {std::pair{meshes::grid(3, 3), 1e-10},
        std::pair{meshes::scaled(meshes::sheared_grid(4, 4, 1), 1e6), 1e-10},
        std::pair{meshes::random_planar(40, 1000, 3), 1e-8}}) {
    Plane<Triangulation<double>> plane(m);
    EXPECT_GT(move_at_random(plane, 2, tolerance, 200), 50U);
  }
}

TEST(Reposition_in_star, keeps_the_vertex_and_its_neighbours) {
  Triangulation<double> t(meshes::grid(1, 1).input());
  const auto h = halfedge(*faces(t.mesh()).begin(), t.mesh());
  const auto n = t.insert_vertex(h, {0.25, 0.25, 0.5});
  const auto spoke = opposite(halfedge(n.vertex, t.mesh()), t.mesh());
  const auto neighbour = target(spoke, t.mesh());
  const auto moved = t.reposition_vertex(n.vertex, spoke, {0.5, 0.25, 0.25});
  EXPECT_EQ(moved.status, Move_status::done);
  EXPECT_EQ(moved.vertex, n.vertex);
  EXPECT_EQ(target(spoke, t.mesh()), neighbour);
  EXPECT_EQ(source(spoke, t.mesh()), n.vertex);
  EXPECT_NEAR(properties::total_area(t), 1, 1e-14);
}

/// Moves the vertex to the other face of the square, out of its own faces.
TEST(Reposition_in_star, is_left_to_insertion_and_removal_where_the_vertex_leaves_its_faces) {
  Triangulation<double> t(meshes::grid(1, 1).input());
  std::vector<typename Triangulation<double>::face_descriptor> both(faces(t.mesh()).begin(),
                                                                    faces(t.mesh()).end());
  const auto other = halfedge(both[1], t.mesh());
  const auto n = t.insert_vertex(halfedge(both[0], t.mesh()), {0.25, 0.25, 0.5});
  const auto moved = t.reposition_vertex(n.vertex, other, {0.25, 0.25, 0.5});
  EXPECT_EQ(moved.status, Move_status::done);
  EXPECT_EQ(t.number_of_vertices(), 5U);
  EXPECT_NEAR(properties::total_area(t), 1, 1e-14);
}

/// All ways lead to one Delaunay triangulation, after any moves: insertion and removal, or new
/// lengths.
TEST(Reposition_in_star, leads_to_the_same_triangulation_as_with_a_correspondence) {
  const auto lengths = [](const auto& plane) {
    std::vector<double> result;
    for (const auto e : edges(plane.t.mesh())) result.push_back(plane.t.length(e));
    std::sort(result.begin(), result.end());
    return result;
  };
  const meshes::Mesh m = meshes::random_planar(30, 1000, 3);
  Plane<Triangulation<double>> alone(m);
  Plane<Triangulation<double, IT::Integer_coordinates>> followed(m);
  const auto move = [](auto& plane) {
    auto& t = plane.t;
    const auto h = halfedge(*std::next(faces(t.mesh()).begin(), 5), t.mesh());
    auto v = plane.insert(h, {0.25, 0.25, 0.5});
    for (const double a : {0.125, 0.25, 0.0625}) {
      const auto spoke = opposite(halfedge(v, t.mesh()), t.mesh());
      // of the spokes the shortest, which both find
      auto best = spoke, g = spoke;
      do {
        if (t.length(edge(g, t.mesh())) < t.length(edge(best, t.mesh()))) best = g;
        g = opposite(next(next(g, t.mesh()), t.mesh()), t.mesh());
      } while (g != spoke);
      const auto n = plane.reposition(v, best, {1 - 2 * a, a, a});
      EXPECT_EQ(n.status, Move_status::done);
      v = n.vertex;
      IT::flip_to_delaunay(t);
    }
  };
  move(alone);
  move(followed);
  const std::vector<double> x = lengths(alone), y = lengths(followed);
  ASSERT_EQ(x.size(), y.size());
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], y[i], 1e-8 * y[i]);
}

} // namespace
