// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_OPTION_GROUPS_H
#define INTRINSIC_OPTION_GROUPS_H

#include "options.h"
#include "support/command_line.h"

#include <string>

// What several commands are asked in the same words.

namespace program {

/// adds the input, and what all commands take.
void add_common_options(CLI::App& command, Options& options);
/// adds edges that are kept.
void add_constraint_options(CLI::App& command, Options& options);
/// adds other lengths than those in space.
void add_metric_option(CLI::App& command, Options& options);
/// adds what `refine` inserts vertices for.
void add_refinement_options(CLI::App& command, Options& options);
/// adds what takes the place of other criteria than the least angle.
void add_adaptive_options(CLI::App& command, Options& options);
/// adds matrices besides the Laplacian.
void add_matrix_options(CLI::App& command, Options& options);
/// adds where edges run on the input, and what is written of it.
void add_correspondence_options(CLI::App& command, Options& options);
/// adds curves that are made geodesic, and how far.
void add_curve_options(CLI::App& command, Options& options);
/// adds what is written of curves.
void add_curve_output_options(CLI::App& command, Options& options);
/// adds all that commands take that solve something on the triangulation: its refinement, where results are written, and points from which
/// they start, if they do.
void add_application_options(CLI::App& command, Options& options, bool has_sources = false);
/// adds curves as sources of distances.
void add_distance_options(CLI::App& command, Options& options);
/// adds how long heat flows.
void add_time_option(CLI::App& command, Options& options);
/// refuses criteria of refinement without an option.
void make_refinement_options_need(CLI::Option& refine, CLI::App& command);

/// returns what is wrong with the options of the command `geodesic`, like `misuse()`.
std::string geodesic_misuse(const Options& options);
/// returns what is wrong with the options of the command `distance`, like `misuse()`.
std::string distance_misuse(const Options& options);
/// returns what is wrong with the options of the command `field`, like `misuse()`.
std::string field_misuse(const Options& options);
/// returns what is wrong with options that are valid by themselves, and the remedy; empty: nothing.
std::string misuse(const Options& options);

} // namespace program

#endif // INTRINSIC_OPTION_GROUPS_H
