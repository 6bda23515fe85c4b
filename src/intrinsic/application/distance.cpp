// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../commands.h"
#include "application.h"

#include <CGAL/Intrinsic_geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_operators/distance/Heat_distance.h>
#include <CGAL/Intrinsic_operators/distance/Signed_heat_distance.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
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

Computed computed_distances(Eigen::VectorXd distances, double time, const Application_options& o) {
  Computed computed{"distance", {}, {}};
  std::size_t unreached = 0;
  double least = 0, greatest = 0;
  for (const double d : distances) {
    if (!std::isfinite(d)) ++unreached;
    if (std::isfinite(d) && d > greatest) greatest = d;
    if (d < least) least = d;
  }
  computed.json = {{"sources", o.sources.size()},
                   {"curves", o.curves.size()},
                   {"signed", o.is_signed},
                   {"time", time},
                   {"min", least},
                   {"max", greatest},
                   {"unreached_vertices", unreached}};
  computed.functions.push_back({"distance", std::move(distances)});
  computed.isolines = 25;
  return computed;
}

} // namespace

void run_distance(const Options& options) {
  const Application_options& o = options.application;
  run_application(options, [&](const auto& t, const Sources& sources, const Points&) {
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < o.curves.size(); ++i)
      curves.push_back(along_edges(t, sources[o.sources.size() + i], o.curves[i]));
    const auto time = IT::parameters::time_factor(o.time_factor);
    if (o.is_signed) {
      IT::Signed_heat_distance heat(t, time);
      return computed_distances(heat.distances(curves), heat.time(), o);
    }
    // vertices of curves and edges between them
    Vertices points;
    for (const Vertices& list : std::span(sources).first(o.sources.size()))
      points.insert(points.end(), list.begin(), list.end());
    IT::Heat_distance heat(t, time);
    return computed_distances(curves.empty() ? heat.distances(points)
                              : points.empty()
                                  ? heat.distances(curves)
                                  : heat.distances(points).cwiseMin(heat.distances(curves)),
                              heat.time(), o);
  });
}

} // namespace program
