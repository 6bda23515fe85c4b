// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_MARKED_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_MARKED_FACES_H

#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_result.h>
#include <CGAL/Intrinsic_triangulations/triangulation/RefinableTriangulation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief finds the fewest numbers whose squares sum to a share of the sum of all squares (the bulk criterion of
Dörfler 1996).
\param indicators numbers that are not negative
\param bulk the share, above 0 and at most 1
\return their positions, the largest number first; none where all are zero
\throws std::invalid_argument if the share is out of range, or a number negative or not finite
\complexity O(n log n)
*/
inline std::vector<std::size_t> mark_bulk(const std::vector<double>& indicators, double bulk) {
  if (!(bulk > 0 && bulk <= 1))
    throw std::invalid_argument("the bulk must be above 0 and at most 1");
  std::vector<std::size_t> order;
  double all = 0;
  for (std::size_t i = 0; i < indicators.size(); ++i) {
    if (!(indicators[i] >= 0) || !std::isfinite(indicators[i]))
      throw std::invalid_argument("the error indicator of face " + std::to_string(i) +
                                  " is negative or not finite; check the solution");
    all += indicators[i] * indicators[i];
    if (indicators[i] > 0) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return indicators[i] != indicators[j] ? indicators[i] > indicators[j] : i < j;
  });
  double sum = 0;
  std::size_t n = 0;
  while (n < order.size() && sum < bulk * all) {
    sum += indicators[order[n]] * indicators[order[n]];
    ++n;
  }
  order.resize(n);
  return order;
}

/*!
\brief remembers faces, as a visitor of `delaunay_refine()` that asks for their refinement.

A flip gives the number of a face to another one, so that a face is known by its corners and its area. It is
bad while it is there: until its circumcenter is inserted, or a vertex close by. A face that has come
to stand between the same vertices is bad too if it is not smaller. All bad faces have at least the area of
the smallest marked one, and with it a circumradius bounded from below: refinement ends.

\tparam Triangulation a model of `RefinableTriangulation`
*/
template <RefinableTriangulation Triangulation>
class Marked_faces : public Refinement_visitor {
public:
  /// remembers faces of a triangulation, given by their numbers.
  Marked_faces(const Triangulation& t, const std::vector<std::size_t>& numbers) {
    faces_.reserve(numbers.size());
    for (const std::size_t i : numbers) {
      const auto f = t.numbers().face_at(static_cast<std::uint32_t>(i));
      // predicates may sharpen the area by some roundings
      faces_.push_back({corners(t, f), (1 - 0x1p-20) * t.area(f)});
    }
    std::sort(faces_.begin(), faces_.end());
  }
  /// tells whether a face is one of those marked, or has taken its place and is as large.
  bool is_bad(const Triangulation& t, typename Triangulation::face_descriptor f) const {
    const Corners c = corners(t, f);
    const auto least =
        std::lower_bound(faces_.begin(), faces_.end(), c,
                         [](const Mark& m, const Corners& k) { return m.first < k; });
    return least != faces_.end() && least->first == c && t.area(f) >= least->second;
  }

private:
  using Corners = std::array<std::uint32_t, 3>;
  using Mark = std::pair<Corners, double>; // and the least area

  static Corners corners(const Triangulation& t, typename Triangulation::face_descriptor f) {
    const auto& mesh = t.mesh();
    const auto h = halfedge(f, mesh), n = next(h, mesh);
    Corners c{t.index(source(h, mesh)), t.index(target(h, mesh)), t.index(target(n, mesh))};
    std::sort(c.begin(), c.end());
    return c;
  }

  std::vector<Mark> faces_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_MARKED_FACES_H
