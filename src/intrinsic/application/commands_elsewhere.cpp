// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../become.h"
#include "../commands.h"

// Commands that the program `intrinsic-applications` leaves to the one that becomes it.

namespace program {

void run_delaunay(const Options& options) { become("intrinsic", options.arguments); }
void run_transfer(const Options& options) { become("intrinsic", options.arguments); }
void run_info(const Options& options) { become("intrinsic", options.arguments); }
void run_study(const Options& options) { become("intrinsic", options.arguments); }

} // namespace program
