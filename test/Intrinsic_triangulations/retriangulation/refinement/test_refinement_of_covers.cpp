// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "properties.h"
#include "soups.h"

#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/transfer.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/read_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/write_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/adaptive_refine.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// That refinement inserts one vertex of the user's surface at a time: its copies on all sheets, in
// one row, or a vertex alone where copies have no room.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
namespace parameters = IT::parameters;
using IT::Domain_kind;
using meshes::Mesh;
template <class Traits, class Correspondence>
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, Traits, Correspondence>;
using Exact = Triangulation<IT::Exact_euclidean_traits, IT::Integer_coordinates>;

std::vector<std::pair<std::string, Mesh>> soups_of_all_kinds() {
  return {{"book", soups::book()},
          {"fins", soups::three_fins()},
          {"Moebius strip", soups::moebius_strip()},
          {"Klein bottle", soups::klein_bottle()},
          {"random soup", soups::random_without_repetition(9, 30, 5)},
          {"another one", soups::random_without_repetition(12, 25, 7)},
          {"potato", meshes::potato(1, 3)},
          {"rough grid", meshes::rough_grid(4, 2)}};
}

// thin faces at seams: what is found by rounded coordinates is beside them
Mesh flattened(Mesh m) {
  for (meshes::Point& p : m.points) {
    p[1] *= 0.01;
    p[2] *= 0.01;
  }
  return m;
}

// Where a vertex is on the user's faces: exact weights of rows.
using Place = std::map<std::uint32_t, double>;
template <class T>
Place place(const T& t, typename T::vertex_descriptor v) {
  const IT::Surface_point& p = t.places()->location(t.index(v));
  const IT::Input& input = t.input();
  const std::uint32_t h = p.halfedge, n = input.next(h);
  Place result;
  const std::array<std::uint32_t, 3> corners{input.source(h), input.target(h), input.target(n)};
  for (std::size_t k = 0; k < 3; ++k)
    if (p.weights[k] != 0) result[input.names().row(corners[k])] = p.weights[k];
  return result;
}

// how many copies a point has: two in a face; on an edge one for each face, but at most two where the border stays
std::size_t expected_copies(const Mesh& m, const Place& p, Domain_kind kind) {
  if (p.size() == 3) return 2;
  const std::uint32_t a = p.begin()->first, b = p.rbegin()->first;
  const auto faces = std::ranges::count_if(m.triangles, [&](const auto& f) {
    return std::ranges::count(f, a) == 1 && std::ranges::count(f, b) == 1;
  });
  return kind == Domain_kind::tufted_cover ? static_cast<std::size_t>(faces) : 2;
}

// the longest coordinate
double size_of(const Mesh& m) {
  double size = 0;
  for (const meshes::Point& p : m.points)
    for (const double x : p) size = std::max(size, std::abs(x));
  return size;
}

// \param without_copies how many rows may lack copies
template <class T>
void expect_rows_are_places(const T& t, const Mesh& m, Domain_kind kind, const std::string& name,
                            std::uint64_t without_copies = 0) {
  std::map<Place, std::vector<std::uint32_t>> rows;
  for (const auto v : vertices(t.mesh()))
    if (t.is_inserted(v)) rows[place(t, v)].push_back(t.input_vertex(v));
  std::set<std::uint32_t> all;
  std::uint64_t incomplete = 0;
  for (const auto& [p, of_copies] : rows) {
    EXPECT_LE(of_copies.size(), expected_copies(m, p, kind)) << name;
    incomplete += of_copies.size() < expected_copies(m, p, kind) ? 1 : 0;
    EXPECT_EQ(std::ranges::count(of_copies, of_copies[0]), std::ssize(of_copies)) << name;
    all.insert(of_copies[0]);
  }
  EXPECT_LE(incomplete, without_copies) << name;
  EXPECT_EQ(all.size(), rows.size()) << name;
  EXPECT_EQ(t.number_of_vertices(), m.points.size() + rows.size()) << name;
  if (!all.empty()) {
    EXPECT_EQ(*all.begin(), m.points.size()) << name;
    EXPECT_EQ(*all.rbegin() + 1, t.number_of_vertices()) << name;
  }
}

// The angle asked for everywhere but where it is said not to be. Where many faces meet at all
// edges, copies have no room now and then.
template <class Result>
void expect_good(const Exact& t, const Result& r, double angle, const std::string& name) {
  std::set<std::uint32_t> unsatisfied;
  std::size_t refused = 0;
  for (const auto& u : r.unsatisfied) {
    unsatisfied.insert(t.index(u.face));
    EXPECT_NE(u.reason, IT::Unsatisfied_reason::stopped) << name;
    refused += u.reason == IT::Unsatisfied_reason::refused ? 1 : 0;
  }
  EXPECT_TRUE(r.status == IT::Status::done || (refused > 0 && r.status == IT::Status::stalled))
      << name;
  if (name.find("soup") == std::string::npos && name != "another one") {
    EXPECT_EQ(refused + r.counts.without_copies + r.counts.refused, 0U) << name;
  }
  EXPECT_LE(refused, num_faces(t.mesh()) / 10) << name;
  for (const auto f : faces(t.mesh()))
    EXPECT_TRUE(unsatisfied.count(t.index(f)) != 0 || properties::least_angle(t, f) >= angle - 1e-9)
        << name;
}

TEST(Refinement_of_covers, inserts_all_copies_of_a_point_in_one_row) {
  for (const auto& [name, m] : soups_of_all_kinds())
    for (const double angle : {25., 30.}) {
      Exact t(IT::make_domain(soups::soup(m), Domain_kind::tufted_cover).input);
      const auto r = IT::delaunay_refine(
          t, parameters::minimum_angle(angle).maximum_circumradius(0.3 * size_of(m)));
      expect_good(t, r, angle, name);
      EXPECT_TRUE(IT::is_delaunay(t)) << name;
      EXPECT_EQ(vertices(t.mesh()).size(),
                t.input().number_of_vertices() + r.counts.inserted_vertices())
          << name;
      EXPECT_NEAR(IT::lumped_mass_matrix(t).sum(), meshes::area(m), 1e-9 * meshes::area(m)) << name;
      expect_rows_are_places(t, m, Domain_kind::tufted_cover, name, r.counts.without_copies);
    }
}

TEST(Refinement_of_covers, finds_copies_on_seams_of_thin_faces) {
  for (const unsigned seed : {3U, 5U, 6U}) {
    const std::string name = "soup " + std::to_string(seed);
    const Mesh m = flattened(soups::random_without_repetition(9, 25, seed));
    Exact t(IT::make_domain(soups::soup(m), Domain_kind::tufted_cover).input);
    const auto r = IT::delaunay_refine(t, parameters::maximum_insertions(30000));
    expect_good(t, r, 25, name);
    expect_rows_are_places(t, m, Domain_kind::tufted_cover, name, r.counts.without_copies);
  }
}

// How many points are inserted where every sheet is refined by itself.
std::size_t points_of_sheets(const Mesh& m) {
  Triangulation<IT::Exact_euclidean_traits, IT::No_correspondence> t(
      IT::make_domain(soups::soup(m), Domain_kind::tufted_cover).input);
  return IT::delaunay_refine(t).counts.inserted_vertices();
}

// Random triangles in a cube, on a small grid of points, and in a plane: with few faces at an edge,
// and with many.
std::vector<std::pair<std::string, Mesh>> random_soups() {
  std::vector<std::pair<std::string, Mesh>> result;
  for (const unsigned seed : {1U, 2U})
    for (const auto& [points, faces] : {std::pair{10U, 25U}, {60U, 150U}, {16U, 150U}, {20U, 50U}})
      for (const char* kind : {"cube", "grid", "plane"}) {
        Mesh m = soups::random_without_repetition(points, faces, seed);
        std::mt19937 random(seed);
        std::vector<int> places(64);
        std::iota(places.begin(), places.end(), 0);
        std::shuffle(places.begin(), places.end(), random);
        for (std::size_t i = 0; i < m.points.size(); ++i) {
          const int n = places[i];
          if (kind == std::string("grid"))
            m.points[i] = {double(n % 4), double(n / 4 % 4), double(n / 16)};
          if (kind == std::string("plane")) m.points[i][2] = 0;
        }
        result.push_back({std::string("soup ") + kind + ", " + std::to_string(points) +
                              " points, " + std::to_string(faces) + " faces, seed " +
                              std::to_string(seed),
                          m});
      }
  return result;
}

TEST(Refinement_of_covers, is_delaunay_wherever_it_stops) {
  for (const auto& [name, m] : random_soups())
    for (const std::uint64_t cap : {0U, 1U, 10U, 100U}) {
      Exact t(IT::make_domain(soups::soup(m), Domain_kind::tufted_cover).input);
      const auto r = IT::delaunay_refine(t, parameters::maximum_insertions(cap));
      EXPECT_TRUE(IT::is_delaunay(t)) << name << ", cap " << cap;
      const bool is_stopped = std::ranges::any_of(
          r.unsatisfied, [](const auto& u) { return u.reason == IT::Unsatisfied_reason::stopped; });
      const std::uint64_t n = r.counts.circumcenters + r.counts.segment_splits;
      if (is_stopped) {
        EXPECT_EQ(r.status, IT::Status::cap) << name << ", cap " << cap;
        EXPECT_GE(n, cap) << name;
      }
      expect_rows_are_places(t, m, Domain_kind::tufted_cover, name, r.counts.without_copies);
    }
}

TEST(Refinement_of_covers, is_delaunay_where_a_visitor_stops_it) {
  struct Impatient : IT::Refinement_visitor {
    int calls = 0, last = 1;
    bool progress(const IT::Refinement_counts&) { return ++calls < last; }
  };
  const Mesh m = soups::random_without_repetition(40, 800, 1);
  for (const int last : {1, 2, 3}) {
    Exact t(IT::make_domain(soups::soup(m), Domain_kind::tufted_cover).input);
    Impatient visitor;
    visitor.last = last;
    const auto r =
        IT::delaunay_refine(t, parameters::maximum_circumradius(100).visitor(std::ref(visitor)));
    EXPECT_EQ(r.status, IT::Status::cancelled) << last;
    EXPECT_TRUE(IT::is_delaunay(t)) << last;
  }
}

// Where sheets are refined one by one, a point is on one of them; else it is on two at least. Seams
// that were segments at small angles took more than a hundred times as many, and some of these
// soups reached the cap of a million.
TEST(Refinement_of_covers, needs_about_as_many_points_as_the_sheets_alone) {
  std::size_t points = 0, of_sheets = 0;
  for (const auto& [name, m] : random_soups()) {
    Exact t(IT::make_domain(soups::soup(m), Domain_kind::tufted_cover).input);
    const auto r = IT::delaunay_refine(t, parameters::maximum_insertions(50000));
    expect_good(t, r, 25, name);
    EXPECT_TRUE(IT::is_delaunay(t)) << name;
    const std::size_t n = t.number_of_vertices() - m.points.size(), sheets = points_of_sheets(m);
    EXPECT_LE(n, 2 * sheets + 20) << name;
    points += n;
    of_sheets += sheets;
  }
  EXPECT_LE(points, 2 * of_sheets);
}

// Asks for rows all the time, and now and then whether the answers are right: numbered in the order of the first copies.
struct Row_visitor : IT::Refinement_visitor {
  std::size_t calls = 0, checks = 0;

  template <class T>
  bool is_bad(const T& t, typename T::face_descriptor f) {
    const auto v = target(halfedge(f, t.mesh()), t.mesh());
    EXPECT_LT(t.input_vertex(v), t.number_of_vertices());
    if (++calls % 16 == 0) check(t);
    return false;
  }

private:
  template <class T>
  void check(const T& t) {
    std::map<std::uint32_t, typename T::vertex_descriptor> inserted;
    for (const auto v : vertices(t.mesh()))
      if (t.is_inserted(v)) inserted.emplace(t.index(v), v);
    std::map<Place, std::uint32_t> row;
    for (const auto& [number, v] : inserted) {
      const auto next = static_cast<std::uint32_t>(t.input().number_of_rows() + row.size());
      EXPECT_EQ(t.input_vertex(v), row.emplace(place(t, v), next).first->second) << number;
    }
    checks += inserted.empty() ? 0 : 1;
  }
};

TEST(Refinement_of_covers, tells_rows_at_every_step) {
  for (const auto& [name, m] : soups_of_all_kinds()) {
    SCOPED_TRACE(name);
    Exact t(IT::make_domain(soups::soup(m), Domain_kind::tufted_cover).input);
    Row_visitor visitor;
    const auto r = IT::delaunay_refine(
        t, parameters::maximum_circumradius(0.2 * size_of(m)).visitor(std::ref(visitor)));
    EXPECT_GT(visitor.checks, 3U);
    Exact copy(t);
    EXPECT_EQ(copy.number_of_vertices(), t.number_of_vertices());
    const auto s = IT::delaunay_refine(copy, parameters::maximum_circumradius(0.15 * size_of(m)));
    const std::uint64_t alone = r.counts.without_copies;
    expect_rows_are_places(copy, m, Domain_kind::tufted_cover, "copy",
                           alone + s.counts.without_copies);
    expect_rows_are_places(t, m, Domain_kind::tufted_cover, "original", alone);
  }
}

TEST(Refinement_of_covers, puts_edges_back_that_flips_have_taken_off_seams) {
  for (const auto& [name, m] : soups_of_all_kinds()) {
    Exact t(IT::make_domain(soups::soup(m), Domain_kind::tufted_cover).input);
    IT::flip_to_delaunay(t);
    const auto r = IT::delaunay_refine(t);
    expect_good(t, r, 25, name);
    expect_rows_are_places(t, m, Domain_kind::tufted_cover, name, r.counts.without_copies);
  }
}

TEST(Refinement_of_covers, splits_borders_that_stay_on_both_sheets) {
  for (const auto& [name, m] : std::vector<std::pair<std::string, Mesh>>{
           {"Moebius strip", soups::moebius_strip()}, {"rough grid", meshes::rough_grid(4, 2)}}) {
    Exact t(IT::make_domain(soups::soup(m), Domain_kind::orientation_cover).input);
    const auto r = IT::delaunay_refine(t, parameters::maximum_edge_length(0.3));
    EXPECT_GT(r.counts.segment_splits, 0U) << name;
    expect_good(t, r, 25, name);
    expect_rows_are_places(t, m, Domain_kind::orientation_cover, name);
  }
}

TEST(Refinement_of_covers, refines_both_sheets_of_a_closed_surface_alike) {
  const Mesh m = meshes::potato(2, 5);
  Exact t(IT::make_domain(soups::soup(m), Domain_kind::tufted_cover).input);
  IT::delaunay_refine(t, parameters::minimum_angle(28));
  // the sheets are two surfaces: which one, spread from a face to its neighbours
  std::map<std::uint32_t, int> sheet;
  std::array<std::vector<double>, 2> lengths;
  for (const auto start : faces(t.mesh())) {
    if (sheet.count(t.index(start)) != 0) continue;
    const int number = sheet.empty() ? 0 : 1;
    std::vector<Exact::face_descriptor> stack{start};
    sheet[t.index(start)] = number;
    while (!stack.empty()) {
      auto h = halfedge(stack.back(), t.mesh());
      stack.pop_back();
      for (int k = 0; k < 3; ++k, h = next(h, t.mesh())) {
        lengths[static_cast<std::size_t>(number)].push_back(t.length(edge(h, t.mesh())));
        const auto f = face(opposite(h, t.mesh()), t.mesh());
        if (sheet.insert({t.index(f), number}).second) stack.push_back(f);
      }
    }
  }
  for (auto& l : lengths) std::ranges::sort(l);
  ASSERT_EQ(lengths[0].size(), lengths[1].size());
  EXPECT_EQ(lengths[0].size() + lengths[1].size(), 3 * num_faces(t.mesh()));
  EXPECT_GT(t.number_of_vertices(), m.points.size());
  for (std::size_t i = 0; i < lengths[0].size(); ++i)
    EXPECT_NEAR(lengths[0][i], lengths[1][i], 1e-9);
}

template <class T>
void expect_shared_rows() {
  const Mesh m = soups::book();
  T t(IT::make_domain(soups::soup(m)).input);
  const auto r = IT::delaunay_refine(t, parameters::maximum_edge_length(0.3));
  EXPECT_EQ(r.status, IT::Status::done);
  EXPECT_GT(r.counts.circumcenters, 0U);
  expect_rows_are_places(t, m, Domain_kind::tufted_cover, "book");
}

TEST(Refinement_of_covers, shares_rows_in_doubles_and_with_signposts) {
  expect_shared_rows<Triangulation<IT::Euclidean_traits<double>, IT::Integer_coordinates>>();
  expect_shared_rows<Triangulation<IT::Exact_euclidean_traits, IT::Signposts>>();
}

TEST(Refinement_of_covers, gives_every_vertex_its_row_where_nobody_knows_its_place) {
  Triangulation<IT::Exact_euclidean_traits, IT::No_correspondence> t(
      IT::make_domain(soups::soup(soups::book())).input);
  const auto r = IT::delaunay_refine(t, parameters::maximum_edge_length(0.3));
  EXPECT_EQ(r.status, IT::Status::done);
  EXPECT_EQ(t.number_of_vertices(), soups::book().points.size() + r.counts.inserted_vertices());
}

TEST(Refinement_of_covers, keeps_rows_in_files_and_copies) {
  const Mesh m = soups::book();
  Exact t(IT::make_domain(soups::soup(m)).input);
  IT::delaunay_refine(t, parameters::maximum_edge_length(0.4));
  std::stringstream file;
  IT::write_intrinsic_triangulation(file, t);
  Exact read = IT::read_intrinsic_triangulation<Exact>(file, "file");
  expect_rows_are_places(read, m, Domain_kind::tufted_cover, "file");
  expect_rows_are_places(Exact(t), m, Domain_kind::tufted_cover, "copy");
  // what was read is refined as what was written
  const auto r = IT::delaunay_refine(read, parameters::maximum_edge_length(0.2));
  const auto s = IT::delaunay_refine(t, parameters::maximum_edge_length(0.2));
  EXPECT_EQ(r.counts.circumcenters, s.counts.circumcenters);
  EXPECT_EQ(r.counts.segment_splits, s.counts.segment_splits);
  expect_rows_are_places(read, m, Domain_kind::tufted_cover, "refined");
  EXPECT_EQ(read.number_of_vertices(), t.number_of_vertices());
}

TEST(Refinement_of_covers, copies_functions_to_the_rows_of_inserted_vertices) {
  const Mesh m = soups::book();
  Exact t(IT::make_domain(soups::soup(m)).input);
  IT::delaunay_refine(t, parameters::maximum_edge_length(0.5));
  Eigen::VectorXd x(m.points.size());
  for (std::size_t i = 0; i < m.points.size(); ++i)
    x[static_cast<Eigen::Index>(i)] = 1 + m.points[i][0];
  const Eigen::VectorXd copied = IT::copy_to_intrinsic(t, x);
  ASSERT_EQ(copied.size(), t.number_of_vertices());
  for (const auto v : vertices(t.mesh()))
    if (t.is_inserted(v)) {
      double expected = 1;
      for (const auto& [row, weight] : place(t, v)) expected += weight * m.points[row][0];
      EXPECT_NEAR(copied[t.input_vertex(v)], expected, 1e-12);
    }
}

TEST(Refinement_of_covers, forgets_the_row_with_the_last_copy) {
  const Mesh m = soups::book();
  Exact t(IT::make_domain(soups::soup(m)).input);
  IT::delaunay_refine(t, parameters::maximum_edge_length(0.5));
  const std::uint32_t rows = t.number_of_vertices();
  std::vector<Exact::vertex_descriptor> copies;
  for (const auto v : vertices(t.mesh()))
    if (t.is_inserted(v) && place(t, v).size() == 3 &&
        (copies.empty() || t.input_vertex(v) == t.input_vertex(copies[0])))
      copies.push_back(v);
  ASSERT_EQ(copies.size(), 2U);
  ASSERT_EQ(t.remove_vertex(copies[0]), IT::Move_status::done);
  EXPECT_EQ(t.number_of_vertices(), rows);
  ASSERT_EQ(t.remove_vertex(copies[1]), IT::Move_status::done);
  EXPECT_EQ(t.number_of_vertices(), rows - 1);
  expect_rows_are_places(t, m, Domain_kind::tufted_cover, "book");
}

TEST(Refinement_of_covers, is_adaptive) {
  const Mesh m = soups::book();
  Exact t(IT::make_domain(soups::soup(m)).input);
  const auto largest = [](const Exact& now) {
    std::vector<double> area(now.numbers().face_capacity(now.mesh()), 0);
    for (const auto f : faces(now.mesh())) area[now.index(f)] = now.area(f);
    return area;
  };
  const auto r = IT::adaptive_refine(t, largest, parameters::maximum_vertices(300));
  EXPECT_EQ(r.status, IT::Status::cap);
  EXPECT_EQ(t.number_of_vertices(), 300U) << "copies are counted once";
  EXPECT_EQ(r.rounds.back().vertices, 300U);
  EXPECT_GT(num_vertices(t.mesh()), 300U);
  EXPECT_LT(r.rounds.back().estimated_error, r.rounds.front().estimated_error / 3);
  expect_rows_are_places(t, m, Domain_kind::tufted_cover, "book");
}

} // namespace
