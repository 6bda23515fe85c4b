// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_OPTION_GROUPS_H
#define INTRINSIC_OPTION_GROUPS_H

#include "options.h"
#include "support/command_line.h"
#include "support/file_formats.h"

#include <string>
#include <vector>

// Options that several commands have in common.

namespace program {

/// returns a check that the extension of a file allows one of several contents; the error lists
/// them with their extensions.
CLI::Validator file_of(std::vector<Contents> offered);
/// adds an option that names a file to be written with one of several contents; its help lists
/// them with their extensions.
CLI::Option* add_output_option(CLI::App& command, const std::string& name, std::string& path,
                               const std::vector<Contents>& offered);
/// adds a page that shows something.
void add_view_option(CLI::App& command, Options& options, const std::string& what);

/// adds the input, and the options of all commands.
void add_common_options(CLI::App& command, Options& options);
/// adds edges that are kept.
void add_constraint_options(CLI::App& command, Options& options);
/// adds other lengths than those in space.
void add_metric_option(CLI::App& command, Options& options);
/// adds the criteria of `refine`.
void add_refinement_options(CLI::App& command, Options& options);
/// adds adaptive refinement, which replaces all criteria but the least angle; the vertex that it is
/// about may be named by another option.
void add_adaptive_options(CLI::App& command, Options& options, bool has_vertex = true);
/// adds matrices besides the Laplacian.
void add_matrix_options(CLI::App& command, Options& options);
/// adds the correspondence, and the files that need it.
void add_correspondence_options(CLI::App& command, Options& options);
/// adds curves to be made geodesic, and where to stop.
void add_curve_options(CLI::App& command, Options& options);
/// adds curves and isolines to cut along, and the files of the cut surface.
void add_cut_options(CLI::App& command, Options& options);
/// adds the files of curves.
void add_curve_output_options(CLI::App& command, Options& options);
/// adds the options of all commands that solve a problem on the triangulation: refinement, files of
/// results, and the points from which they start, if they do.
void add_application_options(CLI::App& command, Options& options, bool has_sources = false,
                             const std::vector<Contents>& outputs = {Contents::values,
                                                                     Contents::subdivision});
/// adds the triangles whose lengths conformal maps scale.
void add_start_option(CLI::App& command, Options& options);
/// adds prescribed angles, and where results are written.
void add_uniformize_options(CLI::App& command, Options& options);
/// adds the method, curves as sources, and the limits of the search.
void add_distance_options(CLI::App& command, Options& options);
/// adds how long heat flows.
void add_time_option(CLI::App& command, Options& options);
/// refuses criteria of refinement without an option.
void make_refinement_options_need(CLI::Option& refine, CLI::App& command);

/// returns what is wrong with the options of the command `geodesic`, like `misuse()`.
std::string geodesic_misuse(const Options& options);
/// returns what is wrong with the options of the command `cut`, like `misuse()`.
std::string cut_misuse(const Options& options);
/// returns what is wrong with the options of the command `distance`, like `misuse()`.
std::string distance_misuse(const Options& options);
/// returns what is wrong with the options of the command `parametrize`, like `misuse()`.
std::string parametrize_misuse(const Options& options);
/// returns what is wrong with the options of the command `field`, like `misuse()`.
std::string field_misuse(const Options& options);
/// returns what is wrong with options that are valid by themselves, and the remedy; empty: nothing.
std::string misuse(const Options& options);

} // namespace program

#endif // INTRINSIC_OPTION_GROUPS_H
