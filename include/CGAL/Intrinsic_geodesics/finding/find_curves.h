// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_FINDING_FIND_CURVES_H
#define CGAL_INTRINSIC_GEODESICS_FINDING_FIND_CURVES_H

#include <CGAL/Intrinsic_geodesics/bezier/make_bezier_curve.h>
#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_geodesics/curves/add_marked_edges.h>
#include <CGAL/Intrinsic_geodesics/finding/Curve_tools.h>
#include <CGAL/Intrinsic_geodesics/finding/Found_curves.h>
#include <CGAL/Intrinsic_geodesics/queries/Curve_inserter.h>
#include <CGAL/Intrinsic_geodesics/queries/Paths_on_faces.h>
#include <CGAL/Intrinsic_geodesics/queries/add_geodesics.h>
#include <CGAL/Intrinsic_geodesics/queries/insert_places.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_geodesics/shortening/certify_geodesic.h>
#include <CGAL/Intrinsic_geodesics/shortening/is_geodesic.h>
#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_geodesics/single_source/flip_to_geodesic_tree.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/constrained_input_edges.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// Marks edges of a triangulation, to be added to curves.
/// \tparam Triangulation the type of the triangulation
template <GeodesicTriangulation Triangulation>
using Edge_marker = std::function<Marked_edges<Triangulation>(const Triangulation&)>;

namespace internal {

// Finds curves, see `find_curves()`.
template <class Triangulation>
class Curve_finder {
  using Vertex = typename Triangulation::vertex_descriptor;
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Curve = Curve_through_vertices<Triangulation>;
  using Wanted = std::vector<Wanted_curve>;

public:
  Curve_finder(Curve_tools<Triangulation>& tools, const Find_curves_options& options)
      : t_(tools.network.triangulation()), options_(options), tools_(tools),
        network_(tools.network),
        log_(tools.log), found_{{}, Marked_edges<Triangulation, std::uint32_t>(t_)} {}

  Curves_along_edges<Triangulation> run(const Wanted& wanted,
                                        const Edge_marker<Triangulation>& mark) {
    const bool is_alone = !mark && options_.is_alone() &&
                          std::all_of(wanted.begin(), wanted.end(), [](const Wanted_curve& c) {
                            return c.kind == Curve_kind::geodesic;
                          });
    if (is_alone && !options_.are_edges) find_on_faces(wanted);
    if (!is_cancelled_) add(wanted, mark, is_alone);
    if (!is_cancelled_) shorten();
    if (!is_cancelled_) measure();
    if (!is_cancelled_) certify();
    finish(found_, is_cancelled_);
    return std::move(found_);
  }

private:
  bool ask(std::uint64_t count) { // whether to go on
    if (options_.progress && !options_.progress(stage_, count)) is_cancelled_ = true;
    return !is_cancelled_;
  }
  bool begin(Curve_stage stage) { return stage_ = stage, ask(0); }
  struct Visitor {
    Curve_finder* finder;
    bool progress(const Shortening_result& r) const { return finder->ask(r.flips); }
    bool progress(std::uint64_t windows, double) const { return finder->ask(windows); }
  };

  // Calls a function; errors begin with the name of the curve.
  template <class Function>
  static auto naming(const Wanted_curve& curve, const Function& function) {
    try {
      return function();
    } catch (const Invalid_input& e) {
      if (curve.name.empty()) throw;
      throw Invalid_input(e.kind(), e.index(), curve.name + ": " + e.what());
    }
  }
  // Shortest paths on the faces under a cover, which are no edges.
  void find_on_faces(const Wanted& wanted) {
    if (!t_.input().names().is_cover() || !begin(Curve_stage::paths_on_faces)) return;
    Paths_on_faces<Triangulation> find(t_);
    for (std::size_t i = 0; i < wanted.size() && !is_cancelled_; ++i)
      if (const Wanted_curve& c = wanted[i];
          find.can_find(c.places.size(), c.is_loop, c.stays_at_places))
        on_faces_[i] =
            naming(c, [&] { return find(c.places, parameters::visitor(Visitor{this})); });
  }

  // Adds all other curves to the network.
  void add(const Wanted& wanted, const Edge_marker<Triangulation>& mark, bool is_alone) {
    if (!begin(Curve_stage::paths)) return;
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (!on_faces_.contains(i)) insert(wanted[i], i);
    fix_junctions(network_, curves_);
    if (mark) naming_crossing([&] { add_marked_edges(network_, mark(t_)); });
    if (is_alone && add_geodesics()) return;
    for (std::size_t i = 0; i < curves_.size() && !is_cancelled_; ++i)
      naming(wanted[number_[i]], [&] { add(wanted[number_[i]], curves_[i], is_alone); });
    for (std::uint32_t c = 0; c < network_.number_of_curves(); ++c) {
      Found_curve& curve = found_.curves.emplace_back();
      curve.initial_length = network_.length(c);
      if (options_.keeps_initial) curve.initial = way(c);
      if (is_alone) curve.way.status = Status::inaccurate; // it may not be the one asked for
    }
  }

  void insert(const Wanted_curve& c, std::size_t number) {
    naming(c, [&] {
      number_.push_back(number);
      curves_.push_back({insert_places(t_, c.places, c.is_loop), c.is_loop, c.stays_at_places});
      if (c.kind == Curve_kind::geodesic) expect_different_neighbors(curves_.back());
    });
  }
  void expect_different_neighbors(const Curve& c) const {
    const std::size_t n = c.vertices.size();
    for (std::size_t i = 0; i + (c.is_loop ? 0 : 1) < n; ++i)
      if (are_copies(t_, c.vertices[i], c.vertices[(i + 1) % n]))
        throw Invalid_input(Element_kind::vertex, t_.input_vertex(c.vertices[i]),
                            name_of_vertex(t_, c.vertices[i]) + internal::repetition(n));
  }

  // False if vertices are not connected, or rounding has spoilt a path.
  bool add_geodesics() {
    Visitor visitor{this};
    auto added =
        internal::add_geodesics(network_, curves_, log_, parameters::visitor(std::ref(visitor)));
    if (added.status != Status::done) {
      network_.clear();
      return added.status == Status::cancelled;
    }
    found_.shortening = added.shortening;
    for (Traced_curve& initial : added.initial) {
      Found_curve& curve = found_.curves.emplace_back();
      curve.initial_length = initial.length;
      curve.way.status = initial.status;
      if (options_.keeps_initial) curve.initial = std::move(initial);
    }
    return true;
  }

  // \param may_cross whether it may cross others and itself, as geodesics that are found alone
  void add(const Wanted_curve& wanted, const Curve& curve, bool may_cross) {
    if (wanted.kind == Curve_kind::tree) return add_tree(curve.vertices.front());
    if (wanted.kind == Curve_kind::bezier) return add_bezier_curve(curve.vertices);
    const std::vector<Halfedge> way = tools_.way_along_edges(curve);
    if (may_cross)
      add_crossing_curve(network_, way, curve.is_loop);
    else
      naming_crossing([&] { curve.is_loop ? network_.add_loop(way) : network_.add_path(way); });
  }

  // the last two edges on the way to each vertex, so that all of its joints are there
  void add_tree(Vertex source) {
    const auto tree = flip_to_geodesic_tree(t_, source);
    for (const Vertex v : vertices(t_.mesh())) {
      const Halfedge last = tree.halfedge_to(v);
      if (last.index == Gluing::none) continue;
      const Halfedge before = tree.halfedge_to(Intrinsic_triangulations::source(last, t_.mesh()));
      before.index == Gluing::none ? network_.add_path(std::vector{last})
                                   : network_.add_path(std::vector{before, last});
    }
  }

  void add_bezier_curve(const std::vector<Vertex>& control_points) {
    const auto curve = make_bezier_curve(t_, control_points);
    if (curve.status != Status::done)
      throw Invalid_input(Element_kind::none, 0,
                          std::string("no geodesics join the control points, or no vertex can be "
                                      "inserted in the middle of one; choose other points") +
                              (Triangulation::Metric::is_exact ? "" : ", or exact arithmetic"));
    for (const auto& fixed : {curve.control_points, curve.crossings})
      for (const Vertex v : fixed) network_.fix(v);
    naming_crossing([&] { network_.add_path(curve.halfedges); });
  }

  // Calls a function; reports a crossing with the user's number of the vertex.
  template <class Function>
  void naming_crossing(const Function& function) const {
    try {
      function();
    } catch (const Invalid_input& e) {
      if (e.kind() != Element_kind::vertex) throw;
      const Vertex v = t_.numbers().vertex_at(static_cast<std::uint32_t>(e.index()));
      throw Invalid_input(Element_kind::vertex, t_.input_vertex(v),
                          "the curve crosses another or itself at " + name_of_vertex(t_, v) +
                              ", where none may pass another; let curves end there, let this one "
                              "stay at that point (waypoints), or find each geodesic alone");
    }
  }

  void shorten() {
    if (!begin(Curve_stage::shortening)) return;
    found_.shortening +=
        internal::shorten_curves(network_, log_,
                                 parameters::visitor(Visitor{this})
                                     .relative_length(options_.relative_length)
                                     .minimum_joint_angle(options_.minimum_joint_angle));
  }

  // In this order: each number that is asked for sharpens others.
  void measure() {
    const Geodesic_report report = is_geodesic(network_);
    std::vector<char> is_geodesic(network_.number_of_curves(), 1);
    for (const Joint_report& joint : report.joints)
      if (!joint.is_geodesic()) is_geodesic[joint.curve] = 0;
    found_.joints = report.joints.size();
    for (std::uint32_t c = 0; c < network_.number_of_curves(); ++c) {
      Found_curve& curve = found_.curves[c];
      curve.is_loop = network_.is_loop(c);
      curve.way.status = network_.is_point(c)  ? Status::contracted
                         : is_geodesic[c] == 0 ? found_.shortening.status
                                               : curve.way.status; // of how it was found
      curve.way.length = network_.length(c);
      curve.way.length_enclosure = network_.length_enclosure(c);
      if (network_.is_point(c) && !t_.is_inserted(network_.start(c)))
        curve.contracted_to = t_.input_vertex(network_.start(c));
      found_.initial_length += curve.initial_length;
    }
    found_.length = network_.length();
  }

  void certify() {
    if (!begin(Curve_stage::certificate)) return;
    if (options_.is_certified)
      found_.is_certified =
          network_.number_of_curves() == 0 || certify_geodesic(network_).is_geodesic();
    for (std::uint32_t c = 0; options_.is_traced && c < network_.number_of_curves(); ++c) {
      Traced_curve traced = way(c);
      found_.curves[c].way.points = std::move(traced.points);
      found_.curves[c].way.faces = std::move(traced.faces);
    }
    for (auto& [number, path] : on_faces_) put_between(number, std::move(path));
    if (log_ != nullptr) return;
    found_.labels = curve_labels(network_);
    if (!on_faces_.empty())
      for (const auto e : edges(t_.mesh()))
        if (const std::uint32_t label = get(found_.labels, e); label != 0)
          put(found_.labels, e, static_cast<std::uint32_t>(number_[label - 1] + 1));
  }

  // The way of a curve over the input; one point if it has contracted.
  Traced_curve way(std::uint32_t c) const {
    if (!network_.is_point(c)) return trace_curve(t_, network_.halfedges(c));
    const auto out = opposite(halfedge(network_.start(c), t_.mesh()), t_.mesh());
    Traced_curve point = trace_curve(t_, std::vector{out});
    if (!point.points.empty()) point.points.resize(1);
    point.faces.clear();
    return point;
  }

  // Puts a path on faces between the curves on the cover.
  void put_between(std::size_t number, Path_on_faces path) {
    if (options_.is_certified && !path.certificate.is_geodesic()) {
      found_.is_certified = false;
      found_.obstacle = path.certificate.obstacle;
    }
    found_.length += path.curve.length;
    found_.initial_length += path.curve.length;
    const auto place = found_.curves.begin() + static_cast<std::ptrdiff_t>(number);
    Found_curve& curve = *found_.curves.emplace(place);
    curve.is_on_faces = true;
    curve.initial_length = path.curve.length;
    if (options_.keeps_initial) curve.initial = path.curve;
    curve.way = std::move(path.curve);
  }

  Triangulation& t_;
  const Find_curves_options& options_;
  Curve_tools<Triangulation>& tools_;
  Curve_network<Triangulation>& network_;
  Flip_log<Triangulation>* log_;
  Curves_along_edges<Triangulation> found_;
  std::vector<Curve> curves_;                     // those that are not on faces
  std::vector<std::size_t> number_;               // of each among the wanted ones
  std::map<std::size_t, Path_on_faces> on_faces_; // by the numbers of wanted curves
  Curve_stage stage_ = Curve_stage::paths;
  bool is_cancelled_ = false;
};

// see `find_curves()`
template <class Triangulation>
Curves_along_edges<Triangulation>
find_curves_with(Curve_tools<Triangulation>& tools, const std::vector<Wanted_curve>& wanted,
                 const Find_curves_options& options, const Edge_marker<Triangulation>& mark) {
  return Curve_finder<Triangulation>(tools, options).run(wanted, mark);
}

} // namespace internal

/*!
\brief finds curves through places that a user names: geodesic paths and loops, Bezier curves, and
geodesics to all vertices.

Paths and loops are found each as if the others were not there, see `add_geodesics()`; where that is
impossible, and with marked edges or if shortening may stop early, they start as shortest paths
along edges and do not cross, see `shorten_curves()`. On a double cover, shortest paths are found on
the faces below, see `Paths_on_faces`, unless curves are to be edges. All other curves are edges of
`t` at the end.
\tparam Triangulation a model of `GeodesicTriangulation`, of `RefinableTriangulation` and of
  `CorrespondingTriangulation`, with exact certificates: see `certify_geodesic()`
\param t the triangulation, flipped to Delaunay: it gets vertices at the places, and is flipped
\param wanted the curves
\param options how to find them
\param mark returns marks of edges, once all places have vertices: chains of them become curves,
  too, see `add_marked_edges()`; they are the first. Default: none
\return the curves
\throws Invalid_input naming what cannot be found, and the remedy
\complexity that of the functions above
*/
template <GeodesicTriangulation Triangulation>
  requires RefinableTriangulation<Triangulation> Curves_along_edges<Triangulation>
  find_curves(Triangulation& t, const std::vector<Wanted_curve>& wanted,
              const Find_curves_options& options = {},
              const std::type_identity_t<Edge_marker<Triangulation>>& mark = {}) {
    internal::Curve_tools<Triangulation> tools(t);
    return internal::find_curves_with(tools, wanted, options, mark);
  }

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_FINDING_FIND_CURVES_H
