// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_CURVE_EDGES_H
#define INTRINSIC_PYTHON_CURVE_EDGES_H

#include "arrays.h"

#include <CGAL/Intrinsic_geodesics/cuts/Cut_surface.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <functional>
#include <memory>

namespace python {

/// Curves along the edges of a triangulation, which it keeps.
struct Curve_edges {
  std::shared_ptr<const IT::Input> input; ///< that of the triangulation
  std::function<IT::Cut_surface()> cut;   ///< cuts along all of them
};

} // namespace python

#endif // INTRINSIC_PYTHON_CURVE_EDGES_H
