// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_MAPS_H
#define INTRINSIC_PYTHON_MAPS_H

#include "Surface.h"

#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_operators/parametrization/measure_distortion.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

// What functions on maps have in common.

namespace python {

/// returns what a certificate says.
py::dict dict_of(const IT::Map_certificate& c);
/// returns the figures of a distortion.
py::dict dict_of(const IT::Map_distortion& d);

/// adds the functions on conformal maps.
void bind_uniformize(py::module_& m);
/// adds the function that finds convex polyhedra.
void bind_embed(py::module_& m);

} // namespace python

#endif // INTRINSIC_PYTHON_MAPS_H
