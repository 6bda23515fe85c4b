// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "become.h"
#include "commands.h"

// Commands that the program `intrinsic` leaves to other ones.

namespace program {

namespace {

const std::string applications = "intrinsic-applications";

} // namespace

void run_delaunay_elsewhere(const Options& options) { become(applications, options.arguments); }
void run_geodesic(const Options& options) { become(applications, options.arguments); }
void run_cut(const Options& options) { become(applications, options.arguments); }
void run_distance(const Options& options) { become(applications, options.arguments); }
void run_parametrize(const Options& options) { become(applications, options.arguments); }
void run_uniformize(const Options& options) { become(applications, options.arguments); }
void run_transport(const Options& options) { become(applications, options.arguments); }
void run_logmap(const Options& options) { become(applications, options.arguments); }
void run_field(const Options& options) { become(applications, options.arguments); }
void run_eigen(const Options& options) { become(applications, options.arguments); }
void run_embed(const Options& options) { become(applications, options.arguments); }
void run_edit(const Options& options) { become(applications, options.arguments); }
void run_simplify(const Options& options) { become(applications, options.arguments); }
void run_isometry(const Options& options) { become(applications, options.arguments); }

void run_study(const Options& options) { become("intrinsic-study", options.study); }

} // namespace program
