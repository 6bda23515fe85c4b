// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/overlay_subdivisions.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include "flat_surfaces.h"
#include "gallery.h"
#include "ideal_triangulations.h"
#include "subdivisions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Three triangulations of a surface on each other. The first two have the same Euclidean metric: in
// it each piece has the same shape on the input and in the middle triangulation.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Euclidean = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                              IT::Integer_coordinates>;
using Ideal = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Ideal_hyperbolic_traits<double>,
                                          IT::Integer_coordinates>;
using Complex = std::complex<double>;
constexpr std::uint32_t none = IT::Common_subdivision::none;

// The triangulation with its lengths as lambda lengths.
Ideal ideal_of(const Euclidean& t) {
  IT::Intrinsic_input in(t.mesh(), std::vector<double>(t.mesh().number_of_edges()),
                         IT::Mollification::none);
  in.may_renumber = false;
  for (const auto e : edges(t.mesh())) in.squared_lengths[t.index(e)] = t.squared_length(e);
  return Ideal(std::move(in));
}

using flat::flip_at_random;

class Overlay_checker {
public:
  Overlay_checker(const Euclidean& t, const Ideal& ideal)
      : t_(t), ideal_(ideal), second_(IT::common_subdivision(ideal)),
        overlay_(IT::overlay_subdivisions(IT::common_subdivision(t), second_, t.input(),
                                          ideal.input().mesh())),
        s_(overlay_.subdivision), of_input_(areas(t.input())), of_middle_(areas(ideal.input())) {}

  const IT::Common_subdivision& subdivision() const { return s_; }

  void check() {
    const auto& mesh = t_.mesh();
    std::size_t edges_of_s = 0;
    IT::for_each_subdivision_edge(s_,
                                  [&](std::uint32_t, std::uint32_t, const auto&) { ++edges_of_s; });
    EXPECT_EQ(edges_of_s, s_.number_of_edges());
    EXPECT_EQ(s_.number_of_vertices() + s_.number_of_faces() + num_edges(mesh),
              s_.number_of_edges() + num_vertices(mesh) + num_faces(mesh));
    for (std::size_t f = 0; f < s_.number_of_faces(); ++f) check_face(f);
    for (const double left : of_input_) EXPECT_NEAR(left, 0, 1e-10);
    for (const double left : of_middle_) EXPECT_NEAR(left, 0, 1e-10);
    check_edges();
  }

private:
  // Places of the corners of the triangle of a face, the first halfedge on the real axis.
  template <class Input>
  static std::array<Complex, 3> triangle(const Input& input, std::uint32_t h) {
    std::array<double, 3> squares;
    for (double& x : squares) {
      x = std::ldexp(input.squared_length(h / 2), -2 * input.scale_exponent());
      h = input.next(h);
    }
    const double l = std::sqrt(squares[0]), x = (squares[0] + squares[2] - squares[1]) / (2 * l);
    return {0, l, {x, std::sqrt(std::max(0., squares[2] - x * x))}};
  }

  static Complex combined(const std::array<double, 3>& w, const std::array<Complex, 3>& z) {
    return w[0] * z[0] + w[1] * z[1] + w[2] * z[2];
  }

  // The place of a corner in the middle triangle of `base`: on a side of the second subdivision.
  Complex in_middle(std::uint32_t base, std::uint32_t c) const {
    const auto at = [&](std::uint32_t own) {
      return combined(subdivisions::corner_in_input_face(ideal_.input(), second_, base, own),
                      triangle(ideal_.input(), base));
    };
    const std::uint32_t h = s_.intrinsic_halfedge[c], own = overlay_.corner[h];
    if (s_.corner[c] < s_.vertices.size()) return at(own);
    const double p = s_.crossings[s_.corner[c] - s_.vertices.size()].on_intrinsic.parameter,
                 along = h % 2 == 0 ? p : 1 - p;
    const auto f = static_cast<std::size_t>(
        std::upper_bound(second_.face_begin.begin(), second_.face_begin.end(), own) -
        second_.face_begin.begin() - 1);
    const std::uint32_t next =
        own + 1 == second_.face_begin[f + 1] ? second_.face_begin[f] : own + 1;
    return (1 - along) * at(own) + along * at(next);
  }

  static double area(const std::vector<Complex>& z) {
    double sum = 0;
    for (std::size_t k = 2; k < z.size(); ++k)
      sum += std::imag(std::conj(z[k - 1] - z[0]) * (z[k] - z[0])) / 2;
    return sum;
  }

  template <class Input>
  static std::vector<double> areas(const Input& input) {
    std::vector<double> result;
    for (std::uint32_t f = 0; f < input.number_of_faces(); ++f) {
      const std::array<Complex, 3> z = triangle(input, input.halfedge_of_face(f));
      result.push_back(area({z[0], z[1], z[2]}));
    }
    return result;
  }

  void check_face(std::size_t f) {
    const std::uint32_t begin = s_.face_begin[f], input_face = s_.input_face[f],
                        own = overlay_.corner[s_.intrinsic_halfedge[begin]],
                        base = t_.input().halfedge_of_face(input_face);
    const std::uint32_t middle_face = ideal_.input().face(second_.input_halfedge[own]),
                        middle = ideal_.input().halfedge_of_face(middle_face);
    std::vector<Complex> p, q;
    for (std::uint32_t c = begin; c < s_.face_begin[f + 1]; ++c) {
      EXPECT_EQ(t_.input().face(s_.input_halfedge[c]), input_face);
      p.push_back(combined(subdivisions::corner_in_input_face(t_.input(), s_, base, c),
                           triangle(t_.input(), base)));
      q.push_back(in_middle(middle, c));
    }
    for (std::size_t i = 0; i < p.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_NEAR(std::abs(p[i] - p[j]), std::abs(q[i] - q[j]), 1e-10);
    EXPECT_GE(area(p), -1e-13);
    of_input_[input_face] -= area(p);
    of_middle_[middle_face] -= area(q);
  }

  // Every edge of the input and of both triangulations is a path.
  void check_edges() const {
    std::set<std::uint32_t> input, intrinsic;
    for (const IT::Common_subdivision::Side& side : s_.side) {
      if (side.input_edge != none) input.insert(side.input_edge);
      if (side.intrinsic_edge != none) intrinsic.insert(side.intrinsic_edge);
    }
    EXPECT_EQ(input.size(), t_.input().number_of_edges());
    EXPECT_EQ(intrinsic.size(), second_.number_of_edges());
    const IT::Edge_polylines lines = IT::intrinsic_edge_polylines(s_);
    EXPECT_EQ(lines.size(), second_.number_of_edges());
    EXPECT_EQ(lines.vertices.size(), 2 * lines.size() + s_.crossings.size());
  }

  const Euclidean& t_;
  const Ideal& ideal_;
  IT::Common_subdivision second_;
  IT::Overlaid_subdivision overlay_;
  const IT::Common_subdivision& s_;
  std::vector<double> of_input_, of_middle_; // areas of faces without pieces
};

TEST(OverlaySubdivisions, hasTheShapeOfTheSurfaceWhateverTheTriangulations) {
  std::size_t crossings = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    flat::Surface s = seed % 3 == 0   ? flat::cube()
                      : seed % 3 == 1 ? flat::tetrahedron()
                                      : flat::Surface::torus(1, flat::Complex(0.3, 0.9), seed);
    s.mix(random, 30, 200);
    Euclidean t(input_of(s));
    if (seed % 2 == 0)
      IT::flip_to_delaunay(t);
    else
      flip_at_random(t, random, 15);
    Ideal ideal = ideal_of(t);
    if (seed < 7) {
      ideal.scale_vertices(ideal::random_factors(ideal.number_of_vertices(), 3, seed));
      IT::flip_to_delaunay(ideal);
    } else {
      ideal::flip_at_random(ideal, 40, seed);
    }
    Overlay_checker checker(t, ideal);
    checker.check();
    crossings += checker.subdivision().crossings.size();
  }
  EXPECT_GT(crossings, 1000U);
}

TEST(OverlaySubdivisions, laysTriangulationsOfOneVertexOnEachOther) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Euclidean t(gallery::input(seed % 2 == 0 ? gallery::octagon_of_genus_2()
                                             : gallery::one_vertex_torus()));
    flip_at_random(t, random, static_cast<int>(seed));
    Ideal ideal = ideal_of(t);
    ideal::flip_at_random(ideal, seed, seed);
    Overlay_checker(t, ideal).check();
  }
}

TEST(OverlaySubdivisions, isTheSecondOneWithoutFlipsBefore) {
  std::mt19937 random(1);
  flat::Surface s = flat::cube();
  s.mix(random, 20, 100);
  const Euclidean t(input_of(s));
  Ideal ideal = ideal_of(t);
  ideal::flip_at_random(ideal, 40, 1);
  const IT::Common_subdivision second = IT::common_subdivision(ideal);
  Overlay_checker checker(t, ideal);
  checker.check();
  EXPECT_TRUE(checker.subdivision().crossings.empty());
  EXPECT_EQ(checker.subdivision().number_of_faces(), second.number_of_faces());
  EXPECT_EQ(checker.subdivision().corner, second.corner);
}

// An edge that one flip removes and the next restores, in a square: its crossings are one point.
TEST(OverlaySubdivisions, keepsEdgesThatCoincideTogether) {
  Euclidean t(gallery::input(gallery::flat_torus(5, 4)));
  std::vector<Euclidean::halfedge_descriptor> diagonals;
  for (const auto e : edges(t.mesh()))
    if (t.squared_length(e) > 1.5) diagonals.push_back(halfedge(e, t.mesh()));
  ASSERT_EQ(diagonals.size(), 20U);
  for (const auto h : diagonals) t.flip_edge(h);
  Ideal ideal = ideal_of(t);
  for (std::size_t i = 0; i < diagonals.size(); i += 2) ideal.flip_edge(diagonals[i]);
  Overlay_checker checker(t, ideal);
  checker.check();
  // four triangles in each square, but no sliver
  EXPECT_EQ(checker.subdivision().number_of_faces(), 4U * diagonals.size());
  EXPECT_EQ(checker.subdivision().number_of_vertices(), 20U + diagonals.size());
}

// The message of the error, which must come.
std::string refused(const IT::Common_subdivision& first, const IT::Common_subdivision& second,
                    const Euclidean& t, const IT::Gluing_map& middle) {
  try {
    IT::overlay_subdivisions(first, second, t.input(), middle);
  } catch (const IT::Invalid_input& e) {
    return e.what();
  }
  return "";
}

TEST(OverlaySubdivisions, refusesSubdivisionsOfOtherTriangulations) {
  std::mt19937 random(1);
  flat::Surface s = flat::cube(), other = flat::tetrahedron();
  s.mix(random, 20, 100);
  other.mix(random, 20, 100);
  Euclidean t(input_of(s));
  const IT::Common_subdivision before = IT::common_subdivision(t);
  flip_at_random(t, random, 15);
  Ideal ideal = ideal_of(t);
  ideal::flip_at_random(ideal, 40, 1);
  const IT::Gluing_map middle = ideal.input().mesh();
  const IT::Common_subdivision first = IT::common_subdivision(t),
                               second = IT::common_subdivision(ideal);
  EXPECT_EQ(refused(first, second, t, middle), "");
  // a stale one, and those of other surfaces
  const std::string stale = refused(before, second, t, middle);
  EXPECT_NE(stale.find("of the middle triangulation is not that of the first subdivision"),
            std::string::npos);
  EXPECT_NE(stale.find("as it is now"), std::string::npos);
  const Euclidean u(input_of(other));
  const IT::Common_subdivision foreign = IT::common_subdivision(u);
  EXPECT_NE(refused(foreign, second, t, middle), "");
  EXPECT_NE(refused(first, foreign, t, middle), "");
  EXPECT_NE(refused(foreign, foreign, t, middle), "");
  EXPECT_NE(refused(second, first, t, middle), "");
  EXPECT_NE(refused({}, second, t, middle), "");
  EXPECT_NE(refused(first, {}, t, middle), "");
  // of the triangulation after other flips, and after more
  const Ideal early = ideal_of(Euclidean(input_of(s)));
  EXPECT_NE(refused(first, IT::common_subdivision(early), t, middle).find("second subdivision"),
            std::string::npos);
  flip_at_random(t, random, 5);
  EXPECT_NE(refused(IT::common_subdivision(t), second, t, middle), "");
  EXPECT_NE(refused(first, second, t, t.mesh()), "");
}

// Each number in the arrays is changed in turn: the result is an error or a surface.
TEST(OverlaySubdivisions, endsForArraysThatAreNone) {
  std::mt19937 random(1);
  flat::Surface s = flat::tetrahedron();
  s.mix(random, 2, 20);
  Euclidean t(input_of(s));
  flip_at_random(t, random, 10);
  Ideal ideal = ideal_of(t);
  ideal::flip_at_random(ideal, 20, 1);
  const std::array<IT::Common_subdivision, 2> valid{IT::common_subdivision(t),
                                                    IT::common_subdivision(ideal)};
  std::size_t refusals = 0, changes = 0;
  for (const std::size_t which : {0U, 1U})
    for (std::size_t array = 0; array < 8; ++array)
      for (std::size_t i = 0; i < 40; ++i) {
        std::array<IT::Common_subdivision, 2> changed = valid;
        IT::Common_subdivision& c = changed[which];
        const std::size_t corner = random() % c.corner.size(),
                          face = random() % c.number_of_faces(),
                          x = random() % c.crossings.size();
        const std::array<std::uint32_t*, 8> numbers{
            &c.corner[corner],
            &c.side[corner].input_edge,
            &c.side[corner].intrinsic_edge,
            &c.intrinsic_halfedge[corner],
            &c.input_halfedge[corner],
            &c.face_begin[face],
            &c.crossings[x].on_input.edge,
            &c.crossings[x].on_intrinsic.edge};
        *numbers[array] = i % 2 == 0 ? static_cast<std::uint32_t>(random()) : *numbers[array] ^ 1U;
        ++changes;
        if (!refused(changed[0], changed[1], t, ideal.input().mesh()).empty()) ++refusals;
      }
  EXPECT_GT(refusals, changes / 2);
}

} // namespace
