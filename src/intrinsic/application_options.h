// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_APPLICATION_OPTIONS_H
#define INTRINSIC_APPLICATION_OPTIONS_H

#include "option_groups.h"

// The options of commands that solve a problem on the triangulation.

namespace program {

/// adds where distances start, and where the search for them ends.
void add_distance_searches(CLI::App& command, Options& options);
/// adds lines of equal distance, and lines between cells.
void add_distance_lines(CLI::App& command, Options& options);
/// adds the options of the command `parametrize`.
void add_parametrize_options(CLI::App& command, Options& options);
/// adds those of `uniformize`.
void add_uniformize_options(CLI::App& command, Options& options);
/// adds those of `transport`.
void add_transport_options(CLI::App& command, Options& options);
/// adds those of `logmap`.
void add_logmap_options(CLI::App& command, Options& options);
/// adds those of `field`.
void add_field_options(CLI::App& command, Options& options);
/// adds those of `eigen`.
void add_eigen_options(CLI::App& command, Options& options);
/// adds those of `edit`.
void add_edit_options(CLI::App& command, Options& options);

} // namespace program

#endif // INTRINSIC_APPLICATION_OPTIONS_H
