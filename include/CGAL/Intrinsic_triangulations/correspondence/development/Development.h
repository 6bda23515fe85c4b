// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_DEVELOPMENT_DEVELOPMENT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_DEVELOPMENT_DEVELOPMENT_H

#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a tree of triangles of a surface, one glued to a side of another, that curves or walks pass.

The first side of the first triangle runs from point 0 to point 1, and triangle number n adds point n + 2. Which
triangles these are is one thing, what is carried along them another: positions in the plane, in any field, or whatever
else follows at the apex of a triangle from the ends of its first side. Memory stays from tree to tree.
*/
class Development {
public:
  /// A triangle.
  struct Triangle {
    std::uint32_t halfedge; ///< its first side, over which it is entered
    std::uint32_t parent;   ///< the triangle on the other side of it; itself in the first
    std::array<std::uint32_t, 3> point; ///< where the first side starts, where it ends, the apex
  };

  /// starts a tree with the face of a halfedge, which is its first side.
  void start(std::uint32_t halfedge) { triangles_.assign(1, {halfedge, 0, {0, 1, 2}}); }

  /*!
  \brief adds the face of a halfedge, which is entered over it.
  \tparam Complex a model of `NumberedComplex`
  \param complex the surface
  \param parent the triangle that has the opposite halfedge
  \param halfedge the halfedge
  */
  template <class Complex>
  void enter(const Complex& complex, std::uint32_t parent, std::uint32_t halfedge) {
    const unsigned side = side_of(complex, parent, halfedge ^ 1U);
    const std::array<std::uint32_t, 3>& p = triangles_[parent].point;
    const auto apex = static_cast<std::uint32_t>(size() + 2);
    triangles_.push_back({halfedge, parent, {p[(side + 1) % 3], p[side], apex}});
  }

  /// returns the number of triangles.
  std::size_t size() const { return triangles_.size(); }
  /// returns the number of the triangle that was added last.
  std::uint32_t last() const { return static_cast<std::uint32_t>(size() - 1); }
  /// returns a triangle; parents come before those that are glued to them.
  const Triangle& operator[](std::size_t n) const { return triangles_[n]; }

  /// returns the side of its parent over which a triangle is entered: 0 for the first side.
  template <class Complex>
  unsigned side_towards(const Complex& complex, std::uint32_t child) const {
    return side_of(complex, triangles_[child].parent, triangles_[child].halfedge ^ 1U);
  }

  /*!
  \brief carries values from point to point.
  \tparam Step a functor from the number of a triangle, and the values where its first side starts and ends, to that at
  its apex
  \param at values at the first points: two at least; those at others are added
  \param step the functor
  \param count number of triangles whose apex is wanted
  */
  template <class Value, class Step>
  void carry(std::vector<Value>& at, const Step& step,
             std::size_t count = std::numeric_limits<std::size_t>::max()) const {
    count = std::min(count, size());
    at.reserve(count + 2);
    for (std::size_t n = at.size() - 2; n < count; ++n)
      at.push_back(step(n, at[triangles_[n].point[0]], at[triangles_[n].point[1]]));
  }

  /*!
  \brief develops the triangles into the plane.
  \tparam Values a functor from a halfedge to the `Face_values<FT>` of its face, from the halfedge on
  \param z positions of the first two points at least, or none: then they are 0 and 1; those of others are added
  \param values the functor
  \param count see `carry()`
  */
  template <class FT, class Values>
  void develop(std::vector<Plane_vector<FT>>& z, const Values& values,
               std::size_t count = std::numeric_limits<std::size_t>::max()) const {
    const auto place = [&](std::size_t n) {
      const Face_values<FT> v = values(triangles_[n].halfedge);
      return apex(v.squared_lengths[0], v.squared_lengths[1], v.squared_lengths[2],
                  v.quadruple_area);
    };
    if (z.empty()) z = {{FT(0), FT(0)}, {FT(1), FT(0)}, place(0)};
    carry(
        z,
        [&](std::size_t n, const Plane_vector<FT>& from, const Plane_vector<FT>& to) {
          return from + (to - from) * place(n);
        },
        count);
  }

private:
  template <class Complex>
  unsigned side_of(const Complex& complex, std::uint32_t triangle, std::uint32_t halfedge) const {
    const std::uint32_t first = triangles_[triangle].halfedge;
    return halfedge == first ? 0 : halfedge == complex.next(first) ? 1 : 2;
  }

  std::vector<Triangle> triangles_;
};

/*!
\brief is a straight line in a development, from a point to another one.
*/
struct Straight_line {
  Plane_vector<double> from; ///< where it starts
  Plane_vector<double> to;   ///< where it ends

  /// returns where it crosses the segment between two points, on its left and on its right: 0 at the first of them, 1 at the other.
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

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_DEVELOPMENT_DEVELOPMENT_H
