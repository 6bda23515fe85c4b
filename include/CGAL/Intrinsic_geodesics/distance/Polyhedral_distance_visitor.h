// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_POLYHEDRAL_DISTANCE_VISITOR_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_POLYHEDRAL_DISTANCE_VISITOR_H

#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief observes the search for distances; the default visitor does nothing.
*/
struct Polyhedral_distance_visitor {
  /*!
  \brief is called now and then, about every 65536 windows.
  \param windows number of windows so far
  \param distance distances up to this one are final, in the units of the input
  \return whether to go on
  */
  bool progress([[maybe_unused]] std::uint64_t windows, [[maybe_unused]] double distance) {
    return true;
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_POLYHEDRAL_DISTANCE_VISITOR_H
