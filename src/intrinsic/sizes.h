// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SIZES_H
#define INTRINSIC_SIZES_H

#include "options.h"
#include "support/text_lines.h"

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace program {

namespace IT = CGAL::Intrinsic_triangulations;

/// reads the wanted lengths of edges, one per vertex of the input; none without `--size`.
/// \throws std::runtime_error naming the line that is wrong
std::vector<double> read_sizes(const Options& options, std::size_t vertices);

/*!
\brief says how long edges may be: as long as the mean of the wanted lengths at their ends. Wanted
lengths are linear between the vertices of the input.
*/
class Sizes {
public:
  /// edges may have any length.
  Sizes() = default;
  /// \param sizes one per vertex of the input
  explicit Sizes(std::vector<double> sizes) : sizes_(std::move(sizes)) {}

  bool empty() const { return sizes_.empty(); }

  /// returns the largest ratio of the length of a side of a face to the length wanted there.
  template <class Triangulation>
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
    if (!t.is_inserted(v)) return sizes_[t.input_vertex(v)];
    const IT::Weighted_vertices w =
        IT::weighted_vertices(t, t.correspondence().location(t.index(v)));
    double size = 0;
    for (std::size_t i = 0; i < w.size; ++i) size += w.weights[i] * sizes_[w.vertices[i]];
    return size;
  }

  std::vector<double> sizes_;
};

} // namespace program

#endif // INTRINSIC_SIZES_H
