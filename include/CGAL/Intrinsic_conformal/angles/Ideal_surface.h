// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_ANGLES_IDEAL_SURFACE_H
#define CGAL_INTRINSIC_CONFORMAL_ANGLES_IDEAL_SURFACE_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The plane that triangles are in.
enum class Geometry : std::uint8_t { euclidean, hyperbolic };

// How much longer the two other sides of a triangle are together than each.
template <class Number>
std::array<Number, 3> surpluses(const std::array<Number, 3>& sides) {
  const auto& [a, b, c] = sides;
  return {(b - a) + c, (c - b) + a, (a - c) + b};
}

// A face of an ideal triangulation: side k runs from corner k to the next one.
struct Ideal_face {
  std::array<int, 3> rows;            // of the corners
  std::array<std::uint32_t, 3> edges; // of the sides, by their numbers
  std::array<double, 3> lambda;       // of the sides, scaled
  std::array<double, 3> surplus; // of the sides, with digits that needles lose in `surpluses()`

  // of the Euclidean triangle; zero if there is none
  double area() const;
};

// The same with the vertices in place of their rows, and enclosed values.
struct Enclosed_ideal_face {
  std::array<std::uint32_t, 3> vertices;
  std::array<Interval_nt<false>, 3> lambda, surplus;
};

// Whether a triangle is so near to a segment that surpluses of its sides lose ten bits or more.
inline bool is_needle(const std::array<double, 3>& sides) {
  return std::ranges::min(surpluses(sides)) < 0x1p-10 * (sides[0] + sides[1] + sides[2]);
}

// Whether factors are so near each other that products of two lambda lengths, with two factors
// each, neither overflow nor underflow. What they share belongs to the unit of scaled lengths.
bool are_in_range(std::span<const Double_double> factors);

// What is left of a number when it is rounded to a double.
inline double rest(const Double_double& x) { return (x - x.to_double()).to_double(); }

// The components of a surface by its rows.
struct Ideal_components {
  std::vector<std::uint32_t> of_row; // `Gluing::none` for isolated vertices
  std::vector<std::size_t> faces;    // how many each component has, on all sheets
};

// An ideal triangulation as solvers see it. All vectors go by rows but `row_of_vertex()`.
class Ideal_surface {
public:
  virtual ~Ideal_surface() = default;
  // the row of each vertex, several of them on a double
  virtual const std::vector<std::uint32_t>& row_of_vertex() const = 0;
  virtual std::size_t number_of_rows() const = 0;
  // lambdas of faces are 2^this times those in the units of the user; `scale()` may change it
  virtual int scale_exponent() const = 0;
  // how many copies of each face there are
  virtual std::uint32_t sheets() const = 0;
  // Sets scale factors and flips to ideal Delaunay. \return the number of flips; nothing, and there
  // is no change, if a factor is out of range
  virtual std::optional<std::size_t> scale(std::span<const Double_double> factors) = 0;
  // Replaces faces by those of now.
  virtual void read(std::vector<Ideal_face>& faces) const = 0;
  // Nothing if the arithmetic does not enclose values. \pre rounding is upwards
  virtual std::optional<std::vector<Enclosed_ideal_face>> enclosures() const = 0;
};

// \param rows how many there are
Ideal_components components_of(const std::vector<Ideal_face>& faces, std::size_t rows);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_CONFORMAL_ANGLES_IDEAL_SURFACE_H
