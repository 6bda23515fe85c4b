// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../become.h"
#include "../commands.h"

// Commands that the program `intrinsic-applications` leaves to the one that becomes it.

namespace program {

// Here, so that the first program compiles faster: few users ask for these two correspondences.
void run_delaunay_with_crossings(const Options& options);
void run_delaunay_with_signposts(const Options& options);

void run_delaunay(const Options& options) {
  if (options.correspondence == "crossings")
    run_delaunay_with_crossings(options);
  else if (options.correspondence == "signposts")
    run_delaunay_with_signposts(options);
  else
    become("intrinsic", options.arguments);
}
void run_transfer(const Options& options) { become("intrinsic", options.arguments); }
void run_info(const Options& options) { become("intrinsic", options.arguments); }
void run_study(const Options& options) { become("intrinsic", options.arguments); }

} // namespace program
