// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_INTEGER_COORDINATES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_INTEGER_COORDINATES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Input_surface.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Face_region.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Input_locator.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/corner_coordinates.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief represents how an intrinsic triangulation lies on the input by integers (§3.5 of the course):
how often each intrinsic edge is crossed by input edges (normal coordinates), and for each intrinsic
halfedge the first input halfedge counterclockwise from it (roundabouts).

No rounding can make these inconsistent: the common subdivision always has the right connectivity. A
vertex that is inserted on an input edge cuts it into two curves.

\cgalModels{CurveCoordinates}
*/
class Integer_coordinates {
public:
  /// What the representation is called by programs.
  static constexpr const char* name = "integer";

  /// constructs no coordinates.
  Integer_coordinates() = default;

  /*!
  \brief constructs coordinates from their parts.
  \param input the input
  \param fans the curves at the vertices, with those of vertices on input edges
  \param normal normal coordinate of each edge number
  \param roundabout slot of each halfedge number
  \param location place of each inserted vertex, see `location()`
  \pre the parts are consistent, see `first_inconsistent_edge()`
  */
  Integer_coordinates(std::shared_ptr<const Input_surface> input, Vertex_fans fans,
                      std::vector<Normal_coordinate> normal, std::vector<std::uint32_t> roundabout,
                      std::vector<Surface_point> location)
      : input_(std::move(input)), fans_(std::move(fans)), normal_(std::move(normal)),
        roundabout_(std::move(roundabout)), location_(std::move(location)) {}

  /// observes the triangulation that the input is: every edge runs along itself.
  /// \complexity linear
  template <class Triangulation>
  void start(const Triangulation& t) {
    start(std::make_shared<const Input_surface>(t));
  }

  /// starts from an input that is given: every edge runs along itself.
  /// \complexity linear
  void start(std::shared_ptr<const Input_surface> input) {
    input_ = std::move(input);
    fans_ = Vertex_fans(*input_);
    normal_.assign(input_->number_of_halfedges() / 2, -1);
    roundabout_.resize(input_->number_of_halfedges());
    for (std::uint32_t h = 0; h < roundabout_.size(); ++h) roundabout_[h] = fans_.slot(h);
  }

  /// returns the input.
  const Input_surface& input() const { return *input_; }
  /// returns the curves at the vertices.
  const Vertex_fans& fans() const { return fans_; }
  /// returns the bound of the numbers of intrinsic edges.
  std::uint32_t number_of_edges() const { return static_cast<std::uint32_t>(normal_.size()); }
  /// returns the number of crossings of an intrinsic edge, or -1 if it runs along an input edge.
  Normal_coordinate normal_coordinate(std::uint32_t edge) const { return normal_[edge]; }
  /// returns the slot of the first curve counterclockwise from an intrinsic halfedge, itself included;
  /// none if no curve starts from its source.
  std::uint32_t roundabout(std::uint32_t halfedge) const { return roundabout_[halfedge]; }
  /// tells whether vertices were ever inserted.
  bool has_inserted_vertices() const { return !location_.empty(); }
  /// tells whether a vertex was inserted.
  bool is_inserted(std::uint32_t vertex) const { return vertex >= input_->number_of_vertices(); }
  /// returns where an inserted vertex is on the input; on an edge if it was inserted on one: then the
  /// halfedge of the location runs along that edge and the last weight is zero.
  const Surface_point& location(std::uint32_t inserted_vertex) const {
    return location_[inserted_vertex - input_->number_of_vertices()];
  }

  /// observes a flip before it is done. \return whether the number of crossings stays in bounds
  template <class Triangulation>
  bool before_flip(const Triangulation& t, std::uint32_t h) {
    const Intrinsic_view<Triangulation> view(t);
    return before_flip(h, corner_coordinates(view, *this, h),
                       corner_coordinates(view, *this, h ^ 1U));
  }
  /// observes a flip of which is known how curves run in the two faces, see
  /// `flipped_normal_coordinate()`.
  bool before_flip(std::uint32_t h, const Corner_coordinates& f, const Corner_coordinates& g) {
    flipped_ = flipped_normal_coordinate(normal_[h / 2], f, g);
    return flipped_ <= maximal_normal_coordinate;
  }

  /// returns the normal coordinate of the edge that the flip which was announced last makes.
  Normal_coordinate flipped_coordinate() const { return flipped_; }

  /// observes a flip after it was done.
  template <class Triangulation>
  void after_flip(const Triangulation& t, std::uint32_t h) {
    normal_[h / 2] = flipped_;
    const Intrinsic_view<Triangulation> view(t);
    update_roundabout(view, h);
    update_roundabout(view, h ^ 1U);
  }

  /// observes the insertion of a vertex into the face of `h` before it is done.
  /// \return true
  template <class Triangulation>
  bool before_insert_in_face(Triangulation& t, std::uint32_t h,
                             const std::array<double, 3>& weights) {
    const Intrinsic_view<Triangulation> view(t);
    const std::array<std::uint32_t, 3> sides = sides_of_face(view, h);
    const Corner_coordinates corners = corner_coordinates(view, *this, h);
    Insertion& n = insertion_;
    n = {};
    n.sides = sides;
    n.along_side = weights[2] == 0 && normal_[h / 2] < 0;
    if (n.along_side) {
      n.location = location_on_side(view, *this, h, weights[1]);
      n.region.cutting = corners.cutting;
      n.region.right_of_fan = corners.emanating[1];
      for (unsigned k = 0; k < 2; ++k)
        if (corners.emanating[k] > 0) n.region.fan_corner = k;
    } else {
      const internal::Located l = internal::locate_by_curves(t, *this, h, weights);
      n.region = l.region;
      n.location = l.point;
    }
    n.normal = inserted_normal_coordinates(corners, n.region);
    if (n.along_side) n.normal[0] = n.normal[1] = -1;
    for (unsigned k = 0; k < 3; ++k) n.roundabout[k] = outgoing_roundabout(n, k);
    return true;
  }

  /// returns the region of the face into which the insertion that was announced last puts the vertex.
  const Face_region& region_of_insertion() const { return insertion_.region; }

  /// observes the insertion of a vertex into a face after it was done; see `split_face()`.
  template <class Triangulation>
  void after_insert_in_face(const Triangulation& t, std::uint32_t h) {
    const Intrinsic_view<Triangulation> view(t);
    const std::array<std::uint32_t, 3> to = spokes(view, h);
    const std::uint32_t p = view.target(to[0]);
    for (const std::uint32_t s : to) grow(s);
    set_location(p, insertion_.location);
    for (unsigned k = 0; k < 3; ++k) {
      normal_[to[k] / 2] = insertion_.normal[k];
      roundabout_[to[k]] = insertion_.roundabout[k];
      roundabout_[to[k] ^ 1U] = Gluing::none;
    }
    if (insertion_.along_side)
      start_curves_on_side(h, to);
    else if (insertion_.region.is_on_curve)
      start_curves_in_face(to);
  }

  /// observes the insertion of a vertex on the border edge of `h` before it is done.
  /// \return true
  template <class Triangulation>
  bool before_insert_in_border_edge(Triangulation& t, std::uint32_t h, double parameter) {
    return before_insert_in_face(t, h, {1 - parameter, parameter, 0});
  }

  /// observes the insertion of a vertex on a border edge after it was done; see
  /// `split_border_edge()`.
  template <class Triangulation>
  void after_insert_in_border_edge(const Triangulation& t, std::uint32_t h) {
    const Intrinsic_view<Triangulation> view(t);
    const std::uint32_t pk = view.next(h), pj = view.next(pk ^ 1U);
    for (const std::uint32_t s : {h, pk, pj}) grow(s);
    set_location(view.target(h), insertion_.location);
    const std::uint32_t slot = fans_.add_fan_on_edge(insertion_.location.halfedge);
    normal_[h / 2] = normal_[pj / 2] = -1;
    normal_[pk / 2] = insertion_.normal[2];
    roundabout_[pk ^ 1U] = insertion_.roundabout[2];
    roundabout_[pj ^ 1U] = roundabout_[h ^ 1U];
    roundabout_[pj] = slot;
    roundabout_[pk] = roundabout_[h ^ 1U] = slot + 1;
  }

  /// observes the removal of a vertex of degree three before it is done; see
  /// `remove_degree_3_vertex()`.
  /// \return whether curves run straight through the face without the vertex; if not, which inexact
  /// arithmetic can lead to, nothing has changed
  template <class Triangulation>
  bool before_remove(const Triangulation& t, std::uint32_t h) {
    const Intrinsic_view<Triangulation> view(t);
    const std::array<std::uint32_t, 3> to = spokes(view, h);
    const std::array<std::uint32_t, 3> sides = outer_sides(view, h, to);
    if (!can_do_without({normal_[sides[0] / 2], normal_[sides[1] / 2], normal_[sides[2] / 2]},
                        {normal_[to[0] / 2], normal_[to[1] / 2], normal_[to[2] / 2]},
                        roundabout_[to[0] ^ 1U] != Gluing::none))
      return false;
    for (unsigned k = 0; k < 3; ++k) {
      const std::uint32_t a = to[k], b = to[(k + 1) % 3];
      if (normal_[a / 2] >= 0 || normal_[b / 2] >= 0) continue;
      // a and b are two parts of one straight curve, which the side between their ends lies on
      normal_[sides[k] / 2] = -1;
      roundabout_[sides[k]] = roundabout_[a];
      roundabout_[sides[k] ^ 1U] = roundabout_[b];
    }
    if (roundabout_[to[0] ^ 1U] != Gluing::none) fans_.remove_fan(roundabout_[to[0] ^ 1U]);
    for (const std::uint32_t s : to) normal_[s / 2] = 0;
    return true;
  }

  /// observes the removal of a vertex after it was done.
  template <class Triangulation>
  void after_remove(const Triangulation&, std::uint32_t) {}

  /// observes the removal of a vertex on the border before it is done; see `remove_border_vertex()`.
  /// \return see `before_remove()`
  template <class Triangulation>
  bool before_remove_from_border(const Triangulation& t, std::uint32_t h) {
    const Intrinsic_view<Triangulation> view(t);
    const std::uint32_t pk = view.next(h), pj = view.next(pk ^ 1U);
    const std::array<Normal_coordinate, 3> sides{0, normal_[view.next(pj) / 2],
                                                 normal_[view.next(pk) / 2]};
    if (!can_do_without(sides, {-1, -1, normal_[pk / 2]}, true)) return false;
    fans_.remove_fan(roundabout_[pj]);
    roundabout_[h ^ 1U] = roundabout_[pj ^ 1U];
    normal_[pj / 2] = normal_[pk / 2] = 0;
    return true;
  }

  /// observes the removal of a vertex on the border after it was done.
  template <class Triangulation>
  void after_remove_from_border(const Triangulation&, std::uint32_t) {}

  /// returns the halfedges to a vertex p of degree three from the corners i, j, k of the face around it,
  /// where `h` is ij in the face ijp.
  template <class View>
  static std::array<std::uint32_t, 3> spokes(const View& view, std::uint32_t h) {
    const std::uint32_t jp = view.next(h), pi = view.next(jp);
    return {pi ^ 1U, jp, view.next(view.next(jp ^ 1U))};
  }

private:
  struct Insertion {
    std::array<std::uint32_t, 3> sides;
    bool along_side = false;
    Face_region region;
    Surface_point location;
    std::array<Normal_coordinate, 3> normal;
    std::array<std::uint32_t, 3> roundabout;
  };

  // The roundabout of an edge between the first side of a corner and the last: that of the first,
  // plus the curves between them (Eq. 12 of the course).
  std::uint32_t turned(std::uint32_t first, Normal_coordinate emanating) const {
    if (roundabout_[first] == Gluing::none) return Gluing::none;
    return fans_.advance(roundabout_[first],
                         static_cast<std::uint32_t>(parallels(normal_[first / 2]) + emanating));
  }

  // In the face of the opposite halfedge, (target, source, apex), the halfedge before `h` at its
  // source is the next one.
  template <class View>
  void update_roundabout(const View& view, std::uint32_t h) {
    const std::uint32_t before = view.next(h ^ 1U), opposite = view.next(before);
    const Normal_coordinate emanating = crossings(normal_[opposite / 2]) -
                                        crossings(normal_[h / 2]) - crossings(normal_[before / 2]);
    roundabout_[h] = turned(before, std::max(0, emanating));
  }

  std::uint32_t outgoing_roundabout(const Insertion& n, unsigned k) const {
    return turned(n.sides[k], n.region.fan_corner == k ? n.region.right_of_fan : 0);
  }

  void grow(std::uint32_t halfedge) {
    const std::size_t edges = halfedge / 2 + 1;
    if (edges <= normal_.size()) return;
    normal_.resize(edges);
    roundabout_.resize(2 * edges, Gluing::none);
  }

  void set_location(std::uint32_t vertex, const Surface_point& location) {
    const std::size_t i = vertex - input_->number_of_vertices();
    if (i >= location_.size()) location_.resize(i + 1);
    location_[i] = location;
  }

  // the sides ij, jk, ki of the face around a vertex of degree three
  template <class View>
  static std::array<std::uint32_t, 3> outer_sides(const View& view, std::uint32_t h,
                                                  const std::array<std::uint32_t, 3>& to) {
    return {h, view.next(to[1] ^ 1U), view.next(to[2] ^ 1U)};
  }

  // Whether a vertex of degree three is in a region of the face around it, or on a curve along a side.
  static bool can_do_without(std::array<Normal_coordinate, 3> sides,
                             std::array<Normal_coordinate, 3> to, bool is_on_curve) {
    for (unsigned k = 0; k < 3; ++k) {
      const unsigned next = (k + 1) % 3, last = (k + 2) % 3;
      if (to[k] >= 0 || to[next] >= 0) continue;
      if (sides[k] != 0) return false;
      sides[k] = -1;
      const Corner_coordinates c = corner_coordinates(sides);
      return is_even_or_fan(sides, c) &&
             to[last] == c.cutting[last] + c.emanating[k] + c.emanating[next];
    }
    const Corner_coordinates c = corner_coordinates(sides);
    return is_even_or_fan(sides, c) && has_region(c, to, is_on_curve);
  }
  // Curves that start from no corner meet two sides each.
  static bool is_even_or_fan(const std::array<Normal_coordinate, 3>& sides,
                             const Corner_coordinates& c) {
    const Normal_coordinate sum = crossings(sides[0]) + crossings(sides[1]) + crossings(sides[2]);
    return sum % 2 == 0 || c.emanating[0] + c.emanating[1] + c.emanating[2] > 0;
  }

  // The new vertex cuts the curve along side ij: ij itself, which goes on to bound a face on the
  // other side, is no longer on a curve.
  void start_curves_on_side(std::uint32_t h, const std::array<std::uint32_t, 3>& to) {
    const std::uint32_t to_target = fans_.add_fan_on_edge(insertion_.location.halfedge);
    roundabout_[to[0] ^ 1U] = roundabout_[to[2] ^ 1U] = to_target + 1;
    roundabout_[to[1] ^ 1U] = to_target;
    roundabout_[to[0]] = roundabout_[h];
    roundabout_[to[1]] = roundabout_[h ^ 1U];
    normal_[h / 2] = 0;
    roundabout_[h ^ 1U] = fans_.advance(roundabout_[h ^ 1U], 1);
  }

  // The new vertex cuts a curve that passes through the face, or starts from a corner of it.
  void start_curves_in_face(const std::array<std::uint32_t, 3>& to) {
    const unsigned k = insertion_.region.corner;
    const bool in_fan = k == insertion_.region.fan_corner;
    // the location's halfedge leaves the face through side k, or starts from corner k
    const std::uint32_t slot = fans_.add_fan_on_edge(insertion_.location.halfedge);
    const std::uint32_t ahead = slot, back = slot + 1;
    const auto out = [&](unsigned corner) -> std::uint32_t& {
      return roundabout_[to[corner % 3] ^ 1U];
    };
    out(k) = in_fan ? back : ahead;
    out(k + 1) = in_fan ? ahead : back;
    out(k + 2) = back;
  }

  std::shared_ptr<const Input_surface> input_;
  Vertex_fans fans_;
  std::vector<Normal_coordinate> normal_; // per edge
  std::vector<std::uint32_t> roundabout_; // per halfedge
  std::vector<Surface_point> location_;   // per inserted vertex
  // of the move that has been announced
  Normal_coordinate flipped_ = 0;
  Insertion insertion_{};
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_INTEGER_COORDINATES_H
