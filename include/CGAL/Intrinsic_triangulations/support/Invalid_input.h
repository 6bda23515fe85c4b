// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_INVALID_INPUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_INVALID_INPUT_H

#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL::Intrinsic_triangulations {

/// Kind of the mesh element of an error.
enum class Element_kind { none, vertex, halfedge, edge, face };

/*!
\brief reports input from which no intrinsic triangulation can be built.

The message names the element at fault, in the numbering of the input, and the remedy.
*/
class Invalid_input : public std::runtime_error {
public:
  /// constructs the error from the element at fault and a message that says what to do.
  Invalid_input(Element_kind kind, std::size_t index, const std::string& message)
      : std::runtime_error(message), kind_(kind), index_(index) {}

  /// constructs the error with a message that starts with the element at fault: "face 7" and the
  /// message.
  static Invalid_input about(Element_kind kind, std::size_t index, const std::string& what);

  /// returns the kind of the element at fault.
  Element_kind kind() const { return kind_; }

  /// returns the index of the element at fault in the input; meaningless for `Element_kind::none`.
  std::size_t index() const { return index_; }

private:
  Element_kind kind_;
  std::size_t index_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_INVALID_INPUT_H
