// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_DIAMOND_UNFOLDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_DIAMOND_UNFOLDER_H

#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Crossing_path.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/unfold_corners.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief finds the input triangles over which a diamond of an intrinsic triangulation lies, from normal
coordinates, roundabouts and the input alone (ch. 7 of the course): integers only.

Let ij be the edge, with faces ijk on its left and jim on its right. The corners are reached from the input
face in which ij starts: j by crossing the curves (input edges) that cross ij; k by turning about i
across the curves that emanate from i into the face ijk, and then crossing those that cross ik; and m
likewise. The curves that cross an edge are found in three ways:

- those that emanate from a corner of one of the two faces are told by the roundabouts there;
- those that cut off the corner i cross ij and ik in the same order;
- others are followed to their end, over the faces around; side by side as long as they run so.

Paths are reduced words in crossings. As a diamond holds no vertex inside, the paths to its corners make one
tree of triangles, whatever the order in which they were found.

Its memory stays from call to call.
*/
class Diamond_unfolder {
public:
  /// Most crossings of an edge that can be unfolded.
  static constexpr Normal_coordinate maximal_crossings = Normal_coordinate(1) << 15;

  /*!
  \brief unfolds the diamond of an edge, or the face on its left if there is none on its right: then corner
  m is corner i.
  \tparam View `Intrinsic_view`
  \param view the triangulation
  \param coordinates its coordinates; no edge has more than `maximal_crossings`
  \param h a halfedge that has a face, not the same one as its opposite
  \return the diamond, valid until the next call
  \complexity linear in the number of crossings of its edges, and in those of the curves that are
  followed
  */
  template <class View>
  const Unfolded_diamond& operator()(const View& view, const Integer_coordinates& coordinates,
                                     std::uint32_t h) {
    reach_ends(view, coordinates, h);
    reach_left(view, h, last(view, h));
    if (!view.is_border(h ^ 1U)) {
      right_ = corner_coordinates(view, coordinates, h ^ 1U);
      reach_right(view, h);
    } else {
      end_at(corners_[3], corners_[0]);
    }
    return unfold_from_common_base();
  }

  /// unfolds a face, that of a halfedge, as a diamond whose corner m is i.
  template <class View>
  const Unfolded_diamond& face(const View& view, const Integer_coordinates& coordinates,
                               std::uint32_t h) {
    reach_ends(view, coordinates, h);
    reach_left(view, h, last(view, h));
    corners_[3] = corners_[0];
    return unfold_from_common_base();
  }

  /*!
  \brief unfolds the input triangles through which an edge runs.
  \return the strip: corners 0 and 1 are the ends of the edge, and so are 2 and 3. Each triangle but the first is
  entered across a curve, from left to right as seen from the edge. Valid until the next call
  \param view, coordinates, h see the other function; `h` must have a face
  \complexity linear in the number of crossings, and in those of the curves that are followed
  */
  template <class View>
  const Unfolded_diamond& strip(const View& view, const Integer_coordinates& coordinates,
                                std::uint32_t h) {
    reach_ends(view, coordinates, h);
    corners_[2] = corners_[0];
    corners_[3] = corners_[1];
    return unfold();
  }

  /// returns how many steps were taken along curves since the last call of this function.
  std::size_t take_steps() { return std::exchange(steps_, 0); }

private:
  using Side = Face_side;

  const Input& input() const { return coordinates_->input(); }

  const Unfolded_diamond& unfold_from_common_base() {
    for (Developed_corner& c : corners_) c.trim();
    while (internal::move_base(corners_)) {
    }
    return unfold();
  }

  template <class View>
  static std::uint32_t last(const View& view, std::uint32_t h) {
    return view.next(view.next(h));
  }

  bool is_along_curve(std::uint32_t h) const { return coordinates_->normal_coordinate(h / 2) < 0; }

  // the input halfedge that is `count` curves counterclockwise of those that start in a corner, whose
  // first side is `h`
  std::uint32_t curve(std::uint32_t h, Normal_coordinate count) const {
    return input_halfedge(*coordinates_, Curve_end{h, count});
  }

  // the first curve counterclockwise from a halfedge, itself included
  std::uint32_t first_curve(std::uint32_t h) const {
    return coordinates_->fans().halfedge(coordinates_->roundabout(h));
  }

  Side side(std::uint32_t input_halfedge) const { return input_side(input(), input_halfedge); }

  // the crossing by which the face of an input halfedge is entered over it
  Crossing entering(std::uint32_t input_halfedge) const {
    return {side(input_halfedge ^ 1U), side(input_halfedge)};
  }

  // The source of an intrinsic halfedge, in the input face in which it starts; beside the halfedge, on its
  // left or right, if it runs along a curve.
  template <class View>
  Developed_corner corner(const View& view, std::uint32_t h, bool on_left) const {
    const std::uint32_t v = view.source(h), slot = coordinates_->roundabout(h);
    const bool is_inserted = coordinates_->is_inserted(v);
    if (slot == Gluing::none) return inserted(v, false); // inside a face
    const std::uint32_t c = coordinates_->fans().halfedge(slot);
    const std::uint32_t in_face = is_along_curve(h) && on_left ? c : c ^ 1U;
    if (is_inserted) return inserted(v, in_face != coordinates_->location(v).halfedge);
    return {{}, side(in_face == c ? c : input().next(in_face))};
  }

  // An inserted vertex, in the face of the halfedge of its location or in the opposite one.
  Developed_corner inserted(std::uint32_t vertex, bool is_opposite) const {
    const Surface_point& p = coordinates_->location(vertex);
    std::array<double, 3> weights = representable_weights(p.weights).value_or(p.weights);
    if (is_opposite) std::swap(weights[0], weights[1]);
    return {{}, side(is_opposite ? p.halfedge ^ 1U : p.halfedge), weights};
  }

  // a corner at the end of the path that has been found
  static void end_at(Developed_corner& c, const Developed_corner& end) {
    c.side = end.side;
    c.weights = end.weights;
  }

  const Unfolded_diamond& unfold() {
    unfolder_(corners_);
    return unfolder_.result();
  }

  // finds i and j: from i, crosses the curves that cross ij
  template <class View>
  void reach_ends(const View& view, const Integer_coordinates& coordinates, std::uint32_t h) {
    coordinates_ = &coordinates;
    left_ = corner_coordinates(view, coordinates, h);
    cross_edge(view, h);
    for (Developed_corner& c : corners_) c.path.clear();
    end_at(corners_[0], corner(view, h, true));
    for (const std::uint32_t x : crossed_) append(corners_[1].path, entering(x));
    end_at(corners_[1], corner(view, h ^ 1U, false));
  }

  // finds the curves that cross ij, as the input halfedges over which faces are entered
  template <class View>
  void cross_edge(const View& view, std::uint32_t h) {
    const Normal_coordinate n = crossings(coordinates_->normal_coordinate(h / 2));
    crossed_.resize(index(n));
    if (n == 0) return;
    const std::uint32_t ki = last(view, h);
    const Normal_coordinate from = left_.cutting[0], to = from + left_.emanating[2];
    for (Normal_coordinate p = from; p < to; ++p) // from k, on the left
      crossed_[index(p)] = curve(ki, p - from);
    follow(view, {h, 0, from, 0}, crossed_);
    follow(view, {h, to, n - to, to}, crossed_);
  }

  // The input halfedges over which curves across a halfedge are crossed. They end on its right; the way
  // back runs from right to left.
  template <class View>
  void follow(const View& view, const Curve_bundle& bundle, std::vector<std::uint32_t>& crossed) {
    if (coordinates_->knows_crossings()) {
      for (Normal_coordinate i = 0; i < bundle.count; ++i)
        crossed[index(bundle.number + i)] =
            coordinates_->entered_by(bundle.halfedge, bundle.position + i);
      return;
    }
    steps_ += follow_curves(view, *coordinates_, bundle, stack_,
                            [&](Normal_coordinate number, const Curve_end& end) {
                              crossed[index(number)] = input_halfedge(*coordinates_, end) ^ 1U;
                            });
  }

  // appends the crossings of a halfedge from number `from` on
  template <class View>
  void append_followed(const View& view, std::uint32_t h, Normal_coordinate from,
                       Crossing_path& path) {
    const Normal_coordinate n = crossings(coordinates_->normal_coordinate(h / 2)) - from;
    if (n <= 0) return;
    others_.resize(index(n));
    follow(view, {h, from, n, 0}, others_);
    for (const std::uint32_t x : others_) append(path, entering(x));
  }

  // finds k: turns counterclockwise about i, crosses the curves that cut off i, emanate from j, cut off k
  template <class View>
  void reach_left(const View& view, std::uint32_t h, std::uint32_t ki) {
    Developed_corner& k = corners_[2];
    for (Normal_coordinate c = 0; c < left_.emanating[0]; ++c)
      append(k.path, entering(curve(h, c)));
    if (!is_along_curve(ki)) {
      const std::uint32_t jk = view.next(h);
      Normal_coordinate p = 0;
      for (; p < left_.cutting[0]; ++p) append(k.path, entering(crossed_[index(p)]));
      for (Normal_coordinate c = left_.emanating[1]; c-- > 0; ++p)
        append(k.path, entering(curve(jk, c) ^ 1U));
      append_followed(view, ki ^ 1U, p, k.path);
    }
    end_at(k, corner(view, ki, true));
  }

  // finds m: turns clockwise about i, crosses the curves that cut off i, emanate from j, cut off m
  template <class View>
  void reach_right(const View& view, std::uint32_t h) {
    Developed_corner& m = corners_[3];
    const std::uint32_t o = h ^ 1U, im = view.next(o);
    const auto turn_across = [&](std::uint32_t c) { append(m.path, {side(c), side(c ^ 1U)}); };
    if (is_along_curve(h)) turn_across(first_curve(h));
    for (Normal_coordinate c = right_.emanating[1]; c-- > 0;) turn_across(curve(im, c));
    if (!is_along_curve(im)) {
      Normal_coordinate p = 0;
      for (; p < right_.cutting[1]; ++p) append(m.path, entering(crossed_[index(p)]));
      for (Normal_coordinate c = 0; c < right_.emanating[0]; ++c, ++p)
        append(m.path, entering(curve(o, c)));
      append_followed(view, im, p, m.path);
    }
    end_at(m, corner(view, im ^ 1U, false));
  }

  static std::size_t index(Normal_coordinate p) { return static_cast<std::size_t>(p); }

  const Integer_coordinates* coordinates_ = nullptr; // of the call
  Corner_coordinates left_, right_;                  // corners i, j, k and j, i, m
  std::vector<std::uint32_t> crossed_, others_;
  std::vector<Curve_bundle> stack_;
  std::array<Developed_corner, 4> corners_;
  std::size_t steps_ = 0;
  internal::Corner_unfolder unfolder_{std::numeric_limits<std::size_t>::max()};
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_DIAMOND_UNFOLDER_H
