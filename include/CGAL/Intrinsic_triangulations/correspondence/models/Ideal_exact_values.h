// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_IDEAL_EXACT_VALUES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_IDEAL_EXACT_VALUES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Diamond_unfolder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Exact_memory.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Exact_values.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Vertex_places.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/ideal_strip.h>
#include <CGAL/Intrinsic_triangulations/formulas/Penner_coordinates.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Mover.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Computes the lambda lengths of a triangulation in any number type, from where its edges run on the
input: in a strip of input triangles for each edge. It repeats the flips instead if they are few and
edges cross very many triangles, or if crossings are not counted.
*/
template <class Triangulation>
class Ideal_exact_values {
public:
  Ideal_exact_values(const Triangulation& t, const Vertex_places<Triangulation>& places,
                     Exact_memory& memory)
      : t_(t), places_(places), memory_(memory), view_(t) {}

  // the lambda lengths of edges, without factors of vertices
  template <class FT, std::size_t n>
  std::array<FT, n> lambdas(const std::array<std::uint32_t, n>& edges) const {
    std::array<FT, n> result;
    const Integer_coordinates* const c = coordinates(edges);
    if (c == nullptr) {
      const std::vector<FT> all = replayed<FT>();
      for (std::size_t k = 0; k < n; ++k) result[k] = all[edges[k]];
      return result;
    }
    std::vector<FT> at;
    for (std::size_t k = 0; k < n; ++k) result[k] = lambda_on_input(*c, edges[k], at);
    if (const std::size_t steps = memory_.unfolder.take_steps(); steps > 0)
      c->count_steps(t_, steps);
    return result;
  }

  // the rows of the ends of an edge
  std::array<std::uint32_t, 2> rows(std::uint32_t edge) const {
    const auto row = [this](std::uint32_t v) { return t_.input_vertex(t_.numbers().vertex_at(v)); };
    return {row(view_.source(2 * edge)), row(view_.target(2 * edge))};
  }

private:
  // null if the strips of edges are much longer than the list of flips
  template <std::size_t n>
  const Integer_coordinates* coordinates(const std::array<std::uint32_t, n>& edges) const {
    const Integer_coordinates* const c = places_.coordinates(t_);
    if (c == nullptr || places_.flips() == nullptr) return c;
    return are_worth_unfolding(*c, edges, *places_.flips()) ? c : nullptr;
  }

  // from where the edge runs on the input
  template <class FT>
  FT lambda_on_input(const Integer_coordinates& c, std::uint32_t edge, std::vector<FT>& at) const {
    const auto lambda = [&](const Face_side& side, unsigned k) {
      std::uint32_t h = c.input().halfedge_of_face(side.face);
      for (unsigned n = (side.slot + k) % 3; n > 0; --n) h = c.input().next(h);
      return FT(t_.metric().input_lambdas()[h / 2]);
    };
    const std::uint32_t h = view_.is_border(2 * edge) ? 2 * edge + 1 : 2 * edge;
    return lambdas_along_strip<FT>(memory_.unfolder.strip(view_, c, h), lambda, at);
  }

  template <class FT>
  std::vector<FT> replayed() const {
    const Flip_list& flips = *places_.flips();
    Gluing_map mesh = flips.input_mesh(places_.connectivity(t_), t_.input());
    const Mesh_adaptor<Gluing_map> numbers(mesh);
    const std::vector<double>& input = t_.metric().input_lambdas();
    std::vector<FT> result(input.begin(), input.end());
    for (std::size_t n = 0; n < flips.size(); ++n) {
      const Diamond d = diamond_of(flips[n], mesh, numbers);
      result[d.ij] = ptolemy_flip(Ideal_diamond_values<FT>{result[d.ij], result[d.jk], result[d.ki],
                                                           result[d.im], result[d.mj]});
      CGAL::Euler::flip_edge(flips[n], mesh);
    }
    return result;
  }

  const Triangulation& t_;
  const Vertex_places<Triangulation>& places_;
  Exact_memory& memory_;
  Intrinsic_view<Triangulation> view_;
};

// The exact values that the metric of a triangulation decides by.
template <class Triangulation, class Places>
using Exact_values_of =
    std::conditional_t<Scales_vertices<typename Triangulation::Metric>,
                       Ideal_exact_values<Triangulation>, Exact_values<Triangulation, Places>>;

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_IDEAL_EXACT_VALUES_H
