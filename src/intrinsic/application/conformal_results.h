// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_APPLICATION_CONFORMAL_RESULTS_H
#define INTRINSIC_APPLICATION_CONFORMAL_RESULTS_H

#include "Computed.h"

#include <CGAL/Intrinsic_conformal/layout/lay_out_scaled.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <vector>

namespace program {

/*!
\brief makes a map of disks to the plane of what `uniformize` has computed: its functions are u and
v at each vertex of the file.
\param computed with a layout
\param surface the disks, or their double
\param points where the vertices of the mesh are
\param is_on_mesh whether files show the faces of the mesh, on which this is another map
*/
Computed map_of_disks(Computed computed, const IT::Input& surface, const std::vector<Point>& points,
                      bool is_on_mesh);

/// returns what files and pages show of a layout, and reports it.
/// \param points where the vertices of the mesh are
Laid_out shown_layout(const IT::Scaled_layout& layout, const std::vector<Point>& points,
                      Json& json);

} // namespace program

#endif // INTRINSIC_APPLICATION_CONFORMAL_RESULTS_H
