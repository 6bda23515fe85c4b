// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_ANGLES_PRESCRIBED_ANGLES_H
#define CGAL_INTRINSIC_CONFORMAL_ANGLES_PRESCRIBED_ANGLES_H

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// An angle that is a rational multiple of pi.
struct Multiple_of_pi {
  std::int64_t numerator = 2;   ///< positive
  std::int64_t denominator = 1; ///< positive

  /// returns the angle in radians.
  double radians() const;
  /// compares numerators and denominators.
  friend bool operator==(const Multiple_of_pi&, const Multiple_of_pi&) = default;
};

/*!
\brief lists the angle that the surface shall have around each of its vertices.

Around a vertex inside of a flat surface the angle is \f$2\pi\f$; a vertex with another angle is a
cone. On the border the angle is that between the two border edges, inside of the surface. Rational
multiples of pi are kept as such, so that the theorem of Gauss and Bonnet is checked in integers.
A vertex may be free instead: its scale factor stays 1, and its angle is what comes out.

Vertices are those of the user: the rows of matrices.
*/
class Prescribed_angles {
public:
  /// prescribes a full turn at each vertex.
  /// \param vertices how many there are
  explicit Prescribed_angles(std::size_t vertices = 0) : angles_(vertices) {}
  /// takes angles in radians. A double stands for itself: the nearest one to a multiple of pi is no
  /// multiple of pi.
  explicit Prescribed_angles(const std::vector<double>& radians);

  /// returns the number of vertices.
  std::size_t size() const { return angles_.size(); }

  /// prescribes an angle in radians. \pre `vertex < size()`
  void set(std::size_t vertex, double radians) { angles_[vertex] = {Kind::real, {}, radians}; }
  /// prescribes a multiple of pi. \pre `vertex < size()`
  void set(std::size_t vertex, Multiple_of_pi angle) {
    angles_[vertex] = {Kind::multiple, angle, angle.radians()};
  }
  /// lets a vertex keep its scale. \pre `vertex < size()`
  void set_free(std::size_t vertex) { angles_[vertex] = {Kind::free, {}, 0}; }

  /// tells whether a vertex keeps its scale. \pre `vertex < size()`
  bool is_free(std::size_t vertex) const { return angles_[vertex].kind == Kind::free; }
  /// tells whether an angle is given as a multiple of pi. \pre `vertex < size()`
  bool is_multiple(std::size_t vertex) const { return angles_[vertex].kind == Kind::multiple; }
  /// returns an angle that is given as a multiple of pi. \pre `is_multiple(vertex)`
  Multiple_of_pi multiple(std::size_t vertex) const { return angles_[vertex].multiple; }
  /// returns an angle in radians; zero if the vertex is free. \pre `vertex < size()`
  double radians(std::size_t vertex) const { return angles_[vertex].radians; }

private:
  enum class Kind : std::uint8_t { multiple, real, free };
  struct Angle {
    Kind kind = Kind::multiple;
    Multiple_of_pi multiple{};
    double radians = Multiple_of_pi().radians();
  };

  std::vector<Angle> angles_;
};

namespace internal {

// Checks angles: their number, that they are positive and finite, and their sum in each component
// without free vertices (Gauss and Bonnet). In a closed surface of F faces angles sum to F pi, so
// that in a double, whose border vertices occur once, those of the user's surface do, too.
// \param component of each row, `Gluing::none` for isolated vertices
// \param faces of each component, on all sheets
// \return what to add to each angle of a component so that they sum to that up to the last place:
//   rounding errors of the angles as given
// \throws Invalid_input
std::vector<double> checked_gauss_bonnet(const Prescribed_angles& angles,
                                         const std::vector<std::uint32_t>& component,
                                         const std::vector<std::size_t>& faces,
                                         std::uint32_t sheets);

// Checks angles of a hyperbolic metric: their number, that they are positive and finite, and that
// they leave an area to each component without free vertices, F pi minus their sum in a closed
// surface of F faces (Gauss and Bonnet). \throws Invalid_input
void check_hyperbolic_angles(const Prescribed_angles& angles,
                             const std::vector<std::uint32_t>& component,
                             const std::vector<std::size_t>& faces, std::uint32_t sheets);

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_CONFORMAL_ANGLES_PRESCRIBED_ANGLES_H
