// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>

#include "refined_meshes.h"

#include <CGAL/Gmpzf.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

// After refinement in exact arithmetic a common subdivision must be one of polygons that have an
// area, whatever represents how the triangulations lie on each other.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Dyadic = CGAL::Gmpzf; // products and sums of doubles: no divisor is looked for
using Weights = std::array<Dyadic, 3>;
constexpr std::uint32_t none = IT::Common_subdivision::none;

// Twice the signed area of a polygon, as a part of the face of its barycentric coordinates: exactly.
Dyadic area(const std::vector<Weights>& p) {
  Dyadic sum(0);
  for (std::size_t i = 2; i < p.size(); ++i)
    sum += (p[i - 1][1] - p[0][1]) * (p[i][2] - p[0][2]) -
           (p[i][1] - p[0][1]) * (p[i - 1][2] - p[0][2]);
  return sum;
}

template <class T>
class Checker {
public:
  Checker(const T& t, const IT::Common_subdivision& s) : t_(t), s_(s), view_(t) {}

  void check() {
    for (std::size_t f = 0; f < s_.number_of_faces(); ++f) check_cell(f);
    for (const auto& [face, sum] : input_) EXPECT_NEAR(CGAL::to_double(sum), 1, 1e-12) << face;
    for (const auto& [face, sum] : intrinsic_) EXPECT_NEAR(CGAL::to_double(sum), 1, 1e-12) << face;
    for (const auto f : faces(t_.mesh())) EXPECT_EQ(intrinsic_.count(t_.index(f)), 1U);
    EXPECT_EQ(input_.size(), t_.input().number_of_faces());
  }

private:
  // by the user's names of the corners
  std::array<std::uint32_t, 3> corners_on_input(std::uint32_t face) const {
    auto v = IT::sides_of_face(t_.input(), t_.input().halfedge_of_face(face));
    for (std::uint32_t& h : v) h = t_.input().names().vertices.user(t_.input().source(h));
    return v;
  }
  std::array<std::uint32_t, 3> corners_on_intrinsic(std::uint32_t face) const {
    auto v = IT::sides_of_face(view_, view_.halfedge_of_face(face));
    for (std::uint32_t& h : v) h = t_.input_vertex(t_.numbers().vertex_at(view_.source(h)));
    return v;
  }
  // the point must be one of the face; nothing is rounded but the parameters of crossings
  static Weights weights(const IT::Weighted_vertices& w, const std::array<std::uint32_t, 3>& v) {
    Weights result{0, 0, 0};
    Dyadic rest(1);
    for (std::size_t i = w.size; i-- > 0;) {
      if (w.weights[i] == 0 && i > 0) continue;
      const Dyadic x = i == 0 ? rest : Dyadic(w.weights[i]);
      rest -= x;
      std::size_t k = 0;
      while (k < 3 && v[k] != w.vertices[i]) ++k;
      if (k < 3)
        result[k] += x;
      else
        EXPECT_EQ(x, 0) << "vertex " << w.vertices[i];
    }
    return result;
  }

  void check_cell(std::size_t f) {
    const std::uint32_t g = t_.input().names().faces.here(s_.input_face[f]);
    const auto on_input = corners_on_input(g),
               on_intrinsic = corners_on_intrinsic(s_.intrinsic_face[f]);
    std::vector<Weights> p, q;
    for (const std::uint32_t v : s_.face(f)) {
      p.push_back(weights(s_.on_input(v), on_input));
      if (is_simple(on_intrinsic)) q.push_back(weights(s_.on_intrinsic(v), on_intrinsic));
    }
    check_sides(f, g, p);
    if (t_.input().quadruple_area(g) == 0) return;
    const Dyadic area_on_input = area(p);
    EXPECT_GT(area_on_input, 0) << "polygon " << f << " on input face " << g;
    input_[g] += area_on_input;
    const std::uint32_t face = s_.intrinsic_face[f];
    if (q.empty()) {
      intrinsic_[face] = Dyadic(1);
      return;
    }
    const Dyadic area_on_intrinsic = area(q);
    EXPECT_GT(area_on_intrinsic, 0) << "polygon " << f << " on face " << face;
    intrinsic_[face] += area_on_intrinsic;
  }

  static bool is_simple(const std::array<std::uint32_t, 3>& v) {
    return v[0] != v[1] && v[1] != v[2] && v[2] != v[0];
  }

  // a side on an input edge has both ends there, and one on an intrinsic edge is there
  void check_sides(std::size_t f, std::uint32_t g, const std::vector<Weights>& p) const {
    const auto sides = IT::sides_of_face(t_.input(), t_.input().halfedge_of_face(g));
    for (std::size_t k = 0; k < p.size(); ++k) {
      const auto [input_edge, intrinsic_edge] = s_.sides(f)[k];
      EXPECT_TRUE(input_edge != none || intrinsic_edge != none);
      if (intrinsic_edge != none) {
        EXPECT_EQ(intrinsic_edge, s_.intrinsic_halfedge[s_.face_begin[f] + k] / 2);
      }
      if (input_edge == none) continue;
      std::size_t side = 0;
      while (side < 3 && sides[side] / 2 != input_edge) ++side;
      ASSERT_LT(side, 3U);
      EXPECT_EQ(p[k][(side + 2) % 3], 0);
      EXPECT_EQ(p[(k + 1) % p.size()][(side + 2) % 3], 0);
    }
  }

  const T& t_;
  const IT::Common_subdivision& s_;
  IT::Intrinsic_view<T> view_;
  std::map<std::uint32_t, Dyadic> input_, intrinsic_; // what is covered of each face
};

void expect_equal(const IT::Common_subdivision& a, const IT::Common_subdivision& b) {
  EXPECT_EQ(a.face_begin, b.face_begin);
  EXPECT_EQ(a.corner, b.corner);
  EXPECT_EQ(a.input_face, b.input_face);
  EXPECT_EQ(a.intrinsic_face, b.intrinsic_face);
}

TEST(Refined_subdivision, is_one_of_polygons_with_an_area_that_cover_all_faces) {
  const std::size_t count = refined::for_each([](const std::string& name, const auto& source) {
    SCOPED_TRACE(name);
    const auto t = refined::triangulation<IT::Integer_coordinates>(source);
    const IT::Common_subdivision s = IT::common_subdivision(t);
    Checker(t, s).check();
  });
  EXPECT_GE(count, refined::generated().size());
}

TEST(Refined_subdivision, is_the_same_for_all_representations) {
  refined::for_each([](const std::string& name, const auto& source) {
    SCOPED_TRACE(name);
    const IT::Common_subdivision s =
        IT::common_subdivision(refined::triangulation<IT::Integer_coordinates>(source));
    expect_equal(s, IT::common_subdivision(refined::triangulation<IT::Explicit_crossings>(source)));
    expect_equal(s, IT::common_subdivision(refined::triangulation<IT::Signposts>(source)));
  });
}

} // namespace
