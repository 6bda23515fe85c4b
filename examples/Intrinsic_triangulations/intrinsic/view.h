// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_VIEW_H
#define INTRINSIC_VIEW_H

#include "load.h"
#include "options.h"
#include "statistics.h"

#include <CGAL/Intrinsic_triangulations/IO/curves/Polyline.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <ostream>
#include <span>
#include <vector>

namespace program {

/// Curves that a page shows.
struct Viewed_curves {
  std::span<const IT::Polyline> curves, initial_curves;
};

/*!
\brief writes the page that shows the intrinsic triangulation.
\param out the file
\param s the common subdivision
\param points the position of each vertex of it
\param options the options
\param json the statistics
\param curves curves on the surface
*/
void write_view(std::ostream& out, const IT::Common_subdivision& s,
                const std::vector<Point>& points, const Options& options, const Json& json,
                const Viewed_curves& curves);

} // namespace program

#endif // INTRINSIC_VIEW_H
