// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "application.h"
#include "../asked_curves.h"
#include "../delaunay.h"
#include "../support/naming_file.h"
#include "cut.h"
#include "write_results.h"

#include <CGAL/Intrinsic_geodesics/compiled.h>
#include <CGAL/Intrinsic_geodesics/queries/insert_places.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/support/Stopwatch.h>

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace program {

namespace {

// Where sources are.
template <class Triangulation>
Marks source_marks(const Loaded<Triangulation>& loaded, const Sources& sources,
                   std::size_t lists_of_points) {
  Marks marks{"sources"};
  const Triangulation& t = loaded.triangulation;
  const std::vector<Point> points = input_points(loaded);
  for (const auto& list : std::span(sources).first(lists_of_points))
    for (const IT::Place& p : list)
      marks.points.push_back(
          {{IT::point_in_space(t, point_on_input(t.input(), p), points)}, false, 0});
  return marks;
}

// Reads points before long work begins: each has an element of the mesh that is good for it.
template <class Triangulation>
Sources sources_of(const Triangulation& t, const std::vector<Asked_curve>& asked,
                   const Options& options) {
  IT::Place_finder<Triangulation> find(t);
  Sources sources;
  for (const Asked_curve& list : asked)
    naming_file(list.name + ": " + options.input, [&] {
      std::vector<IT::Place>& places = sources.emplace_back();
      for (const IT::Place& p : list.places) {
        places.push_back(normalized(t.input(), p));
        if (places.back().is_vertex()) (void)find.vertex(places.back().vertex);
      }
    });
  return sources;
}

// Vertices at the points of curves. They need a triangulation that is not refined any more.
template <class Triangulation>
bool insert_curves(Triangulation& t, const std::vector<Asked_curve>& asked,
                   const Options& options) {
  const std::size_t before = num_vertices(t.mesh());
  for (const Asked_curve& list : asked)
    if (list.kind == IT::Curve_kind::geodesic)
      naming_file(list.name + ": " + options.input,
                  [&] { return IT::insert_places(t, list.places); });
  return num_vertices(t.mesh()) != before;
}

// Adaptive refinement is about the first vertex from which something is computed.
Options about_source(Options options, const std::vector<Asked_curve>& asked,
                     const Sources& sources) {
  if (!options.is_adaptive || asked.empty()) return options;
  const IT::Place& first = sources.front().front();
  if (!first.is_vertex())
    throw std::runtime_error(
        asked.front().name +
        ": --adaptive refines about a vertex; give one first, or another criterion");
  options.adaptive.source = first.vertex;
  return options;
}

template <class Traits>
Computed solved(Loaded<Solved_triangulation<Traits>>& loaded, const Options& options,
                const Solver<Traits>& solve, const Sources& sources, Progress& progress) {
  return naming_file(options.input, [&] {
    return solve(loaded.triangulation, sources, input_points(loaded), progress);
  });
}

template <class Traits>
void run(Loaded<Solved_triangulation<Traits>>& loaded, const Options& options,
         const Solver<Traits>& solve, Progress& progress) {
  if (options.application.alignment && loaded.points.empty())
    throw std::runtime_error(options.input + ": a surface with lengths alone has no directions of "
                                             "curvature; leave --align out");
  const std::vector<Asked_curve> asked =
      asked_points(options, loaded.triangulation.input().number_of_rows(), loaded.facts.polygons);
  const Sources sources = sources_of(loaded.triangulation, asked, options);
  Json json = improve_and_measure(loaded, about_source(options, asked, sources), progress, [&] {
    return insert_curves(loaded.triangulation, asked, options);
  });
  IT::Stopwatch watch;
  progress.show("solving");
  Computed computed = solved(loaded, options, solve, sources, progress);
  if (computed.marks.points.empty() && !sources.empty())
    computed.marks = source_marks(loaded, sources, options.application.sources.size());
  json[computed.command] = computed.json;
  if (loaded.cut.is_cut())
    json["cut"] = {{"edges", loaded.cut.edges},
                   {"length", loaded.cut.length},
                   {"vertices", loaded.cut.original_vertex.size()}};
  json["seconds"][computed.timed] = watch.lap();
  Output_files files;
  write_results(loaded, computed, options, json, files, progress, watch);
  finish(json, options, files, watch);
}

} // namespace

void run_application(const Options& options, const Solver<IT::Exact_euclidean_traits>& exact,
                     const Solver<IT::Euclidean_traits<double>>& approximate) {
  expect_writable_results(options);
  Progress progress(options.logs_progress, options.is_quiet);
  with_loaded<IT::Integer_coordinates>(
      options, progress,
      [&](auto& loaded) {
        if constexpr (std::decay_t<decltype(loaded.triangulation)>::Metric::is_exact)
          run(loaded, options, exact, progress);
        else
          run(loaded, options, approximate, progress);
      },
      options.application.cut.empty() ? Cutter() : Cutter{take_sheet, cut_to_disk});
}

} // namespace program
