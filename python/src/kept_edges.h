// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_KEPT_EDGES_H
#define INTRINSIC_PYTHON_KEPT_EDGES_H

#include "Surface.h"
#include "arrays.h"

#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace python {

/// Edges of the user's mesh that are kept: pairs of vertices, and those with a sharp angle.
struct Kept {
  std::vector<std::uint32_t> ends;   ///< two of each edge
  std::optional<double> sharp_angle; ///< in degrees
};

/// reads what Python gives.
Kept kept(Surface& s, const std::optional<Integers>& ends, std::optional<double> sharp_angle);
/// returns marks of edges of the input; none if no edges are to be kept.
std::vector<char> marks_of(const IT::Input& input, const Kept& keep);

} // namespace python

#endif // INTRINSIC_PYTHON_KEPT_EDGES_H
