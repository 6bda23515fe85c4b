// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_TANGENTS_H
#define INTRINSIC_PYTHON_TANGENTS_H

#include "curve_arrays.h"
#include "places.h"

#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <array>
#include <cstdint>

// Vectors in space at points of a surface.

namespace python {

using Space_vector = std::array<double, 3>; ///< a vector in space

/*!
\brief projects a vector in space to the face of a point, whichever face the point was named in: on
an edge to the nearer one of both; at a vertex, only its direction, to the face whose plane has the
vector nearest to it. At the border the planes of the first and the last
face go on beyond it: a vector that points out of the surface stays outside.
\param coordinates where the user's vertices are
\param vertex the number in the input of a point that is a vertex, which is not isolated
*/
IT::Tangent_vector tangent_in_space(const IT::Input& input, const Points& coordinates,
                                    const Place& p, std::uint32_t vertex, const Space_vector& v);

} // namespace python

#endif // INTRINSIC_PYTHON_TANGENTS_H
