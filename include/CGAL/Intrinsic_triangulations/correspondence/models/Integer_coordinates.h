// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_INTEGER_COORDINATES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_INTEGER_COORDINATES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Crossing_run.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Insertion_placer.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Kept_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <CGAL/Interval_nt.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief represents how an intrinsic triangulation lies on the input by integers (§3.5 of the course):
how often each intrinsic edge is crossed by input edges (normal coordinates), and for each intrinsic
halfedge the first input halfedge counterclockwise from it (roundabouts).

Rounding cannot make them inconsistent: the common subdivision always has the right connectivity. A
vertex that is inserted on an input edge cuts it into two curves.

An insertion finds the place of the vertex by following the input edges that cross its face. If that
takes long, because input edges cross very many intrinsic ones, the coordinates store the crossings
of each edge from then on, as `Explicit_crossings` do: the results are the same.

\cgalModels{CurveCoordinates}
*/
class Integer_coordinates {
public:
  /// Name of the representation in programs.
  static constexpr const char* name = "integer";

  /// constructs no coordinates.
  Integer_coordinates();
  /// copies. This function and the next four are defined in a source: inlined, they are long.
  Integer_coordinates(const Integer_coordinates&);
  /// moves.
  Integer_coordinates(Integer_coordinates&&);
  /// copies.
  Integer_coordinates& operator=(const Integer_coordinates&);
  /// moves.
  Integer_coordinates& operator=(Integer_coordinates&&);
  /// destructs.
  ~Integer_coordinates();

  /*!
  \brief constructs coordinates from their parts.
  \param input the input
  \param fans the curves at the vertices, with those of vertices on input edges
  \param normal normal coordinate of each edge number
  \param roundabout slot of each halfedge number
  \param location place of each inserted vertex, see `location()`
  \pre the parts are consistent, see `first_inconsistent_edge()`
  */
  Integer_coordinates(std::shared_ptr<const Input> input, Vertex_fans fans,
                      std::vector<Normal_coordinate> normal, std::vector<std::uint32_t> roundabout,
                      std::vector<Surface_point> location);

  /// observes the triangulation that the input is: every edge runs along itself.
  /// \complexity linear
  template <class Triangulation>
  void start(const Triangulation& t) {
    input_ = t.shared_input();
    fans_ = Vertex_fans(*input_);
    normal_.assign(input_->number_of_halfedges() / 2, -1);
    roundabout_.resize(input_->number_of_halfedges());
    for (std::uint32_t h = 0; h < roundabout_.size(); ++h) roundabout_[h] = fans_.slot(h);
  }

  /// takes coordinates of a triangulation that is restored, with the numbers that it has.
  template <class Triangulation>
  void restore(const Triangulation&, Integer_coordinates coordinates) {
    *this = std::move(coordinates);
  }

  /// returns itself, so that the triangulation need not make its own coordinates.
  const Integer_coordinates& integer_coordinates() const { return *this; }
  /// returns the input.
  const Input& input() const { return *input_; }
  /// returns the curves at the vertices.
  const Vertex_fans& fans() const { return fans_; }
  /// returns the bound of the numbers of intrinsic edges.
  std::uint32_t number_of_edges() const { return static_cast<std::uint32_t>(normal_.size()); }
  /// returns the number of crossings of an intrinsic edge, or -1 if it runs along an input edge.
  Normal_coordinate normal_coordinate(std::uint32_t edge) const { return normal_[edge]; }
  /// returns the slot of the first curve counterclockwise from an intrinsic halfedge, itself
  /// included; none if no curve starts from its source.
  std::uint32_t roundabout(std::uint32_t halfedge) const { return roundabout_[halfedge]; }
  /// tells whether the input edges that cross each intrinsic edge are stored.
  bool knows_crossings() const { return bool(kept_); }
  /// visits the input halfedges of the faces that intrinsic halfedge `h` enters, from one position
  /// to another, in runs. \pre see above
  template <std::invocable<const Crossing_run&> Visit>
  void for_each_run_of(std::uint32_t h, Normal_coordinate first, Normal_coordinate last,
                       const Visit& visit) const {
    kept_.for_each_run_of(fans_, h, first, last, visit);
  }
  /// returns those that intrinsic halfedge `2 * edge` enters, in order. \pre see above
  std::vector<std::uint32_t> entered_on(std::uint32_t edge) const;
  /// stores the crossings of each edge, unless they are very many. \complexity linear in crossings
  template <class Triangulation>
  void keep_crossings(const Triangulation& t) const {
    kept_.keep_if_few(t, *this, std::size_t(1) << 25U); // four bytes each
  }
  /// does so once following curves has taken as long. \param steps number of steps along curves
  /// since the last call
  template <class Triangulation>
  void count_steps(const Triangulation& t, std::size_t steps) const {
    kept_.decide(t, *this, steps);
  }
  /// tells whether vertices were ever inserted.
  bool has_inserted_vertices() const { return !location_.empty(); }
  /// tells whether a vertex was inserted.
  bool is_inserted(std::uint32_t vertex) const { return vertex >= input_->number_of_vertices(); }
  /// returns where an inserted vertex is on the input; on an edge if it was inserted on one: then
  /// the halfedge of the location runs along that edge and the last weight is zero.
  const Surface_point& location(std::uint32_t inserted_vertex) const {
    return location_[inserted_vertex - input_->number_of_vertices()];
  }

  /// announces a flip. \return whether the number of crossings stays in bounds
  template <class Triangulation>
  bool before(const Triangulation&, const Flip& move) const {
    const Normals left = normals({move.ij, move.jk, move.ki}),
                  right = normals({move.ij, move.im, move.mj});
    const Corner_coordinates f = corner_coordinates(left), g = corner_coordinates(right);
    flipped_ = flipped_normal_coordinate(left[0], f, g);
    if (flipped_ > maximal_normal_coordinate) return false;
    kept_.forget_beyond(normal_.size(), crossings(flipped_));
    if (kept_)
      kept_.announce(fans_, move, f, g, crossings(left[2]), crossings(right[1]),
                     left[0] < 0 ? fans_.halfedge(roundabout_[move.ij ^ 1U]) : Gluing::none);
    return true;
  }

  /// returns the normal coordinate of the new edge of the flip announced last.
  Normal_coordinate flipped_coordinate() const { return flipped_; }

  /// makes room for what a flip adds.
  template <class Triangulation>
  void make_room(const Triangulation&, const Flip&) {
    if (kept_) kept_.make_room();
  }
  /// makes room for what an insertion or a removal adds.
  template <class Triangulation, class Move>
  void make_room(const Triangulation& t, const Move&) {
    make_room(t.numbers().vertex_capacity(t.mesh()) + 1, t.numbers().edge_capacity(t.mesh()) + 3);
  }

  /// follows a flip, or one that is taken back, which is not announced.
  template <class Triangulation>
  void after(const Triangulation& t, const Flip& move) noexcept {
    if (move.is_taken_back()) announce_without_memory(t, move);
    normal_[move.ij / 2] = flipped_;
    update_roundabout(move.km, move.ki, move.im);
    update_roundabout(move.km ^ 1U, move.mj, move.jk);
    if (kept_) kept_.store(fans_, move, flipped_);
  }

  /// announces the insertion of a vertex in a face.
  /// \return whether a place on the input was found for it
  template <class Triangulation>
  bool before(const Triangulation& t, const Insertion_in_face& move) const {
    return announce_insertion(t, move.sides, move.weights, move.place);
  }

  /// follows the insertion of a vertex in a face.
  template <class Triangulation>
  void after(const Triangulation&, const Insertion_in_face& move) noexcept {
    follow(move);
  }

  /// announces the insertion of a vertex on the border.
  /// \return as for an insertion in a face
  template <class Triangulation>
  bool before(const Triangulation& t, const Insertion_on_border& move) const {
    return announce_insertion(t, {move.ip, move.jk, move.ki},
                              {1 - move.parameter, move.parameter, 0}, move.place);
  }

  /// returns the values at the vertex whose insertion was announced last, in a face or on the
  /// border: see `Unfolded_face::values()`. \pre the metric is defined by places
  const Vertex_move_values<Interval_nt<false>>& inserted_values() const { return placer_.values(); }

  /// returns these values in 106 bits. \pre the insertion was not made yet
  Vertex_move_values<Short_ball> inserted_short_values() const {
    return placer_.short_values(*input_);
  }

  /// returns the place of that vertex.
  const Surface_point& inserted_place() const { return insertion_.location; }
  /// returns the corner of its face with the most accurate direction from there, if known. \pre the
  /// metric is defined by places
  std::optional<Seen_corner> inserted_direction() const { return placer_.seen_corner(*input_); }

  /// follows the insertion of a vertex on the border.
  template <class Triangulation>
  void after(const Triangulation&, const Insertion_on_border& move) noexcept {
    follow(move);
  }

  /// announces the removal of a vertex of degree three.
  /// \return whether curves run straight through the face without it, unless arithmetic is inexact
  template <class Triangulation>
  bool before(const Triangulation&, const Removal_from_face& move) const {
    return can_do_without_vertex(normals(move.sides), normals(move.spokes),
                                 roundabout_[move.spokes[0] ^ 1U] != Gluing::none);
  }

  /// follows the removal of a vertex of degree three.
  template <class Triangulation>
  void after(const Triangulation&, const Removal_from_face& move) noexcept {
    follow(move);
  }

  /// announces the removal of a vertex from the border. \return as for a removal from a face
  template <class Triangulation>
  bool before(const Triangulation&, const Removal_from_border& move) const {
    const Normals sides{0, normal_[move.jk / 2], normal_[move.ki / 2]};
    return can_do_without_vertex(sides, {-1, -1, normal_[move.pk / 2]}, true);
  }

  /// follows the removal of a vertex from the border.
  template <class Triangulation>
  void after(const Triangulation&, const Removal_from_border& move) noexcept {
    follow(move);
  }

protected:
  /// \cond
  using Normals = std::array<Normal_coordinate, 3>;

  Normals normals(const std::array<std::uint32_t, 3>& sides) const {
    return {normal_[sides[0] / 2], normal_[sides[1] / 2], normal_[sides[2] / 2]};
  }
  mutable internal::Kept_crossings kept_;
  /// \endcond

private:
  struct Insertion {
    bool along_side = false; // on the first one, which runs along an input edge
    Face_region region;
    Surface_point location;
    Normals normal;
    std::array<std::uint32_t, 3> roundabout;
  };

  template <class Triangulation>
  bool announce_insertion(const Triangulation& t, const std::array<std::uint32_t, 3>& sides,
                          const std::array<double, 3>& weights,
                          const std::optional<Surface_point>& wanted) const {
    const std::size_t steps = placer_.steps();
    const std::optional<Placed_insertion> p = placer_(t, *this, sides[0], weights, wanted);
    count_steps(t, placer_.steps() - steps);
    if (!p) return false;
    Insertion& n = insertion_;
    n.along_side = p->along_side;
    n.region = p->region;
    n.location = p->location;
    n.normal = inserted_normal_coordinates(corner_coordinates(normals(sides)), n.region);
    if (n.along_side) n.normal[0] = n.normal[1] = -1;
    for (unsigned k = 0; k < 3; ++k)
      n.roundabout[k] = turned(sides[k], n.region.fan_corner == k ? n.region.right_of_fan : 0);
    if (kept_) kept_.announce(fans_, sides, normals(sides), n.region);
    return true;
  }

  // The roundabout of an edge between the first side of a corner and the last: that of the first,
  // plus the curves between them (Eq. 12 of the course).
  std::uint32_t turned(std::uint32_t first, Normal_coordinate emanating) const {
    if (roundabout_[first] == Gluing::none) return Gluing::none;
    return fans_.advance(roundabout_[first],
                         static_cast<std::uint32_t>(parallels(normal_[first / 2]) + emanating));
  }

  // of a halfedge between two sides of its source: the one before it, and the one opposite the
  // source in the face on its right
  void update_roundabout(std::uint32_t h, std::uint32_t before, std::uint32_t opposite) {
    const Normal_coordinate emanating = crossings(normal_[opposite / 2]) -
                                        crossings(normal_[h / 2]) - crossings(normal_[before / 2]);
    roundabout_[h] = turned(before, std::max(0, emanating));
  }

  // The flip leads back to where the coordinates were in bounds, and crossings that must be kept
  // find the memory that they had there. Others are a cache: they go if memory is exhausted.
  template <class Triangulation>
  void announce_without_memory(const Triangulation& t, const Flip& move) noexcept {
    try {
      before(t, move);
      make_room(t, move);
    } catch (const std::bad_alloc&) {
      kept_.forget();
    }
  }

  void make_room(std::uint32_t vertices, std::uint32_t edges);
  void grow(std::uint32_t halfedge);
  void set_location(std::uint32_t vertex, const Surface_point& location);

  void follow(const Insertion_in_face& move);
  void follow(const Insertion_on_border& move);
  void follow(const Removal_from_face& move);
  void follow(const Removal_from_border& move);

  // The new vertex cuts the curve along side ij: ij itself, which goes on to bound a face on the
  // other side, is no longer on a curve.
  void start_curves_on_side(std::uint32_t h, const std::array<std::uint32_t, 3>& to);

  // The new vertex cuts a curve that passes through the face, or starts from a corner of it.
  void start_curves_in_face(const std::array<std::uint32_t, 3>& to);

  std::shared_ptr<const Input> input_;
  Vertex_fans fans_;
  std::vector<Normal_coordinate> normal_; // per edge
  std::vector<std::uint32_t> roundabout_; // per halfedge
  std::vector<Surface_point> location_;   // per inserted vertex
  // mutable: of the move that has been announced, for `after()`
  mutable Normal_coordinate flipped_ = 0;
  mutable Insertion insertion_{};
  mutable Insertion_placer placer_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_INTEGER_COORDINATES_H
