// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_HTML_VIEW_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_HTML_VIEW_H

#include <CGAL/Intrinsic_triangulations/IO/curves/Polyline.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision_input.h>

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief tells what a page shows besides an intrinsic triangulation, and the scripts that it needs.
*/
struct Html_view {
  /// Title of the page.
  std::string_view title;
  /// Text under the title.
  std::string_view description;
  /// Text of three.js, revision 111 or near: it is copied into the page, with its licence notice.
  /// Empty: that of `find_three_js()`.
  std::string_view three;
  /// Text of the classic script `TrackballControls.js` of the same distribution. Empty: that of
  /// `find_three_js()`.
  std::string_view trackball_controls;
  /// Fields of numbers at vertices, one of which is shown as colours at a time.
  std::span<const Subdivision_field> fields{};
  /// Which of the fields is shown at first; none if there are fewer.
  std::size_t shown_field = 0;
  /// How many steps of the field lines of equal value show at first; 0: none.
  unsigned isolines = 0;
  /// A place in the plane for each vertex, to be shown by a checkerboard, not numbers where there
  /// is none; or nothing.
  std::span<const std::array<double, 2>> texture{};
  bool has_edges = true;       ///< whether edges show at first
  bool has_face_colors = true; ///< whether faces without a field have colours at first
  /// Width of curves in pixels.
  double curve_width = 3.5;
  /// Curves on the surface, to be drawn in colours that their labels choose.
  std::span<const Polyline> curves{};
  /// What the curves were before, to be drawn thin and grey.
  std::span<const Polyline> initial_curves{};
  /// Points to be marked, each a polyline of one point: red where the label is positive, blue where
  /// it is negative, else yellow.
  std::span<const Polyline> marks{};
  /// What the marked points are.
  std::string_view marks_name = "points";
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_HTML_VIEW_H
