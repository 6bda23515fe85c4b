// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

template <class Correspondence>
using Exact =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Correspondence>;

meshes::Mesh noisy(meshes::Mesh m, unsigned seed, double noise) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-noise, noise);
  for (auto& p : m.points)
    for (double& x : p) x += shift(random);
  return m;
}

struct Weights {
  std::vector<double> values;
  std::size_t sharpened = 0, zero = 0;
};

// whose signs are checked
template <class Correspondence>
Weights weights(const meshes::Mesh& m) {
  Exact<Correspondence> t(m.input());
  IT::flip_to_delaunay(t);
  Weights result;
  for (const auto e : edges(t.mesh())) {
    if (CGAL::is_border(e, t.mesh())) continue;
    const double w = typename Exact<Correspondence>::Const_session(t).cotangent_weight(e);
    result.values.push_back(w);
    if (w == 0) ++result.zero;
    EXPECT_EQ(CGAL::sign(w), t.delaunay_sign(halfedge(e, t.mesh())));
  }
  for (const auto& [bits, count] : t.metric().statistics().sharpenings) result.sharpened += count;
  EXPECT_EQ(t.metric().statistics().probable_zero, 0U);
  return result;
}

TEST(Exact_weights, do_not_depend_on_the_correspondence) {
  std::size_t sharpened = 0, zero = 0, meshes = 0;
  for (const double noise : {0., 1e-15, 1e-12, 1e-6, 1e-3})
    for (const meshes::Mesh& plain :
         {meshes::sheared_grid(12, 12, 7), meshes::folded_lattice(8, 9, 5), meshes::box(6, 5, 4),
          meshes::stairs(9, 3, 5), meshes::potato(3, 3)}) {
      const meshes::Mesh m = noise == 0 ? plain : noisy(plain, 8, noise);
      const Weights expected = weights<IT::No_correspondence>(m);
      EXPECT_EQ(weights<IT::Integer_coordinates>(m).values, expected.values);
      EXPECT_EQ(weights<IT::Explicit_crossings>(m).values, expected.values);
      EXPECT_EQ(weights<IT::Signposts>(m).values, expected.values);
      sharpened += expected.sharpened;
      zero += expected.zero;
      ++meshes;
    }
  EXPECT_EQ(meshes, 25U);
  EXPECT_GT(sharpened, 400U);
  EXPECT_GT(zero, 150U);
}

} // namespace
