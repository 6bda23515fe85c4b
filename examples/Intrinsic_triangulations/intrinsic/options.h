// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_OPTIONS_H
#define INTRINSIC_OPTIONS_H

#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_result.h>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace program {

/// What faces are refined to.
struct Refinement_criteria {
  double minimum_angle = 30;
  double maximum_circumradius = std::numeric_limits<double>::infinity();
  double maximum_edge_length = std::numeric_limits<double>::infinity();
  std::optional<std::uint64_t> maximum_insertions = std::nullopt;
  CGAL::Intrinsic_triangulations::Refinement_order order =
      CGAL::Intrinsic_triangulations::Refinement_order::first_come;
};

/// What the command line asks for.
struct Options {
  std::string input;
  std::string arithmetic = "exact"; ///< `exact` or `double`
  /// `none`, `integer`, `signposts` or `crossings`; empty: what the command takes by default
  std::string correspondence;
  std::string mollification = "automatic"; ///< `automatic`, `none`, `lengths` or `squared`
  std::string output;                      ///< empty: none
  std::string view;                        ///< page that shows the triangulation; empty: none
  std::string mass;                        ///< empty: none
  std::string mass_kind = "lumped";        ///< `lumped` or `galerkin`
  std::string stats;                       ///< empty: none; `-`: standard output
  std::string laplacian;                   ///< of the refined triangulation; empty: none
  double odt_length = 0; ///< target of `odt_optimize()` after refinement; 0: it is not called
  std::optional<double> time_limit; ///< in seconds
  bool logs_progress = false;
  bool no_flip = false;
  bool refines = false;
  Refinement_criteria refinement;
  std::vector<std::string> study; ///< what follows the command `study`
  bool is_arithmetic_given = false;
  bool is_mollification_given = false;
};

/// tells whether the output is the common subdivision, not the intrinsic triangulation
inline bool is_mesh_output(const Options& options) {
  return !options.output.empty() && CGAL::Intrinsic_triangulations::is_common_subdivision_extension(
                                        std::filesystem::path(options.output).extension().string());
}

} // namespace program

#endif // INTRINSIC_OPTIONS_H
