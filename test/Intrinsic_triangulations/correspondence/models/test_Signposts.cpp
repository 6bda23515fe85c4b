// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/follow_signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include "gallery.h"
#include "meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Edge_traces;
using IT::Geodesic_crossing;
using IT::Signposts;
using IT::Surface_point;
using Point = std::array<double, 3>;
using Vector = IT::Plane_vector<double>;
using Exact = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Signposts>;
using Rounded =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>, Signposts>;
static_assert(IT::IntrinsicCorrespondence<Signposts, Rounded>);

constexpr auto none = IT::Gluing::none;

using meshes::distance;

/// A triangulation with the positions of the vertices of its input.
template <class T>
struct Placed {
  T t;
  std::vector<Point> points;

  explicit Placed(const meshes::Mesh& m) : t(input(m)), points(m.points) {
    for (Point& p : points)
      for (double& x : p) x = std::ldexp(x, t.metric().scale_exponent());
  }
  static IT::Intrinsic_input input(const meshes::Mesh& m) {
    IT::Intrinsic_input i = m.input();
    i.may_renumber = false;
    return i;
  }
  const Signposts& signposts() const { return t.correspondence(); }
  Point position(const Surface_point& p) const {
    return meshes::position(signposts().input(), points, p);
  }
  Point position(const Geodesic_crossing& c) const {
    return position(Surface_point{c.halfedge, {1 - c.parameter, c.parameter, 0}});
  }
  Point vertex(std::uint32_t v) const {
    return signposts().is_inserted(v) ? position(signposts().location(v)) : points[v];
  }
};

std::uint32_t crossings_of(const Edge_traces& traces) {
  return static_cast<std::uint32_t>(traces.crossings.size());
}

/// Paths are polylines between the ends, as long as the edges; the directions in space of both
/// parts of a segment agree; nothing is uncertain.
template <class T>
void expect_paths(const Placed<T>& s, const std::string& name) {
  const Edge_traces traces = IT::trace_edges(s.t, s.signposts());
  EXPECT_EQ(traces.failed, 0U) << name << ' ' << traces.first_failed;
  EXPECT_EQ(traces.uncertain, 0U) << name << ' ' << traces.first_uncertain;
  const IT::Intrinsic_view<T> view(s.t);
  double mean = 0;
  for (const auto e : edges(s.t.mesh())) mean += std::sqrt(view.squared_length(s.t.index(e)));
  mean /= static_cast<double>(num_edges(s.t.mesh()));
  for (const auto e : edges(s.t.mesh())) {
    const std::uint32_t i = s.t.index(e);
    Point last = s.vertex(view.source(2 * i));
    double length = 0;
    for (const Geodesic_crossing& c : traces[i]) {
      length += distance(last, s.position(c));
      last = s.position(c);
    }
    length += distance(last, s.vertex(view.target(2 * i)));
    EXPECT_NEAR(length, std::sqrt(view.squared_length(i)), 1e-8 * mean) << name << ' ' << i;
    if (traces.along[i] != none) {
      EXPECT_EQ(traces[i].size(), 0U);
    }
  }
}

/// Points go to the intrinsic triangulation and back, vectors with them.
template <class T>
void expect_round_trips(const Placed<T>& s, int count, double tolerance) {
  const IT::Input& input = s.signposts().input();
  std::mt19937 random(5);
  const auto uniform = [&] { return static_cast<double>(random()) / 0x1p32; };
  for (int i = 0; i < count; ++i) {
    const auto f = static_cast<std::uint32_t>(random() % input.mesh().number_of_faces());
    double a = uniform(), b = uniform();
    if (a + b > 1) a = 1 - a, b = 1 - b;
    const Surface_point p{input.halfedge_of_face(f), {1 - a - b, a, b}};
    const IT::Unscaled_vector v{0.6, 0.8};
    const auto there = IT::tangent_to_intrinsic(s.t, {p, v});
    ASSERT_TRUE(there);
    const auto back = IT::tangent_to_input(s.t, *there);
    ASSERT_TRUE(back);
    ASSERT_LE(distance(s.position(p), s.position(back->point)), tolerance) << i;
    const IT::Unscaled_vector w = back->vector;
    if (back->point.halfedge == p.halfedge) {
      EXPECT_NEAR(w[0], v[0], 10 * tolerance);
      EXPECT_NEAR(w[1], v[1], 10 * tolerance);
    }
  }
}

std::vector<std::pair<std::string, meshes::Mesh>> all_meshes() {
  return {{"grid", meshes::grid(5, 5)},
          {"sheared grid", meshes::sheared_grid(5, 5, 7)},
          {"random planar", meshes::random_planar(200, 1000, 1)},
          {"random planar, fine", meshes::random_planar(300, 1U << 20U, 2)},
          {"parabola", meshes::parabola_fan(20)},
          {"height field", meshes::integer_height_field(10, 8, 3)},
          {"terrain", meshes::integer_terrain(100, 50, 4)},
          {"rough grid", meshes::rough_grid(12, 5)},
          {"box", meshes::box(3, 2, 4)},
          {"sphere", meshes::sphere(3)},
          {"potato", meshes::potato(3, 6)},
          {"l shape", meshes::l_shape(4)},
          {"stairs", meshes::stairs(6, 4, 3)},
          {"folded lattice", meshes::folded_lattice(6, 8, 3)}};
}

/// Whether a flip makes faces that are far from degenerate, so that rounding does not matter.
template <class T>
bool makes_fat_faces(const T& t, typename T::halfedge_descriptor h) {
  if (CGAL::is_border_edge(h, t.mesh())) return false;
  const IT::Diamond d = t.diamond(h);
  const auto l = [&](std::uint32_t e) { return t.metric().approximate_squared_length(e); };
  const auto area = [&](std::uint32_t f) { return t.metric().approximate_quadruple_area(f); };
  const double p_k = l(d.ij) + l(d.ki) - l(d.jk), p_m = l(d.ij) + l(d.im) - l(d.mj);
  const double at_i = p_m * area(d.f) + p_k * area(d.g);
  const double at_j = (2 * l(d.ij) - p_m) * area(d.f) + (2 * l(d.ij) - p_k) * area(d.g);
  return std::min(at_i, at_j) > 1e-3 * l(d.ij) * l(d.ij);
}

/// Inserts, flips, removes and repositions at random. Returns how often each was done.
template <class T>
std::array<int, 6> move_at_random(T& t, int attempts, unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&] { return static_cast<double>(random()) / 0x1p32; };
  std::array<int, 6> done{};
  std::vector<typename T::vertex_descriptor> inserted;
  for (int i = 0; i < attempts; ++i) {
    std::vector<typename T::halfedge_descriptor> all; // elements come and go
    for (const auto h : halfedges(t.mesh()))
      if (face(h, t.mesh()) != boost::graph_traits<typename T::Mesh>::null_face()) all.push_back(h);
    const auto h = all[random() % all.size()];
    double a = uniform(), b = uniform();
    if (a + b > 1) a = 1 - a, b = 1 - b;
    const bool is_thin = t.area(face(h, t.mesh())) < 1e-3; // insertions there make it hopeless
    const auto what = random() % 8;
    if (what < 2 && !is_thin) {
      const auto n = t.insert_vertex(h, {1 - a - b, a, b});
      if (n.status == IT::Move_status::done) inserted.push_back(n.vertex), ++done[0];
    } else if (what == 2 && !is_thin) {
      const bool is_border = CGAL::is_border_edge(h, t.mesh());
      const auto n = t.split_edge(h, 0.25 + a / 2);
      if (n.status == IT::Move_status::done)
        inserted.push_back(n.vertex), ++done[is_border ? 1 : 2];
    } else if (what == 3 && !inserted.empty()) {
      const std::size_t k = random() % inserted.size();
      if (t.remove_vertex(inserted[k]) != IT::Move_status::done) continue;
      inserted[k] = inserted.back();
      inserted.pop_back();
      ++done[3];
    } else if (what == 4 && !inserted.empty() && !is_thin) {
      const std::size_t k = random() % inserted.size();
      const auto n = t.reposition_vertex(inserted[k], h, {1 - a - b, a, b});
      if (n.status == IT::Move_status::done) inserted[k] = n.vertex, ++done[4];
    } else if (makes_fat_faces(t, h) && t.flip_edge(h) == IT::Move_status::done) {
      ++done[5];
    }
  }
  return done;
}

/// Flips edges at random where possible.
template <class T>
std::size_t flip_at_random(T& t, std::size_t attempts, unsigned seed) {
  std::mt19937 random(seed);
  std::size_t done = 0;
  std::vector<typename T::edge_descriptor> all(edges(t.mesh()).begin(), edges(t.mesh()).end());
  for (std::size_t i = 0; i < attempts; ++i) {
    const auto h = halfedge(all[random() % all.size()], t.mesh());
    if (t.flip_edge(h) == IT::Move_status::done) ++done;
  }
  return done;
}

template <class T>
void expect_edges_of_the_input(const Placed<T>& s, const std::string& name) {
  const Edge_traces traces = IT::trace_edges(s.t, s.signposts());
  EXPECT_EQ(crossings_of(traces), 0U) << name;
  EXPECT_TRUE(traces.is_certain()) << name;
  for (std::uint32_t e = 0; e < traces.along.size(); ++e) EXPECT_EQ(traces.along[e], 2 * e) << name;
}

} // namespace

TEST(Signposts, Run_along_the_input_before_the_first_move) {
  for (const auto& [name, mesh] : all_meshes()) {
    const Placed<Rounded> s(mesh);
    expect_edges_of_the_input(s, name);
  }
}

TEST(Signposts, Trace_the_edges_of_Delaunay_triangulations) {
  for (const auto& [name, mesh] : all_meshes()) {
    Placed<Exact> s(mesh);
    IT::flip_to_delaunay(s.t);
    expect_paths(s, name);
  }
}

// Exact: a diamond with a straight angle is not flipped.
TEST(Signposts, Trace_edges_after_random_flips) {
  for (const auto& [name, mesh] : all_meshes()) {
    Placed<Exact> s(mesh);
    EXPECT_GT(flip_at_random(s.t, num_edges(s.t.mesh()), 7), 0U);
    expect_paths(s, name);
  }
}

TEST(Signposts, Return_to_the_input_after_flips_back) {
  for (const auto& [name, mesh] : all_meshes()) {
    Placed<Rounded> s(mesh);
    std::mt19937 random(8);
    std::vector<std::uint32_t> flipped;
    const std::uint32_t n = static_cast<std::uint32_t>(num_edges(s.t.mesh()));
    for (std::uint32_t i = 0; i < n / 2; ++i) {
      const IT::Gluing_map::Halfedge h{2 * static_cast<std::uint32_t>(random() % n)};
      if (s.t.flip_edge(h) == IT::Move_status::done) flipped.push_back(h.index);
    }
    while (!flipped.empty()) {
      for (int k = 0; k < 3; ++k) // four flips are the identity
        ASSERT_EQ(s.t.flip_edge(IT::Gluing_map::Halfedge{flipped.back()}), IT::Move_status::done);
      flipped.pop_back();
    }
    expect_edges_of_the_input(s, name);
  }
}

TEST(Signposts, Take_points_and_vectors_there_and_back) {
  for (const auto& [name, mesh] : all_meshes()) {
    Placed<Exact> s(mesh);
    IT::flip_to_delaunay(s.t);
    SCOPED_TRACE(name);
    expect_round_trips(s, 300, 1e-9);
  }
}

TEST(Signposts, Agree_with_tangent_frames_of_the_intrinsic_triangulation) {
  // The angles between intrinsic halfedges are those of the metric, and fill the circle.
  for (const auto& [name, mesh] : all_meshes()) {
    Placed<Exact> s(mesh);
    IT::flip_to_delaunay(s.t);
    const IT::Intrinsic_view<Exact> view(s.t);
    for (std::uint32_t h = 0; h < 2 * num_edges(s.t.mesh()); ++h) {
      if (view.is_border(h)) continue;
      const IT::Tangent_frames::Fan fan = s.signposts().fan(h);
      const double next = s.signposts().angle(IT::next_around_source(view, h));
      double turn = next - s.signposts().angle(h) - IT::angle_at_source(view, h);
      if (!fan.is_on_border) turn = std::remainder(turn, fan.angle);
      EXPECT_NEAR(turn, 0, 1e-9) << name;
    }
  }
}

TEST(Signposts, Trace_edges_after_all_moves) {
  for (const auto& [name, mesh] : all_meshes()) {
    if (name == "parabola") continue; // angles of 1e-4: rounded metrics do not survive
    Placed<Rounded> s(mesh);
    const std::array<int, 6> done = move_at_random(s.t, 1000, 9);
    for (const std::size_t k : {0, 2, 3, 4, 5}) EXPECT_GT(done[k], 0) << name;
    expect_paths(s, name);
    SCOPED_TRACE(name);
    expect_round_trips(s, 100, 1e-7); // removals flip what they must: some faces are thin
  }
}

TEST(Signposts, Follow_vertices_that_move_within_the_faces_about_them) {
  for (const auto& [name, m] : all_meshes()) {
    if (name == "parabola") continue; // see above
    Placed<Rounded> s(m);
    IT::flip_to_delaunay(s.t);
    std::vector<Rounded::halfedge_descriptor> starts;
    for (const auto f : faces(s.t.mesh())) starts.push_back(halfedge(f, s.t.mesh()));
    std::vector<Rounded::vertex_descriptor> inserted;
    for (std::size_t i = 0; i < starts.size(); i += 3)
      inserted.push_back(s.t.insert_vertex(starts[i], {0.25, 0.25, 0.5}).vertex);
    IT::flip_to_delaunay(s.t);
    std::mt19937 random(7);
    int moved = 0;
    for (int i = 0; i < 200; ++i) {
      const auto v = inserted[random() % inserted.size()];
      auto h = opposite(halfedge(v, s.t.mesh()), s.t.mesh()); // from v
      for (unsigned k = random() % 8; k > 0; --k)
        h = opposite(next(next(h, s.t.mesh()), s.t.mesh()), s.t.mesh());
      const double a = std::ldexp(random() % 1024, -12), b = std::ldexp(random() % 1024, -12);
      const std::array<double, 3> weights{1 - a - b, a, b};
      const auto there =
          IT::locate_on_input(s.t, Surface_point{s.t.numbers().halfedge(h), weights});
      ASSERT_TRUE(there) << name;
      const auto n = s.t.reposition_vertex(v, h, weights);
      if (n.status != IT::Move_status::done) continue; // a thin face
      if (n.vertex != v) {                             // it would not have seen all others
        std::replace(inserted.begin(), inserted.end(), v, n.vertex);
        continue;
      }
      ++moved;
      EXPECT_LE(distance(s.vertex(s.t.index(v)), s.position(*there)), 1e-9) << name;
    }
    EXPECT_GT(moved, 100) << name;
    expect_paths(s, name);
  }
}

TEST(Signposts, Keep_vertices_that_are_inserted_on_input_edges_on_them) {
  for (const auto& [name, mesh] : all_meshes()) {
    Placed<Rounded> s(mesh);
    const auto n = static_cast<std::uint32_t>(num_edges(s.t.mesh()));
    for (std::uint32_t e = 0; e < n; ++e) {
      const auto r = s.t.split_edge(IT::Gluing_map::Halfedge{2 * e}, 0.375);
      if (r.status != IT::Move_status::done) continue; // a thin face
      const Surface_point& p = s.signposts().location(s.t.index(r.vertex));
      EXPECT_EQ(p.halfedge / 2, e) << name;
      EXPECT_EQ(p.weights[2], 0) << name;
      EXPECT_EQ(p.weights[p.halfedge & 1U], 0.625) << name;
    }
    const Edge_traces traces = IT::trace_edges(s.t, s.signposts());
    EXPECT_TRUE(traces.is_certain()) << name;
    std::vector<int> parts(n, 0);
    for (const std::uint32_t h : traces.along)
      if (h != none) ++parts[h / 2];
    for (const int k : parts) EXPECT_EQ(k, 2) << name;
  }
}

TEST(Tangent_frames, Scale_angles_once_to_the_circle_or_on_the_border_to_a_half_circle) {
  const Placed<Rounded> s(meshes::sphere(0)); // four angles of pi / 3 at each vertex
  const IT::Tangent_frames& frames = s.signposts().frames();
  for (std::uint32_t h = 0; h < 24; ++h) {
    EXPECT_NEAR(frames.fan(frames.fan_of(h)).angle, 4 * std::numbers::pi / 3, 1e-15);
    EXPECT_NEAR(std::remainder(frames.polar_angle(h), std::numbers::pi / 2), 0, 1e-15);
  }
  const Placed<Rounded> g(meshes::grid(1, 1));
  for (std::uint32_t h = 0; h < 10; ++h)
    if (g.signposts().input().is_border(h)) {
      EXPECT_NEAR(g.signposts().frames().polar_angle(h), std::numbers::pi, 1e-15);
    }
}

TEST(Signposts, Work_on_the_gallery) {
  for (const gallery::Surface& g : gallery::oriented()) {
    Exact t(gallery::input(g));
    for (unsigned round = 0; round < 5; ++round) {
      flip_at_random(t, 2 * num_edges(t.mesh()), round);
      const Edge_traces traces = IT::trace_edges(t, t.correspondence());
      EXPECT_EQ(traces.failed, 0U) << g.name;
    }
  }
}
