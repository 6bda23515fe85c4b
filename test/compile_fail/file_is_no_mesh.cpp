// expect at once: read_triangle_soup\(name\)
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Files are read first.

#include <CGAL/Intrinsic_triangulations.h>

namespace IT = CGAL::Intrinsic_triangulations;

int main() { IT::Corresponding_triangulation t("mesh.off"); }
