// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_NO_CORRESPONDENCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_NO_CORRESPONDENCE_H

#include <array>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief keeps lengths only: nothing is known of where intrinsic edges run on the input.
\cgalModels{IntrinsicCorrespondence}
*/
struct No_correspondence {
  /// What the representation is called by programs.
  static constexpr const char* name = "none";

  /// observes a triangulation before its first move.
  template <class Triangulation>
  void start(const Triangulation&) {}
  /// observes a flip before it is done. \return true
  template <class Triangulation>
  bool before_flip(const Triangulation&, std::uint32_t) {
    return true;
  }
  /// observes a flip after it was done.
  template <class Triangulation>
  void after_flip(const Triangulation&, std::uint32_t) {}
  /// observes the insertion of a vertex in a face before it is done. \return true
  template <class Triangulation>
  bool before_insert_in_face(const Triangulation&, std::uint32_t, const std::array<double, 3>&) {
    return true;
  }
  /// observes the insertion of a vertex in a face after it was done.
  template <class Triangulation>
  void after_insert_in_face(const Triangulation&, std::uint32_t) {}
  /// observes the insertion of a vertex on the border before it is done. \return true
  template <class Triangulation>
  bool before_insert_in_border_edge(const Triangulation&, std::uint32_t, double) {
    return true;
  }
  /// observes the insertion of a vertex on the border after it was done.
  template <class Triangulation>
  void after_insert_in_border_edge(const Triangulation&, std::uint32_t) {}
  /// observes the removal of a vertex of degree three before it is done. \return true
  template <class Triangulation>
  bool before_remove(const Triangulation&, std::uint32_t) {
    return true;
  }
  /// observes the removal of a vertex of degree three after it was done.
  template <class Triangulation>
  void after_remove(const Triangulation&, std::uint32_t) {}
  /// observes the removal of a vertex on the border before it is done. \return true
  template <class Triangulation>
  bool before_remove_from_border(const Triangulation&, std::uint32_t) {
    return true;
  }
  /// observes the removal of a vertex on the border after it was done.
  template <class Triangulation>
  void after_remove_from_border(const Triangulation&, std::uint32_t) {}
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_NO_CORRESPONDENCE_H
