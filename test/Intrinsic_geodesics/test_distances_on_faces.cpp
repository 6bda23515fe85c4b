// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/distance/batches.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_shortest_path.h>
#include <CGAL/Intrinsic_geodesics/voronoi/voronoi_cells.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Exact distances on faces of which any number meet at an edge. Oracle: two pages of a book unfold.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;
using Distance = IT::Polyhedral_distance<Triangulation>;

/// Triangles around one edge of length 1, in any orientation.
struct Book {
  IT::Triangle_soup soup;
  std::vector<std::array<double, 2>> tips; ///< distance from the edge, and height

  Book(std::size_t pages, std::mt19937& random) {
    const auto uniform = [&random](double a, double b) {
      return a + (b - a) * (static_cast<double>(random()) / 0x1p32);
    };
    soup.points = {{0, 0, 0}, {0, 0, 1}};
    for (std::uint32_t i = 0; i < pages; ++i) {
      const double r = uniform(0.3, 2), z = uniform(0.1, 0.9);
      const double angle = 2 * std::numbers::pi * (i + uniform(0.1, 0.9)) / double(pages);
      tips.push_back({r, z});
      soup.points.push_back({r * std::cos(angle), r * std::sin(angle), z});
      if (random() % 2 == 0)
        soup.triangles.push_back({0, 1, 2 + i});
      else
        soup.triangles.push_back({1, 0, 2 + i});
    }
  }
  /// Distance from the edge, and height, of a point of a page.
  std::array<double, 2> position(const IT::Place& p) const {
    const auto& [r, z] = tips[p.face];
    const double top = soup.triangles[p.face][0] == 1 ? p.weights[0] : p.weights[1];
    return {p.weights[2] * r, p.weights[2] * z + top};
  }
  double distance(const IT::Place& p, const IT::Place& q) const {
    const auto [r, z] = position(p);
    const auto [s, w] = position(q);
    return std::hypot(p.face == q.face ? r - s : r + s, z - w);
  }
  double area() const {
    return std::accumulate(tips.begin(), tips.end(), 0.0,
                           [](double sum, const auto& tip) { return sum + tip[0] / 2; });
  }
  Triangulation triangulation() const {
    Triangulation t(IT::make_domain(soup).input);
    IT::flip_to_delaunay(t);
    return t;
  }
};

/// A point of a page, often very near to a corner or a side.
IT::Place random_place(std::size_t pages, std::mt19937& random) {
  std::array<double, 3> w{};
  for (double& x : w)
    x = static_cast<double>(random() + 1) / 0x1p32 * std::pow(10, -double(random() % 3) * 8);
  const double sum = w[0] + w[1] + w[2];
  return IT::Place::in_face(static_cast<std::uint32_t>(random() % pages),
                            {w[0] / sum, w[1] / sum, w[2] / sum});
}

TEST(DistancesOnFaces, pages_of_a_book_unfold) {
  std::mt19937 random(50);
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    const std::size_t pages = 3 + random() % 4;
    const Book book(pages, random);
    const Triangulation t = book.triangulation();
    IT::Place_finder<Triangulation> find(t);
    Distance d = Distance::on_faces(t);
    ASSERT_TRUE(d.is_on_faces());
    const IT::Place source = random_place(pages, random);
    d.search(find.points(source));
    for (int k = 0; k < 10; ++k) {
      const IT::Place target = random_place(pages, random);
      const double expected = book.distance(source, target);
      for (const IT::Surface_point& q : find.points(target))
        EXPECT_NEAR(d.distance(q), expected, 1e-12);
      EXPECT_NEAR(IT::pair_distances(t, std::vector{find.points(source).front()},
                                     std::vector{find.points(target).front()})
                      .front(),
                  expected, 1e-12);
    }
  }
}

TEST(DistancesOnFaces, tips_are_as_far_whatever_lies_between) {
  IT::Triangle_soup soup;
  soup.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, .5}, {0, 1, .5}, {-1, 0, .5}, {0, -1, .5}};
  soup.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 1, 5}};
  Triangulation t(IT::make_domain(soup).input);
  IT::flip_to_delaunay(t);
  IT::Place_finder<Triangulation> find(t);
  Distance d = Distance::on_faces(t);
  d.search(find.vertex(2));
  for (const std::uint32_t tip : {3U, 4U, 5U}) {
    EXPECT_DOUBLE_EQ(d.distance(find.vertex(tip)), 2);
    const IT::Traced_curve path = IT::trace_shortest_path(t, d.shortest_path(find.vertex(tip)));
    EXPECT_EQ(path.status, IT::Status::done);
    EXPECT_EQ(path.points.size(), 3U); // across the edge once
    EXPECT_EQ(path.faces.size(), 2U);
  }
}

TEST(DistancesOnFaces, cells_have_the_areas_of_the_faces) {
  std::mt19937 random(51);
  for (int i = 0; i < 20; ++i) {
    SCOPED_TRACE(i);
    const std::size_t pages = 3 + random() % 4;
    const Book book(pages, random);
    const Triangulation t = book.triangulation();
    IT::Place_finder<Triangulation> find(t);
    Distance d = Distance::on_faces(t);
    d.search(std::vector{find.vertex(2), find.vertex(3)});
    const IT::Voronoi_cells cells = IT::voronoi_cells(d);
    EXPECT_NEAR(cells.areas[0] + cells.areas[1], book.area(), 1e-12 * book.area());
    for (const IT::Cell_boundary& b : cells.boundaries)
      EXPECT_EQ(IT::trace_boundary(t, b).status, IT::Status::done);
  }
}

} // namespace
