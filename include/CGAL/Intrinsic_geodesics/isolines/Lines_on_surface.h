// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_ISOLINES_LINES_ON_SURFACE_H
#define CGAL_INTRINSIC_GEODESICS_ISOLINES_LINES_ON_SURFACE_H

#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Sheets.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// is an isoline over the input.
struct Traced_isoline {
  double level = 0;                ///< the value
  std::size_t number_of_level = 0; ///< its place among the levels
  bool is_closed = false;          ///< whether the last point is the first one
  Traced_curve curve;              ///< the way
};

namespace internal {

/*!
Takes the lines on a double cover to the surface under it, which has each of them once.

Lines come in pairs that the exchange of front and back maps to each other, away from the seams of
the cover. So lines are cut where they cross a seam; of two sections that are one line on the
surface, the one stays that has its greater part on one chosen sheet. A section that is its own
image, as a line twice around a Moebius strip, is cut where it leaves the chosen sheet. Both need
not be flipped alike: only their lengths on the sheets are compared.
*/
class Lines_on_surface {
public:
  // \complexity linear
  explicit Lines_on_surface(const Input& input);

  // Appends what is left of a line. \complexity linear
  void add(const Traced_isoline& line, std::vector<Traced_isoline>& lines) const;

private:
  bool is_chosen(const Traced_isoline& line, std::size_t piece) const;
  bool is_on_seam(const Surface_point& p) const;
  double length(const Traced_isoline& line, std::size_t piece) const;
  void add_section(const Traced_isoline& section, std::vector<Traced_isoline>& lines) const;
  Traced_isoline part(const Traced_isoline& line, std::size_t begin, std::size_t pieces) const;
  template <class Is_end>
  std::vector<Traced_isoline> split(const Traced_isoline& line, const Is_end& is_end) const;

  const Input& input_;
  Sheets sheets_;
  std::vector<char> chosen_; // by faces
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_ISOLINES_LINES_ON_SURFACE_H
