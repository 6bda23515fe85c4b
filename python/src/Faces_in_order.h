// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_FACES_IN_ORDER_H
#define INTRINSIC_PYTHON_FACES_IN_ORDER_H

#include "Surface.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace python {

/*!
\brief is the order of the faces of a triangulation that Python sees.

Before the first flip, faces have the numbers of the user's triangles; flips keep numbers. Gaps that
removals leave are closed. The corners of a face start from the source of its halfedge.
*/
template <class Triangulation>
class Faces_in_order {
public:
  using Face = typename Triangulation::face_descriptor;

  /// sorts them. \complexity linear, up to sorting
  explicit Faces_in_order(const Triangulation& t) {
    const IT::Element_names& names = t.input().names().faces;
    for (const Face f : faces(t.mesh())) order_.push_back(f);
    std::sort(order_.begin(), order_.end(),
              [&](Face f, Face g) { return names.user(t.index(f)) < names.user(t.index(g)); });
    number_.resize(t.numbers().face_capacity(t.mesh()), -1);
    for (std::size_t i = 0; i < order_.size(); ++i)
      number_[t.index(order_[i])] = static_cast<std::int64_t>(i);
  }

  /// returns the faces.
  const std::vector<Face>& order() const { return order_; }
  /// returns the number that Python has for the face with a number in the triangulation.
  std::int64_t operator[](std::uint32_t f) const { return number_[f]; }

private:
  std::vector<Face> order_;
  std::vector<std::int64_t> number_;
};

} // namespace python

#endif // INTRINSIC_PYTHON_FACES_IN_ORDER_H
