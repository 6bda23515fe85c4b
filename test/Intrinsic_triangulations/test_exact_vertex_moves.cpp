// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gallery.h"
#include "meshes.h"
#include "properties.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_evaluation.h>
#include <CGAL/Intrinsic_triangulations/metric/Face_values.h>
#include <CGAL/Intrinsic_triangulations/metric/History_zero_test.h>
#include <CGAL/Intrinsic_triangulations/metric/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/flip_to_delaunay.h>

#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

// Insertions and removals of vertices with exact traits.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;
using IT::Gluing_map;
using IT::Move_status;
using Exact = IT::Intrinsic_triangulation<>;
using Halfedge = Exact::halfedge_descriptor;
using Vertex = Exact::vertex_descriptor;
using Position = std::array<Gmpq, 2>;

/// A planar triangulation with the exact position of every vertex.
class Planar {
public:
  explicit Planar(const meshes::Mesh& m) : t(m.input()) {
    std::vector<Vertex> by_input(m.points.size());
    for (const Vertex v : vertices(t.mesh())) by_input[t.input_vertex(v)] = v;
    for (std::size_t i = 0; i < m.points.size(); ++i)
      set(by_input[i], {Gmpq(m.points[i][0]), Gmpq(m.points[i][1])});
  }

  Exact t;
  std::vector<Vertex> inserted;

  const Position& at(Vertex v) const { return positions_[t.index(v)]; }
  Position from(Halfedge h) const { return at(source(h, t.mesh())); }

  std::vector<Halfedge> halfedges_with_face() const {
    std::vector<Halfedge> result;
    for (const Halfedge h : halfedges(t.mesh()))
      if (face(h, t.mesh()) != boost::graph_traits<Gluing_map>::null_face()) result.push_back(h);
    return result;
  }

  void insert(Halfedge h, const std::array<double, 3>& weights) {
    const auto w = IT::representable_weights(weights);
    ASSERT_TRUE(w);
    const Position p = combination(h, *w);
    const auto n = t.insert_vertex(h, *w);
    ASSERT_EQ(n.status, Move_status::done);
    set(n.vertex, p);
    inserted.push_back(n.vertex);
  }

  Move_status move(std::size_t i, Halfedge h, const std::array<double, 3>& weights) {
    const auto w = IT::representable_weights(weights);
    const Position p = combination(h, *w);
    const auto n = t.reposition_vertex(inserted[i], h, *w);
    if (n.status != Move_status::done) return n.status;
    inserted[i] = n.vertex;
    set(n.vertex, p);
    return n.status;
  }

  Move_status remove(std::size_t i) {
    const Move_status s = t.remove_vertex(inserted[i]);
    if (s == Move_status::done) {
      inserted[i] = inserted.back();
      inserted.pop_back();
    }
    return s;
  }

  /// Random flips, insertions in faces, on edges and on the border, and removals.
  void step(std::mt19937& random) {
    const auto all = halfedges_with_face();
    const Halfedge h = all[random() % all.size()];
    const double s = (1.0 + static_cast<double>(random() % 6)) / 8;
    const double third = (1 - s) * static_cast<double>(1 + random() % 4) / 5;
    switch (random() % 8) {
    case 0:
      return insert(h, {s, 1 - s - third, third});
    case 1:
      return insert(h, {1 - s, s, 0});
    case 2:
      if (!inserted.empty()) remove(random() % inserted.size());
      return;
    case 3:
      if (!inserted.empty()) move(random() % inserted.size(), h, {third, 1 - s - third, s});
      return;
    default:
      t.flip_edge(h);
    }
  }

private:
  Position combination(Halfedge h, const std::array<double, 3>& w) const {
    Position p{Gmpq(0), Gmpq(0)};
    for (std::size_t k = 0; k < 3; ++k, h = next(h, t.mesh()))
      for (std::size_t c = 0; c < 2; ++c) p[c] += Gmpq(w[k]) * from(h)[c];
    return p;
  }

  void set(Vertex v, const Position& p) {
    if (positions_.size() <= t.index(v)) positions_.resize(t.index(v) + 1);
    positions_[t.index(v)] = p;
  }

  std::vector<Position> positions_;
};

IT::Indexed_face indexed_face(const Exact& t, Halfedge h) {
  const Halfedge n = next(h, t.mesh());
  const auto number = [&t](Halfedge x) { return t.index(edge(x, t.mesh())); };
  return {t.index(face(h, t.mesh())), {number(h), number(n), number(next(n, t.mesh()))}};
}

IT::Flip_history::Side side(const Exact& t, Halfedge h) {
  const IT::Indexed_face f = indexed_face(t, h);
  const auto [version, first] = t.metric().version(f.face);
  return {version, first == f.edges[0] ? 0U : first == f.edges[1] ? 2U : 1U};
}

Gmpq power_of_four(int exponent) {
  return exponent < 0 ? Gmpq(1) / power_of_four(-exponent) : Gmpq(std::ldexp(1.0, 2 * exponent));
}

// lengths from h on, then the area
std::array<Gmpq, 4> from_positions(const Planar& p, Halfedge h) {
  const Gmpq scale = power_of_four(p.t.metric().scale_exponent());
  std::array<Position, 3> corners;
  for (Position& c : corners) {
    c = p.from(h);
    h = next(h, p.t.mesh());
  }
  const auto difference = [&](std::size_t i, std::size_t j) {
    return Position{corners[j][0] - corners[i][0], corners[j][1] - corners[i][1]};
  };
  std::array<Gmpq, 4> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Position d = difference(k, (k + 1) % 3);
    result[k] = (d[0] * d[0] + d[1] * d[1]) * scale;
  }
  const Position u = difference(0, 1), v = difference(0, 2);
  result[3] = 2 * (u[0] * v[1] - u[1] * v[0]) * scale;
  return result;
}

std::array<Gmpq, 4> from_history(const Exact& t, Halfedge h) {
  IT::History_zero_test test(t.metric().input(), t.metric().history(), {side(t, h)});
  const auto face = test.exact_faces()[0];
  std::array<Gmpq, 4> result;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& x = k < 3 ? face.squared_lengths[k] : face.quadruple_area;
    EXPECT_TRUE(x.is_rational());
    result[k] = x.coefficient(0);
  }
  return result;
}

void expect_stored(const Exact& t, Halfedge h, const std::array<Gmpq, 4>& exact) {
  const IT::Indexed_face f = indexed_face(t, h);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& x =
        k < 3 ? t.metric().squared_length(f.edges[k]) : t.metric().quadruple_area(f.face);
    const double near = k < 3 ? t.metric().approximate_squared_length(f.edges[k])
                              : t.metric().approximate_quadruple_area(f.face);
    EXPECT_LE(Gmpq(x.inf()), exact[k]);
    EXPECT_GE(Gmpq(x.sup()), exact[k]);
    EXPECT_GE(near, x.inf());
    EXPECT_LE(near, x.sup());
  }
}

void expect_true_values(const Planar& p) {
  for (const Halfedge h : p.halfedges_with_face()) {
    const auto exact = from_positions(p, h);
    EXPECT_EQ(from_history(p.t, h), exact);
    expect_stored(p.t, h, exact);
  }
}

TEST(Exact_vertex_moves, values_are_those_of_the_plane_after_random_moves) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    std::mt19937 random(seed);
    Planar p(seed % 2 == 0 ? meshes::grid(2, 3) : meshes::random_planar(12, 50, seed));
    for (int i = 0; i < 12; ++i) {
      for (int k = 0; k < 6; ++k) p.step(random);
      expect_true_values(p);
      if (HasFailure()) {
        ADD_FAILURE() << "seed " << seed << " round " << i;
        return;
      }
    }
    EXPECT_GT(p.t.metric().history().number_of_vertex_moves(), 10U);
  }
}

} // namespace
