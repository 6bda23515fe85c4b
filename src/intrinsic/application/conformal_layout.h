// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_APPLICATION_CONFORMAL_LAYOUT_H
#define INTRINSIC_APPLICATION_CONFORMAL_LAYOUT_H

#include "Computed.h"

#include <CGAL/Intrinsic_conformal/layout/lay_out_scaled.h>

#include <vector>

namespace program {

/// returns what files and pages show of a layout, and reports it.
/// \param points where the vertices of the mesh are
Laid_out shown_layout(const IT::Scaled_layout& layout, const std::vector<Point>& points,
                      Json& json);

} // namespace program

#endif // INTRINSIC_APPLICATION_CONFORMAL_LAYOUT_H
