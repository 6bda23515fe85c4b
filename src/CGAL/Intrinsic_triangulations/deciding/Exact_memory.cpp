// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Insertion_placer.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Unfolded_face.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Diamond_unfolder.h>
#include <CGAL/Intrinsic_triangulations/deciding/Exact_memory.h>
#include <CGAL/Intrinsic_triangulations/exact/Exact_ladder.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/flat.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

std::uint32_t Flat_parts::part_of(const Input& input,
                                  const Unfolded_diamond::Triangles& triangles) {
  const std::uint32_t first = triangles[0].side.face;
  if (part_of_input_[first] == unknown) find_part(input, first);
  const bool is_flat = std::all_of(triangles.begin(), triangles.end(), [&](const auto& t) {
    return part_of_input_[t.side.face] == part_of_input_[first];
  });
  return is_flat ? part_of_input_[first] : none;
}

void Flat_parts::find_part(const Input& input, std::uint32_t name) try {
  std::vector<std::uint32_t> stack{name};
  part_of_input_[name] = name;
  while (!stack.empty()) {
    const std::uint32_t f = stack.back();
    stack.pop_back();
    std::uint32_t h = input.halfedge_of_face(f);
    for (unsigned k = 0; k < 3; ++k, h = input.next(h)) {
      const std::uint32_t g = input.face(h ^ 1U);
      if (g == Gluing::none || part_of_input_[g] != unknown) continue;
      const std::uint32_t slot = (input_side(input, h ^ 1U).slot + 2) % 3;
      if (!are_coplanar(input.metric(), name, g, slot)) continue;
      part_of_input_[g] = name;
      stack.push_back(g);
    }
  }
} catch (...) { // memory is exhausted: a part is found as a whole or not at all
  std::replace(part_of_input_.begin(), part_of_input_.end(), name, unknown);
  throw;
}

Turned_faces::Turned_faces() = default;
Turned_faces::Turned_faces(const Turned_faces&) {}
Turned_faces::Turned_faces(Turned_faces&&) = default;
Turned_faces& Turned_faces::operator=(const Turned_faces&) {
  *this = {};
  return *this;
}
Turned_faces& Turned_faces::operator=(Turned_faces&&) noexcept = default;
Turned_faces::~Turned_faces() = default;

Unfolded_face<Turned_faces::FT>::Values Turned_faces::values_of(const Input& input) {
  return values_from(input, input_.of(input.metric()));
}

Face_values<Turned_faces::FT> Turned_faces::short_values(const Input& input) {
  const Face_values<Short_ball> v = to_nearest([&] {
    short_face_.unfold(face_, values_from(input, short_input_.of(input.metric())));
    return short_face_.face_values();
  });
  const auto& l = v.squared_lengths;
  return {{l[0].interval(), l[1].interval(), l[2].interval()}, v.quadruple_area.interval()};
}

Exact_memory::Exact_memory() = default;
Exact_memory::Exact_memory(const Exact_memory&) = default;
Exact_memory::Exact_memory(Exact_memory&&) = default;
Exact_memory& Exact_memory::operator=(const Exact_memory&) = default;
Exact_memory& Exact_memory::operator=(Exact_memory&&) noexcept = default;
Exact_memory::~Exact_memory() = default;

} // namespace CGAL::Intrinsic_triangulations::internal
