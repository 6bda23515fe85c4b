// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_ANGLES_IDEAL_SURFACE_OF_H
#define CGAL_INTRINSIC_CONFORMAL_ANGLES_IDEAL_SURFACE_OF_H

#include <CGAL/Intrinsic_conformal/angles/Ideal_surface.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Requires lambda lengths, and factors of vertices that scale them: ideal hyperbolic traits.
template <class Triangulation>
concept Has_horocycles = IndexedTriangulation<Triangulation> &&
    requires(Triangulation& t, std::span<const double> factors) {
  t.scale_vertices(factors);
  { t.metric().approximate_lambda(std::uint32_t()) } -> std::same_as<double>;
  t.metric().lambda(std::uint32_t());
};

// A triangulation with ideal hyperbolic traits, as solvers see it.
template <Has_horocycles Triangulation>
class Ideal_surface_of final : public Ideal_surface {
public:
  // \throws Invalid_input if there is a border, or a vertex has more copies than sheets
  explicit Ideal_surface_of(Triangulation& t)
      : t_(t), row_(t.numbers().vertex_capacity(t.mesh()), Gluing::none) {
    expect_closed();
    std::vector<std::uint32_t> copies(t.number_of_vertices(), 0);
    for (const auto v : vertices(t.mesh())) {
      const std::uint32_t row = row_[t.index(v)] = t.input_vertex(v);
      if (++copies[row] > sheets())
        throw Invalid_input::about(Element_kind::vertex, row,
                                   " is not manifold: its faces form more than one fan; split it");
    }
  }

  const std::vector<std::uint32_t>& row_of_vertex() const override { return row_; }
  std::size_t number_of_rows() const override { return t_.number_of_vertices(); }
  int scale_exponent() const override { return t_.metric().scale_exponent(); }
  std::uint32_t sheets() const override { return t_.input().names().sheets; }

  std::optional<std::size_t> scale(std::span<const Double_double> factors) override {
    if (!are_in_range(factors)) return std::nullopt;
    std::vector<double> rounded, rests;
    for (const Double_double& w : factors) {
      rounded.push_back(w.to_double());
      rests.push_back(rest(w));
    }
    t_.scale_vertices(rounded, rests);
    const std::size_t flips = flip_to_delaunay(t_).flips;
    sharpen();
    return flips;
  }

  void read(std::vector<Ideal_face>& faces_of_now) const override {
    faces_of_now.clear();
    faces_of_now.reserve(num_faces(t_.mesh()));
    for_each_face([&](const auto& vertices, const auto& sides) {
      Ideal_face& f = faces_of_now.emplace_back();
      f.edges = sides;
      for (std::size_t k = 0; k < 3; ++k) {
        f.rows[k] = static_cast<int>(row_[vertices[k]]);
        f.lambda[k] = t_.metric().approximate_lambda(sides[k]);
      }
      f.surplus = surpluses(f.lambda);
      if constexpr (is_exact)
        if (is_needle(f.lambda)) {
          const std::array<Precise, 3> precise = precise_surpluses(sides);
          for (std::size_t k = 0; k < 3; ++k) f.surplus[k] = precise[k].to_double();
        }
    });
  }

  std::optional<std::vector<Enclosed_ideal_face>> enclosures() const override {
    if constexpr (!is_exact && !std::is_same_v<typename Triangulation::FT, Interval_nt<false>>)
      return std::nullopt;
    else {
      std::vector<Enclosed_ideal_face> result;
      result.reserve(num_faces(t_.mesh()));
      for_each_face([&](const auto& vertices, const auto& sides) {
        Enclosed_ideal_face& f = result.emplace_back();
        f.vertices = vertices;
        std::array<double, 3> near;
        for (std::size_t k = 0; k < 3; ++k) {
          f.lambda[k] = CGAL::to_interval(t_.metric().lambda(sides[k]));
          near[k] = f.lambda[k].inf();
        }
        f.surplus = surpluses(f.lambda);
        if constexpr (is_exact)
          if (is_needle(near)) {
            const std::array<Precise, 3> precise = precise_surpluses(sides);
            for (std::size_t k = 0; k < 3; ++k) f.surplus[k] = precise[k].interval();
          }
      });
      return result;
    }
  }

private:
  using Precise = Short_ball;
  static constexpr bool is_exact = requires(Triangulation & t, std::uint32_t e) {
    t.decider().sharpen(e);
  };

  std::array<Precise, 3> precise_surpluses(const std::array<std::uint32_t, 3>& sides) const {
    const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
    return surpluses(t_.decider().template lambdas<Precise>(sides));
  }

  // Intervals that flips have widened get their digits from the input again: beside needles angles
  // need nearly all of them.
  void sharpen() {
    if constexpr (is_exact) {
      constexpr double width = 0x1p-48; // relative; four units in the last place at least
      const typename Triangulation::Metric::Scope scope;
      for (const typename Triangulation::edge_descriptor e : edges(t_.mesh())) {
        const std::uint32_t i = t_.index(e);
        const auto& lambda = t_.metric().lambda(i);
        if (lambda.sup() - lambda.inf() > width * lambda.inf()) t_.decider().sharpen(i);
      }
    }
  }

  // Calls `visit(vertices, sides)` with the numbers of the corners of each face and of its edges,
  // side k from corner k.
  template <class Visit>
  void for_each_face(const Visit& visit) const {
    const auto& mesh = t_.mesh();
    for (const typename Triangulation::face_descriptor f : faces(mesh)) {
      std::array<std::uint32_t, 3> corners, sides;
      auto h = halfedge(f, mesh);
      for (std::size_t k = 0; k < 3; ++k, h = next(h, mesh)) {
        corners[k] = t_.index(source(h, mesh));
        sides[k] = t_.index(edge(h, mesh));
      }
      visit(corners, sides);
    }
  }

  void expect_closed() const {
    for (const typename Triangulation::halfedge_descriptor h : halfedges(t_.mesh()))
      if (CGAL::is_border(h, t_.mesh())) {
        const std::uint32_t row = t_.input_vertex(source(h, t_.mesh()));
        throw Invalid_input(
            Element_kind::vertex, row,
            "vertex " + std::to_string(row) +
                " is on a border; close the surface: make_domain() with Domain_kind::closed");
      }
  }

  Triangulation& t_;
  std::vector<std::uint32_t> row_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_CONFORMAL_ANGLES_IDEAL_SURFACE_OF_H
