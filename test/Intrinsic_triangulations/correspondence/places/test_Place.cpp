// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include "meshes.h"
#include "soups.h"

#include <gtest/gtest.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Points as users name them: each has one result, whichever face names it.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using meshes::Mesh;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;

std::vector<std::pair<std::string, Mesh>> surfaces() {
  return {{"fins", soups::three_fins()},
          {"Moebius strip", soups::moebius_strip()},
          {"random soup", soups::random(9, 30, 5)},
          {"grid", meshes::grid(4, 3)}};
}

/// Delaunay triangulations, and refined ones, of each surface: as it is found, and as a cover.
template <class Check>
void for_all_triangulations(const Check& check) {
  for (const auto& [name, m] : surfaces())
    for (const IT::Domain_kind kind : {IT::Domain_kind::automatic, IT::Domain_kind::tufted_cover})
      for (const bool is_refined : {false, true}) {
        SCOPED_TRACE(name + (is_refined ? " refined" : ""));
        Triangulation t(IT::make_domain(soups::soup(m), kind).input);
        IT::flip_to_delaunay(t);
        if (is_refined) IT::delaunay_refine(t, IT::parameters::maximum_insertions(20));
        check(m, t);
      }
}

std::set<std::pair<std::uint32_t, std::array<double, 3>>>
as_set(const std::vector<IT::Surface_point>& points) {
  std::set<std::pair<std::uint32_t, std::array<double, 3>>> result;
  for (const IT::Surface_point& p : points) result.insert({p.halfedge, p.weights});
  EXPECT_EQ(result.size(), points.size()) << "a point is there twice";
  return result;
}

TEST(Place, At_a_corner_is_the_vertex_whichever_face_names_it) {
  for_all_triangulations([](const Mesh& m, const Triangulation& t) {
    IT::Place_finder find(t);
    for (std::uint32_t f = 0; f < m.triangles.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k) {
        std::array<double, 3> weights{0, 0, 0};
        weights[k] = 1 + 1e-7; // made to sum to 1
        const IT::Place p = IT::normalized(t.input(), IT::Place::in_face(f, weights));
        EXPECT_EQ(p.vertex, m.triangles[f][k]);
        EXPECT_EQ(p.face, f);
        const auto points = find.points(p);
        EXPECT_EQ(as_set(points), as_set(find.points(IT::Place::at_vertex(m.triangles[f][k]))));
        for (const IT::Surface_point& q : points) {
          EXPECT_EQ(q.weights, (std::array<double, 3>{1, 0, 0}));
          const auto v = source(t.numbers().halfedge_at(q.halfedge), t.mesh());
          EXPECT_EQ(t.input_vertex(v), m.triangles[f][k]);
        }
      }
  });
}

TEST(Place, On_an_edge_is_the_same_point_from_all_of_its_faces) {
  const unsigned seed = 11;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.01, 0.99);
  for_all_triangulations([&](const Mesh& m, const Triangulation& t) {
    IT::Place_finder find(t);
    const auto sides = halfedges(t.mesh());
    const bool has_border = std::any_of(sides.begin(), sides.end(),
                                        [&](auto h) { return CGAL::is_border(h, t.mesh()); });
    std::map<std::array<std::uint32_t, 2>, std::vector<IT::Place>> by_edge;
    std::map<std::array<std::uint32_t, 2>, double> parameter;
    for (std::uint32_t f = 0; f < m.triangles.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t i = m.triangles[f][k], j = m.triangles[f][(k + 1) % 3];
        const std::array<std::uint32_t, 2> edge{std::min(i, j), std::max(i, j)};
        const double w = parameter.emplace(edge, uniform(random)).first->second;
        std::array<double, 3> weights{0, 0, 0};
        weights[k] = i < j ? w : 1 - w;
        weights[(k + 1) % 3] = i < j ? 1 - w : w;
        by_edge[edge].push_back(IT::Place::in_face(f, weights));
      }
    for (const auto& [edge, places] : by_edge) {
      const auto first = as_set(find.points(places.front()));
      // k faces have 2 k sides, glued in pairs, unless the cover has a border; without a cover there
      // is one edge
      const std::size_t copies = has_border && places.size() == 1 ? 2 : places.size();
      EXPECT_EQ(first.size(), t.input().names().sheets == 1 ? 1 : copies);
      for (const IT::Place& p : places) EXPECT_EQ(as_set(find.points(p)), first);
    }
  });
}

TEST(Place, In_a_face_is_found_where_its_corners_say) {
  const unsigned seed = 12;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::exponential_distribution<double> number;
  for_all_triangulations([&](const Mesh& m, const Triangulation& t) {
    IT::Place_finder find(t);
    for (std::uint32_t f = 0; f < m.triangles.size(); ++f) {
      std::array<double, 3> weights{number(random), number(random), number(random)};
      const double sum = weights[0] + weights[1] + weights[2];
      meshes::Point wanted{0, 0, 0};
      for (std::size_t k = 0; k < 3; ++k) {
        weights[k] /= sum;
        for (std::size_t c = 0; c < 3; ++c)
          wanted[c] += weights[k] * m.points[m.triangles[f][k]][c];
      }
      const auto points = find.points(IT::Place::in_face(f, weights));
      EXPECT_EQ(points.size(), t.input().names().sheets);
      for (const IT::Surface_point& p : points) {
        const auto there = IT::point_in_space(t, *IT::locate_on_input(t, p), m.points);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(there[c], wanted[c], 1e-10);
      }
    }
  });
}

TEST(Place, Is_refused_with_the_element_and_the_remedy) {
  const Triangulation t(IT::make_domain(soups::soup(meshes::grid(2, 2))).input);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<std::array<double, 3>> no_weights{
      {0.5, 0.4, 0}, {1.5, -0.5, 0}, {NAN, 0.5, 0.5}, {infinity, 0, 0}, {0, 0, 0}};
  for (const std::array<double, 3>& w : no_weights) try {
      IT::normalized(t.input(), IT::Place::in_face(3, w));
      FAIL();
    } catch (const IT::Invalid_input& e) {
      EXPECT_EQ(e.kind(), IT::Element_kind::face);
      EXPECT_EQ(e.index(), 3U);
    }
  EXPECT_THROW(IT::normalized(t.input(), IT::Place::in_face(1000, {1, 0, 0})), IT::Invalid_input);
  EXPECT_THROW(IT::normalized(t.input(), IT::Place{}), IT::Invalid_input);
  EXPECT_THROW(IT::Place_finder(t).points(IT::Place::at_vertex(1000)), IT::Invalid_input);
}

} // namespace
