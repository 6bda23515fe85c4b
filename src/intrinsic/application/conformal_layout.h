// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_APPLICATION_CONFORMAL_LAYOUT_H
#define INTRINSIC_APPLICATION_CONFORMAL_LAYOUT_H

#include "Computed.h"

#include <CGAL/Intrinsic_operators/conformal/Prescribed_angles.h>
#include <CGAL/Intrinsic_operators/conformal/flat_surface.h>
#include <CGAL/Intrinsic_operators/conformal/flat_torus.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/input/Element_names.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace program {

/// A surface with scale factors that make it flat.
struct Scaled_surface {
  IT::Flat_surface start;              ///< the triangles of the input, with their lengths
  IT::Flat_surface flat;               ///< the ideal Delaunay triangulation, with scaled lengths
  IT::Common_subdivision subdivision;  ///< of both; faces of the input by their numbers
  std::vector<std::uint32_t> row;      ///< of each vertex
  std::vector<double> factors;         ///< of each row
  const IT::Input_names& names;        ///< of the input
  const IT::Prescribed_angles& angles; ///< of each row
};

/*!
\brief lays a flat surface out in the plane, of a double its front.
\param surface the surface
\param torus nothing, or the torus that it is: coordinates are then in the basis of its translations
\param points where the vertices of the mesh are
\param json gets what is reported
\throws std::runtime_error if the surface is a cover that is no double, and has no front
*/
Laid_out lay_out(const Scaled_surface& surface, const IT::Flat_torus* torus,
                 std::span<const std::array<double, 3>> points, Json& json);

} // namespace program

#endif // INTRINSIC_APPLICATION_CONFORMAL_LAYOUT_H
