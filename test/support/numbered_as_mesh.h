// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_NUMBERED_AS_MESH_H
#define TEST_INTRINSIC_TRIANGULATIONS_NUMBERED_AS_MESH_H

#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>

#include "meshes.h"

#include <utility>

/// Builds a triangulation whose elements keep the numbers of the mesh.
template <class Triangulation>
Triangulation numbered_as(const meshes::Mesh& m) {
  CGAL::Intrinsic_triangulations::Intrinsic_input input = m.input();
  input.may_renumber = false;
  return Triangulation(std::move(input));
}

#endif // TEST_INTRINSIC_TRIANGULATIONS_NUMBERED_AS_MESH_H
