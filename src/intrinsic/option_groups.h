// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_OPTION_GROUPS_H
#define INTRINSIC_OPTION_GROUPS_H

#include "options.h"
#include "support/command_line.h"
#include "support/file_formats.h"

#include <cstddef>
#include <string>
#include <vector>

// Options that several commands have in common, and what is wrong with options.

namespace program {

/// The megabytes that a page may have.
inline constexpr IT::Number_range page_megabytes{2, 2000};

/// Adds options to a command.
using Option_group = void (*)(CLI::App&, Options&);

/// A command: one row of the table that the program reads.
struct Command {
  const char* name;                                ///< on the command line
  const char* help;                                ///< what it does
  void (*run)(const Options&);                     ///< does it
  std::vector<Option_group> options;               ///< in the order of its help
  std::string (*misuse)(const Options&) = nullptr; ///< what is wrong with its options alone
};

/// returns all commands, in the order of the help.
const std::vector<Command>& commands();

/// returns a check that the extension of a file allows one of several contents; the error lists
/// them with their extensions. `-`, standard output, gets the first of these: `-.txt`.
Completion file_of(std::vector<Contents> offered);
/// returns a check that a word is a list of so many points at least.
CLI::Validator curve_points(std::size_t least);
/// returns a check that a word is how many levels there are, or a list of them.
CLI::Validator level_list();
/// adds an option that names a file to be written with one of several contents; its help lists
/// them with their extensions.
void add_output_option(CLI::App& command, Options& options, const std::string& name,
                       std::string& path, const std::vector<Contents>& offered);
/// adds whether meshes have only what all readers expect.
void add_plain_flag(CLI::App& command, Options& options);
/// adds a page that shows something.
void add_view_option(CLI::App& command, Options& options, const std::string& what);

/// adds the input, and the options of all commands.
void add_common_options(CLI::App& command, Options& options);
/// adds a second surface, which is compared with the input.
void add_isometry_options(CLI::App& command, Options& options);
/// adds what `info` computes of the surface.
void add_info_options(CLI::App& command, Options& options);
/// adds edges that are kept.
void add_constraint_options(CLI::App& command, Options& options);
/// adds other lengths than those in space.
void add_metric_option(CLI::App& command, Options& options);
/// adds the file of a polyhedron.
void add_polyhedron_option(CLI::App& command, Options& options);
/// adds the criteria of `refine`.
void add_refinement_options(CLI::App& command, Options& options);
/// adds adaptive refinement, which replaces all criteria but the least angle. The vertex that it is
/// about may be named by another option.
void add_adaptive_options(CLI::App& command, Options& options, bool has_vertex);
/// adds the same, with the vertex.
void add_adaptive_options(CLI::App& command, Options& options);
/// adds matrices besides the Laplacian.
void add_matrix_options(CLI::App& command, Options& options);
/// adds the correspondence, and the files that need it.
void add_correspondence_options(CLI::App& command, Options& options);
/// adds `--refine`.
void add_refine_flag(CLI::App& command, Options& options);
/// adds curves that may be given together.
void add_joined_curve_options(CLI::App& command, Options& options);
/// adds files of results, refinement, and the points from which something is computed, if there are
/// any: then adaptive refinement is about the first of them.
void add_results(CLI::App& command, Options& options, bool has_sources,
                 const std::vector<Contents>& outputs = {Contents::values, Contents::subdivision});
/// adds the same, without points.
void add_result_options(CLI::App& command, Options& options);
/// adds how long heat flows.
void add_time_option(CLI::App& command, Options& options);
/// adds the triangles whose lengths conformal maps scale.
void add_start_option(CLI::App& command, Options& options);
/// refuses criteria of refinement without `--refine`, if the command has this option.
void make_refinement_options_need_refine(CLI::App& command);

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
