// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_POLYHEDRAL_DISTANCE_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_POLYHEDRAL_DISTANCE_H

#include <CGAL/Intrinsic_geodesics/distance/Corner_table.h>
#include <CGAL/Intrinsic_geodesics/distance/Distance_field.h>
#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance_visitor.h>
#include <CGAL/Intrinsic_geodesics/distance/Searched_surface.h>
#include <CGAL/Intrinsic_geodesics/distance/Shortest_path.h>
#include <CGAL/Intrinsic_geodesics/distance/spread_windows.h>
#include <CGAL/Intrinsic_geodesics/distance/trace_back.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief finds the distances of all points of a triangulated surface from sources, and the shortest
  paths.

Distances are those on the surface, along shortest paths through faces and across edges, without
discretization: errors are those of rounding. The triangulation is read once, in doubles: only
lengths and areas count, so that it need not lie in space. Any Delta-complex will do, with or
without border; a shortest path may run along the border. The effort depends on the triangulation of
the surface, the distances do not.

At a vertex that is not manifold, paths pass from any fan of faces to any other. On a cover the
copies of a vertex are one point: paths start, end and pass from one side to the other there.

The search is that of Chen and Han (1990), by distance and pruned as by Xin and Wang (2009):
intervals of edges that a source sees, *windows*, spread over the faces, those of an edge together
as by Qin et al. (2016). Distances of vertices, and paths to them, need no windows once they are
found. Those of points in faces do: the first query for one repeats the search, and keeps the
windows, 32 bytes each.

\tparam Triangulation a model of `NumberedTriangulation`
*/
template <NumberedTriangulation Triangulation>
class Polyhedral_distance {
public:
  /// Vertex of the triangulation.
  using vertex_descriptor = typename Triangulation::vertex_descriptor;

  /*!
  \brief finds the distances from sources.
  \tparam Sources a vertex or a point of the triangulation, as `Surface_point` or
    `Face_location<Mesh>`, or a range of either: `vertex_on_intrinsic()` and
    `locate_on_intrinsic()` find those of the user's mesh
  \tparam NP a chain of named parameters
  \param t the triangulation; it must outlive this object unchanged
  \param sources the sources
  \param np optional named parameters:
    - `maximum_distance(d)`: how far to search, in the units of the input. Default: everywhere.
    - `targets(p)`: such places: the search stops once their distances are final. Default: none, it
      goes everywhere.
    - `maximum_number(n)`: cap on the number of windows, which ends the search on bodies so thin
      that there are too many: k times as long as thick, they have up to about 100 k (it is reached
      from 10^5 on). Default: 500 per halfedge and 4 million.
    - `visitor(v)`: see `Polyhedral_distance_visitor`
  \pre points are in faces, and their weights are not negative
  \complexity O(n^2 log n) for n faces that shortest paths cross once, as they do in space (Chen and
    Han; Xin and Wang). Measured: n^1.29 on a scan (armadillo, split to 10^6 faces), n^1.72 on a
    smooth torus of 10^4 to 10^6 faces. Memory: about 68 bytes per halfedge, and 46 per vertex, kept
    for further searches; targets in faces add the windows, 32 bytes for each of 6 to 12 per
    halfedge
  */
  template <class Sources, NamedParameters NP = parameters::Parameters<>>
  Polyhedral_distance(const Triangulation& t, const Sources& sources,
                      const NP& np = parameters::default_values())
      : Polyhedral_distance(t) {
    search(sources, np);
  }

  /// reads the triangulation, and has no sources yet: all distances are infinite.
  /// \complexity linear
  explicit Polyhedral_distance(const Triangulation& t)
      : Polyhedral_distance(internal::Searched_surface<Triangulation>(t)) {}
  /// A triangulation that would end before this object is refused: give it a name.
  template <class... Others>
  explicit Polyhedral_distance(const Triangulation&&, const Others&...) = delete;

  /*!
  \brief reads the user's faces under a cover, any number of which may meet at an edge; another
    triangulation as the constructor does.

  Distances, paths and cells are those on the faces, where paths cross an edge from each of its
  faces to each of the others, not those on the cover, which can be longer. A vertex of the user is
  one vertex. Faces are searched as they are, without flips. Paths, cells and vectors are on the
  input, in the faces of the front.
  \param t the triangulation; it must outlive the result unchanged
  \complexity linear
  */
  static Polyhedral_distance on_faces(const Triangulation& t) {
    return Polyhedral_distance(internal::Searched_surface<Triangulation>::on_faces(t));
  }

  /// tells whether the faces under a cover are searched, so that places that are found are those of
  /// the input.
  bool is_on_faces() const { return surface_.has_faces(); }
  /// returns the triangulation.
  const Triangulation& triangulation() const { return surface_.triangulation(); }
  /// returns an object for the same surface that has no sources, such as for another thread.
  Polyhedral_distance without_sources() const {
    return Polyhedral_distance(surface_, field_.table);
  }

  /*!
  \brief finds the distances from other sources, with the tables that are there.
  \param sources,np see the constructor
  \return `status()`
  */
  template <class Sources, NamedParameters NP = parameters::Parameters<>>
  Status search(const Sources& sources, const NP& np = parameters::default_values()) {
    using namespace internal::tags;
    internal::expect_names<maximum_distance, targets, maximum_number, visitor>(np);
    field_.clear();
    sources_ = {};
    for_each_place(sources, [&](const auto& p) { sources_.add(p); });
    internal::Propagation_limits limits;
    limits.radius = internal::value_or<maximum_distance>(np, limits.radius) / field_.table.unit;
    limits.windows = internal::value_or<maximum_number>(np, field_.default_cap());
    for_each_place(internal::object_or<targets>(np, std::array<Surface_point, 0>()),
                   [&](const auto& p) { limits.targets.add(p); });
    if (!limits.targets.points.empty()) field_.windows.keep(field_.table.corners.size());
    return spread(sources_, limits, np);
  }

  /*!
  \brief adds a source: the search goes on from there, only where the new source is nearer.
  \tparam Source a vertex, or a `Surface_point`
  \param source the source; its index is the number of sources before
  \param np an optional named parameter, `visitor(v)`: see `Polyhedral_distance_visitor`
  \return `status()`
  \pre the search before, if there was one, is done; the new one goes as far as it went
  \complexity that of a search of the places that are nearer to the new source
  */
  template <class Source, NamedParameters NP = parameters::Parameters<>>
  Status add_source(const Source& source, const NP& np = parameters::default_values()) {
    internal::expect_names<internal::tags::visitor>(np);
    internal::Propagation_limits limits;
    limits.radius = sources_.size() == 0 ? limits.radius : field_.radius;
    internal::Places added;
    for_each_place(source, [&](const auto& p) {
      added.add(p, sources_.size());
      sources_.add(p);
    });
    field_.windows = {};
    return spread(added, limits, np);
  }

  /// returns `done`, `cap` or `cancelled`; distances up to `reached_distance()` are final in any
  /// case.
  Status status() const { return status_; }
  /// returns how far the search went, in the units of the input; infinity if it went everywhere.
  double reached_distance() const { return field_.radius * field_.table.unit; }
  /// returns the number of windows that were looked through.
  std::uint64_t number_of_windows() const { return number_of_windows_; }
  /// returns the number of windows to look through at most, if none is given.
  std::uint64_t default_cap() const { return field_.default_cap(); }
  /// returns the number of bytes held, but for those of constant number.
  std::size_t bytes() const { return field_.bytes() + memory_.bytes(); }

  /// returns the distance of a vertex or a point, in the units of the input; infinity if
  /// the search did not reach it. \complexity for a point, linear in the number of windows of its
  /// face, once they are kept
  template <internal::Place_on<Triangulation> Place>
  double distance(const Place& p) const {
    double result = 0;
    for_each_place(p, [&](const auto& place) { result = distance_of(place); });
    return result;
  }
  /// returns the distances of all vertices, by their rows, see
  /// `Intrinsic_triangulation::input_vertex()`.
  std::vector<double> distances() const {
    std::vector<double> result(triangulation().number_of_vertices());
    copy_distances(std::span(result));
    return result;
  }
  /// writes the same to where the caller says, as `float` or `double`.
  /// \pre there is place for a number per vertex
  template <std::floating_point Number>
  void copy_distances(std::span<Number> out) const {
    CGAL_precondition(out.size() == triangulation().number_of_vertices());
    std::fill(out.begin(), out.end(), std::numeric_limits<Number>::infinity());
    for (const vertex_descriptor v : vertices(triangulation().mesh())) {
      Number& least = out[triangulation().input_vertex(v)];
      least = std::min(least, static_cast<Number>(distance(v)));
    }
  }

  /// returns the number of sources.
  std::uint32_t number_of_sources() const { return sources_.size(); }
  /// returns the index of the nearest source of a vertex or a point, by the order of
  /// sources; one of them if several are as near, `Gluing::none` if the search did not reach it.
  /// \complexity that of `distance()`
  template <internal::Place_on<Triangulation> Place>
  std::uint32_t nearest_source(const Place& p) const {
    std::uint32_t result = Gluing::none;
    for_each_place(p, [&](const auto& place) { result = source_at(place); });
    return result;
  }

  /// returns a shortest path to a vertex or a point from the nearest source. \complexity
  /// linear in the number of its points; for a point, also of the windows of its face
  template <internal::Place_on<Triangulation> Place>
  Shortest_path shortest_path(const Place& p) const {
    Shortest_path result;
    for_each_place(p, [&](const auto& place) { result = path_to(place, distance_of(place)); });
    return result;
  }

  /// returns the vector at the nearest source along the shortest path to a vertex or a
  /// `Surface_point`, as long as the path: at a source that is a vertex, in a face into which it
  /// points. Its coordinates are not numbers where the distance is infinite, or rounding has led
  /// the path astray. \complexity that of `shortest_path()`
  template <internal::Place_on<Triangulation> Place>
  Tangent_vector logarithm(const Place& p) const {
    Tangent_vector result;
    for_each_place(p, [&](const auto& place) { result = departure_to(place, distance_of(place)); });
    return result;
  }

  /// \cond
  // What a search with windows finds, as far as the first search went.
  const internal::Distance_field& field_with_windows() const {
    if (field_.windows.are_kept()) return field_;
    internal::Propagation_limits limits;
    limits.radius = field_.radius;
    field_.clear();
    field_.windows.keep(field_.table.corners.size());
    const auto go_on = [](std::uint64_t, double) { return true; };
    spread_windows(field_, sources_, limits, memory_, go_on);
    return field_;
  }
  // What is searched.
  const internal::Searched_surface<Triangulation>& surface() const { return surface_; }
  /// \endcond

private:
  explicit Polyhedral_distance(const internal::Searched_surface<Triangulation>& surface)
      : Polyhedral_distance(surface, surface.table()) {}
  Polyhedral_distance(const internal::Searched_surface<Triangulation>& surface,
                      internal::Corner_table table)
      : surface_(surface), field_(std::move(table)) {}

  template <class NP>
  Status spread(const internal::Places& from, const internal::Propagation_limits& limits,
                const NP& np) {
    auto stored_visitor =
        internal::object_or<internal::tags::visitor>(np, Polyhedral_distance_visitor());
    auto& observed = internal::unwrapped(stored_visitor);
    std::tie(status_, number_of_windows_) =
        spread_windows(field_, from, limits, memory_, [&](std::uint64_t windows, double d) {
          return observed.progress(windows, d * field_.table.unit);
        });
    return status_;
  }

  double distance_of(std::uint32_t v) const { return in_units(field_.vertices[v].distance); }
  double distance_of(const internal::Point_in_face& p) const {
    return in_units(field_with_windows().at(p).distance);
  }

  std::uint32_t source_at(std::uint32_t v) const { return in_reach(field_.vertices[v]); }
  std::uint32_t source_at(const internal::Point_in_face& p) const {
    return in_reach(field_with_windows().at(p));
  }
  std::uint32_t in_reach(const internal::Distance_and_arrival& found) const {
    return found.distance <= field_.radius ? found.arrival.origin : Gluing::none;
  }

  double in_units(double scaled_distance) const {
    return scaled_distance <= field_.radius ? scaled_distance * field_.table.unit
                                            : std::numeric_limits<double>::infinity();
  }

  template <class Places, class Function>
  void for_each_place(const Places& places, const Function& f) const {
    surface_.for_each_place(field_, places, f);
  }

  // To a vertex by number, or to a point in a face.
  template <class Place>
  Shortest_path path_to(const Place& place, double length) const {
    if (!std::isfinite(length)) return {Status::stalled, {}, false, length};
    const internal::Traced_back path = trace_back(field_, place);
    Shortest_path result{path.status, {}, false, length};
    result.is_on_input = surface_.has_faces();
    for (const internal::Path_place& p : path.places) result.points.push_back(surface_.point(p));
    std::reverse(result.points.begin(), result.points.end());
    return result;
  }
  template <class Place>
  Tangent_vector departure_to(const Place& to, double length) const {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const Tangent_vector none{{Gluing::none, {unknown, unknown, unknown}}, {unknown, unknown}};
    if (!std::isfinite(length)) return none;
    const internal::Traced_back path = trace_back(field_, to);
    if (path.status != Status::done || path.places.empty()) return none;
    const internal::Path_place& place = path.places.back();
    const Plane_vector<double>& d = path.departure;
    const double norm = std::hypot(d.x, d.y), scale = norm > 0 ? length / norm : 0;
    if (norm == 0 && length > 0) return none; // from another copy of the source
    return {surface_.point(place), {scale * d.x, scale * d.y}};
  }

  internal::Searched_surface<Triangulation> surface_;
  internal::Places sources_;
  mutable internal::Distance_field field_;
  mutable internal::Propagation_memory memory_;
  Status status_ = Status::done;
  std::uint64_t number_of_windows_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_POLYHEDRAL_DISTANCE_H
