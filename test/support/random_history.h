// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_RANDOM_HISTORY_H
#define TEST_INTRINSIC_TRIANGULATIONS_RANDOM_HISTORY_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Diamond_unfolder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/exact/Exact_ladder.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_list.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Replayed_faces.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include "gallery.h"
#include "meshes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <utility>
#include <vector>

// Triangulations with random flips: of any edge of a convex diamond, Delaunay or not.

namespace random_history {

namespace IT = CGAL::Intrinsic_triangulations;
using Map = IT::Gluing_map;

class Walk {
public:
  Walk(Map map, IT::Input_metric metric)
      : mesh(std::move(map)), input(std::move(metric)),
        surface_(std::make_shared<IT::Input>(mesh, input)) {
    coordinates_.start(Started{surface_});
  }

  /// The diamond of an edge by the flips.
  IT::Replayed_diamond replayed(Map::Halfedge h) const {
    return IT::Replayed_diamond(
        IT::Replayed_faces(*surface_, mesh, flips, {face_from(h), face_from(Map::opposite(h))}));
  }

  bool is_inner(Map::Halfedge h) const {
    return mesh.face(h).index != IT::Gluing::none &&
           mesh.face(Map::opposite(h)).index != IT::Gluing::none &&
           mesh.face(h) != mesh.face(Map::opposite(h));
  }

  /// The input under a diamond; nothing if an edge crosses too many input edges, or one is in one face twice.
  std::optional<IT::Unfolded_diamond> unfolded(Map::Halfedge h) const {
    if (!is_counted_ || mesh.face(h) == mesh.face(Map::opposite(h))) return std::nullopt;
    for (const Map::Halfedge side : {h, Map::opposite(h)})
      for (const Map::Halfedge x : mesh.sides(mesh.face(side)))
        if (coordinates_.normal_coordinate(x.index / 2) > 1000) return std::nullopt;
    IT::Diamond_unfolder unfolder;
    return unfolder(View{&mesh}, coordinates_, h.index);
  }

  template <class Expression>
  CGAL::Sign sign(Map::Halfedge h, const Expression& e) {
    IT::Diamond_values<CGAL::Interval_nt<false>> values;
    const CGAL::Protect_FPU_rounding<true> upwards; // as intervals ask for
    if (const auto u = unfolded(h))
      return ladder_.sign(input, *u, IT::recorded(e), values, statistics);
    return ladder_.sign(input, replayed(h), IT::recorded(e), values, statistics);
  }

  bool is_convex(Map::Halfedge h) {
    return sign(h, IT::Convexity_at_source_expression()) == CGAL::POSITIVE &&
           sign(h, IT::Convexity_at_target_expression()) == CGAL::POSITIVE;
  }

  // turns h clockwise
  void flip(Map::Halfedge h) {
    const Map::Halfedge o = Map::opposite(h);
    const std::uint32_t jk = mesh.next(h).index, ki = mesh.next(mesh.next(h)).index,
                        im = mesh.next(o).index, mj = mesh.next(mesh.next(o)).index;
    const IT::Flip move{
        h.index,
        jk,
        ki,
        im,
        mj,
        h.index,
        {h.index / 2, jk / 2, ki / 2, im / 2, mj / 2, mesh.face(h).index, mesh.face(o).index}};
    is_counted_ = is_counted_ && coordinates_.before(*this, move);
    CGAL::Euler::flip_edge(h, mesh);
    if (is_counted_) coordinates_.after(*this, move);
    flips.make_room(h.index);
    flips.add(h.index);
  }

  bool try_flip(Map::Halfedge h) {
    if (!is_inner(h) || !is_convex(h)) return false;
    flip(h);
    return true;
  }

  // tries to flip random edges
  void run(std::size_t tries, std::mt19937& random) {
    for (std::size_t i = 0; i < tries; ++i)
      try_flip(Map::Halfedge{static_cast<std::uint32_t>(random() % mesh.number_of_halfedges())});
  }

  std::vector<Map::Halfedge> inner_edges() const {
    std::vector<Map::Halfedge> result;
    for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e)
      if (is_inner(Map::Halfedge{2 * e})) result.push_back(Map::Halfedge{2 * e});
    return result;
  }

  Map mesh;
  IT::Input_metric input;
  IT::Flip_list flips;
  IT::Predicate_statistics statistics;

private:
  IT::Indexed_face face_from(Map::Halfedge h) const {
    const Map::Halfedge n = mesh.next(h);
    return {mesh.face(h).index, {h.index / 2, n.index / 2, mesh.next(n).index / 2}};
  }

  struct Started {
    std::shared_ptr<const IT::Input> input;
    const std::shared_ptr<const IT::Input>& shared_input() const { return input; }
  };

  // the data of a triangulation
  struct View {
    const Map* mesh;
    std::uint32_t next(std::uint32_t h) const { return mesh->next({h}).index; }
    std::uint32_t face(std::uint32_t h) const { return mesh->face({h}).index; }
    std::uint32_t source(std::uint32_t h) const { return mesh->source(Map::Halfedge{h}).index; }
    std::uint32_t target(std::uint32_t h) const { return mesh->target(Map::Halfedge{h}).index; }
    bool is_border(std::uint32_t h) const { return face(h) == IT::Gluing::none; }
    static std::uint32_t opposite(std::uint32_t h) { return h ^ 1U; }
  };

  std::shared_ptr<const IT::Input> surface_;
  IT::Integer_coordinates coordinates_;
  bool is_counted_ = true; // whether the coordinates have stayed in bounds
  IT::Exact_ladder ladder_;
};

inline Walk walk_on(const meshes::Mesh& m, double delta = 0) {
  Map map = m.map();
  IT::Input_metric input = IT::Input_metric::from_points(map, m.points, 0);
  input.set_delta(delta);
  return {std::move(map), std::move(input)};
}
inline Walk walk_on(const gallery::Surface& s) {
  Map map(s.gluing);
  return {map, IT::Input_metric::from_squared_lengths(map, gallery::squared_lengths(s), 0)};
}

/// Flips edges until all are Delaunay; returns the number of ties.
inline std::size_t make_delaunay(Walk& walk) {
  std::size_t ties = 0;
  for (bool is_done = false; !is_done;) {
    is_done = true;
    ties = 0;
    for (const Map::Halfedge h : walk.inner_edges()) {
      const CGAL::Sign s = walk.sign(h, IT::Delaunay_expression());
      ties += s == CGAL::ZERO;
      if (s != CGAL::NEGATIVE) continue;
      walk.flip(h);
      is_done = false;
    }
  }
  return ties;
}

/// Expects that two diamonds have the same values, exactly.
template <class FT>
void expect_same(const IT::Diamond_values<FT>& x, const IT::Diamond_values<FT>& y) {
  EXPECT_TRUE(x.ij == y.ij);
  EXPECT_TRUE(x.jk == y.jk);
  EXPECT_TRUE(x.ki == y.ki);
  EXPECT_TRUE(x.im == y.im);
  EXPECT_TRUE(x.mj == y.mj);
  EXPECT_TRUE(x.area_f == y.area_f);
  EXPECT_TRUE(x.area_g == y.area_g);
}

} // namespace random_history

#endif // TEST_INTRINSIC_TRIANGULATIONS_RANDOM_HISTORY_H
