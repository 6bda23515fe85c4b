// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STUDY_REPORT_PARTS_H
#define INTRINSIC_STUDY_REPORT_PARTS_H

#include "study_report_lines.h"
#include "svg_plot.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace program {

/// Sums over the meshes that two arithmetics have done.
struct Time_ratio {
  std::size_t meshes = 0;
  double seconds = 0, reference = 0;

  /// returns the ratio, if there is one.
  std::optional<double> ratio() const {
    return reference > 0 ? std::optional<double>(seconds / reference) : std::nullopt;
  }
};

/// Number of meshes with the same result, of those where both arithmetics have one.
struct Agreement {
  std::size_t same = 0, compared = 0;
  std::vector<std::string> different; ///< names of the others
};

/// returns the arithmetics that have done at least nine meshes of ten.
std::vector<std::string> finishing_arithmetics(const Study_results& results);
/// returns the meshes that all of some arithmetics have done, with times.
std::vector<const Study_mesh*> common_meshes(const Study_results& results,
                                             const std::vector<std::string>& arithmetics);
/// sums times of an arithmetic and of `double` over those of some meshes that both have done.
Time_ratio time_ratio(const std::vector<const Study_mesh*>& meshes, const std::string& arithmetic);
/// compares the hashes of results of two arithmetics.
Agreement agreement(const Study_results& results, const std::string& a, const std::string& b);

/// writes the sums per arithmetic.
void write_summary(std::ostream& out, const Study_results& results);
/// writes where inexact decisions did harm.
void write_harm(std::ostream& out, const Study_results& results);
/// writes where an arithmetic did not finish.
void write_unfinished(std::ostream& out, const Study_results& results);
/// writes what it took certified arithmetics to decide.
void write_escalations(std::ostream& out, const Study_results& results);

/// plots time against the number of faces.
void plot_times(std::ostream& out, const Study_results& results);
/// plots the share of meshes done within so many times the time of `double`.
void plot_profile(std::ostream& out, const Study_results& results);
/// plots how many predicates needed what.
void plot_escalations(std::ostream& out, const Study_results& results);
/// plots edges that are not Delaunay against the amount, for stress meshes that differ in it only.
void plot_stress(std::ostream& out, const Study_results& results);

/// Predicates that the filter left open, by what decided them, in order of cost.
using Decided_by = std::vector<std::pair<std::string, std::uint64_t>>;
/// returns them for an arithmetic, summed over meshes, with the same names for all of `results`.
Decided_by decided_by(const Study_results& results, const std::string& arithmetic);

} // namespace program

#endif // INTRINSIC_STUDY_REPORT_PARTS_H
