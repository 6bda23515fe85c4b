// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STATISTICS_H
#define INTRINSIC_STATISTICS_H

#include "accuracy.h"
#include "constraints.h"
#include "load.h"
#include "options.h"
#include "output_files.h"

#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h>

#include <boost/graph/graph_traits.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace program {

/// JSON with keys in the order in which they are set. Numbers that are not finite become null.
using Json = nlohmann::ordered_json;

/// What testing every edge for the Delaunay property found.
struct Delaunay_check {
  std::size_t non_delaunay_edges = 0, cocircular_edges = 0; ///< constrained edges do not count
  std::size_t constrained_edges = 0, constrained_non_delaunay_edges = 0;
  std::uint64_t probable_zero = 0; ///< ties taken for such without proof
  std::vector<char> is_tie;        ///< per edge, by number
};

/// Integrals over the surface in the units of the input; of a cover, over the faces below it.
struct Integrals {
  double area = 0;
  double trace = 0;                     ///< sum of the diagonal of the Laplacian
  std::array<double, 3> dirichlet = {}; ///< x^T L x of each coordinate function
};

/// tests every edge.
template <class Triangulation, class Constrained>
Delaunay_check check(Triangulation& t, const Constrained& constrained) {
  const std::uint64_t before = t.metric().statistics().probable_zero;
  const auto report = IT::check_delaunay(t);
  Delaunay_check result;
  result.is_tie.assign(t.numbers().edge_capacity(t.mesh()), 0);
  for (const typename Triangulation::edge_descriptor e : report.cocircular_edges) {
    result.is_tie[t.index(e)] = 1;
    if (!get(constrained, e)) ++result.cocircular_edges;
  }
  {
    const typename Triangulation::Const_session session(t);
    for (const typename Triangulation::edge_descriptor e : edges(t.mesh())) {
      if (!get(constrained, e)) continue;
      ++result.constrained_edges;
      if (!session.is_locally_delaunay(halfedge(e, t.mesh())))
        ++result.constrained_non_delaunay_edges;
    }
  }
  result.non_delaunay_edges = report.non_delaunay_edges - result.constrained_non_delaunay_edges;
  result.probable_zero = t.metric().statistics().probable_zero - before;
  return result;
}

/// returns the cotangent weight of an edge without deciding again whether it is a tie, which costs.
template <class Triangulation>
double weight_of(typename Triangulation::Session& session, const Triangulation& t,
                 typename Triangulation::edge_descriptor e, const Delaunay_check& check) {
  return check.is_tie[t.index(e)] != 0 ? 0 : session.cotangent_weight(e, IT::statistics_tolerance);
}

/// measures the shapes of faces.
template <class Triangulation>
IT::Quality quality_of(Triangulation& t, const Delaunay_check& check) {
  return IT::measure_quality(t, [&](auto e) { return check.is_tie[t.index(e)] != 0; });
}

/// integrates over the surface; x^T L x is summed over edges as w (x_i - x_j)^2, without
/// cancellation. Weights of edges from a vertex to itself do not count.
template <class Triangulation>
Integrals integrals_of(Triangulation& t, const std::vector<Point>& scaled_points,
                       const Delaunay_check& check) {
  const auto& mesh = t.mesh();
  const int s = t.metric().scale_exponent();
  long double area = 0, trace = 0;
  std::array<long double, 3> dirichlet = {};
  for (const typename Triangulation::face_descriptor f : faces(mesh)) {
    t.area(f, IT::statistics_tolerance); // makes what is stored accurate, which does not underflow
    area += t.metric().approximate_quadruple_area(t.index(f));
  }
  typename Triangulation::Session session(t);
  for (const typename Triangulation::edge_descriptor e : edges(mesh)) {
    const auto i = source(halfedge(e, mesh), mesh), j = target(halfedge(e, mesh), mesh);
    if (t.input_vertex(i) == t.input_vertex(j)) continue;
    const double weight = weight_of(session, t, e, check) / t.input().names().sheets;
    trace += 2 * weight;
    if (scaled_points.empty()) continue;
    for (unsigned k = 0; k < 3; ++k) {
      const double d = scaled_points[i.index][k] - scaled_points[j.index][k];
      dirichlet[k] += weight * d * d;
    }
  }
  Integrals result;
  result.area = std::ldexp(static_cast<double>(area), -2 * s - 2) / t.input().names().sheets;
  result.trace = static_cast<double>(trace);
  for (unsigned k = 0; k < 3; ++k)
    result.dirichlet[k] = std::ldexp(static_cast<double>(dirichlet[k]), -2 * s);
  return result;
}

/// returns the area of a triangulation as its metric stores it, in the units of the input.
template <class Triangulation>
double stored_area(const Triangulation& t) {
  long double sum = 0;
  for (const typename Triangulation::face_descriptor f : faces(t.mesh()))
    sum += t.metric().approximate_quadruple_area(t.index(f));
  return std::ldexp(static_cast<double>(sum), -2 * t.metric().scale_exponent() - 2) /
         t.input().names().sheets;
}

/// returns the area of a triangle in space.
double area(const Point& p, const Point& q, const Point& r);

/// returns the area of the input from its coordinates, before any mollification, in its units; NaN
/// where the coordinates are not known; where polygons became planar, that of its faces.
/// \pre no edge was flipped, unless traits are exact or it is known where edges run
template <class Triangulation>
double input_area(const Loaded<Triangulation>& loaded) {
  const Triangulation& t = loaded.triangulation;
  const std::vector<Point>& p = loaded.scaled_points();
  if (p.empty()) return std::numeric_limits<double>::quiet_NaN();
  if (!t.input().planar_polygons().empty()) return stored_area(t);
  long double sum = 0;
  if constexpr (Triangulation::Metric::is_exact) {
    if (loaded.points.empty()) { // the metric keeps input faces whatever was flipped
      const IT::Input_metric& input = t.input().metric();
      for (std::uint32_t f = 0; f < input.number_of_faces(); ++f)
        sum += area(p[input.sides(f)[0]], p[input.sides(f)[1]], p[input.sides(f)[2]]);
      return std::ldexp(static_cast<double>(sum), -2 * t.metric().scale_exponent()) /
             t.input().names().sheets;
    }
  }
  if constexpr (Triangulation::has_correspondence) { // stored ones were flipped
    const IT::Input& input = t.input();
    for (std::uint32_t f = 0; f < input.number_of_faces(); ++f) {
      const std::uint32_t h = input.halfedge_of_face(f);
      sum += area(p[input.source(h)], p[input.target(h)], p[input.target(input.next(h))]);
    }
  } else
    for (const typename Triangulation::face_descriptor f : faces(t.mesh())) {
      const auto h = halfedge(f, t.mesh()), n = next(h, t.mesh());
      sum += area(p[source(h, t.mesh()).index], p[target(h, t.mesh()).index],
                  p[target(n, t.mesh()).index]);
    }
  return std::ldexp(static_cast<double>(sum), -2 * t.metric().scale_exponent()) /
         t.input().names().sheets;
}

/// returns what is known of input and mollification, and the program's version.
Json input_json(const Options& options, const std::string& arithmetic,
                const std::string& correspondence, const Input_facts& facts,
                const IT::Input_report& report);
/// returns which surface was made of the file, and why.
Json domain_json(const IT::Domain_report& report,
                 const std::optional<IT::Point_cloud_report>& cloud, std::size_t vertices);
/// returns what was made of polygons.
Json polygons_json(const IT::Polygon_report& report);
/// returns what changed lengths needed.
Json metric_json(const Metric_report& report);
/// returns what is known of constrained edges.
Json constraints_json(const Constraints& constraints, const Delaunay_check& check);
/// returns what flipping did.
Json delaunay_json(const IT::Flip_to_delaunay_result& flips,
                   const IT::Predicate_statistics& statistics, const Delaunay_check& check);
/// returns the certificate: `exact`, `interval` or `none`.
std::string certificate(bool is_exact, std::uint64_t probable_zero, const Delaunay_check& check);
/// returns what depends on the shape of faces.
Json quality_json(const IT::Quality& quality);
/// adds integrals.
void add_integrals(Json& json, const Integrals& integrals, double input_area, bool has_points);
/// returns the peak of resident memory so far, in MiB.
double peak_rss_mib();

/// Shows progress.
struct Delaunay_progress {
  /// where to show it
  Progress* line = nullptr;
  /// is called while flipping
  bool progress(const IT::Flip_to_delaunay_result& result) {
    return line->show("flipping to Delaunay", std::to_string(result.flips) + " flips");
  }
};

/// returns what is known of what was loaded, and how long that took.
template <class Triangulation>
Json loaded_json(const Loaded<Triangulation>& loaded, const Options& options) {
  const Triangulation& t = loaded.triangulation;
  Json json = input_json(options, Triangulation::Metric::is_exact ? "exact" : "double",
                         Triangulation::Correspondence::name, loaded.facts, t.report());
  if (!loaded.domain.reason.empty())
    json["domain"] = domain_json(loaded.domain, loaded.cloud, t.input().number_of_rows());
  else if (t.input().names().sheets > 1)
    json["domain"] = {{"kind", "stored"},
                      {"reason", "the file has a cover"},
                      {"sheets", t.input().names().sheets},
                      {"vertices", t.input().number_of_rows()}};
  if (options.polygons != "fan") json["polygons"] = polygons_json(loaded.polygons);
  if (!options.metric.empty()) json["metric"] = metric_json(loaded.metric);
  json["seconds"] = {{"read", loaded.seconds.read},
                     {"build", loaded.seconds.build},
                     {"topology", loaded.seconds.topology}};
  return json;
}

/*!
\brief flips if the options say so, and measures; the common part of all commands.
\param loaded what was loaded
\param flip whether to flip to Delaunay
\param options the options
\param progress where to show progress
\param constrain called with the statistics before flipping; it returns a writable property map of
  the edges that are kept
\param improve called with the statistics and that map after flipping, before anything is measured
\throws std::runtime_error if flipping does not end, or changes the area, which happens in inexact
arithmetic only
\return the statistics so far
*/
template <class Triangulation, class Constrain, class Improve>
Json flip_and_measure(Loaded<Triangulation>& loaded, bool flip, const Options& options,
                      Progress& progress, const Constrain& constrain, const Improve& improve) {
  constexpr bool is_exact = Triangulation::Metric::is_exact;
  Triangulation& t = loaded.triangulation;
  Json json = loaded_json(loaded, options);
  const double area = input_area(loaded);
  // lengths that were changed have another area than the points
  const bool is_area_known = std::isfinite(area) && area > 0 && options.metric.empty() &&
                             t.report().mollification.kind != IT::Mollification::lengths;
  const double kept_area = is_area_known || is_exact ? area : stored_area(t);
  const auto constrained = constrain(json);
  Stopwatch watch;
  IT::Flip_to_delaunay_result result;
  Delaunay_progress visitor{&progress};
  t.metric().statistics() = {};
  if (flip) {
    progress.show("flipping to Delaunay");
    result = IT::flip_to_delaunay(
        t, edges(t.mesh()),
        IT::parameters::edge_is_constrained_map(constrained).visitor(std::ref(visitor)));
  }
  const double delaunay_seconds = watch.lap();
  if (result.status == IT::Status::cap)
    throw std::runtime_error(options.input + ": flipping did not end after " +
                             std::to_string(result.flips) +
                             " flips in double arithmetic; use --arithmetic exact");
  json["seconds"]["delaunay"] = delaunay_seconds;
  improve(json, constrained);
  watch.lap();
  const IT::Predicate_statistics statistics = t.metric().statistics();
  progress.show("verifying");
  const Delaunay_check checked = check(t, constrained);
  if (loaded.constraints.is_asked_for)
    json["constraints"] = constraints_json(loaded.constraints, checked);
  json["delaunay"] = delaunay_json(result, statistics, checked);
  json["certificate"] = certificate(is_exact, statistics.probable_zero, checked);
  json["quality"] = quality_json(quality_of(t, checked));
  // coordinates of inserted vertices are not known to the metric
  const std::vector<Point> none;
  const bool has_points = num_vertices(t.mesh()) == loaded.scaled_points().size();
  const Integrals integrals = integrals_of(t, has_points ? loaded.scaled_points() : none, checked);
  if (!is_exact) expect_area_kept(kept_area, integrals.area, options);
  add_integrals(json, integrals, area, has_points);
  json["seconds"]["verify"] = watch.lap();
  return json;
}

/// flips if the options say so, and measures.
template <class Triangulation>
Json flip_and_measure(Loaded<Triangulation>& loaded, bool flip, const Options& options,
                      Progress& progress) {
  const auto constrain = [&](Json&) {
    return constrained_edges(loaded.triangulation, loaded.constraints);
  };
  return flip_and_measure(loaded, flip, options, progress, constrain, [](Json&, const auto&) {});
}

/// prints statistics for people.
void print_summary(std::ostream& out, const Json& json);
/// prints the summary to standard error if that is a terminal.
void print_summary_on_terminal(const Json& json);

/// Lists have so many records in the statistics at most.
inline constexpr std::size_t most_records = 1000;

/*!
\brief completes all outputs: adds the last measurements, writes the statistics and, if options name
a file for them, all records, and commits the files.
\param json the statistics
\param options where they go
\param files the files written so far
\param watch started when writing began
*/
void finish(Json& json, const Options& options, Output_files& files, Stopwatch& watch);

} // namespace program

#endif // INTRINSIC_STATISTICS_H
