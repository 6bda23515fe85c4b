// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_geodesics/curves/add_marked_edges.h>
#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include "meshes.h"
#include "numbered_as_mesh.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Curve_network;
using IT::Gluing_map;
using IT::Status;

template <class T>
class CurveLabels : public ::testing::Test {};
using Triangulations = ::testing::Types<
    IT::Intrinsic_triangulation<Gluing_map, IT::Exact_euclidean_traits, IT::Integer_coordinates>,
    IT::Intrinsic_triangulation<Gluing_map, IT::Euclidean_traits<double>, IT::Integer_coordinates>>;
TYPED_TEST_SUITE(CurveLabels, Triangulations);

/// The length of the edges of a label, which must be a path between two vertices: followed from one of them, without looking
/// at the curve.
template <class T, class Labels>
double length_of_path(const T& t, const Labels& labels, std::uint32_t label,
                      typename T::vertex_descriptor from, typename T::vertex_descriptor to) {
  std::multimap<std::uint32_t, typename T::halfedge_descriptor> out;
  for (const auto h : halfedges(t.mesh()))
    if (get(labels, edge(h, t.mesh())) == label) out.insert({t.index(source(h, t.mesh())), h});
  double length = 0;
  std::size_t n = 0;
  typename T::halfedge_descriptor last{};
  auto v = from;
  for (bool moved = true; moved && v != to; ++n) {
    moved = false;
    const auto [first, end] = out.equal_range(t.index(v));
    EXPECT_EQ(std::distance(first, end), v == from ? 1 : 2);
    for (auto i = first; i != end && !moved; ++i) {
      if (n > 0 && i->second == opposite(last, t.mesh())) continue;
      last = i->second;
      length += t.length(edge(last, t.mesh()));
      v = target(last, t.mesh());
      moved = true;
    }
  }
  EXPECT_EQ(v, to);
  EXPECT_EQ(out.size(), 2 * n); // there are no others
  return length;
}

/// The number of edges that are not labelled and not locally Delaunay.
template <class T, class Labels>
std::size_t count_non_delaunay(const T& t, const Labels& labels) {
  std::size_t n = 0;
  for (const auto e : edges(t.mesh()))
    if (get(labels, e) == 0 && !t.is_locally_delaunay(halfedge(e, t.mesh()))) ++n;
  return n;
}

/// Two geodesics between vertices of a mesh, from shortest paths along edges.
template <class T>
void add_geodesics(Curve_network<T>& network,
                   const std::array<std::array<std::uint32_t, 2>, 2>& ends) {
  const T& t = network.triangulation();
  IT::Edge_path_finder<T> find(t);
  for (const auto& [from, to] : ends)
    network.add_path(find(t.numbers().vertex_at(from), t.numbers().vertex_at(to)));
  ASSERT_EQ(shorten_curves(network).status, Status::done);
  for (const auto e : edges(t.mesh())) ASSERT_LE(network.curves_along(e).size(), 1U);
}

TYPED_TEST(CurveLabels, GeodesicsStayUnionsOfEdgesOfTheirLabelsThroughFlipsAndRefinement) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const meshes::Mesh m = meshes::rough_grid(10, seed);
    auto t = numbered_as<TypeParam>(m);
    const std::array<std::array<std::uint32_t, 2>, 2> ends{{{12, 31}, {67, 118}}};
    Curve_network<TypeParam> network(t);
    add_geodesics(network, ends);
    const std::array<double, 2> length{network.length(0), network.length(1)};
    const auto labels = curve_labels(network);
    ASSERT_EQ(flip_to_delaunay(
                  t, IT::parameters::edge_is_constrained_map(network.edge_is_constrained_map()))
                  .status,
              Status::done);
    EXPECT_EQ(count_non_delaunay(t, labels), 0U);
    const auto expect_paths = [&] {
      for (std::uint32_t c = 0; c < 2; ++c)
        EXPECT_NEAR(length_of_path(t, labels, c + 1, t.numbers().vertex_at(ends[c][0]),
                                   t.numbers().vertex_at(ends[c][1])),
                    length[c], 1e-10 * length[c]);
    };
    expect_paths();
    const auto r = delaunay_refine(
        t,
        IT::parameters::minimum_angle(25).maximum_edge_length(0.4).edge_is_constrained_map(labels));
    ASSERT_EQ(r.status, Status::done);
    EXPECT_GT(r.counts.segment_splits, 0U);
    expect_paths();
    if (TypeParam::Metric::is_exact) {
      EXPECT_EQ(count_non_delaunay(t, labels), 0U);
    }
  }
}

TEST(CurveLabelsOfOneEdge, AreThoseOfTheFirstCurve) {
  using T = IT::Intrinsic_triangulation<Gluing_map, IT::Exact_euclidean_traits>;
  T t(meshes::grid(3, 3).input());
  Curve_network<T> network(t);
  const auto labels_before = curve_labels(network);
  const auto h = halfedge(*edges(t.mesh()).begin(), t.mesh());
  network.add_path(std::vector{next(h, t.mesh())});
  network.add_path(std::vector{h});
  network.add_path(std::vector{opposite(h, t.mesh())});
  const auto labels = curve_labels(network);
  for (const auto e : edges(t.mesh())) {
    EXPECT_EQ(get(labels_before, e), 0U);
    EXPECT_EQ(get(labels, e), e == edge(h, t.mesh())                   ? 2U
                              : e == edge(next(h, t.mesh()), t.mesh()) ? 1U
                                                                       : 0U);
  }
}

} // namespace
