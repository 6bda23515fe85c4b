// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_SIGNPOSTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_SIGNPOSTS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signpost_queries.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_walk.h>
#include <CGAL/Intrinsic_triangulations/tracing/tangent_frames.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief represents how an intrinsic triangulation lies on the input by the direction of each
intrinsic halfedge at its source (§3.4 of the course).

At a vertex of the input the direction is a cone angle in the frame of the input (`Tangent_frames`);
at an inserted vertex it is an angle in the frame of the halfedge of its location on the input. A
flip costs two arc tangents (Eq. 7, unscaled). Queries trace geodesics to find paths, points and
vectors. Angles are rounded: results report whether a path was found and is certain. Places of
inserted vertices are rounded too, unless they define the metric, see `Insertion_in_face::place`:
then paths start and end there.

\cgalModels{IntrinsicCorrespondence}
*/
class Signposts {
  // Fans from number_of_fans() on: those of inserted vertices, two each, one more on the border.
  struct Signpost {
    double angle;
    std::uint32_t fan;
  };

public:
  /// What a flip replaces, see `store_flip()`.
  struct Flipped {
    std::array<Signpost, 2> signposts;     ///< of the halfedge and its opposite
    std::array<std::uint32_t, 2> outgoing; ///< of their fans; none at an inserted vertex
  };

  /// Name of the representation in programs.
  static constexpr const char* name = "signposts";

  /// observes the triangulation that the input is.
  /// \complexity linear
  template <class Triangulation>
  void start(const Triangulation& t) {
    start_on(t.shared_input());
  }

  /// returns the input.
  const Input& input() const { return *input_; }
  /// returns the input, to be shared.
  const std::shared_ptr<const Input>& shared_input() const { return input_; }
  /// returns the directions of the input at its vertices.
  const Tangent_frames& frames() const { return *frames_; }
  /// tells whether a vertex was inserted.
  bool is_inserted(std::uint32_t vertex) const { return vertex >= input_->number_of_vertices(); }
  /// returns where an inserted vertex is on the input.
  const Surface_point& location(std::uint32_t inserted_vertex) const {
    return location_[inserted_vertex - input_->number_of_vertices()];
  }
  /// returns the direction of an intrinsic halfedge at its source: a cone angle at a vertex of the
  /// input, an angle in the frame of the location at an inserted vertex.
  double angle(std::uint32_t h) const { return signpost_[h].angle; }

  /// answers queries about the triangulation by tracing geodesics, see `Curve_queries`.
  template <class Triangulation>
  auto queries(const Triangulation& t) const {
    return internal::Signpost_queries<Triangulation, Signposts>(t, *this);
  }

  /// returns the end of a traced geodesic that ends at a vertex.
  Geodesic_target target(std::uint32_t vertex) const {
    return is_inserted(vertex) ? Geodesic_target::at_point(*input_, location(vertex))
                               : Geodesic_target::at_vertex(vertex);
  }

  /// returns the directions at the source of an intrinsic halfedge: those of the input, or of the
  /// plane at an inserted vertex.
  Tangent_frames::Fan fan(std::uint32_t h) const { return fan_of(signpost_[h].fan); }

  /// starts a geodesic on the input from the source of an intrinsic halfedge.
  /// \param h the halfedge
  /// \param turn the angle from it to the geodesic, counterclockwise
  internal::Geodesic_walk<Input> walk(std::uint32_t h, double turn = 0) const;

  /*!
  \brief finds a direction at a vertex of the input among the intrinsic halfedges.
  \param view the triangulation
  \param h a halfedge of the input
  \param turn the angle from it, within the corner of its face
  \return the direction, from an intrinsic halfedge
  \complexity linear in the degree
  */
  template <class View>
  Corner_direction intrinsic_direction(const View& view, std::uint32_t h, double turn) const {
    const std::uint32_t f = frames_->fan_of(h);
    return internal::direction_from(view, *this, outgoing_[f],
                                    reduced(f, frames_->cone_angle(h) + turn));
  }

  /// finds a direction at a vertex that was inserted on an input halfedge, see above.
  template <class View>
  Corner_direction intrinsic_direction_at(const View& view, std::uint32_t inserted_vertex,
                                          std::uint32_t h, double turn) const {
    const std::uint32_t first = view.outgoing_halfedge(inserted_vertex);
    const Surface_point& p = location(inserted_vertex);
    const Geodesic_face face(*input_, p.halfedge);
    unsigned side = 0; // of the face of the location, that the vertex is on
    while (side < 2 && (face.side[side] / 2 != h / 2 || p.weights[(side + 2) % 3] != 0)) ++side;
    const double along = std::atan2(face.edge[side][1], face.edge[side][0]);
    return internal::direction_from(
        view, *this, first,
        reduced(signpost_[first].fan,
                along + (face.side[side] == h ? 0 : std::numbers::pi) + turn));
  }

  /// announces a flip. \return true
  template <class Triangulation>
  bool before(const Triangulation&, const Flip&) const {
    return true;
  }

  /// makes room for what an insertion adds; a flip adds nothing.
  template <class Triangulation, class Move>
  void make_room(const Triangulation& t, const Move&) {
    if constexpr (!std::is_same_v<Move, Flip>)
      make_room(t.numbers().vertex_capacity(t.mesh()) + 1, t.numbers().edge_capacity(t.mesh()) + 3);
  }

  /// follows a flip.
  template <class Triangulation>
  void after(const Triangulation& t, const Flip& move) noexcept {
    leave(move.ij, move.im);
    leave(move.ij ^ 1U, move.jk);
    const Intrinsic_view<Triangulation> view(t);
    set_next(view, move.ki);
    set_next(view, move.mj);
  }
  /// returns what a flip replaces.
  Flipped before_flip(const Flip& move) const;
  /// puts it back when the flip is taken back: directions found anew would differ by rounding.
  void store_flip(const Flip& move, const Flipped& values) noexcept;

  /// announces the insertion of a vertex in a face.
  /// \return whether the place on the input was found
  template <class Triangulation>
  bool before(const Triangulation& t, const Insertion_in_face& move) const {
    const std::uint32_t h = move.sides[0];
    if (move.place) {
      const auto seen =
          move.seen ? move.seen : internal::see_corner(t, *this, {h, move.weights}, *move.place);
      if (seen) seen_ = *seen, inserted_ = *move.place;
      return seen.has_value();
    }
    const Intrinsic_view<Triangulation> view(t);
    std::optional<Mapped_point> p;
    if (move.weights[2] == 0) p = place_on_edge(view, h, move.weights[1]);
    if (!p) p = internal::find_on_input(t, *this, {h, move.weights});
    if (!p) return false;
    inserted_ = p->point;
    const Plane_vector<double> to_source =
        p->transfer(Geodesic_face(view, h).to_corner(move.weights, 0));
    seen_ = {0, std::atan2(to_source[1], to_source[0])};
    return true;
  }

  /// follows the insertion of a vertex in a face.
  template <class Triangulation>
  void after(const Triangulation& t, const Insertion_in_face& move) noexcept {
    const Intrinsic_view<Triangulation> view(t);
    const auto spoke = [&](unsigned k) { return move.spokes[(seen_.corner + k) % 3] ^ 1U; };
    for (const std::uint32_t s : move.spokes) grow(s);
    const std::uint32_t f = add_location(move.vertex, false);
    signpost_[spoke(0)] = {reduced(f, seen_.angle), f};
    for (const std::uint32_t g : {spoke(0), spoke(1), move.sides[0], move.sides[1], move.sides[2]})
      set_next(view, g);
  }

  /// announces that a vertex moves within the faces about it (Eq. 8 of the course).
  /// \return whether the place on the input was found
  template <class Triangulation>
  bool before(const Triangulation& t, const Move_in_star& move) const {
    const auto p = internal::find_on_input(t, *this, {move.spoke, move.weights});
    if (!p) return false;
    inserted_ = p->point;
    const Geodesic_face face(Intrinsic_view<Triangulation>(t), move.spoke);
    const Plane_vector<double> to_target = p->transfer(face.to_corner(move.weights, 1));
    seen_ = {1, std::atan2(to_target[1], to_target[0])};
    return true;
  }

  /// follows it: the directions of all edges at the vertex, from both ends.
  template <class Triangulation>
  void after(const Triangulation& t, const Move_in_star& move) noexcept {
    const Intrinsic_view<Triangulation> view(t);
    location_[move.vertex - input_->number_of_vertices()] = inserted_;
    Signpost& first = signpost_[move.spoke];
    first.angle = reduced(first.fan, seen_.angle);
    std::uint32_t g = move.spoke;
    do {
      set_next(view, view.next(g));
      const std::uint32_t after = next_around_source(view, g);
      if (after != move.spoke) set_next(view, g);
      g = after;
    } while (g != move.spoke);
  }

  /// announces the insertion of a vertex on the border.
  /// \return true
  template <class Triangulation>
  bool before(const Triangulation& t, const Insertion_on_border& move) const {
    if (move.place) {
      inserted_ = *move.place;
      return true;
    }
    const Intrinsic_view<Triangulation> view(t);
    const std::uint32_t i = view.source(move.ip), j = view.target(move.ip);
    const std::uint32_t g = is_inserted(i)
                                ? location(i).halfedge
                                : frames_->halfedge(frames_->fan(signpost_[move.ip].fan).begin);
    inserted_ = point_between(g, i, j, move.parameter);
    return true;
  }

  /// follows the insertion of a vertex on the border.
  template <class Triangulation>
  void after(const Triangulation& t, const Insertion_on_border& move) noexcept {
    const Intrinsic_view<Triangulation> view(t);
    const auto [ip, pk, pj] = std::array{move.ip, move.pk, move.pj};
    for (const std::uint32_t s : {pk, pj}) grow(s);
    const std::uint32_t f = add_location(move.vertex, true);
    signpost_[pj ^ 1U] = signpost_[ip ^ 1U];
    signpost_[pj] = {0, f};
    signpost_[ip ^ 1U] = {std::numbers::pi, f};
    set_next(view, pj);
    set_next(view, move.ki);
  }

  /// announces the removal of a vertex. \return true
  template <class Triangulation, class Removal>
  bool before(const Triangulation&, const Removal&) const {
    return true;
  }

  /// follows the removal of a vertex of degree three.
  template <class Triangulation>
  void after(const Triangulation&, const Removal_from_face& move) noexcept {
    for (std::size_t k = 0; k < 3; ++k) leave(move.spokes[k], move.sides[k]);
  }

  /// follows the removal of a vertex from the border.
  template <class Triangulation>
  void after(const Triangulation&, const Removal_from_border& move) noexcept {
    leave(move.pk ^ 1U, move.ki);
    signpost_[move.ip ^ 1U] = signpost_[move.pj ^ 1U];
  }

private:
  void start_on(std::shared_ptr<const Input> input);
  void make_room(std::uint32_t vertices, std::uint32_t edges);

  std::uint32_t number_of_fans() const {
    return static_cast<std::uint32_t>(frames_->number_of_fans());
  }

  Tangent_frames::Fan fan_of(std::uint32_t f) const {
    if (f < number_of_fans()) return frames_->fan(f);
    const bool is_on_border = (f - number_of_fans()) % 2 == 1;
    return {0, 0, (is_on_border ? 1 : 2) * std::numbers::pi, is_on_border};
  }

  double reduced(std::uint32_t f, double angle) const {
    const Tangent_frames::Fan fan = fan_of(f);
    if (fan.is_on_border) return std::clamp(angle, 0.0, fan.angle);
    if (angle >= fan.angle) angle -= fan.angle;
    if (angle < 0) angle += fan.angle;
    if (angle >= 0 && angle < fan.angle) return angle;
    return 0;
  }

  // the halfedge after `g` at its source is an angle of the metric away (Eq. 7)
  template <class View>
  void set_next(const View& view, std::uint32_t g) {
    const Signpost& s = signpost_[g];
    signpost_[next_around_source(view, g)] = {reduced(s.fan, s.angle + angle_at_source(view, g)),
                                              s.fan};
  }

  // `h` will no longer start from where it does
  void leave(std::uint32_t h, std::uint32_t replacement) {
    const std::uint32_t f = signpost_[h].fan;
    if (f < number_of_fans() && outgoing_[f] == h) outgoing_[f] = replacement;
  }

  void grow(std::uint32_t h) {
    if ((h | 1U) >= signpost_.size()) signpost_.resize((h | 1U) + std::size_t{1});
  }

  std::uint32_t add_location(std::uint32_t vertex, bool is_on_border);

  // the point between two vertices on an input halfedge
  Surface_point point_between(std::uint32_t h, std::uint32_t source, std::uint32_t target,
                              double parameter) const;

  // the point of an intrinsic halfedge, if that runs along an input edge
  template <class View>
  std::optional<Mapped_point> place_on_edge(const View& view, std::uint32_t h,
                                            double parameter) const {
    std::vector<Geodesic_crossing> crossings;
    std::vector<internal::Strip_side> strip;
    const std::uint32_t g = internal::trace_signpost(view, *this, h, crossings, strip).along;
    if (g == Gluing::none) return std::nullopt;
    return Mapped_point{point_between(g, view.source(h), view.target(h), parameter)};
  }

  std::shared_ptr<const Input> input_;
  std::shared_ptr<const Tangent_frames> frames_;
  std::vector<Signpost> signpost_;      // per intrinsic halfedge
  std::vector<std::uint32_t> outgoing_; // per fan of the input: an intrinsic halfedge of it
  std::vector<Surface_point> location_; // per inserted vertex
  // mutable: of the vertex whose insertion has been announced, for `after()`
  mutable Surface_point inserted_;
  mutable Seen_corner seen_; // from there
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_SIGNPOSTS_H
