// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_GEODESIC_GEODESIC_CURVES_H
#define INTRINSIC_GEODESIC_GEODESIC_CURVES_H

#include "../load.h"
#include "../options.h"
#include "../statistics.h"
#include "../support/progress.h"
#include "Curve_builder.h"

#include <CGAL/Intrinsic_geodesics/queries/Paths_on_faces.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_geodesics/shortening/certify_geodesic.h>
#include <CGAL/Intrinsic_geodesics/shortening/is_geodesic.h>
#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/constrained_input_edges.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>

#include <CGAL/Interval_nt.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace program {

/// Shows progress.
struct Shortening_progress : IT::Shortening_visitor {
  /// where to show it
  Progress* line = nullptr;
  /// is called while shortening
  bool progress(const IT::Shortening_result& r) {
    return line->show("shortening", std::to_string(r.flips) + " flips");
  }
};

/// returns the word for how shortening ended.
std::string geodesic_status(IT::Status status, bool is_contracted);

/*!
\brief makes the curves of the options, shortens them, and stores them as polylines in space before
and after that.
*/
template <class Triangulation>
class Geodesic_curves {
public:
  /// starts without curves. \param input_points one point per vertex of the mesh file
  Geodesic_curves(Loaded<Triangulation>& loaded, const Options& options,
                  std::vector<Point> input_points)
      : loaded_(loaded), t_(loaded.triangulation), options_(options), network_(t_),
        points_(std::move(input_points)) {}

  /// builds the curves, shortens them, and reports it.
  void run(Json& json, Progress& progress) {
    Stopwatch watch;
    progress.show("finding paths");
    Curve_builder<Triangulation> builder(loaded_, options_, network_);
    builder.run();
    const bool is_geodesic_tree = !options_.geodesic.source.empty(); // nothing is shortened
    if (!options_.view.empty() && !is_geodesic_tree) initial_ = polylines();
    for (std::uint32_t c = 0; c < network_.number_of_curves(); ++c) {
      const bool is_lone = c < builder.initial().size();
      initial_length_.push_back(is_lone ? builder.initial()[c].length : network_.length(c));
      if (is_lone && !options_.view.empty())
        initial_[c] = polyline(builder.initial()[c], network_.is_loop(c), c);
    }
    json["seconds"]["paths"] = watch.lap();
    progress.show("shortening");
    Shortening_progress visitor;
    visitor.line = &progress;
    on_faces_ = builder.on_faces();
    result_ = builder.shortening();
    result_ += IT::shorten_curves(network_,
                                  IT::parameters::relative_length(options_.geodesic.relative_length)
                                      .minimum_joint_angle(options_.geodesic.joint_angle)
                                      .visitor(std::ref(visitor)));
    json["seconds"]["shorten"] = watch.lap();
    progress.show("verifying");
    json["geodesic"] = facts();
    json["seconds"]["certify"] = watch.lap();
    if (!options_.view.empty() || !options_.output.empty()) {
      shortened_ = polylines();
      add_on_faces(shortened_);
    }
    if (!options_.view.empty()) add_on_faces(initial_);
  }

  /// returns the curves as they were before.
  const std::vector<IT::Polyline>& initial() const { return initial_; }
  /// returns the curves.
  const std::vector<IT::Polyline>& shortened() const { return shortened_; }
  /// returns for each edge with curves the number of the one on the left.
  Edge_labels<Triangulation> labels() const {
    Edge_labels<Triangulation> labels(t_);
    for (const typename Triangulation::edge_descriptor e : edges(t_.mesh()))
      if (network_.carries_curve(e))
        put(labels, e, static_cast<std::int32_t>(network_.curves_along(e).front()) + 1);
    return labels;
  }

private:
  Json facts() const {
    const IT::Geodesic_report report = IT::is_geodesic(network_);
    std::vector<char> is_geodesic(network_.number_of_curves(), 1);
    for (const IT::Joint_report& joint : report.joints)
      if (!joint.is_geodesic()) is_geodesic[joint.curve] = 0;
    Json curves = Json::array();
    double initial_length = 0;
    bool are_all_contracted = true;
    for (std::uint32_t c = 0; c < network_.number_of_curves(); ++c) {
      const bool is_contracted = network_.is_point(c);
      are_all_contracted = are_all_contracted && is_contracted;
      initial_length += initial_length_[c];
      curves.push_back(
          {{"status", geodesic_status(is_geodesic[c] != 0 ? IT::Status::done : result_.status,
                                      is_contracted)},
           {"length", network_.length(c)},
           {"initial_length", initial_length_[c]},
           {"is_loop", network_.is_loop(c)}});
      if (const CGAL::Interval_nt<> bounds = network_.length_enclosure(c); CGAL::is_finite(bounds))
        curves.back()["length_bounds"] = {bounds.inf(), bounds.sup()};
      if (is_contracted && !t_.is_inserted(network_.start(c)))
        curves.back()["vertex"] = t_.input_vertex(network_.start(c));
    }
    double length = network_.length();
    for (const auto& [c, path] : on_faces_) {
      are_all_contracted = false;
      length += path.curve.length;
      initial_length += path.curve.length;
      curves.insert(curves.begin() + static_cast<std::ptrdiff_t>(c), facts(path));
    }
    Json json = {{"status", geodesic_status(result_.status, are_all_contracted)},
                 {"length", length},
                 {"initial_length", initial_length},
                 {"joints", report.joints.size()},
                 {"flips", result_.flips},
                 {"shortenings", result_.shortenings},
                 {"wedge_checks", result_.wedge_checks},
                 {"exact_ties", result_.exact_ties},
                 {"refused_flips", result_.refused_flips},
                 {"certified",
                  network_.number_of_curves() == 0 || IT::certify_geodesic(network_).is_geodesic()},
                 {"curves", curves}};
    for (const auto& [c, path] : on_faces_)
      if (!path.certificate.is_geodesic()) {
        json["certified"] = false;
        json["obstacle"] = path.certificate.obstacle;
      }
    return json;
  }

  static Json facts(const IT::Path_on_faces& path) {
    Json json = {{"status", path.curve.status == IT::Status::done ? "geodesic" : "inaccurate"},
                 {"length", path.curve.length},
                 {"initial_length", path.curve.length},
                 {"is_loop", false}};
    if (const CGAL::Interval_nt<> bounds = path.certificate.length; CGAL::is_finite(bounds))
      json["length_bounds"] = {bounds.inf(), bounds.sup()};
    return json;
  }

  // Puts the paths on faces between the curves of the network.
  void add_on_faces(std::vector<IT::Polyline>& lines) const {
    if (on_faces_.empty()) return;
    for (const auto& [c, path] : on_faces_)
      lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(c), polyline(path.curve, false));
    for (std::size_t c = 0; c < lines.size(); ++c) lines[c].label = static_cast<std::int32_t>(c);
  }

  std::vector<IT::Polyline> polylines() const {
    std::vector<IT::Polyline> result;
    for (std::uint32_t c = 0; c < network_.number_of_curves(); ++c) {
      if (network_.is_point(c)) {
        result.push_back(
            {points_at(network_.start(c)), network_.is_loop(c), static_cast<std::int32_t>(c)});
        continue;
      }
      const IT::Traced_curve curve = IT::trace_curve(t_, network_.halfedges(c));
      result.push_back(polyline(curve, network_.is_loop(c), c));
    }
    return result;
  }

  IT::Polyline polyline(const IT::Traced_curve& curve, bool is_loop, std::uint32_t c = 0) const {
    IT::Polyline line{{}, is_loop, static_cast<std::int32_t>(c)};
    for (const IT::Surface_point& p : curve.points)
      line.points.push_back(IT::point_in_space(t_, p, points_));
    if (line.is_closed) line.points.pop_back(); // the start again
    return line;
  }

  // where a curve is that has contracted
  std::vector<Point> points_at(typename Triangulation::vertex_descriptor v) const {
    const auto out = opposite(halfedge(v, t_.mesh()), t_.mesh());
    const IT::Traced_curve star = IT::trace_curve(t_, std::vector{out});
    if (star.points.empty()) return {};
    return {IT::point_in_space(t_, star.points.front(), points_)};
  }

  Loaded<Triangulation>& loaded_;
  Triangulation& t_;
  const Options& options_;
  IT::Curve_network<Triangulation> network_;
  std::vector<Point> points_;
  std::vector<double> initial_length_;
  IT::Shortening_result result_;
  std::map<std::size_t, IT::Path_on_faces> on_faces_; // by the numbers of curves
  std::vector<IT::Polyline> initial_, shortened_;
};

} // namespace program

#endif // INTRINSIC_GEODESIC_GEODESIC_CURVES_H
