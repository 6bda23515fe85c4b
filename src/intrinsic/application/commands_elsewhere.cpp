// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../become.h"
#include "../commands.h"
#include "../delaunay.h"
#include "isometry.h"

#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>

// Commands that the program `intrinsic-applications` leaves to the one that becomes it.

namespace program {

// Two correspondences are here so that the first program compiles faster: few users ask for them.
void run_delaunay(const Options& options) {
  if (options.correspondence == "crossings")
    run_delaunay_with<IT::Explicit_crossings>(options);
  else if (options.correspondence == "signposts")
    run_delaunay_with<IT::Signposts>(options);
  else
    become("intrinsic", options.arguments);
}
void run_transfer(const Options& options) { become("intrinsic", options.arguments); }
void run_view(const Options& options) { become("intrinsic", options.arguments); }
void run_info(const Options& options) {
  if (options.hashes)
    run_info_with_hash(options);
  else
    become("intrinsic", options.arguments);
}
void run_study(const Options& options) { become("intrinsic", options.arguments); }

} // namespace program
