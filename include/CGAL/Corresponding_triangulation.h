// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CORRESPONDING_TRIANGULATION_H
#define CGAL_CORRESPONDING_TRIANGULATION_H

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is the intrinsic triangulation to begin with: it is exact, and integer coordinates store
where it lies on the input.
*/
using Corresponding_triangulation =
    Intrinsic_triangulation<Gluing_map, Exact_euclidean_traits, Integer_coordinates>;

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_CORRESPONDING_TRIANGULATION_H
