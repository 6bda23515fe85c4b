// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/models/Diamond_unfolder.h>

#include "gallery.h"
#include "meshes.h"
#include "places.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/field.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <random>
#include <utility>
#include <vector>

// Diamonds at vertices that were inserted, unfolded from the input, against exact values that follow the moves: an
// insertion adopts what unfolding says if that is a point of the face, and whatever comes after must agree.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;
using IT::Move_status;
using IT::Multiquadratic_number;
using Face = IT::Face_values<Multiquadratic_number>;
using Diamond = IT::Diamond_values<Multiquadratic_number>;

void expect_equal(const Multiquadratic_number& x, const Multiquadratic_number& y) {
  EXPECT_TRUE((x - y).is_zero());
}

// 16 A^2 of a triangle with two sides from a corner and the one opposite
Multiquadratic_number squared_area(const Multiquadratic_number& a, const Multiquadratic_number& b,
                                   const Multiquadratic_number& opposite) {
  const Multiquadratic_number p = a + b - opposite;
  return Multiquadratic_number(Gmpq(4)) * a * b - p * p;
}

void expect_triangle(const Face& f) {
  const auto& [a, opposite, b] = f.squared_lengths;
  expect_equal(f.quadruple_area * f.quadruple_area, squared_area(a, b, opposite));
}

/// Integer coordinates, and exact values that follow the moves.
class Followed : public IT::Integer_coordinates {
public:
  template <class T>
  void start(const T& t) {
    Integer_coordinates::start(t);
    faces_ = std::make_shared<places::Exact_input>(t.input().metric());
    for (const std::uint32_t h : places::halfedges_of_faces(t)) store(t, h);
  }

  template <class T>
  void after(const T& t, const IT::Flip& move) noexcept {
    Integer_coordinates::after(t, move);
    const auto f = IT::flipped(values(move.diamond));
    length_[move.diamond.ij] = f.km;
    const bool is_taken_back = move.is_taken_back();
    area_[move.diamond.f] = is_taken_back ? f.area_g : f.area_f;
    area_[move.diamond.g] = is_taken_back ? f.area_f : f.area_g;
  }

  template <class T>
  void after(const T& t, const IT::Insertion_in_face& move) noexcept {
    Integer_coordinates::after(t, move);
    Multiquadratic_number rest = area_.at(move.faces[0]);
    for (unsigned k = 0; k < 3; ++k) {
      const Multiquadratic_number side = length_.at(move.sides[k] / 2);
      const Face f = store(t, move.sides[k]);
      expect_equal(f.squared_lengths[0], side);
      rest = rest - f.quadruple_area;
      expect_triangle(f);
    }
    EXPECT_TRUE(rest.is_zero());
  }

  template <class T>
  void after(const T& t, const IT::Insertion_on_border& move) noexcept {
    Integer_coordinates::after(t, move);
    const Multiquadratic_number whole = length_.at(move.ip / 2), area = area_.at(move.f);
    const Face ipk = store(t, move.ki), pjk = store(t, move.jk);
    expect_triangle(ipk);
    expect_triangle(pjk);
    expect_equal(ipk.quadruple_area + pjk.quadruple_area, area);
    EXPECT_TRUE(squared_area(length_.at(move.ip / 2), whole, length_.at(move.pj / 2)).is_zero());
  }

  template <class T>
  void after(const T& t, const IT::Removal_from_face& move) noexcept {
    Integer_coordinates::after(t, move);
    const auto [f, g, h] = move.faces;
    area_[f] = area_.at(f) + area_.at(g) + area_.at(h);
  }

  template <class T>
  void after(const T& t, const IT::Removal_from_border& move) noexcept {
    Integer_coordinates::after(t, move);
    const IT::Border_star s = move.edges_and_faces();
    length_[s.ip] = IT::flipped(values({s.pk, s.ki, s.ip, s.pj, s.jk, s.f, s.g})).km;
    area_[s.f] = area_.at(s.f) + area_.at(s.g);
  }

  Diamond values(const IT::Diamond& d) const {
    return {length_.at(d.ij), length_.at(d.jk), length_.at(d.ki), length_.at(d.im),
            length_.at(d.mj), area_.at(d.f),    area_.at(d.g)};
  }
  const places::Exact_input& exact_input() const { return *faces_; }

private:
  template <class T>
  Face store(const T& t, std::uint32_t h) {
    const IT::Intrinsic_view<T> view(t);
    const Face f = places::Unfolded<T>(t).exact(h, *faces_);
    area_[view.face(h)] = f.quadruple_area;
    for (const Multiquadratic_number& l : f.squared_lengths) {
      length_[h / 2] = l;
      h = view.next(h);
    }
    return f;
  }

  std::shared_ptr<places::Exact_input> faces_;
  std::map<std::uint32_t, Multiquadratic_number> length_, area_;
};

using Exact = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Followed>;
using Halfedge = Exact::halfedge_descriptor;
using Vertex = Exact::vertex_descriptor;

/// A triangulation that moves at random.
class Walk {
public:
  Walk(IT::Intrinsic_input input, unsigned seed) : t(std::move(input)), random_(seed) {}

  Exact t;

  void step() {
    const Halfedge h = random_halfedge();
    switch (random_() % 4) {
    case 0: {
      const double w = static_cast<double>(random_() % 2 + 1) / 4;
      keep(t.insert_vertex(h, {w, w / 2, 1 - w - w / 2}));
      break;
    }
    case 1:
      keep(t.split_edge(h, static_cast<double>(random_() % 3 + 1) / 4));
      break;
    case 2:
      if (!inserted_.empty()) {
        const std::size_t i = random_() % inserted_.size();
        if (t.remove_vertex(inserted_[i]) == Move_status::done)
          inserted_.erase(inserted_.begin() + static_cast<std::ptrdiff_t>(i));
      }
      break;
    default:
      for (int i = 0; i < 3; ++i) t.flip_edge(random_halfedge());
    }
  }

  std::vector<Halfedge> inner_edges() const {
    std::vector<Halfedge> result;
    for (const Halfedge h : halfedges(t.mesh())) {
      const Halfedge o = opposite(h, t.mesh());
      if (h.index < o.index && !is_border(h) && !is_border(o) &&
          face(h, t.mesh()) != face(o, t.mesh()))
        result.push_back(h);
    }
    return result;
  }

private:
  bool is_border(Halfedge h) const {
    return face(h, t.mesh()) == boost::graph_traits<IT::Gluing_map>::null_face();
  }

  Halfedge random_halfedge() {
    std::vector<Halfedge> all;
    for (const Halfedge h : halfedges(t.mesh()))
      if (!is_border(h)) all.push_back(h);
    return all[random_() % all.size()];
  }

  void keep(const Exact::Insertion& i) {
    if (i.status == Move_status::done) inserted_.push_back(i.vertex);
  }

  std::mt19937 random_;
  std::vector<Vertex> inserted_;
};

// returns the number of diamonds that have inserted vertices
std::size_t check_all_diamonds(const Walk& walk) {
  const Followed& followed = walk.t.correspondence();
  places::Unfolded<Exact> unfolded(walk.t);
  std::size_t result = 0;
  for (const Halfedge h : walk.inner_edges()) {
    const IT::Unfolded_diamond& d = unfolded.diamond(h.index);
    const Diamond x = d.values<Multiquadratic_number>(followed.exact_input()),
                  y = followed.values(walk.t.diamond(h));
    expect_equal(x.ij, y.ij);
    expect_equal(x.jk, y.jk);
    expect_equal(x.ki, y.ki);
    expect_equal(x.im, y.im);
    expect_equal(x.mj, y.mj);
    expect_equal(x.area_f, y.area_f);
    expect_equal(x.area_g, y.area_g);
    result += d.has_inserted_corners() ? 1 : 0;
  }
  EXPECT_EQ(places::first_wrong_value(walk.t), IT::Gluing::none);
  return result;
}

TEST(Diamond_unfolder, agrees_exactly_with_repeated_moves_on_meshes) {
  std::size_t checked = 0;
  for (unsigned seed = 1; seed <= 4; ++seed)
    for (const meshes::Mesh& m : {meshes::box(1, 1, 1), meshes::integer_height_field(2, 3, seed)}) {
      Walk walk(m.input(), seed);
      for (int round = 0; round < 4; ++round) {
        for (int i = 0; i < 3; ++i) walk.step();
        checked += check_all_diamonds(walk);
      }
    }
  EXPECT_GT(checked, 200U);
}

TEST(Diamond_unfolder, agrees_exactly_with_repeated_moves_on_Delta_complexes) {
  std::size_t checked = 0;
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name);
    Walk walk(gallery::input(s), 5);
    for (int round = 0; round < 3; ++round) {
      for (int i = 0; i < 2; ++i) walk.step();
      checked += check_all_diamonds(walk);
    }
  }
  EXPECT_GT(checked, 100U);
}

// Wedges of up to `most` faces from each halfedge on: the two sides against the product over all faces.
std::size_t check_wedges(const Walk& walk, std::size_t most) {
  const Followed& followed = walk.t.correspondence();
  const auto& mesh = walk.t.mesh();
  places::Unfolded<Exact> unfolded(walk.t);
  std::size_t result = 0;
  for (Halfedge h : halfedges(mesh)) {
    std::vector<IT::Indexed_face> faces;
    CGAL::Intrinsic_triangulations::Plane_vector<Multiquadratic_number> z{1, 0};
    while (faces.size() < most &&
           face(h, mesh) != boost::graph_traits<IT::Gluing_map>::null_face()) {
      const Halfedge n = next(h, mesh), l = next(n, mesh);
      faces.push_back({face(h, mesh).index, {h.index / 2, n.index / 2, l.index / 2}});
      const Face f = unfolded.exact(h.index, followed.exact_input());
      const auto& [l0, l1, l2] = f.squared_lengths;
      z = z * CGAL::Intrinsic_triangulations::Plane_vector<Multiquadratic_number>{l0 + l2 - l1,
                                                                                  f.quadruple_area};
      const Diamond d = unfolded.wedge(faces).values<Multiquadratic_number>(followed.exact_input());
      const Multiquadratic_number cosine = IT::Right_cosine_expression()(d);
      expect_equal(d.area_f, Multiquadratic_number());
      expect_equal(cosine * z.y, d.area_g * z.x); // one direction
      const auto to_double = [](const CGAL::Gmpq& x) { return CGAL::to_double(x); };
      EXPECT_GT((cosine * z.x + d.area_g * z.y).value(to_double), 0);
      ++result;
      h = opposite(l, mesh);
    }
  }
  return result;
}

TEST(Diamond_unfolder, unfolds_the_sides_of_wedges) {
  std::size_t checked = 0;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    Walk walk(meshes::integer_height_field(2, 2, seed).input(), seed);
    for (int round = 0; round < 3; ++round) {
      for (int i = 0; i < 3; ++i) walk.step();
      checked += check_wedges(walk, 3);
    }
  }
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name);
    Walk walk(gallery::input(s), 7);
    for (int i = 0; i < 5; ++i) walk.step();
    checked += check_wedges(walk, 4);
  }
  EXPECT_GT(checked, 500U);
}

// an insertion on an edge, and one that is as near to it as weights allow
TEST(Diamond_unfolder, lets_the_field_tell_a_straight_angle_from_one_that_is_bent_by_an_ulp) {
  std::array<std::size_t, 2> straight{};
  for (const bool is_bent : {false, true}) {
    Walk walk(meshes::integer_height_field(2, 3, 11).input(), 11);
    Exact& t = walk.t;
    const Halfedge h = *halfedges(t.mesh()).begin();
    const double w = 0.5, tiny = is_bent ? 0x1p-52 : 0;
    const auto p = t.insert_vertex(h, {w, w - tiny, tiny});
    ASSERT_EQ(p.status, Move_status::done);
    // around p: the sum of the angles between the ends of the edge
    std::size_t zeros = 0, others = 0;
    IT::Field_proof proof;
    places::Unfolded<Exact> unfolded(t);
    for (const Halfedge e : walk.inner_edges()) {
      const IT::Convexity_at_source_expression expression;
      const auto answer = proof(
          IT::Question{t.input().metric(), unfolded.diamond(e.index), IT::recorded(expression)});
      const bool expected = expression(t.correspondence().values(t.diamond(e))).is_zero();
      EXPECT_EQ(answer, expected ? IT::Answer::zero : IT::Answer::not_zero);
      ++(expected ? zeros : others);
    }
    EXPECT_GT(others, 0U);
    straight[is_bent ? 1 : 0] = zeros;
  }
  EXPECT_LT(straight[1], straight[0]);
}

} // namespace
