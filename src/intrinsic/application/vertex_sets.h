// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_APPLICATION_VERTEX_SETS_H
#define INTRINSIC_APPLICATION_VERTEX_SETS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace program {

namespace IT = CGAL::Intrinsic_triangulations;

/// The vertices on each line of a file.
struct Vertex_sets {
  std::string path;
  std::vector<std::vector<std::uint32_t>> rows; ///< the vertices as the mesh numbers them
  std::vector<std::size_t> lines;               ///< of the file, from 1

  /// \throws std::runtime_error naming file and line of a set
  [[noreturn]] void refuse(std::size_t set, const std::string& what) const;
};

/*!
\brief reads a text file with numbers of vertices on each line.
\param path the file
\param vertices how many there are
\param are_pairs whether each line has two
\throws std::runtime_error naming the line of a word that is not the number of a vertex, or of too
few or too many numbers
*/
Vertex_sets read_vertex_sets(const std::string& path, std::size_t vertices, bool are_pairs);

/// returns the places of the vertices in sets that a file lists.
/// \throws std::runtime_error naming the line of a vertex without faces
template <class Triangulation>
std::vector<std::vector<IT::Place>> places_of(const Triangulation& t, const Vertex_sets& sets) {
  IT::Place_finder<Triangulation> find(t);
  std::vector<std::vector<IT::Place>> result(sets.rows.size());
  for (std::size_t i = 0; i < result.size(); ++i)
    for (const std::uint32_t row : sets.rows[i]) try {
        (void)find.vertex(row);
        result[i].push_back(IT::Place::at_vertex(row));
      } catch (const IT::Invalid_input& e) {
        sets.refuse(i, e.what());
      }
  return result;
}

} // namespace program

#endif // INTRINSIC_APPLICATION_VERTEX_SETS_H
