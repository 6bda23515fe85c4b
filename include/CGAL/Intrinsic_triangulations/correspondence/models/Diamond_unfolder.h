// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_DIAMOND_UNFOLDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_DIAMOND_UNFOLDER_H

#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief finds the input triangles over which a diamond of an intrinsic triangulation lies, from
normal coordinates, roundabouts and the input alone (ch. 7 of the course): integers only.

Let ij be the edge, with faces ijk on its left and jim on its right. The corners are reached from
the input face in which ij starts: j by crossing the curves (input edges) that cross ij; k by
turning about i across the curves that emanate from i into the face ijk, and then crossing those
that cross ik; and m likewise. The curves that cross an edge are found in three ways:

- roundabouts give those that emanate from a corner of one of the two faces;
- those that cut off the corner i cross ij and ik in the same order;
- others are followed to their end over the faces around, side by side where possible.

Paths are reduced words in crossings: a crossing followed by its inverse cancels. Since a diamond
has no vertex inside, the paths to its corners form one tree of triangles, in whatever order they
are found.

It reuses its memory.
*/
class Diamond_unfolder {
public:
  /// Maximal number of crossings of an edge that is unfolded, a megabyte of triangles.
  /// `Integer_only_triangulation` has no other way and refuses flips with more.
  static constexpr Normal_coordinate maximal_crossings = Normal_coordinate(1) << 15;

  /*!
  \brief unfolds the diamond of an edge, or the face on its left if there is none on its right: then
  corner m is corner i.
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
  \brief unfolds the two sides of a wedge, without the edges in between: a diamond with the source
  of the sides as corner i, the end of the last side as corners j and k, and that of the first as m.
  \param view, coordinates see the other function
  \param faces the faces of the wedge, each from corner i on, counterclockwise: `is_wedge()`
  \complexity linear in the number of crossings of the two sides and of curves at corner i
  */
  template <class View>
  const Unfolded_diamond& wedge(const View& view, const Integer_coordinates& coordinates,
                                std::span<const Indexed_face> faces) {
    reach_ends(view, coordinates, first_side(view, faces.front()));
    corners_[3] = corners_[1];
    Path& path = corners_[1].path;
    path.clear();
    for (const Indexed_face& f : faces) { // turns counterclockwise about i
      const std::uint32_t h = first_side(view, f);
      if (&f != &faces.front() && is_along_curve(h)) append(path, first_curve(h));
      const Corner_coordinates c = corner_coordinates(view, coordinates, h);
      for (Normal_coordinate n = 0; n < c.emanating[0]; ++n) append(path, curve(h, n));
    }
    const std::uint32_t ki = last(view, first_side(view, faces.back()));
    if (!is_along_curve(ki)) append_followed(view, ki ^ 1U, 0, path);
    end_at(corners_[1], corner(view, ki, true));
    corners_[2] = corners_[1];
    return unfold_from_common_base();
  }

  /// tells whether faces are those of a wedge: each is entered from the one before.
  template <class View>
  static bool is_wedge(const View& view, std::span<const Indexed_face> faces) {
    for (std::size_t n = 1; n < faces.size(); ++n)
      if ((last(view, first_side(view, faces[n - 1])) ^ 1U) != first_side(view, faces[n]))
        return false;
    return true;
  }

  /*!
  \brief unfolds the input triangles through which an edge runs.
  \return the strip: corners 0 and 1 are the ends of the edge, and so are 2 and 3. Each triangle but
  the first is entered across a curve, from left to right as seen from the edge. Valid until the
  next call
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
  // Crossings of input edges from face to face, each named by the input halfedge of the face that
  // is entered.
  using Path = std::vector<std::uint32_t>;

  // where a vertex is in the plane into which the input is unfolded along a path
  struct Corner {
    Path path;                  // from a face to the one in which the vertex is found
    std::uint32_t halfedge = 0; // an input halfedge that starts there, unless it was inserted
    std::array<double, 3> weights{1, 0,
                                  0}; // barycentric coordinates, from the start of the halfedge on

    bool is_inserted() const { return weights[0] != 1; }
    bool is_end_of(const Input& input, std::uint32_t h) const {
      return !is_inserted() && (halfedge == h || halfedge == input.next(h));
    }
    // shortens the path: an end of the last crossed edge is reached before crossing it
    void trim(const Input& input) {
      while (!path.empty() && is_end_of(input, path.back())) {
        const std::uint32_t to = path.back(), from = to ^ 1U;
        halfedge = halfedge == to ? input.next(from) : from;
        path.pop_back();
      }
    }
  };

  const Input& input() const { return coordinates_->input(); }

  const Unfolded_diamond& unfold_from_common_base();

  // Moves the base of paths across the next edge if every path crosses it or leads to an end of it.
  // The number of passed crossings gives the base.
  bool moves_base(std::size_t base);

  // joins the paths from the base on into one tree
  const Unfolded_diamond& unfold(std::size_t base = 0);
  // which side of a triangle a halfedge of its face is
  std::uint32_t from_first_side(std::uint32_t triangle, std::uint32_t halfedge) const {
    const Face_side& first = diamond_.triangles[triangle].side;
    return (input_side(input(), halfedge).slot + 3 - first.slot) % 3;
  }

  template <class View>
  static std::uint32_t last(const View& view, std::uint32_t h) {
    return view.next(view.next(h));
  }

  template <class View>
  static std::uint32_t first_side(const View& view, const Indexed_face& f) {
    return view.halfedge(f.face, f.edges[0], f.edges[1]);
  }

  bool is_along_curve(std::uint32_t h) const { return coordinates_->normal_coordinate(h / 2) < 0; }

  // the input halfedge that is `count` curves counterclockwise of those that start in a corner,
  // whose first side is `h`
  std::uint32_t curve(std::uint32_t h, Normal_coordinate count) const {
    return input_halfedge(*coordinates_, Curve_end{h, count});
  }

  // the first curve counterclockwise from a halfedge, itself included
  std::uint32_t first_curve(std::uint32_t h) const {
    return coordinates_->fans().halfedge(coordinates_->roundabout(h));
  }

  static void append(Path& path, std::uint32_t entered) {
    if (!path.empty() && path.back() == (entered ^ 1U))
      path.pop_back();
    else
      path.push_back(entered);
  }

  // The source of an intrinsic halfedge, in the input face in which it starts; beside the halfedge,
  // on its left or right, if it runs along a curve.
  template <class View>
  Corner corner(const View& view, std::uint32_t h, bool on_left) const {
    const std::uint32_t v = view.source(h), slot = coordinates_->roundabout(h);
    const bool is_inserted = coordinates_->is_inserted(v);
    if (slot == Gluing::none) return inserted(v, false); // inside a face
    const std::uint32_t c = coordinates_->fans().halfedge(slot);
    const std::uint32_t in_face = is_along_curve(h) && on_left ? c : c ^ 1U;
    if (is_inserted) return inserted(v, in_face != coordinates_->location(v).halfedge);
    return {{}, in_face == c ? c : input().next(in_face)};
  }

  // An inserted vertex, in the face of the halfedge of its location or in the opposite one.
  Corner inserted(std::uint32_t vertex, bool is_opposite) const {
    const Surface_point& p = coordinates_->location(vertex);
    std::array<double, 3> weights = representable_weights(p.weights).value_or(p.weights);
    if (is_opposite) std::swap(weights[0], weights[1]);
    return {{}, is_opposite ? p.halfedge ^ 1U : p.halfedge, weights};
  }

  // a corner at the end of the path that has been found
  static void end_at(Corner& c, const Corner& end) {
    c.halfedge = end.halfedge;
    c.weights = end.weights;
  }

  // finds i and j: from i, crosses the curves that cross ij
  template <class View>
  void reach_ends(const View& view, const Integer_coordinates& coordinates, std::uint32_t h) {
    coordinates_ = &coordinates;
    left_ = corner_coordinates(view, coordinates, h);
    steps_ += internal::find_entered_from_face(view, coordinates, h, crossed_, stack_);
    for (Corner& c : corners_) c.path.clear();
    end_at(corners_[0], corner(view, h, true));
    for (const std::uint32_t x : crossed_) append(corners_[1].path, x);
    end_at(corners_[1], corner(view, h ^ 1U, false));
  }

  // appends the crossings of a halfedge from number `from` on
  template <class View>
  void append_followed(const View& view, std::uint32_t h, Normal_coordinate from, Path& path) {
    const Normal_coordinate n = crossings(coordinates_->normal_coordinate(h / 2));
    if (n <= from) return;
    others_.resize(index(n));
    steps_ += internal::find_entered(view, *coordinates_, h, from, n, others_, stack_);
    for (Normal_coordinate i = from; i < n; ++i) append(path, others_[index(i)]);
  }

  // finds k: turns counterclockwise about i, crosses the curves that cut off i, emanate from j, cut
  // off k
  template <class View>
  void reach_left(const View& view, std::uint32_t h, std::uint32_t ki) {
    Corner& k = corners_[2];
    for (Normal_coordinate c = 0; c < left_.emanating[0]; ++c) append(k.path, curve(h, c));
    if (!is_along_curve(ki)) {
      const std::uint32_t jk = view.next(h);
      Normal_coordinate p = 0;
      for (; p < left_.cutting[0]; ++p) append(k.path, crossed_[index(p)]);
      for (Normal_coordinate c = left_.emanating[1]; c-- > 0; ++p)
        append(k.path, curve(jk, c) ^ 1U);
      append_followed(view, ki ^ 1U, p, k.path);
    }
    end_at(k, corner(view, ki, true));
  }

  // finds m: turns clockwise about i, crosses the curves that cut off i, emanate from j, cut off m
  template <class View>
  void reach_right(const View& view, std::uint32_t h) {
    Corner& m = corners_[3];
    const std::uint32_t o = h ^ 1U, im = view.next(o);
    const auto turn_across = [&](std::uint32_t c) { append(m.path, c ^ 1U); };
    if (is_along_curve(h)) turn_across(first_curve(h));
    for (Normal_coordinate c = right_.emanating[1]; c-- > 0;) turn_across(curve(im, c));
    if (!is_along_curve(im)) {
      Normal_coordinate p = 0;
      for (; p < right_.cutting[1]; ++p) append(m.path, crossed_[index(p)]);
      for (Normal_coordinate c = 0; c < right_.emanating[0]; ++c, ++p) append(m.path, curve(o, c));
      append_followed(view, im, p, m.path);
    }
    end_at(m, corner(view, im ^ 1U, false));
  }

  static std::size_t index(Normal_coordinate p) { return static_cast<std::size_t>(p); }

  const Integer_coordinates* coordinates_ = nullptr; // of the call
  Corner_coordinates left_, right_;                  // corners i, j, k and j, i, m
  std::vector<std::uint32_t> crossed_, others_;
  std::vector<Curve_bundle> stack_;
  std::array<Corner, 4> corners_;
  std::size_t steps_ = 0;
  Unfolded_diamond diamond_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_DIAMOND_UNFOLDER_H
