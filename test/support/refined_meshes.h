// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_REFINED_MESHES_H
#define TEST_INTRINSIC_TRIANGULATIONS_REFINED_MESHES_H

#include "meshes.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Meshes to refine in exact arithmetic: made here, and those of CGAL's data set if available.

namespace refined {

namespace IT = CGAL::Intrinsic_triangulations;
template <class Correspondence>
using Triangulation =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Correspondence>;

/// Flips to Delaunay and refines to 25 degrees.
template <class Correspondence, class Source>
Triangulation<Correspondence> triangulation(const Source& source) {
  Triangulation<Correspondence> t(source);
  IT::flip_to_delaunay(t);
  IT::delaunay_refine(t, IT::parameters::minimum_angle(25.));
  return t;
}

using Named_meshes = std::vector<std::pair<std::string, meshes::Mesh>>;

/// Faces that are cut by their parallels and diagonals: many circumcenters lie on input edges, up to rounding.
inline Named_meshes cut_by_parallels() {
  return {{"long grid", meshes::grid(3, 40, 1, 0.05)},
          {"sheared grid", meshes::sheared_grid(6, 6, 9)},
          {"rough grid", meshes::rough_grid(8, 3)},
          {"box", meshes::box(2, 7, 1)},
          {"terrain", meshes::integer_terrain(80, 9, 2)},
          {"potato", meshes::potato(2, 6)},
          {"stairs", meshes::stairs(6, 4, 3)},
          {"parabola", meshes::parabola_fan(12)}};
}

/// Slivers and faces of all sizes too: polygons that are small parts of faces.
inline Named_meshes generated() {
  Named_meshes result = cut_by_parallels();
  result.insert(result.end(), {{"grid of slivers", meshes::grid(4, 12, 1, 1e-3)},
                               {"thin grid", meshes::grid(2, 8, 1, 0.01)},
                               {"random planar", meshes::random_planar(60, 1000, 1)},
                               {"cap", meshes::with_cap(meshes::potato(2, 3), 5)},
                               {"needle", meshes::with_needle(meshes::rough_grid(5, 2), 7, 1e-5)}});
  return result;
}

#ifdef INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR
/// The names of the files of the data set up to a size.
inline std::vector<std::filesystem::path> files(std::size_t bytes) {
  std::vector<std::filesystem::path> result;
  for (const auto& entry :
       std::filesystem::directory_iterator(INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR))
    if (entry.path().extension() == ".off" && entry.file_size() <= bytes)
      result.push_back(entry.path());
  std::sort(result.begin(), result.end());
  return result;
}
#endif

/// Calls a function with the name and the source of each mesh; returns their number.
template <class Function>
std::size_t for_each(Function function) {
  std::size_t count = 0;
  for (const auto& [name, mesh] : generated()) {
    function(name, mesh.input());
    ++count;
  }
#ifdef INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR
  for (const auto& file : files(300'000)) {
    IT::Triangle_soup soup;
    try {
      soup = IT::read_triangle_soup(file.string());
      Triangulation<IT::No_correspondence>{soup};
    } catch (const std::exception&) {
      continue; // no oriented manifold: others test that
    }
    function(file.filename().string(), soup);
    ++count;
  }
#endif
  return count;
}

} // namespace refined

#endif // TEST_INTRINSIC_TRIANGULATIONS_REFINED_MESHES_H
