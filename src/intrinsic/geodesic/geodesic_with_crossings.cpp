// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geodesic.h"

#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>

namespace program {

void run_geodesic_with_crossings(const Options& options) {
  run_geodesic_with<IT::Explicit_crossings>(options);
}

} // namespace program
