// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Curve_edges.h"
#include "Surface.h"
#include "curve_arrays.h"
#include "places.h"
#include "searches.h"

#include <CGAL/Intrinsic_geodesics/compiled.h>
#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_geodesics/curves/add_marked_edges.h>
#include <CGAL/Intrinsic_geodesics/queries/Paths_on_faces.h>
#include <CGAL/Intrinsic_geodesics/queries/add_geodesics.h>
#include <CGAL/Intrinsic_geodesics/queries/insert_places.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_geodesics/shortening/certify_geodesic.h>
#include <CGAL/Intrinsic_geodesics/shortening/is_geodesic.h>
#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_triangulations/connectivity/status_name.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Curves on surfaces: geodesics as the command `geodesic` finds them.

namespace python {

namespace {

/// A path or a loop through points.
struct Asked_curve {
  std::vector<Place> points;
  bool is_loop = false;
};

/// How curves are found.
struct Curve_options {
  bool is_shortest = true;      ///< whether sides start as shortest paths
  bool stays_at_points = false; ///< whether curves stay at all of their points
  bool is_certified = false;    ///< whether to decide exactly whether they are geodesic
};

/// Curves that were made geodesic.
struct Found_curves {
  std::shared_ptr<const IT::Input> input;
  std::vector<Way> ways;
  std::vector<double> initial_lengths;
  IT::Shortening_result shortening;
  std::optional<bool> is_certified;
  std::string obstacle;               ///< why paths on faces are not certified
  std::shared_ptr<Curve_edges> edges; ///< null if curves are no edges
};

// Makes curves geodesic on a copy of a triangulation.
template <class T>
class Curve_finder {
  using Vertex = typename T::vertex_descriptor;
  using Halfedge = typename T::halfedge_descriptor;
  using Curves = std::vector<IT::Curve_through_vertices<T>>;

public:
  Curve_finder(const T& t, const Curve_options& options, Watch& watch)
      : t_(std::make_unique<T>(t)), options_(options), visitor_{&watch}, network_(*t_) {}

  Found_curves run(const std::vector<Asked_curve>& asked) {
    if (!find_on_faces(asked)) return {};
    Curves curves;
    for (std::size_t i = 0; i < asked.size(); ++i)
      if (!on_faces_.contains(i))
        curves.push_back({IT::insert_places(*t_, asked[i].points, asked[i].is_loop),
                          asked[i].is_loop, options_.stays_at_points});
    IT::internal::fix_junctions(network_, curves);
    for (const auto& curve : curves) expect_different_neighbors(curve.vertices, curve.is_loop);
    if (!(options_.is_shortest && add_geodesics(curves))) {
      if (found_.shortening.status == IT::Status::cancelled) return {};
      add_along_edges(curves);
    }
    found_.shortening += IT::shorten_curves(network_, observed());
    if (found_.shortening.status == IT::Status::cancelled) return {};
    measure();
    for (std::uint32_t c = 0; c < network_.number_of_curves(); ++c) trace(c);
    if (options_.is_certified)
      found_.is_certified = curves.empty() || IT::certify_geodesic(network_).is_geodesic();
    found_.input = t_->shared_input();
    if (on_faces_.empty())
      found_.edges = edges();
    else
      add_paths_on_faces();
    return std::move(found_);
  }

private:
  // Shortest paths on the faces under a cover, which are no edges. False if it is cancelled.
  bool find_on_faces(const std::vector<Asked_curve>& asked) {
    if (!options_.is_shortest || t_->input().names().sheets == 1) return true;
    IT::Paths_on_faces<T> find(*t_);
    Search_visitor visitor{visitor_.watch};
    for (std::size_t i = 0; i < asked.size(); ++i)
      if (find.can_find(asked[i].points.size(), asked[i].is_loop, options_.stays_at_points)) {
        on_faces_[i] = find(asked[i].points, IT::parameters::visitor(std::ref(visitor)));
        if (on_faces_[i].curve.status == IT::Status::cancelled) return false;
      }
    return true;
  }

  // Puts them between the curves on the cover.
  void add_paths_on_faces() {
    for (auto& [i, path] : on_faces_) {
      const auto place = static_cast<std::ptrdiff_t>(i);
      found_.initial_lengths.insert(found_.initial_lengths.begin() + place, path.curve.length);
      if (options_.is_certified && !path.certificate.is_geodesic()) {
        found_.is_certified = false;
        found_.obstacle = path.certificate.obstacle;
      }
      found_.ways.insert(found_.ways.begin() + place, Way{std::move(path.curve), false});
    }
  }

  auto observed() { return IT::parameters::visitor(std::ref(visitor_)); }

  std::string name(Vertex v) const {
    return t_->is_inserted(v) ? "a point inside of a face"
                              : "vertex " + std::to_string(t_->input_vertex(v));
  }

  void expect_different_neighbors(const std::vector<Vertex>& vertices, bool is_loop) const {
    const std::size_t n = vertices.size();
    for (std::size_t i = 0; i + (is_loop ? 0 : 1) < n; ++i)
      if (IT::internal::are_copies(*t_, vertices[i], vertices[(i + 1) % n]))
        throw IT::Invalid_input(IT::Element_kind::vertex, t_->input_vertex(vertices[i]),
                                name(vertices[i]) + " follows itself on a curve; give it once");
  }

  // Each curve as if the others were not there. False if vertices are not connected, or rounding
  // has spoilt a path.
  bool add_geodesics(const Curves& curves) {
    const auto added = IT::add_geodesics(network_, curves, observed());
    if (added.status != IT::Status::done) {
      network_.clear();
      if (added.status == IT::Status::cancelled) found_.shortening.status = added.status;
      return false;
    }
    found_.shortening = added.shortening;
    for (const IT::Traced_curve& c : added.initial) found_.initial_lengths.push_back(c.length);
    return true;
  }

  void add_along_edges(const Curves& curves) {
    IT::Edge_path_finder<T> find(*t_);
    for (const auto& curve : curves) {
      const std::vector<Halfedge> way = way_along_edges(curve, find);
      try {
        curve.is_loop ? network_.add_loop(way) : network_.add_path(way);
      } catch (const IT::Invalid_input& e) {
        if (e.kind() != IT::Element_kind::vertex) throw;
        const Vertex v = t_->numbers().vertex_at(static_cast<std::uint32_t>(e.index()));
        throw IT::Invalid_input(IT::Element_kind::vertex, t_->input_vertex(v),
                                "a curve crosses another or itself at " + name(v) +
                                    ", where none may pass another; let curves end there, or find "
                                    "each geodesic in a call of its own");
      }
      found_.initial_lengths.push_back(network_.length(network_.number_of_curves() - 1));
    }
  }

  std::vector<Halfedge> way_along_edges(const IT::Curve_through_vertices<T>& curve,
                                        IT::Edge_path_finder<T>& find) const {
    std::vector<Halfedge> way;
    const std::size_t n = curve.vertices.size();
    for (std::size_t i = 0; i + (curve.is_loop ? 0 : 1) < n; ++i) {
      const Vertex from = curve.vertices[i], to = curve.vertices[(i + 1) % n];
      std::vector<Halfedge> piece = find(from, to);
      if (piece.empty()) // from another copy, and to one
        piece = find(IT::internal::copies_of_vertex(*t_, from),
                     IT::internal::copies_of_vertex(*t_, to));
      if (piece.empty())
        throw IT::Invalid_input(IT::Element_kind::vertex, t_->input_vertex(from),
                                "no path leads from " + name(from) + " to " + name(to) +
                                    ", which are in different components; choose points of one");
      way.insert(way.end(), piece.begin(), piece.end());
    }
    return way;
  }

  // Lengths, and whether curves are geodesic, in the order in which the program finds them: each
  // number that is asked for sharpens others.
  void measure() {
    std::vector<char> is_geodesic(network_.number_of_curves(), 1);
    for (const IT::Joint_report& joint : IT::is_geodesic(network_).joints)
      if (!joint.is_geodesic()) is_geodesic[joint.curve] = 0;
    for (std::uint32_t c = 0; c < network_.number_of_curves(); ++c) {
      Way way;
      way.is_closed = network_.is_loop(c) && !network_.is_point(c);
      way.curve.status = network_.is_point(c)  ? IT::Status::contracted
                         : is_geodesic[c] != 0 ? IT::Status::done
                                               : found_.shortening.status;
      way.curve.length = network_.length(c);
      way.curve.length_enclosure = network_.length_enclosure(c);
      found_.ways.push_back(std::move(way));
    }
  }

  // The points of a curve; one if it has contracted.
  void trace(std::uint32_t c) {
    IT::Traced_curve& curve = found_.ways[c].curve;
    IT::Traced_curve traced =
        network_.is_point(c)
            ? IT::trace_curve(
                  *t_, std::vector{opposite(halfedge(network_.start(c), t_->mesh()), t_->mesh())})
            : IT::trace_curve(*t_, network_.halfedges(c));
    curve.points = std::move(traced.points);
    curve.faces = std::move(traced.faces);
    if (!network_.is_point(c)) return;
    curve.points.resize(1);
    curve.faces.clear();
  }

  // what cuts need; the triangulation is moved there
  std::shared_ptr<Curve_edges> edges() {
    auto result = std::make_shared<Curve_edges>();
    const auto labels = IT::curve_labels(network_);
    result->labels.resize(t_->numbers().edge_capacity(t_->mesh()));
    for (const auto e : IT::edges(t_->mesh())) result->labels[t_->index(e)] = get(labels, e);
    for (std::uint32_t c = network_.number_of_curves(); c-- > 0;)
      if (network_.is_point(c)) result->contracted = c;
    result->triangulation = std::move(t_);
    return result;
  }

  std::unique_ptr<T> t_;
  Curve_options options_;
  Shortening_watch visitor_;
  IT::Curve_network<T> network_;
  std::map<std::size_t, IT::Path_on_faces> on_faces_; // by the numbers of curves
  Found_curves found_;
};

py::dict curves(Surface& s, const std::vector<std::pair<Place_arrays, bool>>& asked,
                const Curve_options& options, const py::object& progress) {
  std::vector<Asked_curve> lists;
  for (const auto& [points, is_loop] : asked) lists.push_back({places_of(s, points), is_loop});
  Watch watch(progress);
  Found_curves found = with_triangulation(
      s, watch, [&]<class T>(const T& t) { return Curve_finder<T>(t, options, watch).run(lists); });
  py::list list;
  for (std::size_t i = 0; i < found.ways.size(); ++i) {
    py::dict curve = curve_arrays(*found.input, s.points, std::move(found.ways[i]));
    curve["initial_length"] = found.initial_lengths[i];
    list.append(curve);
  }
  py::dict result;
  result["curves"] = list;
  result["status"] = IT::name_of(found.shortening.status);
  result["flips"] = found.shortening.flips;
  result["is_certified"] = py::cast(found.is_certified);
  result["obstacle"] = found.obstacle.empty() ? py::object(py::none()) : py::str(found.obstacle);
  result["edges"] = found.edges;
  return result;
}

} // namespace

void bind_cuts(py::module_& m);
void bind_traces(py::module_& m);

void bind_curves(py::module_& m) {
  bind_way(m);
  py::class_<Curve_edges, std::shared_ptr<Curve_edges>>(m, "CurveEdges");
  py::class_<Curve_options>(m, "CurveOptions")
      .def(py::init<bool, bool, bool>(), py::arg("is_shortest"), py::arg("stays_at_points"),
           py::arg("is_certified"));
  m.def("curves", curves);
  bind_cuts(m);
  bind_traces(m);
}

} // namespace python
