// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/proofs/prism.h>

#include <CGAL/Intrinsic_triangulations/exact/numbers/Multiquadratic_number.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Square_class_basis.h>

#include "meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Map = IT::Gluing_map;

// walls that are unfolded as a whole
class Unfolded_mesh {
public:
  explicit Unfolded_mesh(const meshes::Mesh& m)
      : map_(m.map()), input_(IT::Input_metric::from_points(map_, m.points, 0)) {
    std::vector<bool> is_seen(map_.number_of_faces());
    diamond_.triangles.start({0, 0});
    is_seen[0] = true;
    for (std::uint32_t n = 0; n < diamond_.triangles.size(); ++n)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const IT::Face_side& first = diamond_.triangles[n].side;
        const Map::Halfedge h = Map::opposite(side(first.face, (first.slot + k) % 3));
        const std::uint32_t g = map_.face(h).index;
        if (g == IT::Gluing::none || is_seen[g]) continue;
        is_seen[g] = true;
        std::uint32_t entry = 0;
        while (side(g, entry) != h) ++entry;
        diamond_.triangles.enter(n, k, {g, entry});
      }
  }

  // every vertex once
  std::vector<IT::Unfolded_diamond::Corner> corners() const {
    std::vector<IT::Unfolded_diamond::Corner> result{{0, 0}, {0, 1}};
    for (std::uint32_t n = 0; n < diamond_.triangles.size(); ++n) result.push_back({n, 2});
    return result;
  }

  bool is_proven(const std::array<IT::Unfolded_diamond::Corner, 4>& corners) {
    diamond_.corners = corners;
    return IT::Prism_proof()(question()) == IT::Answer::zero;
  }

  // whether the last corners are those of two faces
  bool is_diamond() const {
    const auto d = diamond_.values<double>([this](std::uint32_t f) {
      return std::pair<std::array<double, 3>, double>(
          {input_.squared_length<double>(f, 0), input_.squared_length<double>(f, 1),
           input_.squared_length<double>(f, 2)},
          std::sqrt(input_.squared_quadruple_area<double>(f)));
    });
    return d.area_f > 1e-9 * d.ij && d.area_g > 1e-9 * d.ij;
  }

  // of the last corners
  bool is_tie() {
    using Number = IT::Multiquadratic_number;
    const auto face = [this](std::uint32_t f) {
      const auto root = basis_.sqrt_of(input_.squared_quadruple_area<CGAL::Gmpq>(f));
      const auto length = [&](unsigned k) {
        return Number(input_.squared_length<CGAL::Gmpq>(f, k));
      };
      return std::pair<std::array<Number, 3>, Number>({length(0), length(1), length(2)},
                                                      Number(basis_, root.value()));
    };
    return IT::Delaunay_expression()(diamond_.values<Number>(face)).is_zero();
  }

  // the same; what is known in the field is right
  bool is_proven_in_field() const {
    return IT::Prism_in_field_proof()(question()) == IT::Answer::zero;
  }

private:
  IT::Question<IT::Unfolded_diamond, IT::Recorded_diamond_expression> question() const {
    return {input_, diamond_, IT::recorded(IT::Delaunay_expression())};
  }

  Map::Halfedge side(std::uint32_t f, std::uint32_t k) const {
    Map::Halfedge h = map_.halfedge(Map::Face{f});
    for (; k > 0; --k) h = map_.next(h);
    return h;
  }

  Map map_;
  IT::Input_metric input_;
  IT::Unfolded_diamond diamond_;
  IT::Square_class_basis basis_;
};

struct Count {
  std::size_t ties = 0, proven = 0, in_field = 0;
};

// takes four random vertices repeatedly; proven results must be true
Count count(const meshes::Mesh& m, unsigned seed, std::size_t tries = 4000) {
  Unfolded_mesh mesh(m);
  const auto corners = mesh.corners();
  std::mt19937 random(seed);
  Count n;
  while (tries-- > 0) {
    std::array<std::size_t, 4> c{};
    for (std::size_t& x : c) x = random() % corners.size();
    std::array<std::size_t, 4> sorted = c;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) continue;
    const bool is_proven =
        mesh.is_proven({corners[c[0]], corners[c[1]], corners[c[2]], corners[c[3]]});
    if (!mesh.is_diamond()) continue;
    const bool is_tie = mesh.is_tie();
    EXPECT_TRUE(is_tie || !is_proven);
    const bool is_in_field = mesh.is_proven_in_field();
    EXPECT_TRUE(is_tie || !is_in_field);
    n.in_field += is_in_field;
    n.ties += is_tie;
    n.proven += is_proven;
  }
  return n;
}

// rulings are not along an axis: (x, y, z) becomes (2x - 2y + z, x + 2y + 2z, 2x + y - 2z), a similarity
meshes::Mesh tilted(meshes::Mesh m) {
  for (auto& p : m.points) {
    const auto [x, y, z] = p;
    p = {2 * x - 2 * y + z, x + 2 * y + 2 * z, 2 * x + y - 2 * z};
  }
  return m;
}

// panels of widths 5^(1/2), 10^(1/2), 10^(1/2), 5^(1/2)
const std::vector<std::array<double, 2>> mirrored{{0, 0}, {1, 2}, {4, 3}, {7, 2}, {8, 0}};

TEST(Prism_proof, proves_all_ties_that_are_trapezoids) {
  // two rows of vertices at right angles to the rulings
  for (const meshes::Mesh& m : {meshes::walls(mirrored, 1), tilted(meshes::walls(mirrored, 1))}) {
    const Count n = count(m, 1);
    EXPECT_GT(n.proven, 5U);
    EXPECT_EQ(n.proven, n.ties);
  }
  // two rulings of five vertices
  const Count n = count(meshes::walls({{0, 0}, {1, 2}, {1, 2.5}}, 4), 2);
  EXPECT_GT(n.proven, 5U);
}

TEST(Prism_proof, proves_nothing_that_is_false_where_points_are_moved_by_an_ulp) {
  std::mt19937 random(3);
  std::size_t proven = 0, of_even_walls = 0;
  for (unsigned round = 0; round < 4; ++round) {
    meshes::Mesh m = meshes::walls(mirrored, 2);
    of_even_walls += count(m, round, 1000).proven;
    for (auto& p : m.points)
      if (random() % 3 == 0) p[random() % 3] *= 1 + std::ldexp(1.0, -52);
    proven += count(m, round, 1000).proven;
  }
  EXPECT_LT(proven, of_even_walls);
}

TEST(Prism_proof, proves_nothing_where_rulings_are_not_parallel) {
  // a face of the pyramid whose edges meet at the apex, and one beyond; a rectangle below
  meshes::Mesh m{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 1}},
                 {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
  EXPECT_EQ(count(m, 4).proven, 0U);
}

TEST(Prism_in_field_proof, proves_all_ties_over_prisms) {
  for (const meshes::Mesh& m :
       {meshes::walls({{0, 0}, {3, 4}, {8, 4}}, 5), tilted(meshes::walls(mirrored, 2))}) {
    const Count n = count(m, 7);
    EXPECT_GT(n.ties, 3U);
    EXPECT_EQ(n.in_field, n.ties);
  }
}

TEST(Prism_proof, takes_coordinates_of_up_to_122_bits) {
  const auto lifted = [](int e) { // the lower of two rows
    meshes::Mesh m = meshes::walls(mirrored, 1);
    for (auto& p : m.points)
      if (p[2] == 0) p[2] = std::ldexp(1.0, -e);
    return m;
  };
  const std::size_t proven = count(meshes::walls(mirrored, 1), 6).proven;
  EXPECT_GT(proven, 5U);
  // other coordinates are below 2^4
  for (const int e : {50, 60, 100, 118}) EXPECT_EQ(count(lifted(e), 6).proven, proven) << e;
  EXPECT_EQ(count(lifted(130), 6).proven, 0U);
}

} // namespace
