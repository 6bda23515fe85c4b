// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/queries/Paths_on_faces.h>
#include <CGAL/Intrinsic_geodesics/queries/certify_on_faces.h>
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
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

// Paths on faces of which any number meet at an edge. Oracles: two pages of a book unfold, and the
// sum of the lengths of pieces in space.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;

double uniform(std::mt19937& random, double a, double b) {
  return a + (b - a) * (static_cast<double>(random()) / 0x1p32);
}

Triangulation triangulation(const IT::Triangle_soup& soup) {
  Triangulation t(IT::make_domain(soup).input);
  IT::flip_to_delaunay(t);
  return t;
}

/// A point of a path in space.
std::array<double, 3> in_space(const IT::Triangle_soup& soup, const Triangulation& t,
                               const IT::Surface_point& p) {
  const IT::Input& input = t.input();
  std::array<double, 3> x{};
  std::uint32_t h = p.halfedge;
  for (std::size_t k = 0; k < 3; ++k, h = input.next(h))
    for (std::size_t i = 0; i < 3; ++i)
      x[i] += p.weights[k] * soup.points[input.names().row(input.source(h))][i];
  return x;
}

/// Checks that each piece lies in a face, and that their lengths sum to that of the path.
void expect_on_faces(const IT::Triangle_soup& soup, const Triangulation& t,
                     const IT::Traced_curve& path) {
  ASSERT_EQ(path.faces.size() + 1, path.points.size());
  double length = 0;
  for (std::size_t i = 0; i < path.faces.size(); ++i) {
    EXPECT_EQ(t.input().face(path.points[i].halfedge), path.faces[i]);
    const IT::Surface_point end = IT::seen_in_face(t.input(), path.points[i + 1], path.faces[i]);
    const auto p = in_space(soup, t, path.points[i]), q = in_space(soup, t, path.points[i + 1]);
    const auto& face = soup.triangles[t.input().names().polygon(path.faces[i])];
    std::uint32_t h = end.halfedge;
    for (std::size_t k = 0; k < 3; ++k, h = t.input().next(h)) {
      const std::uint32_t row = t.input().names().row(t.input().source(h));
      EXPECT_TRUE(end.weights[k] == 0 || std::ranges::find(face, row) != face.end());
    }
    length += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }
  EXPECT_NEAR(length, path.length, 1e-12 * path.length);
  EXPECT_LE(path.length_enclosure.inf(), path.length * (1 + 1e-13));
  EXPECT_GE(path.length_enclosure.sup(), path.length * (1 - 1e-13));
}

TEST(PathsOnFaces, are_those_of_unfolded_pages_and_certified) {
  std::mt19937 random(52);
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    const std::size_t pages = 3 + random() % 4;
    IT::Triangle_soup soup;
    soup.points = {{0, 0, 0}, {0, 0, 1}};
    std::vector<std::array<double, 2>> tips;
    for (std::uint32_t k = 0; k < pages; ++k) {
      const double r = uniform(random, 0.3, 2), z = uniform(random, 0.1, 0.9);
      const double angle = 2 * std::numbers::pi * (k + uniform(random, 0.1, 0.9)) / double(pages);
      tips.push_back({r, z});
      soup.points.push_back({r * std::cos(angle), r * std::sin(angle), z});
      random() % 2 == 0 ? soup.triangles.push_back({0, 1, 2 + k})
                        : soup.triangles.push_back({1, 0, 2 + k});
    }
    const Triangulation t = triangulation(soup);
    IT::Paths_on_faces<Triangulation> find(t);
    ASSERT_TRUE(find.can_find(2, false, false));
    for (std::uint32_t a = 0; a < pages; ++a)
      for (std::uint32_t b = 0; b < pages; ++b) {
        const double w = uniform(random, 0.1, 0.9); // how near to the tip, in page a
        const IT::Place p = IT::Place::in_face(a, {(1 - w) / 2, (1 - w) / 2, w}),
                        q = IT::Place::at_vertex(2 + b);
        const double r = w * tips[a][0], z = w * tips[a][1] + (1 - w) / 2;
        const double expected =
            std::hypot(a == b ? r - tips[b][0] : r + tips[b][0], z - tips[b][1]);
        const IT::Path_on_faces path = find({p, q});
        EXPECT_EQ(path.certificate.obstacle, "");
        EXPECT_NEAR(path.curve.length, expected, 1e-12);
        EXPECT_LE(path.certificate.length.inf(), expected * (1 + 1e-14));
        EXPECT_GE(path.certificate.length.sup(), expected * (1 - 1e-14));
        EXPECT_LE(path.certificate.length.sup() - path.certificate.length.inf(), 1e-14 * expected);
        expect_on_faces(soup, t, path.curve);
      }
  }
}

// All pairs of faces of a few random points, so that edges and vertices have many faces.
TEST(PathsOnFaces, of_random_soups_are_as_long_as_distances) {
  std::mt19937 random(53);
  std::size_t certified = 0, all = 0;
  for (int i = 0; i < 25; ++i) {
    SCOPED_TRACE(i);
    IT::Triangle_soup soup;
    const auto n = static_cast<std::uint32_t>(7 + random() % 5);
    for (std::uint32_t k = 0; k < n; ++k)
      soup.points.push_back({uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1)});
    for (std::uint32_t k = 0; k + 2 < n; ++k) {
      soup.triangles.push_back({k, k + 1, k + 2});
      soup.triangles.push_back({k / 2, k + 1, k + 2});
      if (k % 3 == 0 && k + 3 < n) soup.triangles.push_back({k, k + 3, k + 1});
    }
    const Triangulation t = triangulation(soup);
    IT::Paths_on_faces<Triangulation> find(t);
    IT::Place_finder<Triangulation> places(t);
    auto distance = IT::Polyhedral_distance<Triangulation>::on_faces(t);
    for (int k = 0; k < 10; ++k) {
      const std::uint32_t a = static_cast<std::uint32_t>(random() % n),
                          b = static_cast<std::uint32_t>((a + 1 + random() % (n - 1)) % n);
      distance.search(places.vertex(a));
      const IT::Path_on_faces path = find({IT::Place::at_vertex(a), IT::Place::at_vertex(b)});
      const double expected = distance.distance(places.vertex(b));
      EXPECT_NEAR(path.curve.length, expected, 1e-10 * expected);
      expect_on_faces(soup, t, path.curve);
      ++all;
      certified += path.certificate.is_geodesic() ? 1 : 0;
    }
  }
  EXPECT_EQ(certified, all);
}

// Around a corner of the pages; not so the straight line across the edge.
TEST(PathsOnFaces, that_can_be_shortened_are_not_certified) {
  IT::Triangle_soup soup;
  soup.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, .5}, {0, 1, .5}, {-1, 0, .5}};
  soup.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  const Triangulation t = triangulation(soup);
  IT::Paths_on_faces<Triangulation> find(t);
  for (const std::uint32_t corner : {0U, 1U}) {
    IT::Path_on_faces first = find({IT::Place::at_vertex(2), IT::Place::at_vertex(corner)});
    const IT::Path_on_faces second = find({IT::Place::at_vertex(corner), IT::Place::at_vertex(4)});
    EXPECT_TRUE(first.certificate.is_geodesic());
    first.curve.points.pop_back();
    first.curve.points.insert(first.curve.points.end(), second.curve.points.begin(),
                              second.curve.points.end());
    first.curve.faces.insert(first.curve.faces.end(), second.curve.faces.begin(),
                             second.curve.faces.end());
    first.curve.length += second.curve.length;
    first.curve.length_enclosure += second.curve.length_enclosure;
    EXPECT_FALSE(IT::certify_on_faces(t.input(), first.curve).is_geodesic());
  }
  const IT::Path_on_faces straight = find({IT::Place::at_vertex(2), IT::Place::at_vertex(4)});
  EXPECT_DOUBLE_EQ(straight.curve.length, 2);
  EXPECT_TRUE(straight.certificate.is_geodesic());
}

// A book of flat pages: grids of squares on directions (a, b, 0), each divided along a diagonal.
struct Grid_book {
  explicit Grid_book(std::mt19937& random) {
    static constexpr std::array<std::array<int, 2>, 6> all{
        {{1, 0}, {3, 4}, {-1, 1}, {-4, 3}, {-2, -1}, {0, -1}}};
    const std::size_t skipped = random() % all.size();
    for (std::size_t k = 0; k < all.size(); ++k)
      if (k != skipped && (pages.size() < 3 || random() % 2 == 0)) pages.push_back(all[k]);
    for (std::uint32_t page = 0; page < pages.size(); ++page)
      for (int j = 0; j < width; ++j)
        for (int i = 0; i < height; ++i) {
          std::array<std::uint32_t, 4> q{vertex(page, j, i), vertex(page, j + 1, i),
                                         vertex(page, j + 1, i + 1), vertex(page, j, i + 1)};
          if (random() % 2 == 0) std::ranges::rotate(q, q.begin() + 1);
          if (random() % 2 == 0) std::ranges::reverse(q);
          soup.triangles.push_back({q[0], q[1], q[2]});
          soup.triangles.push_back({q[2], q[3], q[0]});
        }
  }

  /// A vertex of a page, so many squares from the spine and from below.
  std::uint32_t vertex(std::uint32_t page, int j, int i) {
    const auto [place, is_new] =
        numbers.try_emplace({j == 0 ? 0 : page, std::uint32_t(j), std::uint32_t(i)},
                            static_cast<std::uint32_t>(numbers.size()));
    if (is_new)
      soup.points.push_back({double(j * pages[page][0]), double(j * pages[page][1]), double(i)});
    return place->second;
  }
  /// The square of the width of a square.
  int square(std::uint32_t page) const {
    return pages[page][0] * pages[page][0] + pages[page][1] * pages[page][1];
  }

  static constexpr int width = 3, height = 5;
  std::vector<std::array<int, 2>> pages;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> numbers;
  IT::Triangle_soup soup;
};

// Angles of exactly pi, at vertices of pages and of the spine. Oracle: integers.
TEST(PathsOnFaces, that_are_straight_at_vertices_are_certified) {
  std::mt19937 random(54);
  const auto below = [&random](int n) { return static_cast<int>(random() % unsigned(n)); };
  std::array<int, 2> seen{};
  for (int k = 0; k < 12; ++k) {
    Grid_book book(random);
    const Triangulation t = triangulation(book.soup);
    IT::Paths_on_faces<Triangulation> find(t);
    for (int n = 0; n < 25; ++n) {
      SCOPED_TRACE(std::to_string(k) + ", " + std::to_string(n));
      const auto a = std::uint32_t(random() % book.pages.size());
      const bool bends = random() % 3 == 0; // at the spine
      const auto b = bends ? std::uint32_t((a + 1) % book.pages.size()) : a;
      // from the middle vertex along the page of one end, and along the other one
      const int j = bends ? 0 : below(book.width + 1), i = below(book.height + 1);
      const int dj = below(book.width + 1) - j, di = below(book.height + 1) - i;
      const int ej = below(2) == 0 ? below(book.width + 1) - j
                                   : std::clamp(bends ? dj : -dj, -j, book.width - j),
                ei = below(2) == 0 ? below(book.height + 1) - i
                                   : std::clamp(-di, -i, book.height - i);
      if ((dj == 0 && di == 0) || (ej == 0 && ei == 0) || (bends && (dj == 0 || ej == 0))) continue;
      // collinear: dj / di = -ej / ei, where widths of squares differ by page; and on both sides
      const int m = bends ? -1 : 1;
      const int l = book.square(a) * dj * dj * ei * ei, r = book.square(b) * ej * ej * di * di;
      const bool is_straight = l == r && dj * ej * m <= 0 && di * ei <= 0;
      const auto at = [&](std::uint32_t page, int x, int y) {
        return IT::Place::at_vertex(book.vertex(page, x, y));
      };
      IT::Path_on_faces first = find({at(a, j + dj, i + di), at(a, j, i)});
      const IT::Path_on_faces second = find({at(b, j, i), at(b, j + ej, i + ei)});
      EXPECT_EQ(first.certificate.obstacle, "");
      EXPECT_EQ(second.certificate.obstacle, "");
      IT::Traced_curve& way = first.curve;
      way.points.pop_back(); // the end, where the second path begins
      way.points.insert(way.points.end(), second.curve.points.begin(), second.curve.points.end());
      way.faces.insert(way.faces.end(), second.curve.faces.begin(), second.curve.faces.end());
      way.length += second.curve.length;
      EXPECT_EQ(IT::certify_on_faces(t.input(), first.curve).is_geodesic(), is_straight);
      ++seen[is_straight ? 1 : 0];
    }
  }
  EXPECT_GT(std::min(seen[0], seen[1]), 25);
}

// From page to page, also through vertices.
TEST(PathsOnFaces, of_books_of_grids_are_certified) {
  std::mt19937 random(55);
  for (int k = 0; k < 8; ++k) {
    Grid_book book(random);
    const Triangulation t = triangulation(book.soup);
    IT::Paths_on_faces<Triangulation> find(t);
    for (int n = 0; n < 25; ++n) {
      SCOPED_TRACE(std::to_string(k) + ", " + std::to_string(n));
      const auto a = std::uint32_t(random() % book.pages.size()),
                 b = std::uint32_t((a + 1) % book.pages.size());
      const int x = 1 + int(random() % unsigned(book.width)),
                y = 1 + int(random() % unsigned(book.width)),
                z = int(random() % unsigned(book.height + 1)),
                w = int(random() % unsigned(book.height + 1));
      const IT::Path_on_faces path = find(
          {IT::Place::at_vertex(book.vertex(a, x, z)), IT::Place::at_vertex(book.vertex(b, y, w))});
      EXPECT_EQ(path.certificate.obstacle, "");
      const double length =
          std::hypot(x * std::sqrt(book.square(a)) + y * std::sqrt(book.square(b)), z - w);
      EXPECT_NEAR(path.curve.length, length, 1e-13 * length);
    }
  }
}

TEST(PathsOnFaces, name_places_that_cannot_be_joined) {
  IT::Triangle_soup soup;
  for (const double x : {0.0, 9.0})
    for (const std::array<double, 3>& p :
         {std::array<double, 3>{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}})
      soup.points.push_back({x + p[0], p[1], p[2]});
  soup.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {5, 6, 7}, {5, 6, 8}, {5, 6, 9}};
  const Triangulation t = triangulation(soup);
  IT::Paths_on_faces<Triangulation> find(t);
  const auto at = [](std::uint32_t v) { return IT::Place::at_vertex(v); };
  EXPECT_THROW(find({at(2), at(7)}), IT::Invalid_input);
  EXPECT_THROW(find({at(2), at(2)}), IT::Invalid_input);
  EXPECT_EQ(find({at(2), at(3), at(4)}).curve.points.size(), 5U);
}

} // namespace
