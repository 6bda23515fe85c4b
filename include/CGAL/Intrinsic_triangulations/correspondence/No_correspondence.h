// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_NO_CORRESPONDENCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_NO_CORRESPONDENCE_H

namespace CGAL::Intrinsic_triangulations {

/*!
\brief keeps lengths only: nothing is known of where intrinsic edges run on the input.
\cgalModels{IntrinsicCorrespondence}
*/
struct No_correspondence {
  /// observes a flip before it is done.
  template <class Triangulation, class Halfedge>
  void before_flip(const Triangulation&, Halfedge) {}
  /// observes a flip after it was done.
  template <class Triangulation, class Halfedge>
  void after_flip(const Triangulation&, Halfedge) {}
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_NO_CORRESPONDENCE_H
