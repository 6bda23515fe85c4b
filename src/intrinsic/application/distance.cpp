// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../commands.h"
#include "../status_name.h"
#include "application.h"

#include <CGAL/Intrinsic_geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_operators/distance/Heat_distance.h>
#include <CGAL/Intrinsic_operators/distance/Signed_heat_distance.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace program {

namespace {

using Vertices = std::vector<IT::Gluing_map::Vertex>;
using Curve = std::vector<IT::Gluing_map::Halfedge>;

// the shortest ways along edges from each point of a curve to the next one
template <class Triangulation>
Curve along_edges(const Triangulation& t, const Vertices& points, const std::string& name) {
  IT::Edge_path_finder<Triangulation> find(t);
  Curve curve;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Curve way = find(points[i], points[i + 1]);
    if (way.empty())
      throw std::runtime_error("--curve " + name +
                               ": no edges lead from a point to the next one; choose different "
                               "points of one component");
    curve.insert(curve.end(), way.begin(), way.end());
  }
  return curve;
}

Computed computed_distances(Eigen::VectorXd distances, const Application_options& o) {
  Computed computed{"distance", {}, {}};
  std::size_t unreached = 0;
  double least = 0, greatest = 0;
  for (const double d : distances) {
    if (!std::isfinite(d)) ++unreached;
    if (std::isfinite(d) && d > greatest) greatest = d;
    if (d < least) least = d;
  }
  computed.json = {{"method", o.distance},
                   {"sources", o.sources.size()},
                   {"curves", o.curves.size()},
                   {"signed", o.is_signed},
                   {"min", least},
                   {"max", greatest},
                   {"unreached_vertices", unreached}};
  computed.functions.push_back({"distance", std::move(distances)});
  computed.isolines = 25;
  return computed;
}

Vertices joined(std::span<const Vertices> lists) {
  Vertices all;
  for (const Vertices& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

template <class Triangulation>
Computed heat_distances(const Triangulation& t, const Sources& sources,
                        const Application_options& o) {
  std::vector<Curve> curves;
  for (std::size_t i = 0; i < o.curves.size(); ++i)
    curves.push_back(along_edges(t, sources[o.sources.size() + i], o.curves[i]));
  const auto with_time = [&](Eigen::VectorXd distances, double time) {
    Computed computed = computed_distances(std::move(distances), o);
    computed.json["time"] = time;
    return computed;
  };
  const auto factor = IT::parameters::time_factor(o.time_factor);
  if (o.is_signed) {
    IT::Signed_heat_distance heat(t, factor);
    return with_time(heat.distances(curves), heat.time());
  }
  const Vertices points = joined(std::span(sources).first(o.sources.size()));
  IT::Heat_distance heat(t, factor);
  return with_time(curves.empty()   ? heat.distances(points)
                   : points.empty() ? heat.distances(curves)
                                    : heat.distances(points).cwiseMin(heat.distances(curves)),
                   heat.time());
}

template <class Triangulation>
Computed exact_distances(const Triangulation& t, const Sources& sources,
                         const Application_options& o) {
  const Vertices points = joined(std::span(sources).first(o.sources.size()));
  const Vertices targets = joined(std::span(sources).subspan(o.sources.size()));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const IT::Polyhedral_distance<Triangulation> search(
      t, points,
      IT::parameters::maximum_distance(o.maximum_distance.value_or(infinity)).targets(targets));
  const std::vector<double> by_row = search.distances();
  const auto rows = static_cast<Eigen::Index>(by_row.size());
  Computed computed = computed_distances(Eigen::Map<const Eigen::VectorXd>(by_row.data(), rows), o);
  Json to_targets = Json::array();
  for (const auto v : targets) to_targets.push_back(finite_or_null(by_row[t.input_vertex(v)]));
  computed.json["status"] = program::name(search.status());
  computed.json["reached"] = finite_or_null(search.reached_distance());
  computed.json["targets"] = std::move(to_targets);
  return computed;
}

} // namespace

void run_distance(const Options& options) {
  run_application(options, [&](const auto& t, const Sources& sources, const Points&) {
    const Application_options& o = options.application;
    return o.distance == "exact" ? exact_distances(t, sources, o) : heat_distances(t, sources, o);
  });
}

} // namespace program
