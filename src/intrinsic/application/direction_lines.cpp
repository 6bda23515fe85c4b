// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "direction_lines.h"

#include <cstddef>
#include <string>
#include <vector>

namespace program {

std::vector<IT::Placed_vector> placed_vectors(const Drawn_directions& directions,
                                              const Drawn_subdivision& drawn) {
  std::vector<IT::Placed_vector> result;
  for (std::size_t v = 0; v < drawn.s.vertices.size(); ++v)
    for (const std::vector<Point>& vectors : directions.at_vertices)
      result.push_back({drawn.points[v], vectors[v]});
  return result;
}

void append_fields(std::vector<IT::Subdivision_field>& fields, const std::string& name,
                   const Drawn_directions& directions) {
  using Place = IT::Subdivision_field::Place;
  const std::size_t degree = directions.at_vertices.size();
  for (std::size_t k = 0; k < degree; ++k) {
    const std::string numbered = degree == 1 ? name : name + "_" + std::to_string(k);
    fields.push_back({numbered, directions.at_vertices[k]});
    if (!directions.at_faces.empty())
      fields.push_back({numbered, directions.at_faces[k], Place::faces});
  }
  if (!directions.index.empty()) fields.push_back({"index", directions.index, Place::faces});
}

} // namespace program
