// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/follow_signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_edge.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include "gallery.h"
#include "meshes.h"
#include "refined_meshes.h"
#include "refusals.h"
#include "subdivision_oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Integer_coordinates;
using IT::Signposts;
using subdivision_oracle::Mover;
template <class Traits, class Correspondence>
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, Traits, Correspondence>;
using Exact = IT::Exact_euclidean_traits;
using Rounded = IT::Euclidean_traits<double>;

constexpr auto none = IT::Gluing::none;

std::vector<std::pair<std::string, IT::Intrinsic_input>> inputs() {
  std::vector<std::pair<std::string, IT::Intrinsic_input>> result;
  const auto add = [&](const std::string& name, const meshes::Mesh& m) {
    result.emplace_back(name, m.input());
  };
  add("grid", meshes::grid(4, 4));
  add("sheared grid", meshes::sheared_grid(5, 5, 7));
  add("random planar", meshes::random_planar(60, 1000, 1));
  add("parabola", meshes::parabola_fan(20));
  add("terrain", meshes::integer_terrain(50, 50, 4));
  add("rough grid", meshes::rough_grid(6, 5));
  add("box", meshes::box(3, 2, 4));
  add("potato", meshes::potato(2, 6));
  add("walls", meshes::walls({{0, 0}, {3, 0}, {1, 2}}, 4));
  add("stairs", meshes::stairs(6, 4, 3));
  add("folded lattice", meshes::folded_lattice(4, 6, 3));
  for (const gallery::Surface& s : gallery::oriented())
    result.emplace_back(s.name, gallery::input(s));
  for (auto& [name, input] : result) input.may_renumber = false;
  return result;
}

/// One triangulation with two representations.
template <class Traits>
struct Twins {
  Triangulation<Traits, Integer_coordinates> integer;
  Triangulation<Traits, Signposts> signposts;

  explicit Twins(const IT::Intrinsic_input& i) : integer(i), signposts(i) {}
  void flip_to_delaunay() {
    IT::flip_to_delaunay(integer);
    IT::flip_to_delaunay(signposts);
  }
  /// whether both made the same moves
  bool move(int count, unsigned seed, bool with_vertices) {
    Mover first(integer, seed);
    Mover second(signposts, seed);
    for (int i = 0; i < count; ++i) {
      if (with_vertices) {
        move_alike(first, integer);
        move_alike(second, signposts);
      } else {
        if (integer.flip_edge({first.halfedge(false)}) !=
            signposts.flip_edge({second.halfedge(false)}))
          return false;
      }
    }
    return first.statuses == second.statuses;
  }
  /// Signposts follow vertices within their stars, integer coordinates do not: both insert and
  /// remove.
  template <class T>
  static void move_alike(Mover<T>& mover, T& t) {
    mover.move(
        true, [&](std::uint32_t h, const auto& w) { return t.insert_vertex({h}, w); },
        [&](IT::Gluing_map::Vertex v, std::uint32_t h, const auto& w) {
          auto n = t.insert_vertex({h}, w);
          if (n.status != IT::Move_status::done) return n;
          n.status = t.remove_vertex(v);
          if (n.status != IT::Move_status::done) t.remove_vertex(n.vertex);
          return n;
        });
  }
  /// what tracing finds, unless it is refused
  std::optional<Integer_coordinates> read() const {
    try {
      return integer_coordinates(signposts, signposts.correspondence());
    } catch (const IT::Invalid_input& e) {
      EXPECT_EQ(e.kind(), IT::Element_kind::edge);
      EXPECT_LT(e.index(), integer.correspondence().number_of_edges());
      return {};
    }
  }
};

/// The input halfedge that curves counterclockwise from an intrinsic halfedge begin with, and those
/// that cross it: both representations number the slots of inserted vertices as they come.
template <class T>
void expect_equal(const T& t, const Integer_coordinates& expected, const Integer_coordinates& found,
                  const std::string& name) {
  const IT::Intrinsic_view<T> view(t);
  for (const auto d : edges(t.mesh())) {
    const std::uint32_t e = t.index(d);
    ASSERT_EQ(found.normal_coordinate(e), expected.normal_coordinate(e)) << name << ' ' << e;
    for (const std::uint32_t h : {2 * e, 2 * e + 1}) {
      const std::uint32_t a = expected.roundabout(h), b = found.roundabout(h);
      ASSERT_EQ(a == none, b == none) << name << ' ' << h;
      if (a == none) continue;
      if (!expected.is_inserted(view.source(h))) {
        EXPECT_EQ(a, b) << name << ' ' << h;
      }
      EXPECT_EQ(expected.fans().halfedge(a), found.fans().halfedge(b)) << name << ' ' << h;
    }
  }
}

void expect_equal(const IT::Common_subdivision& a, const IT::Common_subdivision& b,
                  const std::string& name) {
  EXPECT_EQ(a.number_of_vertices(), b.number_of_vertices()) << name;
  EXPECT_EQ(a.face_begin, b.face_begin) << name;
  EXPECT_EQ(a.corner, b.corner) << name;
  EXPECT_EQ(a.input_face, b.input_face) << name;
  EXPECT_EQ(a.intrinsic_face, b.intrinsic_face) << name;
}

template <class Traits>
void expect_equal_subdivisions_of_delaunay_triangulations() {
  for (const auto& [name, input] : inputs()) {
    Twins<Traits> t(input);
    t.flip_to_delaunay();
    expect_equal(IT::common_subdivision(t.integer), IT::common_subdivision(t.signposts), name);
  }
}

TEST(Signpost_subdivision, Is_that_of_integer_coordinates_after_flips_to_Delaunay) {
  expect_equal_subdivisions_of_delaunay_triangulations<Exact>();
  expect_equal_subdivisions_of_delaunay_triangulations<Rounded>();
}

TEST(Signpost_subdivision, Is_that_of_integer_coordinates_after_random_flips) {
  for (const auto& [name, input] : inputs()) {
    Twins<Exact> t(input);
    ASSERT_TRUE(t.move(25, 7, false)) << name;
    const auto found = t.read();
    if (found) expect_equal(t.integer, t.integer.correspondence(), *found, name);
  }
}

TEST(Signpost_subdivision, Is_right_or_refused_after_random_moves) {
  int accepted = 0, all = 0;
  for (const auto& [name, input] : inputs())
    for (const unsigned seed : {1U, 2U, 3U}) {
      Twins<Rounded> t(input);
      t.flip_to_delaunay();
      if (!t.move(60, seed, true)) continue; // doubles led the two apart
      ++all;
      const auto found = t.read();
      if (!found) continue;
      ++accepted;
      expect_equal(t.integer, t.integer.correspondence(), *found, name);
      expect_equal(IT::common_subdivision(t.integer), IT::common_subdivision(t.signposts), name);
    }
  EXPECT_GT(2 * accepted, all) << all;
  RecordProperty("accepted", accepted);
  RecordProperty("all", all);
}

/// Edges of either triangulation, traced one by one after many flips of doubles: whatever is said to be done has the
/// points that integer coordinates, which flips do not round, find.
TEST(Signpost_paths, Are_said_to_be_done_only_where_rounding_decided_nothing) {
  std::size_t done = 0, inaccurate = 0, wrong = 0;
  const auto compare = [&](const IT::Edge_path& expected, const IT::Edge_path& found,
                           const std::string& name) {
    if (found.status == IT::Status::not_traceable) return;
    ASSERT_EQ(expected.status, IT::Status::done) << name;
    if (found.status == IT::Status::done) {
      ++done;
      EXPECT_EQ(found.points.size(), expected.points.size()) << name;
    } else {
      EXPECT_EQ(found.status, IT::Status::inaccurate) << name;
      ++inaccurate;
      wrong += found.points.size() == expected.points.size() ? 0 : 1;
    }
  };
  for (const auto& [name, input] : inputs())
    for (const unsigned seed : {22U, 24U}) {
      Twins<Rounded> t(input);
      if (!t.move(40, seed, false)) continue; // doubles led the two apart
      for (std::uint32_t x = 0; x < t.integer.input().number_of_halfedges(); ++x)
        compare(IT::trace_input_edge(t.integer, x), IT::trace_input_edge(t.signposts, x), name);
      for (const auto e : edges(t.integer.mesh()))
        compare(IT::trace_edge(t.integer, e), IT::trace_edge(t.signposts, e), name);
    }
  EXPECT_GT(done, 100 * inaccurate);
  RecordProperty("wrong", std::to_string(wrong));
}

TEST(Signpost_subdivision, Is_found_after_exact_moves_of_vertices) {
  int accepted = 0, all = 0;
  for (const auto& [name, input] : inputs()) {
    Twins<Exact> t(input);
    t.flip_to_delaunay();
    ASSERT_TRUE(t.move(12, 5, true)) << name;
    ++all;
    const auto found = t.read();
    if (!found) continue;
    ++accepted;
    expect_equal(t.integer, t.integer.correspondence(), *found, name);
  }
  EXPECT_EQ(accepted, all);
  RecordProperty("accepted", accepted);
  RecordProperty("all", all);
}

TEST(Signpost_subdivision, Is_that_of_integer_coordinates_after_exact_refinement) {
  std::size_t on_edges = 0;
  for (const auto& [name, mesh] : refined::cut_by_parallels()) {
    Twins<Exact> t(mesh.input());
    t.flip_to_delaunay();
    IT::delaunay_refine(t.integer, IT::parameters::minimum_angle(25.));
    IT::delaunay_refine(t.signposts, IT::parameters::minimum_angle(25.));
    const Signposts& s = t.signposts.correspondence();
    for (const auto v : vertices(t.integer.mesh())) {
      if (!t.integer.is_inserted(v)) continue;
      const IT::Surface_point &p = t.integer.correspondence().location(t.integer.index(v)),
                              &q = s.location(t.integer.index(v));
      EXPECT_EQ(p.halfedge, q.halfedge) << name;
      EXPECT_EQ(p.weights, q.weights) << name;
      on_edges += p.weights[2] == 0 ? 1 : 0;
    }
    EXPECT_TRUE(IT::trace_edges(t.signposts, s).is_certain()) << name;
    const auto found = t.read();
    ASSERT_TRUE(found) << name;
    expect_equal(t.integer, t.integer.correspondence(), *found, name);
    expect_equal(IT::common_subdivision(t.integer), IT::common_subdivision(t.signposts), name);
  }
  EXPECT_GT(on_edges, 30U);
}

// ---- errors are refused

/// Signposts that were turned by an angle.
struct Turned_signposts {
  const Signposts& original;
  std::uint32_t turned;
  double by;

  const IT::Input& input() const { return original.input(); }
  auto shared_input() const { return original.shared_input(); }
  bool is_inserted(std::uint32_t v) const { return original.is_inserted(v); }
  const IT::Surface_point& location(std::uint32_t v) const { return original.location(v); }
  IT::Geodesic_target target(std::uint32_t v) const { return original.target(v); }
  auto walk(std::uint32_t h, double turn = 0) const {
    return original.walk(h, h / 2 == turned ? turn + by : turn);
  }
};

TEST(Signpost_subdivision, Names_the_edge_whose_signposts_are_wrong) {
  Triangulation<Exact, Signposts> t(meshes::potato(2, 6).input());
  flip_to_delaunay(t);
  for (std::uint32_t e = 0; e < num_edges(t.mesh()); e += 5) {
    const Turned_signposts wrong{t.correspondence(), e, 0.01};
    refusals::expect_invalid([&] { integer_coordinates(t, wrong); }, IT::Element_kind::edge, e,
                             {"use integer coordinates"});
  }
}

/// Coordinates in parts.
struct Parts {
  std::shared_ptr<const IT::Input> input;
  IT::Vertex_fans fans;
  std::vector<IT::Normal_coordinate> normal;
  std::vector<std::uint32_t> roundabout;
  std::vector<IT::Surface_point> location;

  template <class T>
  explicit Parts(const T& t) : input(t.correspondence().shared_input()) {
    const Integer_coordinates c = integer_coordinates(t, t.correspondence());
    fans = c.fans();
    for (std::uint32_t e = 0; e < c.number_of_edges(); ++e) {
      normal.push_back(c.normal_coordinate(e));
      roundabout.push_back(c.roundabout(2 * e));
      roundabout.push_back(c.roundabout(2 * e + 1));
    }
    for (const auto d : vertices(t.mesh())) {
      const std::uint32_t v = t.index(d);
      if (!c.is_inserted(v)) continue;
      location.resize(std::max<std::size_t>(location.size(), v + 1 - input->number_of_vertices()));
      location[v - input->number_of_vertices()] = c.location(v);
    }
  }
  template <class T>
  std::uint32_t first_bad_edge(const T& t) const {
    const Integer_coordinates c(input, fans, normal, roundabout, location);
    const std::uint32_t bad = first_inconsistent_edge(t, c);
    return bad != none ? bad : first_wrong_length(t, c);
  }
};

template <class Check>
void for_some_triangulations(Check check) {
  for (const auto& m : {meshes::sheared_grid(4, 4, 5), meshes::rough_grid(4, 5),
                        meshes::potato(1, 6), meshes::random_planar(20, 1000, 1)}) {
    Triangulation<Exact, Signposts> t(m.input());
    flip_to_delaunay(t);
    Mover mover(t, 3);
    for (int i = 0; i < 8; ++i) mover.move(true);
    const Parts right(t);
    ASSERT_EQ(right.first_bad_edge(t), none);
    check(t, right);
  }
}

TEST(Coordinate_check, Finds_every_wrong_roundabout) {
  for_some_triangulations([](const auto& t, const Parts& right) {
    for (std::size_t h = 0; h < right.roundabout.size(); ++h) {
      const std::uint32_t slot = right.roundabout[h];
      if (slot == none) continue;
      for (const std::uint32_t wrong : {right.fans.advance(slot, 1), none}) {
        if (wrong == slot) continue; // the only one
        Parts p = right;
        p.roundabout[h] = wrong;
        EXPECT_NE(p.first_bad_edge(t), none) << h;
      }
    }
  });
}

TEST(Coordinate_check, Finds_every_crossing_too_few) {
  for_some_triangulations([](const auto& t, const Parts& right) {
    for (std::uint32_t e = 0; e < right.normal.size(); ++e)
      if (right.normal[e] > 0) {
        Parts p = right;
        --p.normal[e];
        EXPECT_NE(p.first_bad_edge(t), none) << e;
      }
  });
}

TEST(Coordinate_check, Finds_every_inserted_vertex_in_a_wrong_place) {
  int vertices_inside = 0;
  for_some_triangulations([&](const auto& t, const Parts& right) {
    for (const auto d : vertices(t.mesh())) {
      if (!t.is_inserted(d)) continue;
      Parts p = right;
      IT::Surface_point& x = p.location[t.index(d) - right.input->number_of_vertices()];
      if (!(x.weights[0] > 0.01)) continue;
      x.weights[0] -= 0.001;
      x.weights[1] += 0.001;
      EXPECT_NE(p.first_bad_edge(t), none);
      ++vertices_inside;
    }
  });
  EXPECT_GT(vertices_inside, 3);
}

} // namespace
