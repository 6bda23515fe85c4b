// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_FACE_DEVELOPMENT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_FACE_DEVELOPMENT_H

#include <CGAL/Intrinsic_triangulations/correspondence/curves/Crossing_run.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Triangle_strips.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// A point of an intrinsic face, placed on the input.
struct Place_in_face {
  Face_region region; ///< in the face
  std::uint32_t triangle =
      0; ///< the input triangle that contains it, by its number in the development
  std::array<double, 3> weights{}; ///< of the corners of the triangle, multiples of 2^-52
  Surface_point
      location; ///< on the input; if it is on a curve, on the side of the curve of larger numbers
};

/*!
\brief finds the input triangles under an intrinsic face, and the region of the face in each of
them.

The curves (input edges) in a face ijk cut off corners or emanate from one corner. In the first case
a middle region is left, from which the regions at each corner are reached across the curves that
cut it off; in the second the regions form one strip along the side opposite that corner. Each lies
in one input triangle. The lists of curves across one or two sides determine all of them (§3.5 of
the course).

It uses only the input and integers: errors do not depend on earlier moves. It reuses its memory.
*/
class Face_development {
public:
  /// A corner of the face.
  struct Corner {
    std::uint32_t triangle;        ///< an input triangle in which it is
    std::array<double, 3> weights; ///< where it is in that
  };

  /*!
  \brief finds the triangles under the face of a halfedge.
  \tparam Complex `Intrinsic_view`
  \tparam Coordinates a model of `CurveCoordinates`
  \complexity linear in the number of curves in the face, or of long turns of curves that are
  stored, and that of following curves
  */
  template <class Complex, CurveCoordinates Coordinates>
  void unfold(const Complex& complex, const Coordinates& coordinates, std::uint32_t h) {
    const Input& input = coordinates.input();
    sides_ = sides_of_face(complex, h);
    curves_ = corner_coordinates(complex, coordinates, h);
    fan_ = curves_.fan_corner();
    first_ = fan_ == 3 ? 0 : (fan_ + 1) % 3;
    along_ = crossings(coordinates.normal_coordinate(sides_[first_] / 2));
    std::array<Surface_point, 3> corners;
    for (unsigned k = 0; k < 3; ++k) corners[k] = corner_on_input(complex, coordinates, sides_[k]);
    triangles_.start(corners[first_].halfedge);
    entered_.clear();
    steps_ +=
        internal::append_entered_from_face(complex, coordinates, sides_[first_], entered_, stack_);
    triangles_.enter(input, coordinates.fans(), 0, entered_);
    if (fan_ == 3) {
      const unsigned third = (first_ + 2) % 3;
      entered_.clear();
      steps_ += internal::append_entered(complex, coordinates, sides_[third], 0,
                                         curves_.cutting[third], entered_, stack_);
      enter_back(input, coordinates.fans());
    }
    for (unsigned k = 0; k < 3; ++k) {
      const std::uint32_t t = region_at(k, 0);
      corner_[k] = {t, seen_from(input, corners[k], triangles_.side(t)).weights};
    }
  }

  /// returns the triangles.
  const Triangle_strips& triangles() const { return triangles_; }
  /// returns the number of the last triangle.
  std::uint32_t last() const { return triangles_.last(); }
  /// returns a corner of the face.
  const Corner& corner(unsigned k) const { return corner_[k]; }
  /// returns how many steps were taken so far along curves.
  std::size_t steps() const { return steps_; }

  /// returns the point of the triangles at a corner of one of them, if that point is a corner of a
  /// triangle, too: its corner.
  std::optional<unsigned> shared_corner(std::uint32_t triangle, const Corner& c) const;

  /// returns a side of the triangle of the first region beside the first side of the face.
  std::uint32_t beside_first_side() const { return region_at(fan_ == 0 ? 1 : 0, 0); }
  /// returns the region there, of points on the first side, which runs along a curve.
  Face_region region_beside_first_side() const {
    Face_region r = middle_region();
    if (fan_ < 3) r.right_of_fan = fan_ == 1 ? curves_.emanating[1] : 0;
    return r;
  }

  /*!
  \brief finds the region of a point.
  \param is_beyond says for a triangle (not the first) whether the point is beyond the side over
    which it is entered
  \param region becomes the region
  \return the triangle
  \complexity logarithmic
  */
  template <class Is_beyond>
  std::uint32_t find_region(const Is_beyond& is_beyond, Face_region& region) const {
    region = middle_region();
    if (fan_ < 3) {
      const Normal_coordinate m = first_exception(along_, [&](Normal_coordinate i) {
        return is_beyond(static_cast<std::uint32_t>(i) + 1);
      });
      region.cutting[first_] = std::min(m, curves_.cutting[first_]);
      const unsigned end = (first_ + 1) % 3;
      region.cutting[end] = std::min(along_ - m, curves_.cutting[end]);
      region.right_of_fan = std::clamp(m - curves_.cutting[first_], 0, curves_.emanating[fan_]);
      return static_cast<std::uint32_t>(m);
    }
    for (unsigned k = 0; k < 3; ++k) {
      const Normal_coordinate all = curves_.cutting[k];
      const Normal_coordinate beyond = first_exception(all, [&](Normal_coordinate i) {
        const std::uint32_t outer = region_at(k, all - 1 - i);
        return k == first_ ? !is_beyond(outer + 1) : is_beyond(outer);
      });
      if (beyond == 0) continue;
      region.cutting[k] = all - beyond;
      return region_at(k, region.cutting[k]);
    }
    return region_at(first_, curves_.cutting[first_]);
  }

  /// returns the triangle that is entered over the side of a triangle opposite a corner: itself,
  /// another one, or `none`.
  std::uint32_t entered_over(std::uint32_t t, unsigned opposite) const {
    return t > 0 && opposite == 2 ? t : triangles_.entered_over(t, (opposite + 1) % 3);
  }
  /// returns the triangles that are entered from a triangle, two at most.
  boost::container::small_vector<std::uint32_t, 2> children(std::uint32_t t) const;

  /*!
  \brief names the curve over which a triangle is entered.
  \return whether the triangle is on the left of the curve as it leaves the face through the side
  that starts from the corner it cuts off, or as it starts from its corner
  */
  bool name_curve(std::uint32_t child, Face_region& r) const;

private:
  Face_region middle_region() const {
    Face_region r;
    r.cutting = curves_.cutting;
    r.fan_corner = fan_;
    return r;
  }

  // the first of `count` numbers for which a property does not hold; it holds for all before it
  template <class Is_example>
  static Normal_coordinate first_exception(Normal_coordinate count, const Is_example& is_example) {
    Normal_coordinate begin = 0, step = 1; // all before `begin` are examples
    while (begin + step <= count && is_example(begin + step - 1)) {
      begin += step;
      step *= 2;
    }
    Normal_coordinate end = std::min(begin + step - 1, count); // an exception, or all
    while (begin < end) {
      const Normal_coordinate middle = begin + (end - begin) / 2;
      if (is_example(middle))
        begin = middle + 1;
      else
        end = middle;
    }
    return begin;
  }

  // the triangle of the region that `passed` curves cut off corner k do not cut off from it
  std::uint32_t region_at(unsigned k, Normal_coordinate passed) const {
    if (k == first_) return static_cast<std::uint32_t>(passed);
    if (k == (first_ + 1) % 3) return static_cast<std::uint32_t>(along_ - passed);
    if (passed == curves_.cutting[k]) return static_cast<std::uint32_t>(curves_.cutting[first_]);
    return static_cast<std::uint32_t>(along_ + curves_.cutting[k] - passed);
  }

  // the second strip, over curves that were found on the way back
  void enter_back(const Input& input, const Vertex_fans& fans);

  std::array<std::uint32_t, 3> sides_{};
  Corner_coordinates curves_{};
  unsigned first_ = 0;          // corner from which the strip along a side starts
  unsigned fan_ = 3;            // corner opposite that side, if curves emanate from it
  Normal_coordinate along_ = 0; // number of curves across that side
  Triangle_strips triangles_;
  std::array<Corner, 3> corner_{};
  std::vector<Crossing_run> entered_;
  std::vector<Curve_bundle> stack_;
  std::size_t steps_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_FACE_DEVELOPMENT_H
