// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/moves.h>

#include "gallery.h"
#include "mesh_types.h"
#include "meshes.h"
#include "validity.h"

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/signed_incidence.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Gluing;

namespace {

// A mesh, its numbering, and how many vertices, edges and faces it must have: now, and at most so far.
template <class Mesh>
struct Complex {
  using Traits = boost::graph_traits<Mesh>;
  using Vertex = typename Traits::vertex_descriptor;
  using Halfedge = typename Traits::halfedge_descriptor;
  using Edge = typename Traits::edge_descriptor;
  using Face = typename Traits::face_descriptor;
  using Counts = std::array<std::uint32_t, 3>;

  explicit Complex(const gallery::Surface& s)
      : mesh(built(s)),
        numbers(mesh), count{s.expected.vertices, s.expected.edges, s.expected.faces}, most(count) {
  }
  Complex(const Complex& other)
      : mesh(other.mesh), numbers(mesh, other.numbers, other.mesh), count(other.count),
        most(other.most) {}

  static Mesh built(const gallery::Surface& s) {
    Mesh result;
    IT::copy_gluing_map(IT::Gluing_map(s.gluing), result);
    return result;
  }

  Vertex insert_in_face(Halfedge h) {
    grow(1, 3, 2);
    return IT::split_face(h, mesh, numbers);
  }
  Vertex insert_in_border_edge(Halfedge h) {
    grow(1, 2, 1);
    return IT::split_border_edge(h, mesh, numbers);
  }
  void remove_from_face(Halfedge h) {
    IT::remove_degree_3_vertex(h, mesh, numbers);
    count = {count[0] - 1, count[1] - 3, count[2] - 2};
  }
  void remove_from_border(Halfedge h) {
    IT::remove_border_vertex(h, mesh, numbers);
    count = {count[0] - 1, count[1] - 2, count[2] - 1};
  }
  void grow(std::uint32_t v, std::uint32_t e, std::uint32_t f) {
    count = {count[0] + v, count[1] + e, count[2] + f};
    for (std::size_t k = 0; k < 3; ++k) most[k] = std::max(most[k], count[k]);
  }

  bool is_border(Halfedge h) const { return face(h, mesh) == Traits::null_face(); }
  std::vector<Halfedge> all() const {
    std::vector<Halfedge> result;
    for (const Halfedge h : halfedges(mesh)) result.push_back(h);
    return result;
  }

  Mesh mesh;
  IT::Mesh_adaptor<Mesh> numbers;
  Counts count, most;
};

// next, target and face of every halfedge, by numbers
using Snapshot = std::map<std::uint32_t, std::array<std::uint32_t, 3>>;

template <class Mesh>
Snapshot snapshot(const Complex<Mesh>& c) {
  Snapshot result;
  for (const auto h : c.all())
    result[c.numbers.halfedge(h)] = {
        c.numbers.halfedge(next(h, c.mesh)), c.numbers.vertex(target(h, c.mesh)),
        c.is_border(h) ? Gluing::none : c.numbers.face(face(h, c.mesh))};
  return result;
}

// halfedges that point to each vertex, by its number
template <class Mesh>
std::map<std::uint32_t, std::uint32_t> degrees(const Complex<Mesh>& c) {
  std::map<std::uint32_t, std::uint32_t> result;
  for (const auto h : c.all()) ++result[c.numbers.vertex(target(h, c.mesh))];
  return result;
}

template <class Mesh>
void expect_numbers_fit(const Complex<Mesh>& c) {
  for (const auto v : vertices(c.mesh)) {
    EXPECT_EQ(c.numbers.vertex_at(c.numbers.vertex(v)), v);
    EXPECT_LT(c.numbers.vertex(v), c.numbers.vertex_capacity(c.mesh));
  }
  for (const auto f : faces(c.mesh)) {
    EXPECT_EQ(c.numbers.face_at(c.numbers.face(f)), f);
    EXPECT_LT(c.numbers.face(f), c.numbers.face_capacity(c.mesh));
  }
  for (const auto h : c.all()) {
    EXPECT_EQ(c.numbers.halfedge_at(c.numbers.halfedge(h)), h);
    EXPECT_EQ(c.numbers.halfedge(opposite(h, c.mesh)), c.numbers.halfedge(h) ^ 1U);
    EXPECT_LT(c.numbers.halfedge(h) / 2, c.numbers.edge_capacity(c.mesh));
  }
  // no number is taken while one is free
  EXPECT_EQ(c.numbers.vertex_capacity(c.mesh), c.most[0]);
  EXPECT_EQ(c.numbers.edge_capacity(c.mesh), c.most[1]);
  EXPECT_EQ(c.numbers.face_capacity(c.mesh), c.most[2]);
}

template <class Range>
std::uint32_t length_of(const Range& range) {
  return static_cast<std::uint32_t>(std::distance(range.begin(), range.end()));
}

template <class Mesh>
void expect_sound(const Complex<Mesh>& c) {
  ASSERT_EQ(IT::delta_complex_defect(c.mesh).value_or("none"), "none");
  EXPECT_EQ(length_of(vertices(c.mesh)), c.count[0]);
  EXPECT_EQ(length_of(edges(c.mesh)), c.count[1]);
  EXPECT_EQ(length_of(halfedges(c.mesh)), 2 * c.count[1]);
  EXPECT_EQ(length_of(faces(c.mesh)), c.count[2]);
  expect_numbers_fit(c);
  for (const auto h : c.all())
    if (c.is_border(h)) {
      EXPECT_TRUE(c.is_border(halfedge(target(h, c.mesh), c.mesh)));
    }
}

// whether the third corner of the face of h is a vertex with three edges, none a loop, and no border
template <class Mesh>
bool is_opposite_degree_3(const Complex<Mesh>& c, typename Complex<Mesh>::Halfedge h) {
  if (c.is_border(h)) return false;
  const auto p = target(next(h, c.mesh), c.mesh);
  const auto first = next(h, c.mesh); // turn about p, whose edges may form several umbrellas
  auto turned = first;
  for (int k = 0; k < 3; ++k) {
    if (c.is_border(turned) || (k > 0 && turned == first)) return false;
    turned = opposite(next(turned, c.mesh), c.mesh);
  }
  if (turned != first) return false;
  std::uint32_t degree = 0;
  for (const auto g : c.all()) {
    if (target(g, c.mesh) != p) continue;
    ++degree;
    if (c.is_border(g) || c.is_border(opposite(g, c.mesh)) || source(g, c.mesh) == p) return false;
  }
  return degree == 3;
}

// whether h runs along the border to a vertex with three edges, none a loop, one of them inside
template <class Mesh>
bool runs_to_removable_border_vertex(const Complex<Mesh>& c, typename Complex<Mesh>::Halfedge h) {
  if (c.is_border(h) || !c.is_border(opposite(h, c.mesh))) return false;
  const auto p = target(h, c.mesh);
  if (c.is_border(opposite(next(h, c.mesh), c.mesh))) return false; // saves most of the counting
  std::uint32_t degree = 0, inside = 0;
  for (const auto g : c.all()) {
    if (target(g, c.mesh) != p) continue;
    ++degree;
    if (source(g, c.mesh) == p) return false;
    inside += c.is_border(g) || c.is_border(opposite(g, c.mesh)) ? 0 : 1;
  }
  return degree == 3 && inside == 1;
}

template <class Mesh>
bool can_flip(const Complex<Mesh>& c, typename Complex<Mesh>::Halfedge h) {
  const auto o = opposite(h, c.mesh);
  return !c.is_border(h) && !c.is_border(o) && face(h, c.mesh) != face(o, c.mesh);
}

using Random = std::mt19937;

template <class Mesh>
typename Complex<Mesh>::Halfedge random_halfedge(const Complex<Mesh>& c, Random& random) {
  const auto all = c.all();
  return all[random() % all.size()];
}

// removes the vertex opposite a halfedge or, at the border, the first one that can be removed along it
template <class Mesh>
bool remove_near(Complex<Mesh>& c, typename Complex<Mesh>::Halfedge h) {
  if (is_opposite_degree_3(c, h)) {
    c.remove_from_face(h);
    return true;
  }
  if (!c.is_border(h)) return false;
  for (auto b = next(h, c.mesh); b != h; b = next(b, c.mesh))
    if (runs_to_removable_border_vertex(c, opposite(b, c.mesh))) {
      c.remove_from_border(opposite(b, c.mesh));
      return true;
    }
  return false;
}

// makes a move if the one that was drawn can be made; from 60 faces on no insertions are drawn
template <class Mesh>
bool make_random_move(Complex<Mesh>& c, Random& random) {
  const auto h = random_halfedge(c, random);
  switch (random() % (c.count[2] > 60 ? 3 : 5)) {
  case 0:
    if (!can_flip(c, h)) return false;
    CGAL::Euler::flip_edge(h, c.mesh);
    return true;
  case 1:
  case 2:
    return remove_near(c, h);
  default:
    if (c.is_border(h))
      c.insert_in_border_edge(opposite(h, c.mesh));
    else
      c.insert_in_face(h);
    return true;
  }
}

} // namespace

template <class Mesh>
class Moves : public ::testing::Test {};
TYPED_TEST_SUITE(Moves, All_meshes);

TYPED_TEST(Moves, insertion_in_a_face_joins_the_vertex_to_its_corners) {
  for (const gallery::Surface& s : gallery::oriented()) {
    const std::size_t sides = 2 * std::size_t{s.expected.edges};
    for (std::size_t i = 0; i < sides; ++i) {
      SCOPED_TRACE(s.name + ", halfedge " + std::to_string(i));
      Complex<TypeParam> c(s);
      const auto ij = c.all()[i];
      if (c.is_border(ij)) continue;
      const auto& m = c.mesh;
      const auto jk = next(ij, m), ki = next(jk, m);
      const auto vi = target(ki, m), vj = target(ij, m), vk = target(jk, m);
      const auto f = face(ij, m);
      auto degree = degrees(c);
      const auto p = c.insert_in_face(ij);
      expect_sound(c);
      gallery::expect_topology(c.mesh, s);
      EXPECT_EQ(target(next(ij, m), m), p);
      EXPECT_EQ(face(ij, m), f);
      const std::array outer{ij, jk, ki};
      const std::array start{vi, vj, vk}, end{vj, vk, vi};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto to_p = next(outer[k], m), from_p = next(to_p, m);
        EXPECT_EQ(target(outer[k], m), end[k]);
        EXPECT_EQ(target(to_p, m), p);
        EXPECT_EQ(target(from_p, m), start[k]);
        EXPECT_EQ(opposite(to_p, m), next(next(outer[(k + 1) % 3], m), m));
        EXPECT_NE(face(outer[k], m), face(outer[(k + 1) % 3], m));
      }
      for (const auto v : start) ++degree[c.numbers.vertex(v)];
      degree[c.numbers.vertex(p)] = 3;
      EXPECT_EQ(degrees(c), degree);
    }
  }
}

TYPED_TEST(Moves, insertion_in_a_border_edge_joins_the_vertex_to_the_opposite_corner) {
  std::size_t inserted = 0;
  for (const gallery::Surface& s : gallery::oriented()) {
    const std::size_t sides = 2 * std::size_t{s.expected.edges};
    for (std::size_t i = 0; i < sides; ++i) {
      SCOPED_TRACE(s.name + ", halfedge " + std::to_string(i));
      Complex<TypeParam> c(s);
      const auto& m = c.mesh;
      const auto ij = c.all()[i];
      if (c.is_border(ij) || !c.is_border(opposite(ij, m))) continue;
      ++inserted;
      const auto jk = next(ij, m), ki = next(jk, m);
      const auto vi = target(ki, m), vj = target(ij, m), vk = target(jk, m);
      const auto f = face(ij, m);
      auto degree = degrees(c);
      const auto p = c.insert_in_border_edge(ij);
      expect_sound(c);
      gallery::expect_topology(c.mesh, s);
      EXPECT_EQ(target(ij, m), p);
      EXPECT_EQ(face(ij, m), f);
      EXPECT_EQ(target(opposite(ij, m), m), vi);
      EXPECT_EQ(target(next(ij, m), m), vk);
      EXPECT_EQ(next(next(ij, m), m), ki);
      const auto pj = next(opposite(next(ij, m), m), m);
      EXPECT_EQ(target(pj, m), vj);
      EXPECT_EQ(next(pj, m), jk);
      EXPECT_TRUE(c.is_border(opposite(pj, m)));
      EXPECT_EQ(next(opposite(pj, m), m), opposite(ij, m));
      EXPECT_EQ(halfedge(p, m), opposite(pj, m));
      ++degree[c.numbers.vertex(vk)];
      degree[c.numbers.vertex(p)] = 3;
      EXPECT_EQ(degrees(c), degree);
    }
  }
  EXPECT_GT(inserted, 20U);
}

TYPED_TEST(Moves, removal_after_insertion_restores_the_complex) {
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name);
    Complex<TypeParam> c(s);
    const Snapshot before = snapshot(c);
    for (const auto h : c.all()) {
      if (c.is_border(h)) continue;
      c.insert_in_face(h);
      c.remove_from_face(h);
      EXPECT_EQ(snapshot(c), before);
      expect_sound(c);
      if (!c.is_border(opposite(h, c.mesh))) continue;
      c.insert_in_border_edge(h);
      c.remove_from_border(h);
      EXPECT_EQ(snapshot(c), before);
      expect_sound(c);
    }
  }
}

TYPED_TEST(Moves, removal_by_any_side_keeps_the_face_of_that_side) {
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name);
    for (int turns = 1; turns < 3; ++turns) {
      Complex<TypeParam> c(s);
      Snapshot expected = snapshot(c);
      auto h = c.all()[0];
      if (c.is_border(h)) h = opposite(h, c.mesh);
      const std::array sides{h, next(h, c.mesh), next(next(h, c.mesh), c.mesh)};
      c.insert_in_face(h);
      const auto side = sides[static_cast<std::size_t>(turns)];
      const auto f = face(side, c.mesh);
      for (const auto x : sides) expected[c.numbers.halfedge(x)][2] = c.numbers.face(f);
      c.remove_from_face(side);
      EXPECT_EQ(face(side, c.mesh), f);
      EXPECT_EQ(snapshot(c), expected);
      expect_sound(c);
      gallery::expect_topology(c.mesh, s);
    }
  }
}

TYPED_TEST(Moves, random_insertions_removals_and_flips_keep_the_complex_valid_and_without_gaps) {
  int removed_from_face = 0, removed_from_border = 0;
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name + ", seed 1");
    Random random(1);
    Complex<TypeParam> c(s);
    for (int made = 0; made < 1000;) {
      const auto before = c.count;
      if (!make_random_move(c, random)) continue;
      removed_from_face += c.count[1] + 3 == before[1] ? 1 : 0;
      removed_from_border += c.count[1] + 2 == before[1] ? 1 : 0;
      if (++made % 40 != 0 && made > 40) continue;
      expect_sound(c);
      gallery::expect_topology(c.mesh, s);
      if (::testing::Test::HasFailure()) return;
    }
  }
  EXPECT_GT(removed_from_face, 1000);
  EXPECT_GT(removed_from_border, 40);
}

TYPED_TEST(Moves, insertions_and_flips_are_undone_backwards) {
  enum Kind { flip, in_face, in_border };
  for (const gallery::Surface& s : gallery::oriented())
    for (const unsigned seed : {3U, 4U}) {
      SCOPED_TRACE(s.name + ", seed " + std::to_string(seed));
      Random random(seed);
      Complex<TypeParam> c(s);
      const Snapshot before = snapshot(c);
      std::vector<std::pair<Kind, std::uint32_t>> made;
      while (made.size() < 150) {
        auto h = random_halfedge(c, random);
        if (random() % 3 != 0) {
          if (!can_flip(c, h)) continue;
          CGAL::Euler::flip_edge(h, c.mesh);
          made.emplace_back(flip, c.numbers.halfedge(h));
        } else if (c.is_border(h)) {
          h = opposite(h, c.mesh);
          c.insert_in_border_edge(h);
          made.emplace_back(in_border, c.numbers.halfedge(h));
        } else {
          c.insert_in_face(h);
          made.emplace_back(in_face, c.numbers.halfedge(h));
        }
      }
      expect_sound(c);
      for (auto move = made.rbegin(); move != made.rend(); ++move) {
        const auto h = c.numbers.halfedge_at(move->second);
        if (move->first == in_face) c.remove_from_face(h);
        if (move->first == in_border) c.remove_from_border(h);
        if (move->first != flip) continue;
        if (random() % 2 == 0)
          IT::flip_edge_back(h, c.mesh);
        else // four are the identity
          for (int k = 0; k < 3; ++k) CGAL::Euler::flip_edge(h, c.mesh);
      }
      EXPECT_EQ(snapshot(c), before);
      expect_sound(c);
    }
}

TYPED_TEST(Moves, copies_keep_the_numbers_and_go_on_like_the_original) {
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name);
    Random random(6);
    Complex<TypeParam> c(s);
    for (int made = 0; made < 100;) made += make_random_move(c, random) ? 1 : 0;
    Complex<TypeParam> copy(c);
    EXPECT_EQ(snapshot(copy), snapshot(c));
    expect_sound(copy);
    for (int made = 0; made < 20;) {
      const std::uint32_t n = c.numbers.halfedge(random_halfedge(c, random));
      const auto insert = [n](Complex<TypeParam>& x) {
        const auto h = x.numbers.halfedge_at(n);
        if (x.is_border(h)) return 0;
        x.insert_in_face(h);
        return 1;
      };
      made += insert(c);
      insert(copy);
    }
    EXPECT_EQ(snapshot(copy), snapshot(c));
    expect_sound(copy);
    expect_sound(c);
  }
}

TYPED_TEST(Moves, a_new_numbering_of_a_mesh_with_removed_elements_fills_the_gaps) {
  Complex<TypeParam> c(gallery::annulus(4));
  const auto all = c.all();
  for (const auto h : {all[0], all[6], all[12]})
    c.insert_in_face(c.is_border(h) ? opposite(h, c.mesh) : h);
  c.remove_from_face(c.is_border(all[6]) ? opposite(all[6], c.mesh) : all[6]);
  IT::Mesh_adaptor<TypeParam> numbers(c.mesh);
  IT::split_face(face(all[6], c.mesh) == Complex<TypeParam>::Traits::null_face()
                     ? opposite(all[6], c.mesh)
                     : all[6],
                 c.mesh, numbers);
  EXPECT_EQ(IT::delta_complex_defect(c.mesh).value_or("none"), "none");
  EXPECT_EQ(numbers.vertex_capacity(c.mesh), 8U + 3U);
  EXPECT_EQ(numbers.edge_capacity(c.mesh), 16U + 9U);
  EXPECT_EQ(numbers.face_capacity(c.mesh), 8U + 6U);
}

// ---- what reads a Gluing_map with removed elements

namespace {

// a tetrahedron with gaps in the numbers of all elements: one vertex was inserted, another removed
Complex<IT::Gluing_map> with_gaps() {
  Complex<IT::Gluing_map> c(gallery::tetrahedron());
  c.insert_in_face(c.mesh.halfedge(IT::Gluing_map::Face{0}));
  for (const auto h : c.all())
    if (is_opposite_degree_3(c, h) && c.mesh.target(c.mesh.next(h)).index < 4) {
      c.remove_from_face(h);
      break;
    }
  return c;
}

} // namespace

TEST(Gluing_map_with_removed_elements, is_iterated_over_without_them_in_both_directions) {
  const Complex<IT::Gluing_map> c = with_gaps();
  ASSERT_TRUE(c.mesh.has_garbage());
  const auto expect_skipped = [&c](const auto& range, std::size_t live, std::uint32_t bound) {
    std::vector<std::uint32_t> forward, backward, expected;
    for (const auto d : range) {
      forward.push_back(d.index);
      EXPECT_FALSE(c.mesh.is_removed(d));
    }
    for (auto i = range.end(); i != range.begin();) backward.push_back((*--i).index);
    std::reverse(backward.begin(), backward.end());
    EXPECT_EQ(forward, backward);
    EXPECT_TRUE(std::is_sorted(forward.begin(), forward.end()));
    EXPECT_EQ(forward.size(), live);
    EXPECT_LT(live, bound);
  };
  expect_skipped(vertices(c.mesh), 4, c.mesh.number_of_vertices());
  expect_skipped(edges(c.mesh), 6, c.mesh.number_of_edges());
  expect_skipped(halfedges(c.mesh), 12, c.mesh.number_of_halfedges());
  expect_skipped(faces(c.mesh), 4, c.mesh.number_of_faces());
}

TEST(Gluing_map_with_removed_elements, is_read_and_copied_without_them) {
  const Complex<IT::Gluing_map> c = with_gaps();
  ASSERT_TRUE(c.mesh.has_garbage());
  EXPECT_EQ(IT::euler_characteristic(c.mesh), 2);
  EXPECT_EQ(IT::umbrellas(c.mesh), (std::vector<std::uint32_t>{1, 1, 1, 1}));
  EXPECT_EQ(IT::incidence(c.mesh).number_of_edges, 6U);
  const Gluing g = IT::gluing_from_map(c.mesh);
  EXPECT_EQ(g.number_of_vertices, 4U);
  EXPECT_EQ(g.origin.size(), 12U);
  EXPECT_NO_THROW(IT::validate(g));
  Surface_mesh mesh;
  IT::copy_gluing_map(c.mesh, mesh);
  EXPECT_EQ(IT::delta_complex_defect(mesh).value_or("none"), "none");
  EXPECT_EQ(mesh.number_of_vertices(), 4U);
  EXPECT_EQ(mesh.number_of_edges(), 6U);
  EXPECT_EQ(mesh.number_of_faces(), 4U);
  EXPECT_FALSE(mesh.has_garbage());
}

// ---- what sizes arrays by the numbers of a triangulation with removed elements

namespace {

template <class Mesh>
using Triangulation = IT::Intrinsic_triangulation<Mesh, IT::Euclidean_traits<double>>;

// inserts 40 vertices in random faces and removes most of them, the first ones first
template <class Mesh>
void leave_gaps(Triangulation<Mesh>& t) {
  Random random(7);
  std::vector<typename Triangulation<Mesh>::vertex_descriptor> inserted;
  for (int k = 0; k < 40; ++k) {
    const auto all = faces(t.mesh());
    const auto f = *std::next(all.begin(), static_cast<int>(random() % length_of(all)));
    const auto n = t.insert_vertex(halfedge(f, t.mesh()), {0.25, 0.5, 0.25});
    ASSERT_EQ(n.status, IT::Move_status::done);
    inserted.push_back(n.vertex);
  }
  int removed = 0;
  for (int k = 0; k < 30; ++k)
    removed += t.remove_vertex(inserted[static_cast<std::size_t>(k)]) == IT::Move_status::done;
  ASSERT_GT(removed, 20);
}

template <class Mesh>
std::vector<double> squared_lengths(const Triangulation<Mesh>& t) {
  std::vector<double> result;
  for (const auto e : edges(t.mesh())) result.push_back(t.squared_length(e));
  return result;
}

} // namespace

template <class Mesh>
class Triangulation_with_removed_vertices : public ::testing::Test {};
TYPED_TEST_SUITE(Triangulation_with_removed_vertices, All_meshes);

TYPED_TEST(Triangulation_with_removed_vertices, keeps_its_values_when_it_is_copied_and_moved) {
  Triangulation<TypeParam> t(meshes::rough_grid(4, 1).input());
  leave_gaps(t);
  const std::vector<double> expected = squared_lengths(t);
  Triangulation<TypeParam> copy(t);
  EXPECT_EQ(squared_lengths(copy), expected);
  Triangulation<TypeParam> moved(std::move(copy));
  EXPECT_EQ(squared_lengths(moved), expected);
  Triangulation<TypeParam> assigned(meshes::rough_grid(3, 1).input());
  assigned = moved;
  EXPECT_EQ(squared_lengths(assigned), expected);
  EXPECT_EQ(IT::flip_to_delaunay(assigned).flips, IT::flip_to_delaunay(t).flips);
  EXPECT_EQ(squared_lengths(assigned), squared_lengths(t));
}

TYPED_TEST(Triangulation_with_removed_vertices, is_made_Delaunay_and_has_matrices) {
  Triangulation<TypeParam> t(meshes::rough_grid(4, 1).input());
  leave_gaps(t);
  IT::flip_to_delaunay(t);
  EXPECT_TRUE(IT::is_delaunay(t));
  const auto rows =
      static_cast<Eigen::Index>(std::distance(vertices(t.mesh()).first, vertices(t.mesh()).second));
  const Eigen::SparseMatrix<double> laplacian = IT::cotangent_laplacian(t);
  const Eigen::SparseMatrix<double> mass = IT::lumped_mass_matrix(t);
  ASSERT_EQ(laplacian.rows(), rows);
  ASSERT_EQ(mass.rows(), rows);
  std::vector<int> count(static_cast<std::size_t>(rows), 0);
  for (const auto v : vertices(t.mesh())) ++count.at(t.input_vertex(v));
  for (Eigen::Index i = 0; i < rows; ++i) {
    EXPECT_EQ(count[static_cast<std::size_t>(i)], 1);
    EXPECT_GT(mass.coeff(i, i), 0);
    EXPECT_GT(laplacian.coeff(i, i), 0);
  }
}
