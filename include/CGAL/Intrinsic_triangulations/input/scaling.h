// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_SCALING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_SCALING_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <array>
#include <vector>

/*!
\file
Scaling of the input by powers of two, so that the mean edge is near 1: products of four squared
lengths then neither overflow nor underflow on meshes drawn at 1e120 or 1e-160. Exact.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Multiplies by 2^exponent, in two steps so that the factors are normal numbers.
class Power_of_two {
public:
  explicit Power_of_two(int exponent)
      : first_(std::ldexp(1.0, exponent / 2)), second_(std::ldexp(1.0, exponent - exponent / 2)),
        inverse_first_(std::ldexp(1.0, -(exponent / 2))),
        inverse_second_(std::ldexp(1.0, exponent / 2 - exponent)) {}
  double operator()(double x) const { return x * first_ * second_; }
  // returns whether that was exact
  bool scale(double& x) const {
    const double scaled = x * first_ * second_;
    const bool exact = scaled * inverse_first_ * inverse_second_ == x;
    x = scaled;
    return exact;
  }

private:
  double first_, second_, inverse_first_, inverse_second_;
};

} // namespace internal

/*!
\brief scales points by a power of two so that the mean edge is near 1.

The mean is taken of up to 4096 edges, spread evenly.
\param mesh the connectivity
\param points one point per vertex, which is scaled
\return the exponent of the power
\throws Invalid_input naming the first vertex with a coordinate that is not finite, or that is too
  small against the mean edge to be scaled exactly
\complexity linear
*/
int scale_points(const Gluing_map& mesh, std::vector<std::array<double, 3>>& points);

/*!
\brief scales squared lengths by a power of four so that the largest is near 1.
\return s, where squared lengths are scaled by 4^s
\throws Invalid_input naming the first edge with a squared length that is negative or not finite,
  or that is too small against the largest to be scaled exactly
*/
int scale_squared_lengths(std::vector<double>& squared_lengths);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_SCALING_H
