// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "application_options.h"
#include "support/file_formats.h"

#include <string>

namespace program {

namespace {

void add_solver_option(CLI::App& command, Options& options) {
  std::string& solver = options.application.solver;
  const Words solvers({{"auto", "by size"},
                       {"direct", "by a factorization"},
                       {"iterative", "in less memory, up to a residual"}},
                      solver);
  Option_adder{command}("--solver", solver, {solvers.check()},
                        "how linear problems are solved: " + solvers.help());
}

// Refuses iterations, and says why.
void add_solver_of_heat(CLI::App& command, Options& options) {
  const Words solvers({{"direct", "by a factorization"}, {"auto", "the same, default"}}, "");
  const CLI::Validator direct(
      [](std::string& word) -> std::string {
        if (word != "iterative") return {};
        return word + ": far from its source heat is smaller than the residual of an iteration by "
                      "hundreds of powers of ten; give direct";
      },
      "");
  Option_adder{command}("--solver", options.application.solver, {direct, solvers.check()},
                        "how heat is computed: " + solvers.help());
}

} // namespace

void add_distance_searches(CLI::App& command, Options& options) {
  const Option_adder add(command);
  Application_options& a = options.application;
  add_results(command, options, true,
              {Contents::values, Contents::subdivision, Contents::full_matrix});
  command.get_option("--source")->required(false);
  add_time_option(command, options);
  const Words methods(
      {{"exact", "along shortest paths from points"}, {"heat", "smooth; the default with --curve"}},
      defaults::distance_method);
  add("--method", a.distance, {methods.check()}, methods.help());
  command.callback([&a] {
    if (a.distance.empty()) a.distance = a.curves.empty() ? defaults::distance_method : "heat";
  });
  add("--targets", a.targets, {curve_points(1)},
      "points; the exact search ends when their distances are known")
      ->allow_extra_args(false);
  add("--max-distance", a.maximum_distance, {in_range(ranges::max_distance)},
      "the exact search ends at this distance");
  add("--curve", a.curves, {curve_points(2)},
      "a curve through points, along edges of the triangulation; closed if the last point is the "
      "first")
      ->allow_extra_args(false);
  add("--signed", a.is_signed, "distances on the left of curves are negative");
  add("--pairs", a.pairs, {file_name},
      "text file: the numbers of two vertices on each line; their distances are found");
  add("--sources", a.source_sets, {file_name},
      "text file: on each line the vertices of a set; the distances from each set are found, a "
      "row of a matrix each");
  add_solver_of_heat(command, options);
}

void add_distance_lines(CLI::App& command, Options& options) {
  const Option_adder add(command);
  Application_options& a = options.application;
  CLI::Option* const isolines =
      add("--isolines", a.isolines, {file_of({Contents::curves})},
          "write the lines of equal distance, with the number of their level, to " +
              extensions_of(Contents::curves));
  add("--levels", a.levels, {level_list(), isolines},
      "distances of these lines: how many, evenly spaced, or a list, separated by commas; a whole "
      "number alone is how many; " +
          default_is(defaults::levels));
  CLI::Option* const voronoi = add("--voronoi", a.voronoi, {file_of({Contents::curves})},
                                   "write the lines between the cells of the "
                                   "nearest source, or set of --sources, to " +
                                       extensions_of(Contents::curves));
  add("--cell-tolerance", a.cell_tolerance, {in_range(ranges::cell_tolerance), voronoi},
      "how far off these lines may be, in units of the file; default a thousandth of the mean "
      "edge");
}

void add_parametrize_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  const Words methods({{"harmonic", "to a circle"},
                       {"conformal", "with scale 1 on the border of disks"},
                       {"spectral", "nearly conformal, also of points"},
                       {"lscm", ""}},
                      defaults::map_method);
  add("--method", options.application.map, {methods.check()}, methods.help());
  add("--cut", options.application.cut,
      std::string(defaults::cut) +
          " (default): cut open along few edges unless it is a disk; or a file that lists the "
          "edges, two vertices a line");
  add_start_option(command, options);
  add_solver_option(command, options);
  command.callback([&options] {
    if (options.application.cut.empty() && options.application.map != "conformal")
      options.application.cut = defaults::cut;
  });
}

void add_uniformize_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  Uniformize_options& u = options.uniformize;
  add_output_option(command, options, "-o", options.output,
                    {Contents::values, Contents::subdivision});
  add_view_option(command, options, "a checkerboard of the layout, or the logarithm of the scale");
  add_metric_option(command, options);
  CLI::Option* const angles =
      add("--angles", u.angles, {file_name},
          "text file: the angle around each vertex on a line of its own, in radians, as a multiple "
          "of pi (3/2pi), or free; by default 2pi, and free on the border");
  add("--cones", u.cones, {Type{"NUMBER|RATIO|FILE"}},
      "how many vertices have other angles, which are chosen; or, such as 10x, the largest ratio "
      "of scales, for as many as are needed; or a text file: the number of such a vertex and its "
      "angle on each line")
      ->excludes(angles);
  add_start_option(command, options);
  const Words targets({{"plane", "flat but for cones"},
                       {"sphere", "the round one"},
                       {"torus", "flat, with its period"},
                       {"disk", "hyperbolic, in Poincaré's disk"}},
                      "");
  add("--target", u.target, {targets.check()},
      targets.help() + "; by default, without --angles and --cones, sphere, torus "
                       "and disk for closed surfaces of genus 0, 1 and more, else plane");
}

void add_transport_options(CLI::App& command, Options& options) {
  add_time_option(command, options);
  Option_adder{command}("--vectors", options.application.vectors,
                        "text file: on each line the number of a vertex, an angle in degrees from "
                        "the first edge there, and a length or none")
      ->required();
  add_solver_of_heat(command, options);
}

void add_logmap_options(CLI::App& command, Options& options) {
  add_results(command, options, true);
  add_time_option(command, options);
  const Words methods(
      {{"exact", "by shortest paths"}, {"affine", "by heat, also on points"}, {"polar", "by heat"}},
      "exact");
  Option_adder{command}("--method", options.application.logarithm, {methods.check()},
                        methods.help());
  add_solver_of_heat(command, options);
}

void add_field_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  Application_options& a = options.application;
  add("--degree", a.degree, {in_range(ranges::degree)},
      "number of equivalent directions at a vertex: 1 vectors, 2 lines, 4 crosses; " +
          default_is(defaults::degree));
  add("--vectors", a.vectors, "text file of vectors that are kept, as for transport");
  add("--singularities", a.singularities, {file_of({Contents::points})},
      "write the singularities, points with their index, to " + extensions_of(Contents::points));
  add("--align", a.alignment, {in_range(ranges::align)},
      "how strongly the field follows the directions of principal curvature; 0: as little as "
      "possible");
  add_solver_option(command, options);
}

void add_eigen_options(CLI::App& command, Options& options) {
  Option_adder{command}("--count", options.application.count, {in_range(ranges::count)},
                        "how many; " + default_is(defaults::count));
  add_solver_option(command, options);
}

void add_edit_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  add("--handles", options.application.handles,
      "text file: on each line the number of a vertex and its displacement")
      ->required();
  const Words energies({{"biharmonic", ""}, {"harmonic", ""}}, defaults::energy);
  add("--energy", options.application.energy, {energies.check()},
      "energy to minimize: " + energies.help());
  add_solver_option(command, options);
}

} // namespace program
