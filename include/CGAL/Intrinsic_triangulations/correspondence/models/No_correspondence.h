// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_NO_CORRESPONDENCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_NO_CORRESPONDENCE_H

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is an empty correspondence: it does not store where intrinsic edges run on the input.
\cgalModels{IntrinsicCorrespondence}
*/
struct No_correspondence {
  /// Name of the representation in programs.
  static constexpr const char* name = "none";

  /// observes a triangulation before its first move.
  template <class Triangulation>
  void start(const Triangulation&) {}
  /// observes a restored triangulation and how it lies on its input.
  template <class Triangulation, class Coordinates>
  void restore(const Triangulation&, const Coordinates&) {}
  /// is called before a move. \return true
  template <class Triangulation, class Move>
  bool before(const Triangulation&, const Move&) const {
    return true;
  }
  /// is called before a move that nobody refuses.
  template <class Triangulation, class Move>
  void make_room(const Triangulation&, const Move&) {}
  /// is called after a move.
  template <class Triangulation, class Move>
  void after(const Triangulation&, const Move&) noexcept {}
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_NO_CORRESPONDENCE_H
