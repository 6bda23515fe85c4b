// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "asked_curves.h"
#include "option_groups.h"
#include "support/file_formats.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace program {

namespace {

// However they are spelled, and through links of either kind.
bool are_same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  const auto path = [](const std::string& name) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(name));
  };
  return path(a) == path(b) || (std::filesystem::is_regular_file(a, ignored) &&
                                std::filesystem::equivalent(a, b, ignored));
}

bool are_same_output(const Output& a, const Output& b) {
  const bool is_standard = is_standard_output(a.path);
  return is_standard == is_standard_output(b.path) &&
         (is_standard || are_same_file(a.path, b.path));
}

bool names_a_file_twice(const Options& o) {
  const std::vector<Output> all = outputs(o);
  for (auto i = all.begin(); i != all.end(); ++i)
    if (std::any_of(i + 1, all.end(), [&](const auto& n) { return are_same_output(*i, n); }))
      return true;
  return false;
}

// An output that is a file to be read, which may be a pipe or a terminal; empty if there is none.
std::string overwritten_input(const Options& o) {
  const Application_options& a = o.application;
  std::vector<std::string> read{o.input,
                                o.constraints,
                                o.metric,
                                o.sizes,
                                o.field,
                                o.geodesic.network,
                                o.other,
                                a.vectors,
                                a.handles,
                                a.pairs,
                                a.source_sets,
                                a.cut,
                                o.uniformize.angles,
                                o.uniformize.cones};
  read.insert(read.end(), o.shown.begin(), o.shown.end());
  for (const std::string& in : read)
    for (const Output& out : outputs(o))
      if (std::error_code ignored; !in.empty() && !is_standard_output(out.path) &&
                                   std::filesystem::is_regular_file(in, ignored) &&
                                   are_same_file(in, out.path))
        return out.path;
  return {};
}

// An input that is no file but the number of a vertex or the like; empty if there is none.
std::string point_among_inputs(const Options& o) {
  for (const std::string& in : o.inputs)
    if (std::error_code ignored; o.inputs.size() > 1 && curve_points_misuse(in, 1).empty() &&
                                 !std::filesystem::exists(in, ignored))
      return in;
  return {};
}

bool lacks_correspondence(const Options& o) {
  return o.correspondence == "none" && needs_correspondence(o);
}

bool has_other_correspondence(const Options& o) {
  return o.is_adaptive && !o.correspondence.empty() && o.correspondence != "integer";
}

// Waypoints without points that they could be.
bool has_idle_waypoints(const Geodesic_options& g) {
  return g.has_waypoints && g.paths.empty() && g.loops.empty() && g.network.empty();
}

const char idle_waypoints[] = "--waypoints is of curves through several points; give it with "
                              "--path, --loop or --network";

// What is wrong if plain files are asked for, and none has anything to be left out.
std::string plain_misuse(const Options& o) {
  if (!o.is_plain) return {};
  const bool has_surface = o.command != "geodesic" || o.geodesic.writes_subdivision;
  if (has_surface && is_mesh_output(o)) return {};
  if (!has_surface && !is_file_of(Contents::triangulation, o.output))
    return "curves have no labels; leave --plain out, or give --subdivision";
  return "--plain leaves labels, edges and colours of a surface out; give it with -o and " +
         extensions_of(Contents::subdivision);
}

// What is wrong with the file of curves.
std::string curve_output_misuse(const Options& o) {
  const bool is_subdivision = o.geodesic.writes_subdivision;
  if (is_subdivision && !is_mesh_output(o))
    return "--subdivision needs -o with " + extensions_of(Contents::subdivision);
  if (!is_subdivision && is_mesh_output(o) && !is_file_of(Contents::curves, o.output))
    return o.output + ": write curves to " + extensions_of(Contents::curves) +
           ", or the common subdivision with --subdivision";
  return {};
}

// What is wrong with options of batches of distances.
std::string batch_misuse(const Options& o) {
  const Application_options& a = o.application;
  if (!a.pairs.empty() && !a.source_sets.empty())
    return "--pairs and --sources have different results; give one of them";
  if (!a.sources.empty() || !a.curves.empty() || !a.targets.empty() || a.is_signed)
    return "--pairs and --sources say where distances start; give them without --source, "
           "--targets, --curve and --signed";
  if (o.is_adaptive)
    return "--adaptive refines about one point; give it with --source, or another criterion";
  if (!a.voronoi.empty() && !a.pairs.empty())
    return "--voronoi divides the surface among sources; give them with --source or --sources";
  if (!o.view.empty() || !a.isolines.empty())
    return "a page and isolines show one function; for one set give --source, not --pairs or "
           "--sources";
  if (!a.pairs.empty() && a.maximum_distance)
    return "searches between pairs end where they arrive; leave --max-distance out";
  if (!a.pairs.empty() && !o.output.empty() && !is_file_of(Contents::values, o.output))
    return o.output + ": write distances of pairs to " + extensions_of(Contents::values);
  if (!a.source_sets.empty() && !a.voronoi.empty()) {
    if (!o.output.empty() && !is_file_of(Contents::values, o.output))
      return "with --voronoi, --sources gives the distance of the nearest set; write it with -o "
             "to " +
             extensions_of(Contents::values);
    return {};
  }
  if (!a.source_sets.empty() && !is_file_of(Contents::full_matrix, o.output))
    return "--sources makes a matrix; write it with -o to " + extensions_of(Contents::full_matrix);
  return {};
}

} // namespace

std::string geodesic_misuse(const Options& o) {
  const Geodesic_options& g = o.geodesic;
  const bool has_curves =
      !g.paths.empty() || !g.loops.empty() || !g.network.empty() || has_constraints(o);
  const int alone = (g.bezier.empty() ? 0 : 1) + (g.source.empty() ? 0 : 1);
  if (alone == 0 && !has_curves)
    return "there is no curve; name some with --path, --loop, --bezier, --source, --network, "
           "--marked or --sharp-angle";
  if (alone > 1 || (alone == 1 && has_curves))
    return "--bezier and --source flip edges wherever they need to; give them without other curves";
  if (has_idle_waypoints(g)) return idle_waypoints;
  return curve_output_misuse(o);
}

std::string cut_misuse(const Options& o) {
  const Geodesic_options& g = o.geodesic;
  const bool has_curves =
      !g.paths.empty() || !g.loops.empty() || !g.network.empty() || has_constraints(o);
  const int kinds =
      (has_curves ? 1 : 0) + (o.cut.levels.empty() ? 0 : 1) + (o.cut.makes_disks ? 1 : 0);
  if (kinds == 0)
    return "there is nothing to cut along; name curves with --path, --loop, --network, --marked or "
           "--sharp-angle, isolines with --levels, or give --to-disk";
  if (kinds > 1)
    return "curves, isolines and cuts to disks would divide each other; give either curves, "
           "--levels or --to-disk";
  if (has_idle_waypoints(g)) return idle_waypoints;
  if (!o.cut.levels.empty() && o.application.sources.empty() == o.field.empty())
    return "--levels needs a function: give --source for distances, or --values, a file of numbers";
  return {};
}

std::string distance_misuse(const Options& o) {
  const Application_options& a = o.application;
  if (a.sources.empty() && a.curves.empty() && !has_batch(a))
    return "distances need a source; give points with --source, or a curve with --curve, or a file "
           "with --pairs or --sources";
  if (has_batch(a))
    if (const std::string misuse = batch_misuse(o); !misuse.empty()) return misuse;
  if (!a.voronoi.empty() &&
      (a.distance != "exact" || !a.targets.empty() || a.maximum_distance.has_value()))
    return "cells need exact distances everywhere; give --voronoi without --method heat, "
           "--targets and --max-distance";
  if (!has_batch(a) && !o.output.empty() && is_file_of(Contents::full_matrix, o.output) &&
      !is_file_of(Contents::values, o.output))
    return o.output +
           ": a matrix has a row for each set of sources; give them with --sources, "
           "or write values to " +
           extensions_of(Contents::values);
  if (a.is_signed && (a.curves.empty() || !a.sources.empty()))
    return "only curves have sides; with --signed, give --curve and no --source";
  const bool is_exact = a.distance == "exact";
  if (is_exact && (!a.curves.empty() || a.time_factor != defaults::time_factor))
    return "exact distances start at points and need no time; leave --curve, --signed and "
           "--time-factor out, or use --method heat";
  if (!is_exact && (!a.targets.empty() || a.maximum_distance))
    return "only the search for exact distances can end early; leave --method heat out with "
           "--targets and --max-distance";
  return {};
}

std::string parametrize_misuse(const Options& o) {
  if (o.application.map == "spectral" && o.application.solver == "iterative")
    return "the matrix of a spectral map is nearly singular, and is factored; leave --solver "
           "iterative out with --method spectral";
  if (o.application.map != "conformal")
    return o.uniformize.start.empty()
               ? ""
               : "lengths of triangles are scaled by conformal maps alone; give --start with "
                 "--method conformal";
  if (o.application.solver == "iterative")
    return "the matrices of conformal maps change in each step, and are factored; leave --solver "
           "iterative out with --method conformal";
  if (!o.application.cut.empty() || o.refines || has_constraints(o))
    return "--method conformal maps disks, between their vertices, and flips all edges; leave "
           "--cut, --refine, --sharp-angle and --marked out";
  return {};
}

std::string field_misuse(const Options& o) {
  if (o.application.alignment && o.application.degree % 2 != 0)
    return "directions of curvature have no sign; with --align, give an even --degree: 2 for "
           "lines, 4 for crosses";
  return {};
}

std::string misuse(const Options& options) {
  if (const std::string word = point_among_inputs(options); !word.empty())
    return word + ": there is no such mesh; if this is a point, separate points by commas: " +
           "--source 0,1";
  if (!options.input_format.empty() && std::ranges::count(options.inputs, "-") == 0)
    return "--input-format is of standard input; give - as the input, or leave it out";
  if (names_a_file_twice(options)) return "two outputs are the same file; give each its own";
  if (const std::string name = overwritten_input(options); !name.empty())
    return name + ": the output is also an input; give it another name";
  if (lacks_correspondence(options))
    return "the common subdivision, lengths in a file and --adaptive need a correspondence; use "
           "--correspondence integer, or write the intrinsic triangulation to .idt";
  if (const std::string plain = plain_misuse(options); !plain.empty()) return plain;
  if (has_other_correspondence(options))
    return "--adaptive keeps integer coordinates; use --correspondence integer";
  return {};
}

} // namespace program
