// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_ENCLOSED_VALUES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_ENCLOSED_VALUES_H

#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/formulas/nonnegative_intervals.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief stores squared lengths and quadruple areas: intervals that contain the exact values, and
doubles within.

The middle of a wide interval is a poor approximation; doubles computed beside it, and kept within
it, are a good one.

A decider narrows the intervals, which are a cache of the exact values; only moves change those. So
`refine()` is const; there are no locks.
*/
class Enclosed_values {
public:
  /// Number type of the intervals.
  using FT = Interval_nt<false>;

  /// New values of a flip: intervals, and the doubles beside them.
  struct Flipped {
    Flipped_values<FT> enclosure;         ///< intervals that contain the values
    Flipped_values<double> approximation; ///< values in floating point
  };

  /// New values of an insertion of a vertex: intervals and doubles.
  using New_values = std::pair<Vertex_move_values<FT>, Vertex_move_values<double>>;

  /// constructs no values.
  Enclosed_values() = default;

  /// takes intervals and doubles of squared lengths and quadruple areas.
  /// \param squared_lengths, quadruple_areas, lengths, areas in scaled units
  /// \param are_input_lengths_positive what the function of that name returns
  Enclosed_values(std::vector<FT> squared_lengths, std::vector<FT> quadruple_areas,
                  std::vector<double> lengths, std::vector<double> areas,
                  bool are_input_lengths_positive = true)
      : squared_length_(std::move(squared_lengths)), quadruple_area_(std::move(quadruple_areas)),
        length_(std::move(lengths)), area_(std::move(areas)),
        are_input_lengths_positive_(are_input_lengths_positive) {}

  /// tells whether the area of a face is zero; exact for an input face.
  bool is_degenerate(std::uint32_t f) const { return quadruple_area_[f].sup() <= 0; }
  /// tells whether the length of an edge is zero; exact for an input edge.
  bool is_zero_length(std::uint32_t e) const { return squared_length_[e].sup() <= 0; }
  /// tells whether all edges of the input had a length. \pre the values are not restored
  bool are_input_lengths_positive() const { return are_input_lengths_positive_; }
  /// returns an interval that contains the squared length of an edge, in scaled units.
  const FT& squared_length(std::uint32_t e) const { return squared_length_[e]; }
  /// returns an interval that contains the quadruple area of a face, in scaled units.
  const FT& quadruple_area(std::uint32_t f) const { return quadruple_area_[f]; }
  /// returns a double near the squared length of an edge, in scaled units.
  double approximate_squared_length(std::uint32_t e) const { return length_[e]; }
  /// returns a double near the quadruple area of a face, in scaled units.
  double approximate_quadruple_area(std::uint32_t f) const { return area_[f]; }
  /// returns half the cotangent of the angle opposite side `ij` of face `f` with sides ij, jk, ki.
  double cotangent_weight(std::uint32_t ij, std::uint32_t jk, std::uint32_t ki,
                          std::uint32_t f) const {
    return (length_[jk] + length_[ki] - length_[ij]) / (2 * area_[f]);
  }

  /// Greatest relative width of intervals whose doubles users get, unless they allow larger errors:
  /// below half of the 1e-12 that `measures.h` states.
  static constexpr double narrow = 0x1p-41;

  /// tells whether the interval of the squared length of an edge has at most the relative width
  /// `narrow`.
  bool is_narrow(std::uint32_t edge) const {
    const FT& x = squared_length_[edge];
    return is_narrow(x, narrow * x.sup());
  }
  /// tells whether the interval of the quadruple area of a face has at most a relative width.
  bool is_area_narrow(std::uint32_t face, double width = narrow) const {
    const FT& x = quadruple_area_[face];
    return is_narrow(x, width * x.sup());
  }
  /// tells whether the intervals of a face have at most a relative width; with the default the
  /// values are precise enough to place points in the face, for lengths of an ordinary face.
  bool is_narrow(const Indexed_face& face, double width = narrow) const;

  /// returns the intervals of a diamond.
  Diamond_values<FT> enclosure(const Diamond& d) const {
    return gather(squared_length_, quadruple_area_, d);
  }
  /// returns the intervals of a face.
  Face_values<FT> enclosure(const Indexed_face& f) const {
    return gather(squared_length_, quadruple_area_, f);
  }
  /// returns the intervals of faces.
  std::vector<Face_values<FT>> enclosures(std::span<const Indexed_face> faces) const {
    std::vector<Face_values<FT>> result;
    result.reserve(faces.size());
    for (const Indexed_face& f : faces) result.push_back(enclosure(f));
    return result;
  }

  /// makes room for values of so many edges and faces.
  void make_room(std::uint32_t edges, std::uint32_t faces);

  /// makes the intervals of a diamond smaller. \pre `better` contains the exact values
  void refine(const Diamond& d, const Diamond_values<FT>& better) const;
  /// makes the intervals of faces smaller; see above.
  void refine(std::span<const Indexed_face> faces,
              const std::vector<Face_values<FT>>& better) const;
  /// makes the intervals of a face smaller; see above.
  void refine(const Indexed_face& face, const Face_values<FT>& better) const;
  /// makes the interval of a squared length smaller; see above.
  void refine_length(std::uint32_t e, const FT& better) const {
    refine(squared_length_[e], length_[e], better);
  }
  /// makes the interval of a quadruple area smaller; see above.
  void refine_area(std::uint32_t f, const FT& better) const {
    refine(quadruple_area_[f], area_[f], better);
  }

  /// computes a flip so that the doubles stay good, see `flipped_consistently()`. Use it for edges
  /// that may be Delaunay: on others errors do not grow. \pre the diamond is strictly convex
  std::optional<Flipped> compute_consistent_flip(const Diamond& d) const {
    return Flipped{flipped_nonnegative(enclosure(d)), flipped_consistently(approximation(d))};
  }

  /// Greatest error of stored weights that users get, unless they allow larger ones.
  static constexpr double weight_tolerance = 0x1p-40;

  /// returns the weight of an edge between two faces, as `stored_weight()` does, if intervals prove
  /// without division that its error is at most `tolerance` times itself: the usual case.
  // inlined by force: in a loop over all edges the calls took as long as the proofs
  BOOST_FORCEINLINE std::optional<double> usual_weight(const Diamond& d,
                                                       double tolerance = weight_tolerance) const {
    const FT &a_f = quadruple_area_[d.f], &a_g = quadruple_area_[d.g];
    const auto [q_f, q_g] = numerators(d);
    const double left = cotangent_weight(d.ij, d.jk, d.ki, d.f),
                 right = cotangent_weight(d.ij, d.im, d.mj, d.g), weight = left + right,
                 size = std::abs(weight), product_of_areas = a_f.inf() * a_g.inf(),
                 part = rest_of_weight(left, q_f, a_f) * a_g.inf() +
                        rest_of_weight(right, q_g, a_g) * a_f.inf();
    const bool is_proven = part <= 2 * (tolerance - 0x1p-51) * (size * product_of_areas) &&
                           size < 0x1p1000 && size > 0x1p-900 && product_of_areas > 0x1p-900;
    return is_proven ? std::optional(weight) : std::nullopt;
  }

  /*!
  \brief returns the weight of an edge between two faces from the doubles, if the intervals prove it
  accurate enough:

  its sign is right, it is zero only where the intervals are zero too, and its error is at most
  `tolerance` times itself or min(1, E), where E = (a_f + a_g) / (4 L_ij) is the least Dirichlet
  energy in the two faces of functions that change by one along the edge. The default is just below
  the 1e-12 that `measures.h` states.
  */
  std::optional<double> stored_weight(const Diamond& d, double tolerance = weight_tolerance) const {
    if (const auto weight = usual_weight(d, tolerance)) return weight;
    const FT &ij = squared_length_[d.ij], &a_f = quadruple_area_[d.f], &a_g = quadruple_area_[d.g];
    const auto [q_f, q_g] = numerators(d);
    const double left = cotangent_weight(d.ij, d.jk, d.ki, d.f),
                 right = cotangent_weight(d.ij, d.im, d.mj, d.g), weight = left + right,
                 size = std::abs(weight);
    const double error = error_of_weight(left, q_f, a_f) + error_of_weight(right, q_g, a_g) +
                         0x1p-52 * size,
                 energy = 0.25 * (a_f.inf() + a_g.inf()) / ij.sup();
    if (!(error <= tolerance * std::max(size, std::min(energy, 1.0))) || !(size < 0x1p1000))
      return std::nullopt;
    // a sum that the error does not reach
    if (error < size) return weight;
    const FT product = delaunay_value(q_f, a_f, q_g, a_g);
    if (product.inf() == 0 && product.sup() == 0) return 0.0; // as on axis-parallel meshes
    const bool is_certain = weight > 0 ? product.inf() > 0 : weight < 0 && product.sup() < 0;
    return is_certain ? std::optional(weight) : std::nullopt;
  }

protected:
  /// returns `cotangent_numerators()`.
  BOOST_FORCEINLINE std::pair<FT, FT> numerators(const Diamond& d) const {
    return cotangent_numerators(squared_length_, d);
  }
  /// returns the doubles of a diamond.
  Diamond_values<double> approximation(const Diamond& d) const { return gather(length_, area_, d); }

  /// computes the new values of a flip. \pre the diamond is strictly convex
  // inlined by force: passing its result takes a tenth of the time of a flip
  BOOST_FORCEINLINE Flipped flipped_values(const Diamond& d) const {
    return {flipped_nonnegative(enclosure(d)), flipped(approximation(d))};
  }

  /// returns the values that a flip replaces.
  Flipped stored(const Diamond& d) const {
    return {{squared_length_[d.ij], quadruple_area_[d.f], quadruple_area_[d.g]},
            {length_[d.ij], area_[d.f], area_[d.g]}};
  }

  /// stores the new values of a flip.
  BOOST_FORCEINLINE void store(const Diamond& d, const Flipped& n) noexcept {
    const auto& [enclosure, approximation] = n;
    squared_length_[d.ij] = positive_part(enclosure.km);
    quadruple_area_[d.f] = positive_part(enclosure.area_f);
    quadruple_area_[d.g] = positive_part(enclosure.area_g);
    length_[d.ij] = nearest(approximation.km, squared_length_[d.ij]);
    area_[d.f] = nearest(approximation.area_f, quadruple_area_[d.f]);
    area_[d.g] = nearest(approximation.area_g, quadruple_area_[d.g]);
  }

  /// stores the new values of an insertion, also for new edges and faces. \pre there is room
  void store(std::span<const std::uint32_t> edges, std::span<const std::uint32_t> faces,
             const New_values& n) noexcept;

private:
  // a bound on |q - 2 w a|; rounding is upwards
  static double rest_of_weight(double w, const FT& q, const FT& a) {
    const FT rest = q + product_with_nonnegative(FT(-2 * w), a);
    return std::max(rest.sup(), -rest.inf());
  }
  // A bound on |w - q / (2 a)|.
  static double error_of_weight(double w, const FT& q, const FT& a) {
    return a.inf() > 0 ? rest_of_weight(w, q, a) / (2 * a.inf())
                       : std::numeric_limits<double>::infinity();
  }

  static bool is_narrow(const FT& x, double width) {
    return x.sup() - x.inf() <= width && CGAL::is_finite(x);
  }

  template <class T>
  static Diamond_values<T> gather(const std::vector<T>& lengths, const std::vector<T>& areas,
                                  const Diamond& d) {
    return {lengths[d.ij], lengths[d.jk], lengths[d.ki], lengths[d.im],
            lengths[d.mj], areas[d.f],    areas[d.g]};
  }

  template <class T>
  static Face_values<T> gather(const std::vector<T>& lengths, const std::vector<T>& areas,
                               const Indexed_face& f) {
    return {{lengths[f.edges[0]], lengths[f.edges[1]], lengths[f.edges[2]]}, areas[f.face]};
  }

  // Lengths and areas are never negative, even if rounding makes the lower bound negative.
  static FT positive_part(const FT& x) { return {std::max(x.inf(), 0.0), x.sup()}; }

  static void refine(FT& stored, double& approximation, const FT& better);

  // the lower bound if x is not a number
  static double nearest(double x, const FT& interval) {
    return x >= interval.inf() ? std::min(x, interval.sup()) : interval.inf();
  }

  // mutable: see `refine()`
  mutable std::vector<FT> squared_length_;
  mutable std::vector<FT> quadruple_area_;
  mutable std::vector<double> length_; // squared
  mutable std::vector<double> area_;   // quadruple
  bool are_input_lengths_positive_ = true;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_ENCLOSED_VALUES_H
