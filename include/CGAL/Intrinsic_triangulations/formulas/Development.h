// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_DEVELOPMENT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_DEVELOPMENT_H

#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a tree of triangles of a surface, one glued to a side of another, that curves or walks
pass.

The first side of the first triangle runs from point 0 to point 1, and triangle number n adds point
n + 2. The tree is separate from the values carried along it: positions in the plane in any field,
or any values that follow at the apex of a triangle from the ends of its first side. It reuses its
memory.
\tparam Side_ names a side of a triangle of the surface: a halfedge, or a `Face_side`
*/
template <std::copyable Side_ = std::uint32_t>
class Development {
public:
  /// Type of names of sides.
  using Side = Side_;
  /// No triangle.
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// A triangle; its sides and corners are counted from its first side on.
  struct Triangle {
    Side side;                          ///< its first side, over which it is entered
    std::array<std::uint32_t, 3> point; ///< where the first side starts, where it ends, the apex
    /// the triangles beyond its sides, `none` where there is none; a parent comes before its
    /// children
    std::array<std::uint32_t, 3> beyond;

    /// returns the triangle from which it is entered. \pre it is not the first triangle
    std::uint32_t parent() const { return beyond[0]; }
  };

  /// starts a tree with a triangle.
  void start(const Side& side) { triangles_.assign(1, {side, {0, 1, 2}, {none, none, none}}); }

  /*!
  \brief adds a triangle.
  \param parent the triangle that it is glued to
  \param exit the side of the parent along which
  \param side its first side
  \return its number
  */
  std::uint32_t enter(std::uint32_t parent, unsigned exit, const Side& side) {
    const auto number = static_cast<std::uint32_t>(size());
    Triangle& p = triangles_[parent];
    p.beyond[exit] = number;
    const std::uint32_t start = p.point[(exit + 1) % 3], end = p.point[exit];
    triangles_.push_back({side, {start, end, number + 2}, {parent, none, none}});
    return number;
  }

  /*!
  \brief adds the face of a halfedge, which is entered over it.
  \tparam Complex a model of `NumberedComplex`
  \param complex the surface
  \param parent the triangle that has the opposite halfedge
  \param halfedge the halfedge
  */
  template <class Complex>
  std::uint32_t enter(const Complex& complex, std::uint32_t parent, std::uint32_t halfedge) {
    const std::uint32_t first = triangles_[parent].side, exit = halfedge ^ 1U;
    return enter(parent, exit == first ? 0U : exit == complex.next(first) ? 1U : 2U, halfedge);
  }

  /// returns the number of triangles.
  std::size_t size() const { return triangles_.size(); }
  /// returns the number of the triangle that was added last.
  std::uint32_t last() const { return static_cast<std::uint32_t>(size() - 1); }
  /// returns a triangle.
  const Triangle& operator[](std::size_t n) const { return triangles_[n]; }
  /// returns the first triangle.
  auto begin() const { return triangles_.begin(); }
  /// returns the end of the triangles.
  auto end() const { return triangles_.end(); }

  /// returns the side of its parent over which a triangle is entered.
  unsigned exit_to(std::uint32_t child) const {
    const auto& b = triangles_[triangles_[child].parent()].beyond;
    return b[2] == child ? 2 : b[1] == child ? 1 : 0;
  }

  /*!
  \brief carries values from point to point.
  \tparam Values a sequence, such as `std::vector`
  \tparam Step a functor from a triangle, and the values where its first side starts and ends, to
    that at its apex
  \param at values at the first points: two at least; those at others are added
  \param step the functor
  \param count number of triangles whose apex is computed
  */
  template <class Values, class Step>
  void carry(Values& at, const Step& step,
             std::size_t count = std::numeric_limits<std::size_t>::max()) const {
    count = std::min(count, size());
    at.reserve(count + 2);
    for (std::size_t n = at.size() - 2; n < count; ++n) {
      const Triangle& t = triangles_[n];
      at.push_back(step(t, at[t.point[0]], at[t.point[1]]));
    }
  }

  /*!
  \brief develops the triangles into the plane.
  \tparam Values a functor from a side to the `Face_values<FT>` of its face, from that side on
  \param z positions of the first two points at least, or none: then they are 0 and 1; those of
    others are added
  \param values the functor
  \param count see `carry()`
  */
  template <class FT, class Values>
  void develop(std::vector<Plane_vector<FT>>& z, const Values& values,
               std::size_t count = std::numeric_limits<std::size_t>::max()) const {
    const auto place = [&](const Triangle& t) {
      const Face_values<FT> v = values(t.side);
      return apex(v.squared_lengths[0], v.squared_lengths[1], v.squared_lengths[2],
                  v.quadruple_area);
    };
    if (z.empty()) z = {{FT(0), FT(0)}, {FT(1), FT(0)}, place(triangles_.front())};
    carry(
        z,
        [&](const Triangle& t, const Plane_vector<FT>& from, const Plane_vector<FT>& to) {
          return from + (to - from) * place(t);
        },
        count);
  }

private:
  std::vector<Triangle> triangles_;
};

/*!
\brief is a straight line in a development, from a point to another one.
*/
struct Straight_line {
  Plane_vector<double> from; ///< where it starts
  Plane_vector<double> to;   ///< where it ends

  /// returns where it crosses the segment between two points, on its left and on its right: 0 at
  /// the first of them, 1 at the other.
  double parameter(const Plane_vector<double>& left, const Plane_vector<double>& right) const {
    const double a = cross(to - from, left - from), b = cross(to - from, right - from);
    return a - b > 0 ? std::clamp(a / (a - b), 0.0, 1.0) : 0.5;
  }
  /// returns where the foot of a point is on it: 0 at its start, 1 at its end.
  double along(const Plane_vector<double>& p) const {
    const Plane_vector<double> d = to - from;
    const double squared = dot(d, d);
    return squared > 0 ? std::clamp(dot(d, p - from) / squared, 0.0, 1.0) : 0.5;
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_DEVELOPMENT_H
