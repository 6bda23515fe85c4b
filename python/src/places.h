// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_PLACES_H
#define INTRINSIC_PYTHON_PLACES_H

#include "Surface.h"
#include "arrays.h"

#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>

#include <tuple>
#include <vector>

// Points that the user gives: vertices, and places in faces of the mesh.

namespace python {

using IT::Place;
using IT::Place_finder;

/// The arrays that Python makes of points: faces, barycentric coordinates (n, 3), and vertices, -1
/// for points in faces.
using Place_arrays = std::tuple<Integers, Doubles, Integers>;

/// reads points of a surface, normalized.
std::vector<Place> places_of(const Surface& s, const Place_arrays& arrays);

} // namespace python

#endif // INTRINSIC_PYTHON_PLACES_H
