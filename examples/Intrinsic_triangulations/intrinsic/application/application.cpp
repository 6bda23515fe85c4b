// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "application.h"
#include "../delaunay.h"
#include "../geodesic/Asked_vertices.h"
#include "../support/Number_rows.h"
#include "../support/naming_file.h"
#include "../view.h"
#include "direction_lines.h"

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace program {

namespace {

/// The surface on which results are drawn: the common subdivision, or the mesh of the file.
struct Drawn_results {
  Drawn_subdivision drawn;
  std::vector<IT::Vertex_field> fields;
};

void expect_writable_results(const Options& options) {
  if (is_mesh_output(options) && options.application.on == "intrinsic")
    throw std::runtime_error(
        options.output +
        ": faces of the intrinsic triangulation bend over edges of the mesh; write "
        "the common subdivision with --on subdivision, or values to a file .txt");
}

void write_functions(std::ostream& out, const Computed& computed, Eigen::Index rows) {
  Number_rows numbers(out);
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (const Function& f : computed.functions) numbers.put(f.values[i]);
    for (Eigen::Index c = 0; c < computed.displacements.cols(); ++c)
      numbers.put(computed.displacements(i, c));
    if (computed.directions) {
      const std::uint32_t copy = computed.directions->of_row[static_cast<std::size_t>(i)];
      const std::complex<double> z =
          copy == IT::Gluing::none ? 0 : computed.directions->vectors[copy];
      numbers.put(z.real());
      numbers.put(z.imag());
    }
    numbers.end_row();
  }
}

Drawn_results draw(Drawn_subdivision drawn, const Computed& computed,
                   const Eigen::SparseMatrix<double>& interpolation) {
  Drawn_results results{std::move(drawn), {}};
  for (const Function& f : computed.functions)
    results.fields.push_back(
        {f.name, Eigen::VectorXd(interpolation * f.values.head(interpolation.cols()))});
  if (computed.displacements.size() == 0) return results;
  const Eigen::MatrixXd d = interpolation * computed.displacements.topRows(interpolation.cols());
  for (std::size_t v = 0; v < results.drawn.points.size(); ++v)
    for (std::size_t c = 0; c < 3; ++c)
      results.drawn.points[v][c] += d(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(c));
  return results;
}

void write_results_view(std::ostream& out, const Drawn_results& results, const Computed& computed,
                        const std::vector<IT::Polyline>& lines, const Options& options,
                        const Json& json) {
  Viewed viewed;
  viewed.curves = lines;
  viewed.isolines = computed.isolines;
  viewed.is_plain = computed.isolines > 0 || computed.is_map || computed.directions;
  if (computed.directions) viewed.curve_width = 1.5;
  std::vector<std::array<double, 2>> texture;
  if (computed.is_map)
    for (std::size_t v = 0; v < results.drawn.points.size(); ++v)
      texture.push_back({results.fields[0].values[v], results.fields[1].values[v]});
  else if (computed.shown < results.fields.size())
    viewed.field = &results.fields.at(computed.shown);
  viewed.texture = texture;
  write_view(out, results.drawn.s, results.drawn.points, options, json, viewed);
}

/// returns the mesh of the file, or the input that was stored: the common subdivision before the first move.
template <class Triangulation>
Drawn_subdivision drawn_input(const Loaded<Triangulation>& loaded, const Options& options) {
  expect_points(loaded, options);
  const IT::Input& input = loaded.triangulation.input();
  IT::Intrinsic_input in(input.mesh(), loaded.scaled_points(), IT::Mollification::none);
  for (Point& p : in.points)
    for (double& x : p) x = std::ldexp(x, -input.scale_exponent());
  in.names = input.names();
  in.may_renumber = false;
  Loaded<Triangulation> alone{Triangulation(std::move(in)), {}, {}, {}, {}};
  if (!Triangulation::Metric::is_exact)
    alone.points = alone.triangulation.input().metric().points();
  Json unread;
  return drawn_subdivision(alone, options, unread);
}

/// writes what was computed.
template <class Triangulation>
void write_results(const Loaded<Triangulation>& loaded, const Computed& computed,
                   const Options& options, Json& json, Output_files& files, Progress& progress,
                   Stopwatch& watch) {
  const bool is_on_input = options.application.on == "input";
  if (needs_subdivision(options)) {
    progress.show("subdividing");
    Drawn_subdivision drawn =
        is_on_input ? drawn_input(loaded, options) : drawn_subdivision(loaded, options, json);
    const Eigen::SparseMatrix<double> interpolation =
        is_on_input ? IT::interpolation_from_input(drawn.s)
                    : IT::interpolation_from_intrinsic(drawn.s);
    const Drawn_results results = draw(std::move(drawn), computed, interpolation);
    json["seconds"]["subdivide"] = watch.lap();
    progress.show("writing");
    if (is_mesh_output(options))
      files.write(options.output, [&](std::ostream& out) {
        IT::write_common_subdivision(out,
                                     std::filesystem::path(options.output).extension().string(),
                                     results.drawn.s, results.drawn.points, results.fields);
      });
    if (!options.view.empty())
      files.write(options.view, [&](std::ostream& out) {
        write_results_view(out, results, computed, direction_lines(loaded, computed, results.drawn),
                           options, json);
      });
  }
  if (!options.output.empty() && !is_mesh_output(options))
    files.write(options.output, [&](std::ostream& out) {
      write_functions(out, computed,
                      is_on_input ? loaded.triangulation.input().number_of_rows()
                                  : loaded.triangulation.number_of_vertices());
    });
}

// Adaptive refinement is about the first vertex from which something is computed.
Options about_source(Options options, const std::vector<Asked_curve>& asked) {
  if (!options.adaptive.is_asked_for || asked.empty()) return options;
  const Asked_point& first = asked.front().points.front();
  if (!first.is_vertex)
    throw std::runtime_error(
        asked.front().source +
        ": --adaptive refines about a vertex; give one first, or another criterion");
  options.adaptive.source = first.element;
  return options;
}

template <class Traits>
Computed solved(Loaded<Solved_triangulation<Traits>>& loaded, const Options& options,
                const Solver<Traits>& solve, const Sources& sources) {
  return naming_file(options.input,
                     [&] { return solve(loaded.triangulation, sources, input_points(loaded)); });
}

template <class Traits>
void run(Loaded<Solved_triangulation<Traits>>& loaded, const Options& options,
         const Solver<Traits>& solve, Progress& progress) {
  Asked_vertices find(loaded.triangulation, options);
  const std::vector<Asked_curve> asked =
      asked_points(options, loaded.triangulation.input().number_of_rows(), loaded.facts.polygons);
  Sources sources;
  for (const Asked_curve& points : asked) sources.push_back(find(points));
  Json json = improve_and_measure(loaded, about_source(options, asked), progress);
  Stopwatch watch;
  progress.show("solving");
  const Computed computed = solved(loaded, options, solve, sources);
  json[computed.command] = computed.json;
  json["seconds"]["solve"] = watch.lap();
  Output_files files;
  write_results(loaded, computed, options, json, files, progress, watch);
  finish(json, options, files, watch);
  print_summary_on_terminal(json);
}

} // namespace

void append_direction(std::vector<IT::Polyline>& lines, const Point& from, const Point& vector,
                      bool is_arrow) {
  Point middle, to;
  for (std::size_t c = 0; c < 3; ++c) {
    middle[c] = from[c] + 0.7 * vector[c];
    to[c] = from[c] + vector[c];
  }
  lines.push_back({{from, is_arrow ? middle : to}, false, 1});
  if (is_arrow) lines.push_back({{middle, to}, false, 0}); // a tip of another colour
}

double length_of_lines(const IT::Common_subdivision& s, const std::vector<Point>& points,
                       const IT::Tangent_field& vectors) {
  double longest = 0, sum = 0;
  for (const std::complex<double>& z : vectors) longest = std::max(longest, std::abs(z));
  std::size_t count = 0;
  IT::for_each_subdivision_edge(
      s, [&](std::uint32_t a, std::uint32_t b, const IT::Common_subdivision::Side& side) {
        if (side.intrinsic_edge == IT::Common_subdivision::none) return;
        ++count;
        sum += std::hypot(points[a][0] - points[b][0], points[a][1] - points[b][1],
                          points[a][2] - points[b][2]);
      });
  return longest > 0 && count > 0 ? sum / static_cast<double>(count) / 2 / longest : 0;
}

void run_application(const Options& options, const Solver<IT::Exact_euclidean_traits>& exact,
                     const Solver<IT::Euclidean_traits<double>>& approximate) {
  expect_writable_results(options);
  Progress progress(options.logs_progress);
  with_loaded<IT::Integer_coordinates>(options, progress, [&](auto& loaded) {
    if constexpr (std::decay_t<decltype(loaded.triangulation)>::Metric::is_exact)
      run(loaded, options, exact, progress);
    else
      run(loaded, options, approximate, progress);
  });
}

} // namespace program
