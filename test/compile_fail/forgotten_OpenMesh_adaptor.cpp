// expect at once: include CGAL/Intrinsic_triangulations/connectivity/adaptors/OpenMesh_adaptor.h
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// OpenMesh meshes are known to BGL by a header; a class without one stands for them here.

#include <CGAL/Intrinsic_triangulations.h>

struct OpenMesh_mesh {};

int main() {
  const OpenMesh_mesh mesh;
  CGAL::Intrinsic_triangulations::Corresponding_triangulation t(mesh);
}
