// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_RENUMBERING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_RENUMBERING_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/Element_names.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <array>
#include <cstdint>
#include <vector>

/*!
\file
Numbering for locality. A mesh whose neighbouring faces are far apart in memory costs a cache miss
per access; numbering its faces along a space-filling curve makes flips several times faster.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief tells whether neighbouring faces lie so far apart in memory that renumbering pays.

True if the mesh does not fit a processor's cache (more than 2^17 faces), and edges that follow each
other in a sample touch a new group of 64 consecutive faces more often than every eighth time. Rows
of a grid touch few groups, however long they are.
\complexity constant
*/
bool is_badly_ordered(const Gluing_map& mesh);

/*!
\brief orders points along a Morton curve.
\return numbers of the points in the new order
\pre coordinates are finite
\complexity linear: a radix sort
*/
std::vector<std::uint32_t> morton_order(const std::vector<std::array<double, 3>>& points);

/*!
\brief renumbers a mesh in space so that neighbours are near in memory: vertices along a Morton
curve, faces and edges along with them.
\param mesh the connectivity, which is replaced
\param points one point per vertex, which are permuted
\return the numbers before, as the user's numbers
\pre `mesh` is oriented and has a vertex, coordinates are finite
\complexity linear
*/
Input_names renumber(Gluing_map& mesh, std::vector<std::array<double, 3>>& points);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_RENUMBERING_H
