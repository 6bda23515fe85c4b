// expect at once of templates: files hold integer coordinates, from which signposts are not made; read with Integer_coordinates
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Files say what to do where a correspondence cannot be restored.

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/read_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>

#include <sstream>

namespace IT = CGAL::Intrinsic_triangulations;

int main() {
  using Triangulation =
      IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, IT::Signposts>;
  std::istringstream file;
  IT::read_intrinsic_triangulation<Triangulation>(file, "file.idt");
}
