// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../delaunay.h"

#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>

namespace program {

void run_delaunay_with_signposts(const Options& options) {
  run_delaunay_with<IT::Signposts>(options);
}

} // namespace program
