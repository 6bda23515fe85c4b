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

/*!
\brief writes the page that shows the intrinsic triangulation, and says on standard error what it
leaves out.
\param out the file
\param s the common subdivision
\param points the position of each vertex of it
\param options the options
\param json the statistics
\param view what else is shown
*/
void write_view(std::ostream& out, const IT::Common_subdivision& s,
                const std::vector<Point>& points, const Options& options, const Json& json,
                IT::Html_view view);

} // namespace program

#endif // INTRINSIC_VIEW_H
