// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_VIEW_H
#define INTRINSIC_VIEW_H

#include "load.h"
#include "options.h"
#include "statistics.h"

#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/IO/view/write_html_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <array>
#include <cstddef>
#include <ostream>
#include <span>
#include <string>
#include <vector>

namespace program {

/// What a page shows besides the triangulation.
struct Viewed {
  std::span<const IT::Polyline> curves{}, initial_curves{};
  std::span<const IT::Subdivision_field> fields{}; ///< numbers at vertices, to be shown as colours
  std::size_t shown_field = 0;                     ///< which of them at first; others: none
  unsigned isolines = 0;                           ///< steps between lines of equal values of it
  std::span<const IT::Polyline> marks{};           ///< points that are marked, of one point each
  std::string marks_name{};
  std::span<const std::array<double, 2>> texture{}; ///< places in the plane, or none
  bool is_disk = false;                             ///< whether these are in Poincaré's disk
  bool is_plain =
      false; ///< whether edges are hidden at first, and faces without a field have no colours
  double curve_width = 3.5; ///< in pixels
};

/*!
\brief writes the page that shows the intrinsic triangulation, and says on standard error what it
leaves out; see `write_page()`.
*/
void write_view(std::ostream& out, const IT::Common_subdivision& s,
                const std::vector<Point>& points, const Options& options, const Json& json,
                const Viewed& viewed);

/*!
\brief writes the page that shows the intrinsic triangulation.
\param out the file
\param s the common subdivision
\param points the position of each vertex of it
\param options the options
\param json the statistics
\param viewed what else is shown
\return what the page leaves out
*/
IT::Html_view_report write_page(std::ostream& out, const IT::Common_subdivision& s,
                                const std::vector<Point>& points, const Options& options,
                                const Json& json, const Viewed& viewed);

} // namespace program

#endif // INTRINSIC_VIEW_H
