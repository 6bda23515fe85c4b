// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_HAS_ACCURATE_VALUES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_HAS_ACCURATE_VALUES_H

#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/Summed_weights.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Metric_values.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

/*
Finds the edges whose weights doubles do not prove to be accurate, see `Summed_weights`, in half
of the time that all sums take: a corner with q > c (a + b + c) has a weight that its own bound does
not reach, whatever the area, and most edges are between two such corners.
*/
template <class Triangulation>
class Doubtful_weights {
  using Halfedge = typename Triangulation::halfedge_descriptor;

public:
  // \param width see `relative_width()` \pre rounding is to nearest
  Doubtful_weights(const Triangulation& t, double width) : t_(t), width_(Weight_bound::of(width)) {}

  // one halfedge of each, or both
  std::vector<Halfedge> operator()() const {
    std::vector<Halfedge> result;
    Block block;
    std::size_t n = 0;
    const auto empty = [&] {
      for (std::size_t i = 0; i < n; ++i)
        if (!is_certain(block[i])) result.push_back(block[i]);
      n = 0;
    };
    for (const typename Triangulation::face_descriptor f : faces(t_.mesh())) {
      n = add_small_corners(f, block, n);
      if (n + 3 > block.size()) empty();
    }
    empty();
    return result;
  }

private:
  // a few kilobytes: memory for all corners at once, which is new, took a fifth of the time
  using Block = std::array<Halfedge, 768>;

  // Adds the sides opposite small corners of a face to the first `n` of a block, without branches:
  // which corners are small is not predictable. \return how many there are now
  std::size_t add_small_corners(typename Triangulation::face_descriptor f, Block& block,
                                std::size_t n) const {
    Halfedge h = halfedge(f, t_.mesh());
    const Face_values<double> values = approximate_values(t_.metric(), indexed_face_from(t_, h));
    const auto [a, b, c] = values.squared_lengths;
    const double sum = a + b + c,
                 limit = 4 * width_ / statistics_tolerance * sum; // twice what suffices
    const bool has_area = values.quadruple_area > 2 * Weight_bound::least * sum;
    for (const double q : {b + c - a, c + a - b, a + b - c}) {
      block[n] = h;
      n += std::size_t{!(unsigned{q > limit} & unsigned{has_area})};
      h = next(h, t_.mesh());
    }
    return n;
  }

  // Whether an edge is on the border, or its weight is certain: by the sums of both corners times
  // both areas, since divisions take half of the time.
  bool is_certain(Halfedge h) const {
    const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_face();
    if (face(h, t_.mesh()) == null || face(opposite(h, t_.mesh()), t_.mesh()) == null) return true;
    const Diamond d = t_.diamond(h);
    const auto length = [this](std::uint32_t e) {
      return t_.metric().approximate_squared_length(e);
    };
    const double a_f = t_.metric().approximate_quadruple_area(d.f),
                 a_g = t_.metric().approximate_quadruple_area(d.g), ij = length(d.ij),
                 f = length(d.jk) + length(d.ki), g = length(d.im) + length(d.mj);
    const double weight = std::abs((f - ij) * a_g + (g - ij) * a_f), areas = a_f * a_g,
                 size = (f + ij) * a_g + (g + ij) * a_f;
    return width_ * size < statistics_tolerance / 4 * weight && areas > Weight_bound::least &&
           size < areas / (2 * Weight_bound::least);
  }

  const Triangulation& t_;
  double width_;
};

} // namespace internal

/*!
\brief tells whether `measure()` reads stored values as they are.

Else, with exact traits around slivers, it may make them more accurate: then the last bits of what
is computed afterwards depend on whether it was called.
\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\param t the triangulation, which does not change at all
\return true for traits without enclosures
\complexity linear
*/
template <NumberedTriangulation Triangulation>
  requires MeasuredTriangulation<Triangulation>
bool has_accurate_values(const Triangulation& t) {
  if constexpr (internal::Has_enclosures<typename Triangulation::Metric>) {
    const double width = internal::relative_width(t);
    if (!(width <= statistics_tolerance))
      for (const typename Triangulation::face_descriptor f : faces(t.mesh()))
        if (!t.metric().is_narrow(internal::indexed_face(t, f), statistics_tolerance)) return false;
    const auto doubtful = internal::Doubtful_weights<Triangulation>(t, width)();
    const typename Triangulation::Const_session session(t); // for arithmetic of intervals
    for (const typename Triangulation::halfedge_descriptor h : doubtful) {
      const Diamond d = t.diamond(h);
      if (!t.metric().stored_weight(d, statistics_tolerance) &&
          !t.metric().remembered_signs().is_zero(d.ij))
        return false;
    }
  }
  return true;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_HAS_ACCURATE_VALUES_H
