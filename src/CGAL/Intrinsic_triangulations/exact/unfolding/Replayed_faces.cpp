// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_list.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Replayed_faces.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

Replayed_faces::Replayed_faces(const Input_definition& input, Gluing_map mesh,
                               const Flip_list& flips, std::vector<Indexed_face> faces)
    : input_(&input), flips_(&flips), is_needed_(flips.size()), faces_(std::move(faces)) {
  std::vector<char> is_needed(mesh.number_of_faces(), 0);
  for (const Indexed_face& f : faces_) is_needed[f.face] = 1;
  mesh_ = flips.undone(std::move(mesh), [&](std::size_t n, const Gluing_map& after) {
    char& f = is_needed[after.face(flips[n]).index];
    char& g = is_needed[after.face(Gluing_map::opposite(flips[n])).index];
    if (f == 0 && g == 0) return;
    f = g = 1;
    is_needed_[n] = true;
    ++size_;
  });
}

} // namespace CGAL::Intrinsic_triangulations
