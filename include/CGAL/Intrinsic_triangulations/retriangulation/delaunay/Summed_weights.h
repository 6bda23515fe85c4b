// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_SUMMED_WEIGHTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_SUMMED_WEIGHTS_H

#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>
#include <CGAL/Intrinsic_triangulations/triangulation/metric_concepts.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The greatest relative width of the intervals that a metric stores; 0 if it stores none.
template <class Triangulation>
double relative_width(const Triangulation& t) {
  double ratio = 0;
  if constexpr (Has_enclosures<typename Triangulation::Metric>) {
    const auto widen = [&ratio](const auto& x) {
      const double width = x.sup() - x.inf();
      if (width > ratio * x.sup()) ratio = width / x.sup();
      if (!(x.sup() <= std::numeric_limits<double>::max())) // or no number
        ratio = std::numeric_limits<double>::infinity();
    };
    for (const typename Triangulation::edge_descriptor e : edges(t.mesh()))
      widen(t.metric().squared_length(t.index(e)));
    for (const typename Triangulation::face_descriptor f : faces(t.mesh()))
      widen(t.metric().quadruple_area(t.index(f)));
  }
  return ratio;
}

// Cotangents of the angles opposite the sides of a face.
// \param inverse of the quadruple area
inline std::array<double, 3> cotangents_of(const Face_values<double>& face, double inverse) {
  const auto [a, b, c] = face.squared_lengths;
  return {(b + c - a) * inverse, (c + a - b) * inverse, (a + b - c) * inverse};
}

/*
The cotangent weight of an edge as a sum over its corners, and a bound on its error.

The half cotangent of a corner is w = q / (2 A), where q = b + c - a, of squared lengths a, b, c and
the quadruple area A. Where no interval is wider than r times its values, the error of w is at most
r (a + b + c) / (2 A) + r |w| <= r (a + b + c) / A up to terms in r^2.
*/
struct Weight_bound {
  double weight = 0;
  double size = 0; // (a + b + c) / A of all faces

  // Products of smaller values, or their quotients, may lose digits below the range of doubles.
  static constexpr double least = 0x1p-500;

  // r, and what rounding adds: 2^-52 for rounding of q and w, 2^-52 for sums and, if r < 2^-29,
  // for terms in r^2. \param width see `relative_width()`
  static double of(double width) { return width + 0x1p-51; }

  // (a + b + c) / A of a face. \param inverse of the quadruple area
  static double size_of(const Face_values<double>& face, double inverse) {
    const auto [a, b, c] = face.squared_lengths;
    return (a + b + c) * inverse;
  }
  // adds a corner. \param cotangent see `cotangents_of()` \param size_of_face see `size_of()`
  void add(double cotangent, double size_of_face) {
    weight += cotangent / 2;
    size += size_of_face;
  }

  // Whether the error is at most `tolerance` times the weight: then its sign is right, too.
  // \param width see `of()` \param tolerance at most 2^-29
  bool is_certain(double width, double tolerance) const {
    const double w = std::abs(weight);
    return width * size < tolerance * w && w > least && size < 1 / least;
  }
};

/*
Cotangent weights of all edges as sums over faces, and bounds on their errors from one for all
stored intervals. So nearly all edges need no operation on intervals;
`Enclosed_values::stored_weight()` is left for ties, slivers, and meshes with wide intervals.
*/
template <class Triangulation>
class Summed_weights {
public:
  // whether there are bounds at all: other metrics give weights at least as fast
  static constexpr bool exist = Has_enclosures<typename Triangulation::Metric>;

  // \param width of stored intervals, see `relative_width()`
  // \pre rounding is to nearest, also in `add()`
  Summed_weights(const Triangulation& t, double width) : width_(Weight_bound::of(width)) {
    if constexpr (exist) sums_.resize(t.numbers().edge_capacity(t.mesh()));
  }

  // adds the corners of a face. \param cotangents as `cotangents_of()` returns them
  void add(const Indexed_face& face, const Face_values<double>& values, double inverse,
           const std::array<double, 3>& cotangents) {
    if constexpr (exist) {
      const double size = Weight_bound::size_of(values, inverse);
      for (std::size_t k = 0; k < 3; ++k) sums_[face.edges[k]].add(cotangents[k], size);
    }
  }

  // The weight of an edge whose faces were added, if its error is at most `tolerance` times itself:
  // then its sign is right, too.
  // \param tolerance at most 2^-29
  std::optional<double> certain(std::uint32_t e, double tolerance) const {
    if constexpr (exist)
      if (sums_[e].is_certain(width_, tolerance)) return sums_[e].weight;
    return std::nullopt;
  }

private:
  double width_; // see `Weight_bound::of()`
  std::vector<Weight_bound> sums_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_SUMMED_WEIGHTS_H
