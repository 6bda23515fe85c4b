// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFINEMENT_STATE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFINEMENT_STATE_H

#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_result.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_test.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The work that waits for refinement, and its result so far.
template <class Triangulation>
struct Refinement_state {
  using Face = typename Triangulation::face_descriptor;
  using Halfedge = typename Triangulation::halfedge_descriptor;

  Face_queue queue;                 // faces that are bad
  std::vector<Face> touched;        // those that changed
  std::vector<Halfedge> encroached; // segments that may not be Delaunay
  bool is_going_on = true;
  Refinement_result<Face> result;

  // sets the status of the result; returns false
  bool stop(Status status) {
    result.status = status;
    return is_going_on = false;
  }
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFINEMENT_STATE_H
