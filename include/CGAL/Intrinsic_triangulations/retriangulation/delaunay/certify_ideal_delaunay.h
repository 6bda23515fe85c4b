// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_CERTIFY_IDEAL_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_CERTIFY_IDEAL_DELAUNAY_H

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Diamond_unfolder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Ideal_exact_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Penner_coordinates.h>
#include <CGAL/Intrinsic_triangulations/metric/nearest_lengths.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/Delaunay_certificate.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Decides which edges are ideal Delaunay, from integer coordinates, the input and the factors of
// vertices alone.
template <class Triangulation>
class Ideal_delaunay_certifier {
  using Interval = Interval_nt<false>;

public:
  explicit Ideal_delaunay_certifier(const Triangulation& t)
      : t_(t), coordinates_(t.correspondence().integer_coordinates()), view_(t),
        input_lambda_(nearest_lengths(t.input().metric(), t.input().mesh())) {}

  Delaunay_certificate certificate() {
    const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_face();
    const Protect_FPU_rounding<true> upwards;
    std::vector<Interval> lambda(t_.numbers().edge_capacity(t_.mesh()));
    for (const auto e : edges(t_.mesh())) lambda[t_.index(e)] = evaluate<Interval>(t_.index(e));
    Delaunay_certificate result;
    for (const auto e : edges(t_.mesh())) {
      const auto h = halfedge(e, t_.mesh());
      const auto f = face(h, t_.mesh()), g = face(opposite(h, t_.mesh()), t_.mesh());
      if (f == null || g == null || f == g) continue;
      const Sign s = sign(t_.diamond(h), lambda, result.statistics);
      if (s == NEGATIVE) ++result.non_delaunay_edges;
      if (s == ZERO) ++result.ties;
    }
    return result;
  }

private:
  // with factors of vertices
  template <class FT>
  FT evaluate(std::uint32_t e) {
    std::vector<FT> at;
    const FT lambda = lambda_on_input<FT>(view_, coordinates_, e, input_lambda_, unfolder_, at);
    const auto row = [this](std::uint32_t v) { return t_.input_vertex(t_.numbers().vertex_at(v)); };
    return t_.metric().scaled(lambda, row(view_.source(2 * e)), row(view_.target(2 * e)));
  }

  Sign sign(const Diamond& d, const std::vector<Interval>& lambda,
            Predicate_statistics& statistics) {
    ++statistics.checks;
    const Ideal_diamond_values<Interval> v{lambda[d.ij], lambda[d.jk], lambda[d.ki], lambda[d.im],
                                           lambda[d.mj]};
    const Interval outer = Ideal_delaunay_expression::outer(v),
                   inner = Ideal_delaunay_expression::inner(v);
    if (outer.inf() > inner.sup()) return POSITIVE;
    if (outer.sup() < inner.inf()) return NEGATIVE;
    ++statistics.filter_failures;
    const Sign s = CGAL::sign(Ideal_delaunay_expression()(
        Ideal_diamond_values<Gmpq>{evaluate<Gmpq>(d.ij), evaluate<Gmpq>(d.jk), evaluate<Gmpq>(d.ki),
                                   evaluate<Gmpq>(d.im), evaluate<Gmpq>(d.mj)}));
    ++(s == ZERO ? statistics.certified_zero : statistics.integer);
    return s;
  }

  const Triangulation& t_;
  const Integer_coordinates& coordinates_;
  Intrinsic_view<Triangulation> view_;
  std::vector<double> input_lambda_; // of the edges of the input
  Diamond_unfolder unfolder_;
};

} // namespace internal

/// \cond see the overload for Euclid's metric: doxygen cannot tell the two apart
// Uses only where edges run on the input, the lengths there, and the factors of vertices: no stored
// lambda lengths and no history. Normal coordinates define straight edges, and there are no areas,
// so that no face is inverted and no edge bent.
template <MutableDeltaComplex Mesh, IntrinsicTriangulationTraits Traits, class Correspondence>
  requires internal::Scales_vertices<typename Traits::Metric> && requires(const Correspondence& c) {
    c.integer_coordinates();
  }
Delaunay_certificate
certify_delaunay(const Intrinsic_triangulation<Mesh, Traits, Correspondence>& ideal) {
  return internal::Ideal_delaunay_certifier(ideal).certificate();
}
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_CERTIFY_IDEAL_DELAUNAY_H
