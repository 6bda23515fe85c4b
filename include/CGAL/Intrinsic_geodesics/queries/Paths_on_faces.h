// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_QUERIES_PATHS_ON_FACES_H
#define CGAL_INTRINSIC_GEODESICS_QUERIES_PATHS_ON_FACES_H

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/queries/certify_on_faces.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_shortest_path.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// What is wrong with a place that is given twice, next to each other, of so many places of a curve.
inline std::string repetition(std::size_t places) {
  return places > 2 ? " follows itself on a curve; give it once"
                    : " is both ends of a curve; give another end, or points between, through "
                      "which it leads";
}

} // namespace internal

/*!
\brief is a path on the faces under a double cover, and what was proven about it.
*/
struct Path_on_faces {
  /// The path, on the fronts of the faces.
  Traced_curve curve;
  /// What was proven: each of its shortest paths, from one place to the next, is locally shortest.
  Certificate_on_faces certificate;
};

/*!
\brief finds shortest paths on the user's faces, any number of which meet at an edge, where the
triangulation is of a double cover of them.

A path on the cover can be longer, as it crosses an edge only to the next face around it. The paths
are not edges of the triangulation.
\tparam Triangulation a model of `CorrespondingTriangulation`
*/
template <QueriedTriangulation Triangulation>
class Paths_on_faces {
public:
  /// reads the faces if `t` is of a double cover. \param t the triangulation; it must outlive this
  /// object unchanged \complexity linear
  explicit Paths_on_faces(const Triangulation& t)
      : t_(t), search_(Polyhedral_distance<Triangulation>::on_faces(t)), find_(t) {}

  /// tells whether there are faces under a cover.
  bool has_faces() const { return search_.is_on_faces(); }
  /// tells whether a curve through places consists of shortest paths on the faces under a cover,
  /// and so can be found here: any other curve is shortened as a whole, on the cover.
  /// \param places how many there are \param stays whether the curve stays at all of them
  bool can_find(std::size_t places, bool is_loop, bool stays) const {
    return has_faces() && !is_loop && (places == 2 || stays);
  }

  /*!
  \brief finds shortest paths on the faces from each of several places to the next one.
  \param places the places, two at least
  \param np an optional named parameter, `visitor(v)`: see `Polyhedral_distance_visitor`
  \return the path; `cancelled` or `inaccurate` as a search
  \throws Invalid_input if a place follows itself, or is in another component than the next one
  \pre `has_faces()`
  \complexity that of `Polyhedral_distance` and of `certify_on_faces()` for each
  */
  template <NamedParameters NP = parameters::Parameters<>>
  Path_on_faces operator()(const std::vector<Place>& places,
                           const NP& np = parameters::default_values()) {
    internal::expect_names<internal::tags::visitor>(np);
    Path_on_faces result;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      const Surface_point from = point(places[i]), to = point(places[i + 1]);
      if (from.halfedge == to.halfedge && from.weights == to.weights)
        refuse(places[i], name(places[i]) + internal::repetition(places.size()));
      if (search_.search(from, np.targets(to)) == Status::cancelled) {
        result.curve.status = Status::cancelled;
        return result;
      }
      Traced_curve side = trace_shortest_path(t_, search_.shortest_path(to));
      if (side.status == Status::stalled)
        refuse(places[i], "no path leads from " + name(places[i]) + " to " + name(places[i + 1]) +
                              ", which are in different components; choose points of one");
      add(std::move(side), result);
    }
    return result;
  }

private:
  // On a cover it has others, which are the same point of the faces.
  Surface_point point(const Place& p) { return find_.points(p).front(); }

  void add(Traced_curve side, Path_on_faces& path) const {
    const Certificate_on_faces certificate = certify_on_faces(t_.correspondence().input(), side);
    side.length_enclosure = certificate.length;
    // a place between sides is named in the face where the path goes on
    if (!path.curve.points.empty() && !side.points.empty())
      path.curve.points.back() = side.points.front();
    internal::append(side, path.curve);
    if (side.status != Status::done) path.curve.status = side.status;
    if (path.certificate.is_geodesic()) path.certificate.obstacle = certificate.obstacle;
    path.certificate.length += certificate.length;
  }

  std::string name(const Place& p) const {
    const Place place = normalized(t_.input(), p);
    return place.is_vertex() ? "vertex " + std::to_string(place.vertex)
                             : "a point inside of face " + std::to_string(place.face);
  }
  [[noreturn]] void refuse(const Place& p, const std::string& message) const {
    const Place place = normalized(t_.input(), p);
    throw Invalid_input(place.is_vertex() ? Element_kind::vertex : Element_kind::face,
                        place.is_vertex() ? place.vertex : place.face, message);
  }

  const Triangulation& t_;
  Polyhedral_distance<Triangulation> search_;
  Place_finder<Triangulation> find_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_QUERIES_PATHS_ON_FACES_H
