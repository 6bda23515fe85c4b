// expect: satisfaction of .CorrespondingTriangulation<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Correspondence alone does not answer queries where no values are stored.

#include <CGAL/Integer_only_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  const Integer_only_triangulation<>* t = nullptr;
  common_subdivision(*t);
}
