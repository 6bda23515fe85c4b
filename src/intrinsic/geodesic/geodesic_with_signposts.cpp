// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geodesic.h"

#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>

namespace program {

void run_geodesic_with_signposts(const Options& options) {
  run_geodesic_with<IT::Signposts>(options);
}

} // namespace program
