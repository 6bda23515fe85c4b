// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_edge.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include "gallery.h"
#include "meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Edge_crossings;
using IT::Explicit_crossings;
using IT::Integer_coordinates;
using Point = std::array<double, 3>;
using Lists = std::vector<std::vector<std::uint32_t>>;

template <class C, class Mesh = IT::Gluing_map>
using Rounded = IT::Intrinsic_triangulation<Mesh, IT::Euclidean_traits<double>, C>;
template <class C>
using Exact = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, C>;
static_assert(IT::IntrinsicCorrespondence<Explicit_crossings, Rounded<Explicit_crossings>>);
static_assert(std::copyable<Explicit_crossings>);

IT::Intrinsic_input input(const meshes::Mesh& m) {
  IT::Intrinsic_input i = m.input();
  i.may_renumber = false;
  return i;
}

Lists lists_of(const Explicit_crossings& c) {
  Lists lists;
  for (std::uint32_t e = 0; e < c.number_of_edges(); ++e) {
    const std::span<const std::uint32_t> list = c.entered_on(e);
    lists.emplace_back(list.begin(), list.end());
  }
  return lists;
}

std::vector<std::pair<std::string, meshes::Mesh>> all_meshes() {
  return {{"grid", meshes::grid(5, 5)},
          {"sheared grid", meshes::sheared_grid(5, 5, 7)},
          {"random planar", meshes::random_planar(60, 1000, 1)},
          {"parabola", meshes::parabola_fan(20)},
          {"terrain", meshes::integer_terrain(50, 50, 4)},
          {"rough grid", meshes::rough_grid(6, 5)},
          {"box", meshes::box(3, 2, 4)},
          {"sphere", meshes::sphere(2)},
          {"potato", meshes::potato(2, 6)},
          {"walls", meshes::walls({{0, 0}, {3, 0}, {1, 2}}, 4)},
          {"l shape", meshes::l_shape(4)},
          {"stairs", meshes::stairs(6, 4, 3)},
          {"folded lattice", meshes::folded_lattice(4, 6, 3)}};
}

/// The curves are followed with integer coordinates; the lists must say the same.
template <class T, class U>
void expect_same(const T& explicit_one, const U& integer_one, const std::string& name) {
  const Explicit_crossings& c = explicit_one.correspondence();
  const Integer_coordinates& d = integer_one.correspondence();
  ASSERT_EQ(c.number_of_edges(), d.number_of_edges()) << name;
  const Edge_crossings traced = edge_crossings(integer_one, d),
                       read = edge_crossings(explicit_one, c);
  for (std::uint32_t e = 0; e < c.number_of_edges(); ++e) {
    ASSERT_EQ(c.normal_coordinate(e), d.normal_coordinate(e)) << name;
    ASSERT_EQ(c.roundabout(2 * e), d.roundabout(2 * e)) << name;
    ASSERT_EQ(c.roundabout(2 * e + 1), d.roundabout(2 * e + 1)) << name;
    ASSERT_TRUE(std::ranges::equal(c.entered_on(e), traced.entered_on(e))) << name << ' ' << e;
  }
  ASSERT_EQ(read.begin, traced.begin) << name;
  ASSERT_EQ(read.entered, traced.entered) << name;
  ASSERT_EQ(read.curve_begin, traced.curve_begin) << name;
  ASSERT_EQ(read.on_curve, traced.on_curve) << name;
}

/// What a step of random moves did.
struct Step {
  IT::Move_status status;
  std::uint32_t number; // of the new vertex
};

/// Makes the same random moves on triangulations that differ in the correspondence only.
template <class T>
class Mover {
public:
  using Vertex = typename T::vertex_descriptor;
  using Halfedge = typename T::halfedge_descriptor;

  Mover(T& t, unsigned seed) : t_(t), random_(seed) {}

  Step step() {
    const auto move = random_() % 6;
    const Halfedge h = random_halfedge();
    if (move == 0) return added(t_.insert_vertex(h, random_weights()));
    if (move == 1) return added(t_.split_edge(h, 0.1 + 0.8 * uniform()));
    if (move >= 4 || inserted_.empty()) return {t_.flip_edge(h), 0};
    const std::size_t i = random_() % inserted_.size();
    const Vertex v = inserted_[i];
    if (move == 2) {
      const IT::Move_status s = t_.remove_vertex(v);
      if (s == IT::Move_status::done) drop(i);
      return {s, 0};
    }
    const auto n = t_.reposition_vertex(v, h, random_weights());
    if (n.status == IT::Move_status::done) drop(i);
    return added(n);
  }

  const std::vector<Vertex>& inserted() const { return inserted_; }

private:
  double uniform() { return static_cast<double>(random_()) / 0x1p32; }
  std::array<double, 3> random_weights() {
    double x = uniform(), y = uniform();
    if (x + y > 1) x = 1 - x, y = 1 - y;
    return {1 - x - y, x, y};
  }
  void drop(std::size_t i) { inserted_.erase(inserted_.begin() + static_cast<std::ptrdiff_t>(i)); }

  template <class Insertion>
  Step added(const Insertion& n) {
    if (n.status != IT::Move_status::done) return {n.status, 0};
    inserted_.push_back(n.vertex);
    return {n.status, t_.index(n.vertex)};
  }

  // a side of a random face, in proportion to its area
  Halfedge random_halfedge() {
    double total = 0;
    for (const auto f : faces(t_.mesh())) total += t_.area(f);
    double rest = uniform() * total;
    auto chosen = *faces(t_.mesh()).begin();
    for (const auto f : faces(t_.mesh())) {
      chosen = f;
      rest -= t_.area(f);
      if (rest < 0) break;
    }
    Halfedge h = halfedge(chosen, t_.mesh());
    for (auto turns = random_() % 3; turns > 0; --turns) h = next(h, t_.mesh());
    return h;
  }

  T& t_;
  std::mt19937 random_;
  std::vector<Vertex> inserted_;
};

Point place(const std::vector<Point>& points, const std::array<std::uint32_t, 3>& vertex,
            const std::array<double, 3>& weight) {
  Point p{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i)
    if (weight[i] != 0)
      for (std::size_t k = 0; k < 3; ++k) p[k] += weight[i] * points[vertex[i]][k];
  return p;
}

using meshes::distance;

/// A Euclidean surface whose triangulation is observed, and where its vertices are in space.
template <class T>
struct Placed {
  const T& t;
  const std::vector<Point>& points;

  Point position(const IT::Surface_point& p) const {
    const IT::Input& in = t.correspondence().input();
    const std::uint32_t h = p.halfedge;
    return place(points, {in.source(h), in.target(h), in.target(in.next(h))}, p.weights);
  }
  Point vertex(std::uint32_t v) const {
    const auto& c = t.correspondence();
    return c.is_inserted(v) ? position(c.location(v)) : points[v];
  }
};

/// The polyline of crossings in space is as long as the edge, and parameters are arc lengths.
template <class T>
void expect_traces(const T& t, const std::vector<Point>& points, const std::string& name) {
  const IT::Intrinsic_view<T> view(t);
  const Placed<T> placed{t, points};
  double mean = 0;
  for (const auto e : edges(t.mesh())) mean += std::sqrt(t.squared_length(e));
  mean /= static_cast<double>(num_edges(t.mesh()));
  for (const auto e : edges(t.mesh())) {
    const std::uint32_t i = t.index(e);
    const double length = std::sqrt(t.squared_length(e));
    double sum = 0;
    Point last = placed.vertex(view.source(2 * i));
    for (const IT::Path_point& x : trace_edge(t, e).points) {
      const Point p = placed.position(x.on_input);
      sum += distance(last, p);
      last = p;
      EXPECT_NEAR(sum, x.parameter * length, 1e-8 * mean) << name << ' ' << i;
    }
    sum += distance(last, placed.vertex(view.target(2 * i)));
    EXPECT_NEAR(sum, length, 1e-8 * mean) << name << ' ' << i;
  }
}

double area_of_face(const IT::Common_subdivision& s, const std::vector<Point>& places,
                    std::size_t f) {
  const std::span<const std::uint32_t> v = s.face(f);
  Point n{0, 0, 0};
  for (std::size_t i = 1; i + 1 < v.size(); ++i) {
    Point a, b;
    for (std::size_t k = 0; k < 3; ++k) {
      a[k] = places[v[i]][k] - places[v[0]][k];
      b[k] = places[v[i + 1]][k] - places[v[0]][k];
    }
    for (std::size_t k = 0; k < 3; ++k)
      n[k] += a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
  }
  return std::hypot(n[0], n[1], n[2]) / 2;
}

template <class T>
double area_of(const T& t) {
  double area = 0;
  for (const auto f : faces(t.mesh())) area += t.area(f);
  return area;
}

/// The subdivision has the Euler characteristic and the area of the surface.
template <class T>
void expect_subdivision(const T& t, const std::vector<Point>& points, const std::string& name) {
  const IT::Common_subdivision s = IT::common_subdivision(t);
  const auto chi = [](std::size_t v, std::size_t e, std::size_t f) {
    return static_cast<std::ptrdiff_t>(v) - static_cast<std::ptrdiff_t>(e) +
           static_cast<std::ptrdiff_t>(f);
  };
  EXPECT_EQ(chi(s.number_of_vertices(), s.number_of_edges(), s.number_of_faces()),
            chi(num_vertices(t.mesh()), num_edges(t.mesh()), num_faces(t.mesh())))
      << name;
  const std::vector<Point> places = positions(s, points);
  double area = 0;
  for (std::size_t f = 0; f < s.number_of_faces(); ++f) area += area_of_face(s, places, f);
  const double expected = area_of(t);
  EXPECT_NEAR(area, expected, 1e-9 * expected) << name;
}

template <class Mesh>
void move_twins(const std::string& name, const meshes::Mesh& m, unsigned seed, int count) {
  Rounded<Explicit_crossings, Mesh> t(input(m));
  Rounded<Integer_coordinates> u(input(m));
  flip_to_delaunay(t);
  flip_to_delaunay(u);
  expect_same(t, u, name);
  Mover move_t(t, seed);
  Mover move_u(u, seed);
  int done = 0;
  for (int i = 0; i < count; ++i) {
    const Step a = move_t.step(), b = move_u.step();
    ASSERT_EQ(a.status, b.status) << name << " seed " << seed << " move " << i;
    ASSERT_EQ(a.number, b.number) << name << " seed " << seed << " move " << i;
    if (a.status == IT::Move_status::done) ++done;
    if (i % 8 == 0) {
      expect_same(t, u, name + " seed " + std::to_string(seed) + " move " + std::to_string(i));
      if (testing::Test::HasFatalFailure()) return;
    }
  }
  EXPECT_GT(3 * done, count);
  expect_same(t, u, name);
  expect_subdivision(t, m.points, name);
  expect_traces(t, m.points, name);
}

TEST(Explicit_crossings, Are_those_that_integer_coordinates_trace_after_the_same_moves) {
  for (const auto& [name, m] : all_meshes())
    for (const unsigned seed : {1U, 2U}) move_twins<IT::Gluing_map>(name, m, seed, 160);
}

TEST(Explicit_crossings, Give_the_common_subdivision_that_integer_coordinates_give) {
  for (const auto& [name, m] : all_meshes()) {
    Rounded<Explicit_crossings> t(input(m));
    Rounded<Integer_coordinates> u(input(m));
    Mover move_t(t, 3);
    Mover move_u(u, 3);
    for (int i = 0; i < 60; ++i) move_t.step(), move_u.step();
    const IT::Common_subdivision a = IT::common_subdivision(t);
    const IT::Common_subdivision b = IT::common_subdivision(u);
    EXPECT_EQ(a.corner, b.corner) << name;
    EXPECT_EQ(a.face_begin, b.face_begin) << name;
    EXPECT_EQ(a.input_face, b.input_face) << name;
    EXPECT_EQ(a.intrinsic_face, b.intrinsic_face) << name;
    EXPECT_EQ(positions(a, m.points), positions(b, m.points)) << name;
  }
}

TEST(Explicit_crossings, Are_right_on_complexes_that_are_not_simplicial) {
  for (const gallery::Surface& s : gallery::oriented()) {
    const IT::Gluing_map map(s.gluing);
    const std::vector<double> lengths = gallery::squared_lengths(s);
    for (const unsigned seed : {1U, 2U, 3U}) {
      Rounded<Explicit_crossings> t(IT::Intrinsic_input(map, lengths));
      Rounded<Integer_coordinates> u(IT::Intrinsic_input(map, lengths));
      Mover move_t(t, seed);
      Mover move_u(u, seed);
      for (int i = 0; i < 60; ++i) {
        ASSERT_EQ(move_t.step().status, move_u.step().status) << s << ' ' << seed << ' ' << i;
        expect_same(t, u, s.name + " seed " + std::to_string(seed) + " move " + std::to_string(i));
        if (HasFatalFailure()) return;
      }
      const IT::Common_subdivision c = IT::common_subdivision(t);
      EXPECT_EQ(static_cast<std::ptrdiff_t>(c.number_of_vertices() + c.number_of_faces()) -
                    static_cast<std::ptrdiff_t>(c.number_of_edges()),
                s.euler_characteristic())
          << s;
    }
  }
}

template <class T>
void expect_restored_by_flips(T& t, int flips, const std::string& name) {
  const Lists before = lists_of(t.correspondence());
  std::mt19937 random(7);
  std::vector<IT::Gluing_map::Halfedge> flipped;
  for (int i = 0; i < flips; ++i) {
    const IT::Gluing_map::Halfedge h{
        static_cast<std::uint32_t>(random() % t.mesh().number_of_halfedges())};
    if (t.flip_edge(h) == IT::Move_status::done) flipped.push_back(h);
  }
  std::reverse(flipped.begin(), flipped.end());
  for (const IT::Gluing_map::Halfedge h : flipped)
    for (int i = 0; i < 3; ++i) ASSERT_EQ(t.flip_edge(h), IT::Move_status::done) << name;
  EXPECT_EQ(lists_of(t.correspondence()), before) << name;
}

TEST(Explicit_crossings, Are_restored_by_flipping_back) {
  for (const auto& [name, m] : all_meshes()) {
    Exact<Explicit_crossings> t(input(m));
    flip_to_delaunay(t);
    expect_restored_by_flips(t, 40, name);
    Exact<Integer_coordinates> u(input(m));
    flip_to_delaunay(u);
    expect_same(t, u, name);
  }
  for (const gallery::Surface& s : gallery::oriented()) {
    Exact<Explicit_crossings> t(
        IT::Intrinsic_input(IT::Gluing_map(s.gluing), gallery::squared_lengths(s)));
    expect_restored_by_flips(t, 10, s.name);
  }
}

TEST(Explicit_crossings, Are_restored_by_removal) {
  for (const auto& [name, m] : all_meshes()) {
    Rounded<Explicit_crossings> t(input(m));
    flip_to_delaunay(t);
    const Lists before = lists_of(t.correspondence());
    for (const auto h : halfedges(t.mesh())) {
      if (t.mesh().face(h).index == IT::Gluing::none) continue;
      const auto n = t.insert_vertex(h, {0.25, 0.625, 0.125});
      ASSERT_EQ(n.status, IT::Move_status::done);
      ASSERT_EQ(t.remove_vertex(n.vertex), IT::Move_status::done);
      if (t.mesh().face(IT::Gluing_map::opposite(h)).index == IT::Gluing::none) {
        const auto p = t.split_edge(h, 0.25);
        ASSERT_EQ(p.status, IT::Move_status::done);
        ASSERT_EQ(t.remove_vertex(p.vertex), IT::Move_status::done);
      }
      Lists after = lists_of(t.correspondence());
      for (std::size_t e = before.size(); e < after.size(); ++e) ASSERT_TRUE(after[e].empty());
      after.resize(before.size());
      ASSERT_EQ(after, before) << name;
    }
  }
}

TEST(Explicit_crossings, Trace_edges_as_integer_coordinates_do) {
  const meshes::Mesh m = meshes::integer_terrain(80, 60, 9);
  Rounded<Explicit_crossings> t(input(m));
  Rounded<Integer_coordinates> u(input(m));
  flip_to_delaunay(t);
  flip_to_delaunay(u);
  std::size_t count = 0;
  for (const auto e : edges(t.mesh())) {
    const auto a = trace_edge(t, e).points, b = trace_edge(u, e).points;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].on_input.halfedge, b[i].on_input.halfedge);
      EXPECT_EQ(a[i].on_input.weights, b[i].on_input.weights);
      EXPECT_EQ(a[i].parameter, b[i].parameter);
    }
    count += a.size() - 2;
  }
  EXPECT_GT(count, 50U);
}

TEST(Explicit_crossings, Of_a_surface_mesh_are_the_same) {
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  const meshes::Mesh m = meshes::rough_grid(8, 3);
  Rounded<Explicit_crossings, Mesh> t(input(m));
  Rounded<Integer_coordinates> u(input(m));
  flip_to_delaunay(t);
  flip_to_delaunay(u);
  expect_same(t, u, "surface mesh");
  expect_subdivision(t, m.points, "surface mesh");
}

TEST(Explicit_crossings, Are_copied_and_moved) {
  const meshes::Mesh m = meshes::integer_terrain(50, 50, 4);
  Rounded<Explicit_crossings> t(input(m));
  Rounded<Integer_coordinates> u(input(m));
  flip_to_delaunay(t);
  flip_to_delaunay(u);
  Rounded<Explicit_crossings> copy(t);
  Rounded<Integer_coordinates> moved_copy(u);
  Mover a(copy, 5);
  Mover b(moved_copy, 5);
  for (int i = 0; i < 50; ++i) a.step(), b.step();
  expect_same(t, u, "original");
  expect_same(copy, moved_copy, "copy");
  t = std::move(copy);
  expect_same(t, moved_copy, "moved");
}

TEST(Explicit_crossings, Name_the_input_edge_that_an_edge_runs_along) {
  const meshes::Mesh m = meshes::grid(1, 1);
  Rounded<Explicit_crossings> t(input(m));
  const Explicit_crossings& c = t.correspondence();
  for (std::uint32_t h = 0; h < t.mesh().number_of_halfedges(); ++h) EXPECT_EQ(c.along(h), h);
  for (const auto h : halfedges(t.mesh())) {
    if (t.flip_edge(h) != IT::Move_status::done) continue;
    // halfedge h turned clockwise, thus its old opposite crosses it from left to right
    EXPECT_EQ(c.along(h.index), IT::Gluing::none);
    EXPECT_EQ(c.entered_by(h.index, 0), h.index ^ 1U);
    EXPECT_EQ(c.entered_by(h.index ^ 1U, 0), h.index);
    return;
  }
  FAIL();
}

// ---- Ranges for the edges to an inserted vertex, by drawing straight curves in the plane

struct Plane {
  double x, y;
};
double cross(const Plane& a, const Plane& b) { return a.x * b.y - a.y * b.x; }
Plane operator-(const Plane& a, const Plane& b) { return {a.x - b.x, a.y - b.y}; }
Plane between(const Plane& a, const Plane& b, double s) {
  return {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)};
}

/// The end of a curve: position on a side, counted from its source, or side 3 for a corner.
struct End {
  unsigned side;
  int position;
  Plane place;
};
using Curve = std::array<End, 2>;

/// A face and the curves in it.
struct Drawing {
  std::array<Plane, 3> corner{{{0, 0}, {1, 0}, {0.3, 0.8}}};
  std::array<IT::Normal_coordinate, 3> normal;
  std::vector<Curve> curves;
  IT::Corner_coordinates expected;

  End on_side(unsigned k, int position) const {
    const double s = (position + 1.0) / (normal[k] + 1.0);
    return {k, position, between(corner[k], corner[(k + 1) % 3], s)};
  }

  Drawing(const std::array<int, 3>& cutting, unsigned fan, int emanating)
      : expected{cutting, {0, 0, 0}} {
    if (fan < 3) expected.emanating[fan] = emanating;
    for (unsigned k = 0; k < 3; ++k)
      normal[k] = cutting[k] + cutting[(k + 1) % 3] + expected.emanating[(k + 2) % 3];
    for (unsigned k = 0; k < 3; ++k) {
      const unsigned before = (k + 2) % 3;
      for (int i = 0; i < cutting[k]; ++i)
        curves.push_back({on_side(before, normal[before] - 1 - i), on_side(k, i)});
    }
    for (int i = 0; fan < 3 && i < emanating; ++i)
      curves.push_back(
          {End{3, 0, corner[fan]}, on_side((fan + 1) % 3, cutting[(fan + 1) % 3] + i)});
  }

  // whether curve `c` has `p` on the left
  static double left_of(const Curve& c, const Plane& p) {
    return cross(c[1].place - c[0].place, p - c[0].place);
  }

  // arcs come from the last side and leave through the first one of their corner: the corner is on
  // their right; curves of a fan are in the order in which points on the left pass them
  IT::Face_region region(const Plane& p, std::size_t on) const {
    IT::Face_region r;
    for (unsigned k = 0; k < 3; ++k)
      if (expected.emanating[k] > 0) r.fan_corner = k;
    std::size_t i = 0;
    for (unsigned k = 0; k < 3; ++k)
      for (int n = 0; n < expected.cutting[k]; ++n, ++i) {
        if (i == on) r.is_on_curve = true, r.corner = k;
        if (i != on && left_of(curves[i], p) > 0) ++r.cutting[k];
      }
    for (; i < curves.size(); ++i) {
      if (i == on) r.is_on_curve = true, r.corner = r.fan_corner;
      if (i != on && left_of(curves[i], p) > 0) ++r.right_of_fan;
    }
    return r;
  }

  // the ends of curves that the segment from corner `k` to `p` crosses from left to right, each as the
  // end that is ahead
  std::vector<std::array<Plane, 2>> crossed(unsigned k, const Plane& p, std::size_t on) const {
    std::vector<std::pair<double, std::array<Plane, 2>>> found;
    const Plane d = p - corner[k];
    for (std::size_t i = 0; i < curves.size(); ++i) {
      if (i == on || (curves[i][0].side == 3 && cross(curves[i][0].place - corner[k], d) == 0 &&
                      curves[i][0].place.x == corner[k].x))
        continue;
      const Plane a = curves[i][0].place, b = curves[i][1].place;
      const double from = left_of(curves[i], corner[k]), to = left_of(curves[i], p);
      if (from * to >= 0) continue;
      if (cross(d, b - a) < 0)
        found.push_back({from / (from - to), {a, b}});
      else
        found.push_back({from / (from - to), {b, a}});
    }
    std::sort(found.begin(), found.end(),
              [](const auto& x, const auto& y) { return x.first < y.first; });
    std::vector<std::array<Plane, 2>> curves_in_order;
    for (const auto& f : found) curves_in_order.push_back(f.second);
    return curves_in_order;
  }

  // the curve that crosses halfedge `h` of sides 0, 2, 4 from left to right, after `i` others
  std::array<Plane, 2> through(std::uint32_t h, int i) const {
    const unsigned k = h / 2;
    const int position = h % 2 == 0 ? i : normal[k] - 1 - i;
    for (const Curve& c : curves)
      for (std::size_t e = 0; e < 2; ++e)
        if (c[e].side == k && c[e].position == position) {
          const bool ends_there = h % 2 == 0;
          return ends_there ? std::array{c[1 - e].place, c[e].place}
                            : std::array{c[e].place, c[1 - e].place};
        }
    ADD_FAILURE() << "nothing crosses there";
    return {};
  }
};

void expect_spokes(const Drawing& d, const Plane& p, std::size_t on) {
  const IT::Corner_coordinates c = IT::corner_coordinates(d.normal);
  ASSERT_EQ(c.cutting, d.expected.cutting);
  ASSERT_EQ(c.emanating, d.expected.emanating);
  const IT::Face_region r = d.region(p, on);
  const auto normal = IT::inserted_normal_coordinates(c, r);
  for (unsigned k = 0; k < 3; ++k) {
    std::vector<std::array<Plane, 2>> found;
    IT::internal::find_crossings_of_spoke(k, {0, 2, 4}, d.normal, c, r,
                                          [&](std::uint32_t h, int first, int last) {
                                            for (int i = first; i < last; ++i)
                                              found.push_back(d.through(h, i));
                                          });
    const auto expected = d.crossed(k, p, on);
    ASSERT_EQ(found.size(), expected.size());
    ASSERT_EQ(static_cast<int>(found.size()), std::max(0, normal[k]));
    for (std::size_t i = 0; i < found.size(); ++i)
      for (std::size_t e = 0; e < 2; ++e) {
        EXPECT_EQ(found[i][e].x, expected[i][e].x);
        EXPECT_EQ(found[i][e].y, expected[i][e].y);
      }
  }
}

TEST(Spokes, Cross_the_straight_curves_that_separate_the_vertex_from_the_corner) {
  std::mt19937 random(11);
  const auto uniform = [&] { return static_cast<double>(random()) / 0x1p32; };
  for (int trial = 0; trial < 400; ++trial) {
    std::array<int, 3> cutting;
    for (int& n : cutting) n = static_cast<int>(random() % 4);
    const auto fan = static_cast<unsigned>(random() % 4);
    if (fan < 3) cutting[fan] = 0;
    const Drawing d(cutting, fan, fan < 3 ? 1 + static_cast<int>(random() % 4) : 0);
    for (int i = 0; i < 20; ++i) {
      double x = uniform(), y = uniform();
      if (x + y > 1) x = 1 - x, y = 1 - y;
      const Plane p = between(between(d.corner[0], d.corner[1], x / (1 - y)), d.corner[2], y);
      expect_spokes(d, p, d.curves.size());
    }
    for (std::size_t i = 0; i < d.curves.size(); ++i)
      expect_spokes(d, between(d.curves[i][0].place, d.curves[i][1].place, 0.1 + 0.8 * uniform()),
                    i);
    if (HasFatalFailure()) return;
  }
}

// ---- Storage

TEST(Crossing_lists, Keep_what_is_assigned) {
  std::mt19937 random(13);
  IT::internal::Crossing_lists lists(20);
  Lists expected(20);
  for (std::uint32_t n = 0; n < 20000; ++n) {
    if (n % 1000 == 0) {
      expected.emplace_back();
      lists.grow(expected.size());
    }
    const std::size_t i = random() % expected.size();
    expected[i].assign(random() % (random() % 8 == 0 ? 100 : 10), n);
    for (std::uint32_t& x : expected[i]) x += static_cast<std::uint32_t>(random() % 7);
    lists.assign(i, expected[i]);
    if (n % 500 != 0) continue;
    const IT::internal::Crossing_lists copy = lists;
    for (std::size_t j = 0; j < expected.size(); ++j)
      ASSERT_TRUE(std::ranges::equal(copy[j], expected[j])) << n << ' ' << j;
  }
}

} // namespace
