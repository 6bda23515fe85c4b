// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_LOAD_H
#define INTRINSIC_LOAD_H

#include "constraints.h"
#include "metric.h"
#include "options.h"
#include "support/naming_file.h"
#include "support/progress.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/stored_surface.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/build_surface.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_surface.h>
#include <CGAL/Intrinsic_triangulations/connectivity/count_elements.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/support/Stopwatch.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace program {

/// How a mesh was cut open.
struct Cut {
  /// The vertex of the file that each vertex of the surface is a copy of; empty: it is not cut.
  std::vector<std::uint32_t> original_vertex;
  std::size_t edges = 0;             ///< number of edges that were cut
  double length = 0;                 ///< of these edges in space
  std::vector<IT::Polyline> seams{}; ///< these edges in space

  bool is_cut() const { return !original_vertex.empty(); }
};

/// An intrinsic triangulation and what is known of its input.
template <IT::NumberedTriangulation Triangulation>
struct Loaded : IT::Built_surface<Triangulation> {
  Constraints constraints{};   ///< edges of the input that are kept
  Metric_report metric{};      ///< what changed lengths needed
  Cut cut{};                   ///< if it was cut open
  std::vector<double> sizes{}; ///< wanted lengths at vertices, or none
};

/// returns one point per vertex of the mesh file, in its order and units; zeros if there are none.
template <class Triangulation>
std::vector<Point> input_points(const Loaded<Triangulation>& loaded) {
  return loaded.points.empty() ? std::vector<Point>(loaded.triangulation.input().number_of_rows())
                               : loaded.points;
}

/// reads the wanted lengths of edges, one per vertex of the input; none without a file.
/// \throws std::runtime_error naming the line that is wrong
std::vector<double> read_sizes(const Options& options, std::size_t vertices);

/// returns which surface options ask for.
IT::Surface_options surface_of(const Options& options);

/// tells whether a file name has the extension of intrinsic triangulations.
bool is_triangulation_file(const std::string& path);

/// Cuts meshes open before their triangulations are built; or does nothing, if it has no functions.
struct Cutter {
  std::function<void(IT::Read_surface&)> prepare; ///< what to do with the mesh as it was read
  /// Cuts the mesh and edges of it that are kept.
  std::function<Cut(IT::Read_surface&, Constraints&, const Options&)> cut;
};

/// returns a point for each copy of a vertex.
inline std::vector<Point> points_of_copies(std::vector<Point> points, const Cut& cut) {
  for (std::size_t v = points.size(); !points.empty() && v < cut.original_vertex.size(); ++v)
    points.push_back(points[cut.original_vertex[v]]);
  return points;
}

/// builds the intrinsic triangulation of a mesh.
template <class Triangulation>
Loaded<Triangulation> build(IT::Read_surface file, const Options& options,
                            const Cutter& cut_open = {}) {
  IT::Stopwatch watch;
  if (cut_open.prepare) cut_open.prepare(file);
  Constraints constraints = constraints_of(file.input, options);
  std::vector<Point> points = file.input.points;
  return naming_file(options.input, [&] {
    const Metric_report metric = change_metric(file, options);
    std::optional<IT::Element_counts> before_cut;
    Cut cut;
    if (cut_open.cut) {
      const IT::Gluing_map before = file.input.mesh;
      cut = cut_open.cut(file, constraints, options);
      if (cut.is_cut()) before_cut = IT::count_elements(before);
      points = points_of_copies(std::move(points), cut);
    }
    const double seconds = watch.lap();
    Loaded<Triangulation> loaded{
        IT::build_surface<Triangulation>(std::move(file), std::move(points)),
        std::move(constraints), metric, std::move(cut)};
    loaded.facts.seconds_of_building += seconds;
    if (before_cut) loaded.facts.counts = *before_cut;
    return loaded;
  });
}

/// builds the intrinsic triangulation of a mesh file.
template <class Triangulation>
Loaded<Triangulation> load_mesh(const Options& options, Progress& progress,
                                const Cutter& cut_open) {
  IT::Stopwatch watch;
  progress.show("reading");
  IT::Read_surface file = IT::read_surface(options.input, surface_of(options));
  const double seconds = watch.lap() - file.facts.seconds_of_reading; // of matching edges
  progress.show("building");
  Loaded<Triangulation> loaded = build<Triangulation>(std::move(file), options, cut_open);
  loaded.facts.seconds_of_building += seconds;
  loaded.sizes = read_sizes(options, loaded.triangulation.input().number_of_rows());
  return loaded;
}

/// restores edges to be kept that were flipped away before the triangulation was stored.
/// \throws std::runtime_error naming one that cannot be restored
template <class Triangulation>
void restore_constrained_edges(Loaded<Triangulation>& loaded, const Options& options) {
  const std::string missing =
      IT::restore_kept_edges(loaded.triangulation, loaded.constraints.is_constrained);
  if (!missing.empty()) throw std::runtime_error(options.input + ": " + missing);
}

/// reads an intrinsic triangulation from its file.
template <class Triangulation>
Loaded<Triangulation> load_triangulation(const Options& options, Progress& progress) {
  progress.show("reading");
  Loaded<Triangulation> loaded{IT::read_stored_surface<Triangulation>(options.input)};
  const auto& input = loaded.triangulation.input();
  if constexpr (Triangulation::has_correspondence) {
    loaded.constraints = constraints_of(input, options);
    restore_constrained_edges(loaded, options);
  }
  loaded.sizes = read_sizes(options, input.number_of_rows());
  return loaded;
}

/// The triangulations of the default correspondence. What several programs do with them is compiled
/// once, as `extern template` tells.
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
