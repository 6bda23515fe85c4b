// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_NAMED_INPUTS_H
#define TEST_INTRINSIC_TRIANGULATIONS_NAMED_INPUTS_H

#include <CGAL/Intrinsic_triangulations/domains/Domain.h>

#include "gallery.h"
#include "meshes.h"
#include "operator_test_meshes.h"
#include "soups.h"

#include <string>
#include <utility>
#include <vector>

namespace operator_test {

struct Named_input {
  std::string name;
  IT::Intrinsic_input input;
};

/// Surfaces for fields of vectors: closed and bordered, of several genera, covers, Delta-complexes.
inline std::vector<Named_input> named_inputs() {
  std::vector<Named_input> all;
  for (const auto& [name, mesh] :
       {std::pair{"box", meshes::box(2, 3, 2)}, std::pair{"potato", meshes::potato(2, 5)},
        std::pair{"rough grid", meshes::rough_grid(6, 4)},
        std::pair{"terrain", meshes::integer_terrain(40, 200, 2)},
        std::pair{"stairs", meshes::stairs(4, 3, 0.3)}})
    all.push_back({name, mesh.input()});
  all.push_back({"torus", rough_torus(8, 0.3, 1).input()});
  for (const auto& [name, mesh] :
       {std::pair{"book", soups::book()}, std::pair{"fins", soups::three_fins()},
        std::pair{"moebius", soups::moebius_strip()}, std::pair{"klein", soups::klein_bottle()}})
    all.push_back({name, IT::make_domain(soups::soup(mesh)).input});
  for (const gallery::Surface& s : gallery::oriented()) all.push_back({s.name, input(s)});
  return all;
}

} // namespace operator_test

#endif // TEST_INTRINSIC_TRIANGULATIONS_NAMED_INPUTS_H
