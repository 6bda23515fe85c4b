// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_LOAD_H
#define INTRINSIC_LOAD_H

#include "constraints.h"
#include "metric.h"
#include "options.h"
#include "support/Cut.h"
#include "support/naming_file.h"
#include "support/progress.h"
#include "support/read_mesh.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/read_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/covers/restore_input_edges.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace program {

/// Seconds that the parts of the work took.
struct Seconds {
  double read = 0, build = 0, topology = 0;
};

/// An intrinsic triangulation and what is known of its input.
template <class Triangulation>
struct Loaded {
  Triangulation triangulation;
  Input_facts facts;
  Seconds seconds;
  /// One point per vertex of the mesh file, in its order and units; empty where the metric keeps
  /// them or there are none.
  std::vector<Point> points;
  Constraints constraints;                       ///< edges of the input that are kept
  Metric_report metric{};                        ///< what changed lengths needed
  IT::Domain_report domain{};                    ///< which surface was made of a file
  IT::Polygon_report polygons{};                 ///< what was made of its polygons
  std::optional<IT::Point_cloud_report> cloud{}; ///< if it was made of points
  Cut cut{};                                     ///< if it was cut open
  std::vector<double> sizes{};                   ///< wanted lengths at vertices, or none

  /// tells whether it is known where vertices are in space.
  bool has_points() const {
    return !points.empty() || !triangulation.input().metric().points().empty();
  }
};

/// returns one point per vertex of the mesh file, in its order and units; zeros if there are none.
template <class Triangulation>
std::vector<Point> input_points(const Loaded<Triangulation>& loaded) {
  if (!loaded.points.empty()) return loaded.points;
  const Triangulation& t = loaded.triangulation;
  const std::vector<Point>& scaled = t.input().metric().points();
  std::vector<Point> points(t.input().number_of_rows());
  for (std::uint32_t v = 0; v < scaled.size(); ++v) {
    Point& p = points[t.input_vertex({v})];
    p = scaled[v];
    for (double& x : p) x = std::ldexp(x, -t.metric().scale_exponent());
  }
  return points;
}

/// reads the wanted lengths of edges, one per vertex of the input; none without `--size`.
/// \throws std::runtime_error naming the line that is wrong
std::vector<double> read_sizes(const Options& options, std::size_t vertices);

/// returns which surface options ask for.
Surface_choice surface_of(const Options& options);

/// tells whether a file name has the extension of intrinsic triangulations.
bool is_triangulation_file(const std::string& path);

/// returns the number of faces of the user's mesh of which an input has parts.
std::size_t number_of_polygons(const IT::Input_definition& input);

/// counts the elements of a triangulation before its first move, when they are those of the input.
template <class Triangulation>
void describe(Loaded<Triangulation>& loaded) {
  Stopwatch watch;
  loaded.facts = facts_of(loaded.triangulation.mesh());
  loaded.seconds.topology = watch.lap();
}

/// Cuts meshes open before their triangulations are built; or does nothing, if it has no functions.
struct Cutter {
  std::function<void(Mesh_file&)> prepare; ///< what to do with the mesh as it was read
  /// Cuts the mesh and edges of it that are kept.
  std::function<Cut(Mesh_file&, Constraints&, const Options&)> cut;
};

/// returns a point for each copy of a vertex.
inline std::vector<Point> points_of_copies(std::vector<Point> points, const Cut& cut) {
  for (std::size_t v = points.size(); !points.empty() && v < cut.original_vertex.size(); ++v)
    points.push_back(points[cut.original_vertex[v]]);
  return points;
}

/// builds the intrinsic triangulation of a mesh.
template <class Triangulation>
Loaded<Triangulation> build(Mesh_file file, const Options& options, const Cutter& cut_open = {}) {
  Stopwatch watch;
  if (cut_open.prepare) cut_open.prepare(file);
  Constraints constraints = constraints_of(file, options);
  const IT::Polygon_report polygons = file.input.planar_polygons.report;
  // exact traits keep the points unless they only keep changed lengths
  const bool are_points_kept = Triangulation::Metric::is_exact && options.metric.empty() &&
                               file.input.mollification != IT::Mollification::lengths;
  std::vector<Point> points = are_points_kept ? std::vector<Point>() : file.input.points;
  return naming_file(options.input, [&] {
    const Metric_report metric = change_metric(file, options);
    Input_facts facts;
    Cut cut;
    if (cut_open.cut) {
      const IT::Gluing_map before = file.input.mesh;
      cut = cut_open.cut(file, constraints, options);
      if (cut.is_cut()) facts = facts_of(before);
      points = points_of_copies(std::move(points), cut);
    }
    Loaded<Triangulation> loaded{Triangulation(std::move(file.input)),
                                 {},
                                 {},
                                 {},
                                 std::move(constraints),
                                 metric,
                                 std::move(file.domain),
                                 polygons,
                                 std::move(file.cloud)};
    const Triangulation& t = loaded.triangulation;
    if (!points.empty() && t.input().metric().points().empty()) {
      loaded.points.resize(t.input().number_of_rows());
      for (std::uint32_t v = 0; v < points.size(); ++v)
        loaded.points[t.input_vertex({v})] = points[t.input().names().vertices.user(v)];
    }
    loaded.seconds = {file.seconds, watch.lap()};
    describe(loaded);
    if (cut.is_cut()) loaded.facts = facts;
    loaded.cut = std::move(cut);
    loaded.facts.polygons = file.polygons;
    loaded.facts.triangulated_polygons = file.triangulated_polygons;
    loaded.facts.faces_with_repeated_vertices = file.faces_with_repeated_vertices;
    return loaded;
  });
}

/// builds the intrinsic triangulation of a mesh file.
template <class Triangulation>
Loaded<Triangulation> load_mesh(const Options& options, Progress& progress,
                                const Cutter& cut_open) {
  Stopwatch watch;
  progress.show("reading");
  Mesh_file file = read_mesh(options.input, surface_of(options));
  const double seconds = watch.lap() - file.seconds; // of matching edges
  progress.show("building");
  Loaded<Triangulation> loaded = build<Triangulation>(std::move(file), options, cut_open);
  loaded.seconds.build += seconds;
  loaded.sizes = read_sizes(options, loaded.triangulation.input().number_of_rows());
  return loaded;
}

/// restores edges to be kept that were flipped away before the triangulation was stored.
/// \throws std::runtime_error naming one that cannot be restored
template <class Triangulation>
void restore_constrained_edges(Loaded<Triangulation>& loaded, const Options& options) {
  Triangulation& t = loaded.triangulation;
  const std::uint32_t e = IT::restore_input_edges(t, loaded.constraints.is_constrained).missing;
  if (e == IT::Gluing::none) return;
  const auto row = [&](std::uint32_t v) { return std::to_string(t.input().names().row(v)); };
  throw std::runtime_error(options.input + ": the edge between vertices " +
                           row(t.input().source(2 * e)) + " and " + row(t.input().target(2 * e)) +
                           " of the input, which is to be kept, has been flipped away and does "
                           "not come back; start from the mesh");
}

/// returns what is known of a triangulation that was stored.
template <class Triangulation>
Loaded<Triangulation> stored(Triangulation t) {
  Loaded<Triangulation> loaded{std::move(t), {}, {}, {}, {}, {}};
  describe(loaded);
  const auto& input = loaded.triangulation.input();
  loaded.facts.polygons = number_of_polygons(input);
  loaded.facts.triangulated_polygons = loaded.triangulation.report().triangulated_polygons;
  return loaded;
}

/// reads an intrinsic triangulation from its file.
template <class Triangulation>
Loaded<Triangulation> load_triangulation(const Options& options, Progress& progress) {
  Stopwatch watch;
  progress.show("reading");
  auto t = IT::read_intrinsic_triangulation<Triangulation>(std::filesystem::path(options.input));
  const double seconds = watch.lap();
  Loaded<Triangulation> loaded = stored(std::move(t));
  loaded.seconds.read = seconds;
  const auto& input = loaded.triangulation.input();
  if constexpr (Triangulation::has_correspondence) {
    loaded.constraints = constraints_of(input, options);
    restore_constrained_edges(loaded, options);
  }
  loaded.sizes = read_sizes(options, input.number_of_rows());
  return loaded;
}

/// The triangulations of the default correspondence. What several programs and the Python module do
/// with them is compiled once, as `extern template` tells.
using Exact_triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                        IT::Integer_coordinates>;
/// With doubles.
using Double_triangulation =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>,
                                IT::Integer_coordinates>;

extern template Loaded<Exact_triangulation> load_mesh(const Options&, Progress&, const Cutter&);
extern template Loaded<Double_triangulation> load_mesh(const Options&, Progress&, const Cutter&);
extern template Loaded<Exact_triangulation> load_triangulation(const Options&, Progress&);
extern template Loaded<Double_triangulation> load_triangulation(const Options&, Progress&);

/// returns the arithmetic to compute in: that of a stored triangulation, else that of the options.
/// \throws Invalid_input if options contradict a stored triangulation
std::string arithmetic_of(const Options& options);

/*!
\brief loads the input and calls a function with it.
\tparam Correspondence what is kept of where edges run on the input
\param options the options
\param progress where to show progress
\param function called with `Loaded<Triangulation>&`
\param cut_open cuts meshes open, or none
*/
template <class Correspondence, class Function>
void with_loaded(const Options& options, Progress& progress, const Function& function,
                 const Cutter& cut_open = {}) {
  const auto call = [&](auto loaded) { function(loaded); };
  using Exact =
      IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Correspondence>;
  using Double =
      IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>, Correspondence>;
  const bool exact = arithmetic_of(options) == "exact";
  if constexpr (std::is_same_v<Correspondence, IT::No_correspondence> ||
                std::is_same_v<Correspondence, IT::Integer_coordinates>)
    if (is_triangulation_file(options.input)) {
      if (exact)
        call(load_triangulation<Exact>(options, progress));
      else
        call(load_triangulation<Double>(options, progress));
      return;
    }
  if (exact)
    call(load_mesh<Exact>(options, progress, cut_open));
  else
    call(load_mesh<Double>(options, progress, cut_open));
}

/// the same, without correspondence
template <class Function>
void with_loaded(const Options& options, Progress& progress, const Function& function) {
  with_loaded<IT::No_correspondence>(options, progress, function);
}

} // namespace program

#endif // INTRINSIC_LOAD_H
