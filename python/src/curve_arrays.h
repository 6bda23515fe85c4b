// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_CURVE_ARRAYS_H
#define INTRINSIC_PYTHON_CURVE_ARRAYS_H

#include "arrays.h"

#include <CGAL/Intrinsic_geodesics/cuts/Cut_surface.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

// Curves over the user's mesh as arrays.

namespace python {

/// Coordinates of vertices, or none of an abstract metric.
using Points = std::vector<Point>;

/// A curve over the mesh, as it is to be given to Python.
struct Way {
  IT::Traced_curve curve;
  bool is_closed = false; ///< then the last of its points is the first one again
};

/// Curves along the edges of a triangulation, which it keeps.
struct Curve_edges {
  std::shared_ptr<const IT::Input> input; ///< that of the triangulation
  std::function<IT::Cut_surface()> cut;   ///< cuts along all of them
};

/// returns curves for files and pages: triples of points, whether a curve is closed, and its label.
std::vector<IT::Polyline> polylines_of(const py::handle& curves);

/// adds the class to the module: an object that can be pickled, but has no members there.
void bind_way(py::module_& m);

/// \throws Invalid_input if a curve has elements that the input does not have: it is another
/// surface's. \param name what messages call the curve: "curves[2]"
void expect_on_input(const IT::Input& input, const IT::Traced_curve& curve,
                     const std::string& name);

/*!
\brief returns points of the input as arrays: `points` in space (none without coordinates),
`faces` of the user, `corners`, the vertices whose weights are `barycentric`, and `vertices` of the
user at them, or -1.
\param faces the face in which each point is given, or none: any with the point
*/
py::dict point_arrays(const IT::Input& input, const Points& coordinates,
                      const std::vector<IT::Surface_point>& points,
                      const std::vector<std::uint32_t>& faces = {});

/*!
\brief returns a curve as the arrays of its points, each in the face where it goes on, with its
length, bounds of that, and itself as `way`. A closed one does not repeat its first point.
\param drops_repetitions whether consecutive points in one place become one
*/
py::dict curve_arrays(const IT::Input& input, const Points& coordinates, Way way,
                      bool drops_repetitions = false);

} // namespace python

#endif // INTRINSIC_PYTHON_CURVE_ARRAYS_H
