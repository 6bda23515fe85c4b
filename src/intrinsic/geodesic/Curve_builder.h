// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_GEODESIC_CURVE_BUILDER_H
#define INTRINSIC_GEODESIC_CURVE_BUILDER_H

#include "../constraints.h"
#include "../load.h"
#include "../options.h"
#include "../support/file_formats.h"
#include "../support/naming_file.h"
#include "../asked_curves.h"

#include <CGAL/Intrinsic_geodesics/bezier/make_bezier_curve.h>
#include <CGAL/Intrinsic_geodesics/compiled.h>
#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_geodesics/curves/add_marked_edges.h>
#include <CGAL/Intrinsic_geodesics/queries/Paths_on_faces.h>
#include <CGAL/Intrinsic_geodesics/queries/add_geodesics.h>
#include <CGAL/Intrinsic_geodesics/queries/insert_places.h>
#include <CGAL/Intrinsic_geodesics/single_source/flip_to_geodesic_tree.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace program {

/*!
\brief adds the curves of the options to a network: first vertices at their points, then marked
edges, then paths and loops. Paths and loops are geodesics, each found as if the others were not
there. Beside marked edges, and if shortening may stop early, they start as shortest paths along
edges. Shortest paths on the faces under a cover are no edges, and not in the network.
*/
template <class Triangulation>
class Curve_builder {
  using Vertex = typename Triangulation::vertex_descriptor;
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Vertices = std::vector<Vertex>;
  using Curve = IT::Curve_through_vertices<Triangulation>;

public:
  /// prepares the curves of `options` on what was loaded.
  Curve_builder(Loaded<Triangulation>& loaded, const Options& options,
                IT::Curve_network<Triangulation>& network)
      : loaded_(loaded), t_(loaded.triangulation), options_(options), network_(network) {}

  /// adds the curves. \throws std::runtime_error naming what cannot be added, and the remedy
  void run() {
    std::vector<Asked_curve> curves =
        asked_curves(options_, t_.input().number_of_rows(), loaded_.facts.polygons);
    if (are_free(curves)) take_paths_on_faces(curves);
    std::vector<Curve> through;
    for (const Asked_curve& curve : curves)
      through.push_back(
          {naming_file(curve.source + ": " + options_.input,
                       [&] { return IT::insert_places(t_, curve.points, curve.is_loop); }),
           curve.is_loop, options_.geodesic.has_waypoints});
    IT::internal::fix_junctions(network_, through);
    if (has_constraints(options_))
      named(options_.input,
            [&] { IT::add_marked_edges(network_, constrained_edges(t_, loaded_.constraints)); });
    IT::Edge_path_finder<Triangulation> find(t_);
    if (are_free(curves) && add_geodesics(curves, through)) return;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const Vertices& vertices = through[i].vertices;
      if (curves[i].kind == Curve_kind::source) add_tree(vertices.front());
      if (curves[i].kind == Curve_kind::control_points) add_bezier_curve(vertices, curves[i]);
      if (curves[i].kind != Curve_kind::joined) continue;
      const std::vector<Halfedge> way = way_through(vertices, curves[i], find);
      named(curves[i].source,
            [&] { curves[i].is_loop ? network_.add_loop(way) : network_.add_path(way); });
    }
    if (network_.number_of_curves() == 0 && on_faces_.empty())
      throw std::runtime_error(options_.input +
                               ": no edge is marked, so there is no curve; mark edges, or choose a "
                               "smaller --sharp-angle");
  }

  /// returns the shortest paths that curves were made of, if each was found alone.
  const std::vector<IT::Traced_curve>& initial() const { return initial_; }
  /// returns the paths on the faces under a cover, by the numbers of curves.
  const std::map<std::size_t, IT::Path_on_faces>& on_faces() const { return on_faces_; }
  /// returns what was done to find them.
  const IT::Shortening_result& shortening() const { return shortening_; }

private:
  // Whether each curve is found as if the others were not there: there are no marked edges, and
  // shortening does not stop early.
  bool are_free(const std::vector<Asked_curve>& curves) const {
    const Geodesic_options& g = options_.geodesic;
    return !has_constraints(options_) && !g.is_along_edges && g.relative_length == 0 &&
           g.joint_angle == 180 &&
           std::all_of(curves.begin(), curves.end(),
                       [](const Asked_curve& c) { return c.kind == Curve_kind::joined; });
  }

  // Finds shortest paths on the faces under a cover, unless curves are to be edges.
  void take_paths_on_faces(std::vector<Asked_curve>& curves) {
    const bool are_edges =
        options_.refines || options_.geodesic.writes_subdivision ||
        (!options_.output.empty() && !is_file_of(Contents::curves, options_.output));
    if (are_edges || t_.input().names().sheets == 1) return;
    IT::Paths_on_faces<Triangulation> find(t_);
    std::vector<Asked_curve> others;
    for (std::size_t i = 0; i < curves.size(); ++i)
      if (const Asked_curve& c = curves[i];
          find.can_find(c.points.size(), c.is_loop, options_.geodesic.has_waypoints))
        on_faces_[i] =
            naming_file(c.source + ": " + options_.input, [&] { return find(c.points); });
      else
        others.push_back(c);
    curves = std::move(others);
  }

  // False if vertices are not connected, or rounding has spoilt a path.
  bool add_geodesics(const std::vector<Asked_curve>& asked, const std::vector<Curve>& curves) {
    for (std::size_t i = 0; i < asked.size(); ++i)
      expect_different_neighbors(curves[i].vertices, asked[i]);
    const auto added = IT::add_geodesics(network_, curves);
    if (added.status != IT::Status::done) {
      network_.clear();
      return false;
    }
    initial_ = added.initial;
    shortening_ = added.shortening;
    return true;
  }

  // the last two edges on the way to each vertex, so that all of its joints are there
  void add_tree(Vertex source) {
    const auto tree =
        naming_file(options_.input, [&] { return IT::flip_to_geodesic_tree(t_, source); });
    for (const Vertex v : vertices(t_.mesh())) {
      const Halfedge last = tree.halfedge_to(v);
      if (last.index == IT::Gluing::none) continue;
      const Halfedge before = tree.halfedge_to(IT::source(last, t_.mesh()));
      before.index == IT::Gluing::none ? network_.add_path(std::vector{last})
                                       : network_.add_path(std::vector{before, last});
    }
  }

  void add_bezier_curve(const Vertices& control_points, const Asked_curve& asked) {
    named(asked.source, [&] {
      const auto curve = IT::make_bezier_curve(t_, control_points);
      if (curve.status != IT::Status::done)
        throw std::runtime_error(
            asked.source +
            ": no geodesics join the control points, or no vertex can be "
            "inserted in the middle of one; choose other points" +
            (Triangulation::Metric::is_exact ? "" : ", or --arithmetic exact"));
      for (const Vertices& fixed : {curve.control_points, curve.crossings})
        for (const Vertex v : fixed) network_.fix(v);
      network_.add_path(curve.halfedges);
    });
  }

  // as the user names it
  std::string name(Vertex v) const {
    return t_.is_inserted(v)
               ? "a point inside of a face of " + options_.input
               : "vertex " + std::to_string(t_.input_vertex(v)) + " of " + options_.input;
  }

  // Calls a function; reports a crossing with the numbers of the file.
  template <class Function>
  void named(const std::string& source, const Function& function) const {
    try {
      function();
    } catch (const IT::Invalid_input& e) {
      if (e.kind() != IT::Element_kind::vertex) throw;
      throw std::runtime_error(source + ": the curve crosses another or itself at " +
                               name(t_.numbers().vertex_at(static_cast<std::uint32_t>(e.index()))) +
                               ", where none may pass another; let curves end there, give it as a "
                               "point of this one with "
                               "--waypoints, or make each geodesic in a run of its own");
    }
  }

  void expect_different_neighbors(const Vertices& vertices, const Asked_curve& curve) const {
    const std::size_t n = vertices.size();
    for (std::size_t i = 0; i + (curve.is_loop ? 0 : 1) < n; ++i)
      if (IT::internal::are_copies(t_, vertices[i], vertices[(i + 1) % n]))
        throw std::runtime_error(curve.source + ": " + name(vertices[i]) +
                                 " follows itself; give it once");
  }

  std::vector<Halfedge> way_through(const Vertices& vertices, const Asked_curve& curve,
                                    IT::Edge_path_finder<Triangulation>& find) const {
    expect_different_neighbors(vertices, curve);
    std::vector<Halfedge> way;
    const std::size_t n = vertices.size();
    for (std::size_t i = 0; i + (curve.is_loop ? 0 : 1) < n; ++i) {
      const Vertex from = vertices[i], to = vertices[(i + 1) % n];
      std::vector<Halfedge> piece = find(from, to);
      if (piece.empty()) // from another copy, and to one
        piece =
            find(IT::internal::copies_of_vertex(t_, from), IT::internal::copies_of_vertex(t_, to));
      if (piece.empty())
        throw std::runtime_error(curve.source + ": no path leads from " + name(from) + " to " +
                                 name(to) +
                                 ", they are in different components; choose points of one");
      way.insert(way.end(), piece.begin(), piece.end());
    }
    return way;
  }

  Loaded<Triangulation>& loaded_;
  Triangulation& t_;
  const Options& options_;
  IT::Curve_network<Triangulation>& network_;
  std::vector<IT::Traced_curve> initial_;
  std::map<std::size_t, IT::Path_on_faces> on_faces_;
  IT::Shortening_result shortening_;
};

} // namespace program

#endif // INTRINSIC_GEODESIC_CURVE_BUILDER_H
