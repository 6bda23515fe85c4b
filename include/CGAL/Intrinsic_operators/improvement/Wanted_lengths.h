// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_WANTED_LENGTHS_H
#define CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_WANTED_LENGTHS_H

#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief says how long edges may be: as long as the mean of the wanted lengths at their ends. Wanted
lengths are linear between the vertices of the input.
*/
class Wanted_lengths {
public:
  /// edges may have any length.
  Wanted_lengths() = default;
  /// \param lengths one per vertex of the input
  explicit Wanted_lengths(std::vector<double> lengths) : lengths_(std::move(lengths)) {}

  /// tells whether edges may have any length.
  bool empty() const { return lengths_.empty(); }

  /// returns the largest ratio of the length of a side of a face to the length wanted there.
  template <QueriedTriangulation Triangulation>
  double longest_side(const Triangulation& t, typename Triangulation::face_descriptor f) const {
    const auto& mesh = t.mesh();
    auto h = halfedge(f, mesh);
    double longest = 0, size = at(t, source(h, mesh));
    for (int k = 0; k < 3; ++k, h = next(h, mesh)) {
      const double size_of_target = at(t, target(h, mesh));
      const double squared = t.metric().approximate_squared_length(t.index(edge(h, mesh)));
      const double length = std::ldexp(std::sqrt(squared), -t.metric().scale_exponent());
      longest = std::max(longest, 2 * length / (size + size_of_target));
      size = size_of_target;
    }
    return longest;
  }

private:
  template <class Triangulation>
  double at(const Triangulation& t, typename Triangulation::vertex_descriptor v) const {
    if (!t.is_inserted(v)) return lengths_[t.input_vertex(v)];
    const Weighted_vertices w = weighted_vertices(t, t.correspondence().location(t.index(v)));
    double size = 0;
    for (std::size_t i = 0; i < w.size; ++i) size += w.weights[i] * lengths_[w.vertices[i]];
    return size;
  }

  std::vector<double> lengths_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_WANTED_LENGTHS_H
