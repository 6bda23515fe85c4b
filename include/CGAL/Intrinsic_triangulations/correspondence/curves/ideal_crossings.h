// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_IDEAL_CROSSINGS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_IDEAL_CROSSINGS_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Edge_crossings.h>
#include <CGAL/Intrinsic_triangulations/formulas/Development.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/*!
\file
Where edges of an ideal triangulation cross edges of its input.

Every vertex p with its horocycle is a light-like vector v_p, and the point of a face with the
homogeneous coordinates s is the sum of the s_p v_p. In Euclid's triangle with the lambda lengths as
sides, the barycentric coordinates of the point are s over its sum: this projective map keeps the
circumcircle. With <v_p, v_q> = -lambda_pq^2, up to a constant, the crossing of edges ij and pq is

    lambda_ij (lambda_qi lambda_qj v_p + lambda_pi lambda_pj v_q)
      = lambda_pq (lambda_jp lambda_jq v_i + lambda_ip lambda_iq v_j).

A factor w of vertex p multiplies v_p by w^2.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief holds where crossings are along edges: on the input, in triangles with its lengths; on the
intrinsic triangulation, in triangles with its lambda lengths, factors of vertices included.
*/
struct Ideal_crossing_parameters : Crossing_parameters {
  /// Per crossing: the sum of the homogeneous coordinates on the intrinsic triangulation of the
  /// point whose coordinates on the input have the sum 1. At a vertex with factor w, it is 1 / w^2.
  std::vector<double> weight;
};

namespace internal {

// Computes lambda lengths from the ends of an edge to all points of its strip of input triangles;
// keeps its memory from edge to edge.
class Ideal_strip {
public:
  explicit Ideal_strip(const Input& input);

  // \param entered the input halfedges of the faces that the edge enters
  void measure(std::span<const std::uint32_t> entered);

  // the lambda length of the edge
  double length() const { return length_; }
  double length(std::uint32_t input_halfedge) const { return lambda_[input_halfedge / 2]; }
  // from the start of the edge to the source and the target of halfedge number `n` of `entered`
  const std::array<double, 2>& from_start(std::size_t n) const { return from_start_[n]; }
  // the same from its end
  std::array<double, 2> from_end(std::size_t n) const {
    const std::array<double, 2>& l = from_end_[from_end_.size() - 1 - n];
    return {l[1], l[0]};
  }

private:
  void measure(std::span<const std::uint32_t> entered, std::vector<std::array<double, 2>>& result,
               double& length);

  const Input& input_;
  std::vector<double> lambda_; // of the edges of the input
  Development<> strip_;        // from the first face that is entered on
  std::vector<double> at_;     // by point
  std::vector<std::uint32_t> backwards_;
  std::vector<std::array<double, 2>> from_start_, from_end_;
  double length_ = 0;
};

} // namespace internal

/*!
\brief computes where the edges of a triangulation with an ideal hyperbolic metric cross those of
the input.

It uses only the lengths of the input and the connectivity of the crossings. All terms are positive:
relative errors are a few roundings per crossing of the edge.
\tparam Triangulation a model of `IndexedTriangulation`, with an ideal hyperbolic metric
\tparam Coordinates a model of `CurveCoordinates`
\param t the triangulation
\param coordinates its normal coordinates and roundabouts
\param crossings what `edge_crossings()` returned
\complexity linear in the number of crossings
*/
template <IndexedTriangulation Triangulation, CurveCoordinates Coordinates>
  requires internal::Scales_vertices<typename Triangulation::Metric>
      Ideal_crossing_parameters ideal_crossing_parameters(const Triangulation& t,
                                                          const Coordinates& coordinates,
                                                          const Edge_crossings& crossings) {
    const Intrinsic_view<Triangulation> view(t);
    const auto factor = [&t](std::uint32_t v) {
      return t.metric().factor(t.input_vertex(t.numbers().vertex_at(v)));
    };
    Ideal_crossing_parameters p;
    for (auto* values : {&p.on_input, &p.on_intrinsic, &p.weight}) values->resize(crossings.size());
    internal::Ideal_strip strip(coordinates.input());
    for (std::uint32_t e = 0; e + 1 < crossings.begin.size(); ++e) {
      const std::span<const std::uint32_t> entered = crossings.entered_on(e);
      if (entered.empty()) continue;
      strip.measure(entered);
      const double w_i = factor(view.source(2 * e)), w_j = factor(view.target(2 * e));
      for (std::size_t n = 0; n < entered.size(); ++n) {
        const auto [ip, iq] = strip.from_start(n);
        const auto [jp, jq] = strip.from_end(n);
        const double at_p = iq * jq, at_q = ip * jp; // on the input, up to a factor
        const double at_i = jp * jq / (w_i * w_i), at_j = ip * iq / (w_j * w_j);
        const std::size_t c = crossings.begin[e] + n;
        p.on_input[c] = (entered[n] % 2 == 0 ? at_q : at_p) / (at_p + at_q);
        p.on_intrinsic[c] = at_j / (at_i + at_j);
        p.weight[c] = strip.length(entered[n]) / strip.length() * ((at_i + at_j) / (at_p + at_q));
      }
    }
    internal::make_monotone(crossings, p);
    return p;
  }

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_IDEAL_CROSSINGS_H
